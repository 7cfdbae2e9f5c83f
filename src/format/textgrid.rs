//! Praat's TextGrid: interval tiers and point tiers, in both of its text forms.
//!
//! Source: Praat's manual, "TextGrid file formats" and "Text file formats" (Boersma and Weenink, <https://www.praat.org>):
//! of a text file, Praat sees the free-standing numbers, the texts in quotation marks and the flags in angle brackets, and
//! takes everything else for a comment. So the long form (`xmin = 0`) and the short one (`0`) are one and the same here.
//!
//! # Conventions
//! - Seconds. UTF-8, or UTF-16 with a byte order mark, as Praat writes it.
//! - An interval without a text is a gap, not a value. A point is a value that starts and ends at one instant.
//! - A quotation mark in a text is doubled. Praat's backslash trigraphs (`\sw`) stay as they are.
//!
//! # What is refused
//! Binary TextGrids, counts that do not fit, intervals that end before they begin, times that are not finite: each with
//! line and column.

mod read;
mod token;
mod write;

use crate::tier::Tier;
use crate::time::Seconds;

pub use read::{Reading, read};
pub use write::write;

/// What a TextGrid's tier is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Stretches of time (`IntervalTier`).
    Intervals,
    /// Instants (`TextTier`).
    Points,
}

/// A tier of a TextGrid.
#[derive(Debug, Clone, PartialEq)]
pub struct GridTier {
    /// Name and values; sources are empty.
    pub tier: Tier,
    /// What it is made of.
    pub kind: Kind,
}

/// What a TextGrid says.
#[derive(Debug, Clone, PartialEq)]
pub struct TextGrid {
    /// When it begins, as a rule 0.
    pub start: Seconds,
    /// When it ends.
    pub end: Seconds,
    /// Its tiers, in order. Several may have one name.
    pub tiers: Vec<GridTier>,
}
