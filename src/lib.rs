//! Chereme: a sign written as phonological components becomes signing motion.
//!
//! See docs/ARCHITECTURE.md for the map and docs/DESIGN.md for the decisions.

pub mod avatar;
pub mod body;
pub mod cli;
pub mod corpus;
pub mod diagnostics;
pub mod evaluation;
pub mod format;
pub mod motion;
pub mod notation;
pub mod phonology;
pub mod score;
pub mod synthesis;
pub mod tier;
pub mod time;
pub mod track;
