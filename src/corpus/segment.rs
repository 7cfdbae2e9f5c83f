//! Segments: what one hand does under one gloss, with the values of its phonological components.

use crate::phonology::Side;
use crate::time::Seconds;

/// A phonological component of which a segment has values; each is a tier of a hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Component {
    /// The hand's shape.
    Configuration,
    /// Where the hand is.
    Placement,
    /// Where fingers and palm look.
    Orientation,
    /// What the hand does.
    Movement,
}

impl Component {
    /// All four, in the order of the tiers.
    pub const ALL: [Component; 4] =
        [Component::Configuration, Component::Placement, Component::Orientation, Component::Movement];

    /// The name of its tier without the hand: `Configuration`.
    pub fn title(self) -> &'static str {
        match self {
            Component::Configuration => "Configuration",
            Component::Placement => "Placement",
            Component::Orientation => "Orientation",
            Component::Movement => "Movement",
        }
    }
}

/// A value of a component and when it holds, from the recording's start.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// The value as its tier has it: `round-B`, `chest, touch`, `fingers up, palm out`, `arc up-right 15cm`.
    pub label: String,
    /// When it begins.
    pub start: Seconds,
    /// When it ends.
    pub end: Seconds,
}

/// What one hand does under one gloss.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Segment {
    /// The number of the recording in its corpus.
    pub recording: usize,
    /// The hand; `None` where the annotation does not tell hands apart.
    pub side: Option<Side>,
    /// When it begins, from the recording's start.
    pub start: Seconds,
    /// When it ends.
    pub end: Seconds,
    /// The gloss; `None` where it is not known.
    pub gloss: Option<String>,
    /// The values of each component in time, in the order of [`Component::ALL`]; none where they are not known.
    pub values: [Vec<Value>; 4],
}

impl Segment {
    /// How long it lasts.
    pub fn duration(&self) -> Seconds {
        self.end - self.start
    }

    /// The values of a component.
    pub fn of(&self, component: Component) -> &[Value] {
        &self.values[component as usize]
    }
}
