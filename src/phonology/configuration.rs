//! Hand configuration as it is described: a named handshape with changes.
//!
//! The names and their joint angles are data (`grammar/handshapes.ron`). HamNoSys writes a handshape as
//! a class with modifiers; both come to a base and changes, and to joint angles in `handshape`.

use super::hand::{Digit, Digits};

/// A handshape: a named one, perhaps halfway to a second, perhaps changed (`U, thumb out, index hooked`).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Configuration {
    /// The name of a handshape of the inventory, as written.
    pub base: String,
    /// A second handshape: the configuration lies halfway between the two (HamNoSys "between").
    pub between: Option<String>,
    /// Changes, applied in order.
    pub changes: Vec<HandshapeChange>,
}

impl Configuration {
    /// A named handshape without changes.
    pub fn named(base: impl Into<String>) -> Configuration {
        Configuration { base: base.into(), between: None, changes: Vec::new() }
    }
}

/// A change to a named handshape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HandshapeChange {
    /// `thumb out`, `thumb across`, ...
    Thumb(ThumbPosition),
    /// `index hooked`, `index middle bent`; no digits means the selected fingers: `bent`.
    Bend(Digits, Bend),
    /// `spread` (true) or `together` (false).
    Spread(bool),
    /// `index over middle`: the first crosses in front of (palmar of) the second.
    Cross(Digit, Digit),
    /// `thumb between index middle`.
    ThumbBetween(Digit, Digit),
}

/// Where the thumb is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ThumbPosition {
    /// Along the hand's edge, beside the index.
    Along,
    /// Stretched away from the hand (hamthumboutmod).
    Out,
    /// Across the palm or the closed fingers (hamthumbacrossmod).
    Across,
    /// Facing the fingers (hamthumbopenmod).
    Opposed,
}

impl ThumbPosition {
    /// All of them.
    pub const ALL: [ThumbPosition; 4] =
        [ThumbPosition::Along, ThumbPosition::Out, ThumbPosition::Across, ThumbPosition::Opposed];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            ThumbPosition::Along => "along",
            ThumbPosition::Out => "out",
            ThumbPosition::Across => "across",
            ThumbPosition::Opposed => "opposed",
        }
    }
}

/// How a finger is bent (HamNoSys's bending modifiers, and closed).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Bend {
    /// All joints stretched.
    Straight,
    /// Right angle at the knuckle, the rest stretched.
    Bent,
    /// Half of that.
    HalfBent,
    /// Every joint a little.
    Round,
    /// Knuckle stretched, the others bent: a hook.
    Hooked,
    /// Knuckle and middle joint bent, the last stretched.
    DoubleBent,
    /// Every joint bent.
    DoubleHooked,
    /// Closed as in a fist.
    Closed,
}

impl Bend {
    /// All of them.
    pub const ALL: [Bend; 8] = [
        Bend::Straight,
        Bend::Bent,
        Bend::HalfBent,
        Bend::Round,
        Bend::Hooked,
        Bend::DoubleBent,
        Bend::DoubleHooked,
        Bend::Closed,
    ];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            Bend::Straight => "straight",
            Bend::Bent => "bent",
            Bend::HalfBent => "half-bent",
            Bend::Round => "round",
            Bend::Hooked => "hooked",
            Bend::DoubleBent => "double-bent",
            Bend::DoubleHooked => "double-hooked",
            Bend::Closed => "closed",
        }
    }
}
