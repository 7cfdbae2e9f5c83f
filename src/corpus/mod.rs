//! Annotated motion capture: recordings, what is annotated on them, and how their segments are found by phonology
//! (Naert et al. 2021, §3).
//!
//! A recording is a motion of the rig with tiers over it. Its segments are what a hand does under one gloss, with the
//! values of each phonological component and when they hold. Nothing here changes a motion.

pub mod annotate;
pub mod bases;
pub mod build;
pub mod cache;
pub mod cut;
pub mod examine;
pub mod example;
pub mod files;
pub mod index;
pub mod label;
pub mod library;
pub mod manifest;
pub mod motion;
pub mod propose;
pub mod query;
pub mod segment;
pub mod tiers;
