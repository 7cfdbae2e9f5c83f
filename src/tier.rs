//! Tiers: timed values side by side, as in ELAN, without meaning of their own.
//!
//! A description, an annotation and a track share this shape (see docs/DESIGN.md, "the one idea").
//! Values carry the label that a person reads, and the source that the value came from.

use crate::time::Seconds;

/// One value of a tier: what held from `start` to `end`.
#[derive(Debug, Clone, PartialEq)]
pub struct TierValue {
    /// When the value begins.
    pub start: Seconds,
    /// When the value ends; never before `start`.
    pub end: Seconds,
    /// What a person reads on the tier.
    pub label: String,
    /// Where the value came from ("description", "grammar: round-B", "default", ...).
    pub source: String,
}

/// A named sequence of values in the order of their starts.
#[derive(Debug, Clone, PartialEq)]
pub struct Tier {
    /// The tier's name, such as `RH Configuration`.
    pub name: String,
    values: Vec<TierValue>,
}

impl Tier {
    /// An empty tier.
    pub fn new(name: impl Into<String>) -> Tier {
        Tier { name: name.into(), values: Vec::new() }
    }

    /// Adds a value, keeping the order of starts.
    ///
    /// A value whose end lies before its start is given no length rather than a negative one.
    pub fn push(&mut self, start: Seconds, end: Seconds, label: impl Into<String>, source: impl Into<String>) {
        let end = if end < start { start } else { end };
        let at = self.values.partition_point(|v| v.start <= start);
        self.values.insert(at, TierValue { start, end, label: label.into(), source: source.into() });
    }

    /// The values, in the order of their starts.
    pub fn values(&self) -> &[TierValue] {
        &self.values
    }

    /// The value that holds at an instant: the last one that started and has not ended.
    pub fn at(&self, time: Seconds) -> Option<&TierValue> {
        self.values.iter().rev().find(|v| v.start <= time && time <= v.end)
    }
}
