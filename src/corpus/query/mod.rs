//! Queries by phonology: `gloss=hello hand=right configuration~5 placement=chest duration<1.2s`.
//!
//! Conditions stand side by side, and a segment is found that meets them all.
//!
//! | written | means |
//! |---|---|
//! | `gloss=hello` | that gloss; so `recording=`, `signer=` |
//! | `hand=right`, `left`, `strong`, `weak` | strong and weak by the signer's dominant hand |
//! | `configuration=round-B` | a value that says so, and perhaps more; so `placement=`, `orientation=`, `movement=` |
//! | `fingers=up`, `palm=out` | one half of the orientation |
//! | `configuration=5\|B` | one or the other |
//! | `configuration=O>K` | the values in that order, others perhaps between |
//! | `configuration!=5` | no value is that |
//! | `configuration=?`, `!=?` | not known, known |
//! | `configuration~5`, `~5:0.3` | near: ranked by distance, up to 0.3 |
//! | `duration<1.2s`, `start>=800ms` | times; without a unit seconds |
//! | `placement="chest left, close"` | quotes hold words together |
//!
//! Case does not matter, nor how accents are written. Names of the inventories stand for one another (`chest` is `breast`).
//!
//! # What is not known
//! is neither a match nor a mismatch (Kleene's strong three-valued logic): a segment whose configuration nobody annotated may well have the
//! one that is asked for. Such segments come after all sure ones, and say what is not known.

mod find;
mod near;
mod parse;
mod prepare;
mod reasons;
mod scan;

pub use find::{Hit, Options};
pub use parse::{Parsed, parse};

use super::label::Label;
use super::segment::Component;
use crate::diagnostics::Span;
use crate::phonology::Side;

/// What a condition is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// The gloss.
    Gloss,
    /// The hand.
    Hand,
    /// The recording's name.
    Recording,
    /// Who signs.
    Signer,
    /// The values of a component.
    Value(Component),
    /// Where the fingers point: a half of the orientation.
    Fingers,
    /// Where the palm faces.
    Palm,
    /// How long the segment lasts.
    Duration,
    /// When it begins in its recording.
    Start,
}

impl Field {
    /// All of them.
    pub const ALL: [Field; 12] = [
        Field::Gloss,
        Field::Hand,
        Field::Recording,
        Field::Signer,
        Field::Value(Component::Configuration),
        Field::Value(Component::Placement),
        Field::Value(Component::Orientation),
        Field::Value(Component::Movement),
        Field::Fingers,
        Field::Palm,
        Field::Duration,
        Field::Start,
    ];

    /// The name in queries.
    pub fn name(self) -> &'static str {
        match self {
            Field::Gloss => "gloss",
            Field::Hand => "hand",
            Field::Recording => "recording",
            Field::Signer => "signer",
            Field::Value(Component::Configuration) => "configuration",
            Field::Value(Component::Placement) => "placement",
            Field::Value(Component::Orientation) => "orientation",
            Field::Value(Component::Movement) => "movement",
            Field::Fingers => "fingers",
            Field::Palm => "palm",
            Field::Duration => "duration",
            Field::Start => "start",
        }
    }

    /// The component whose values it is about.
    pub fn component(self) -> Option<Component> {
        match self {
            Field::Value(component) => Some(component),
            Field::Fingers | Field::Palm => Some(Component::Orientation),
            Field::Gloss | Field::Hand | Field::Recording | Field::Signer | Field::Duration | Field::Start => None,
        }
    }
}

/// A hand as a query names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HandName {
    /// That side of the signer.
    Side(Side),
    /// The dominant hand.
    Strong,
    /// The other one.
    Weak,
}

/// How a time compares with the one that is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Order {
    /// The same, to half a millisecond.
    Equal,
    /// Shorter or earlier.
    Less,
    /// That at most.
    AtMost,
    /// Longer or later.
    More,
    /// That at least.
    AtLeast,
}

impl Order {
    /// How near two times are that count as the same, seconds: text gives milliseconds.
    pub const SAME: f64 = 0.0005;

    /// Whether a time stands so to the one that is asked for, seconds.
    pub fn holds(self, time: f64, asked: f64) -> bool {
        match self {
            Order::Equal => (time - asked).abs() <= Order::SAME,
            Order::Less => time < asked,
            Order::AtMost => time <= asked,
            Order::More => time > asked,
            Order::AtLeast => time >= asked,
        }
    }
}

/// Values in a row: one, or several in that order.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// What each value must say; at least one.
    pub parts: Vec<Label>,
}

/// What a condition asks.
#[derive(Debug, Clone, PartialEq)]
pub enum Asked {
    /// That it is not known.
    Missing,
    /// That it is one of these names, folded.
    Names(Vec<String>),
    /// That it is one of these hands.
    Hands(Vec<HandName>),
    /// That the values are as one of these patterns.
    Values(Vec<Pattern>),
    /// That the values are near one of these patterns.
    Near {
        /// The patterns; each part has features to compare.
        patterns: Vec<Pattern>,
        /// The greatest distance; any where not said.
        bound: Option<f64>,
    },
    /// That the time stands so to one of these, seconds.
    Times(Order, Vec<f64>),
}

/// One condition.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// What it is about.
    pub field: Field,
    /// Whether the opposite is asked (`!=`).
    pub negated: bool,
    /// What is asked.
    pub asked: Asked,
    /// The value as it was written, without its bound.
    pub written: String,
    /// Where it stands in the query's text.
    pub span: Span,
}

/// Conditions, all of which must hold.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Query {
    /// The conditions, in the order in which they were written.
    pub conditions: Vec<Condition>,
}
