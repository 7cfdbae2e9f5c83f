//! The statistics of the paper's evaluations (Naert et al. 2021, §7), and intervals for what is measured of motion.
//!
//! Ratings are ranks: Kruskal–Wallis ([`kruskal_wallis`]) asks whether any of several groups differs, Mann–Whitney
//! ([`mann_whitney`]) which two, Holm ([`holm`]) keeps many such questions honest. Rates have Wilson's interval
//! ([`wilson`]), measures that come in clusters a bootstrap ([`bootstrap`]).
//!
//! # Conventions
//! Probabilities and shares lie in 0..=1; p-values are two-sided; intervals are of 95 %. Functions return `None` where the
//! question has no answer (a group without values), never a number that looks like one.
//!
//! # Departs from the paper
//! The paper compares answers of the same people with tests for independent groups, and does not say that it corrects for
//! many comparisons. The tests here are the paper's; the correction is printed beside the raw p.

pub mod bootstrap;
pub mod describe;
pub mod gamma;
mod groups;
mod holm;
mod proportion;
mod ranks;

pub use groups::{KruskalWallis, MannWhitney, Method, kruskal_wallis, mann_whitney};
pub use holm::holm;
pub use proportion::{Rate, wilson};
pub use ranks::{Ranks, ranks};

/// The two-sided 95 % point of the standard normal distribution.
pub const Z95: f64 = 1.959_963_984_540_054;
