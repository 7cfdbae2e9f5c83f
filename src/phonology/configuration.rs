//! Hand configuration as it is described: a named handshape with changes.
//!
//! The names and their joint angles are data (`grammar/handshapes.ron`). HamNoSys writes a handshape as
//! a class with modifiers; both come to a base and changes, and to joint angles in `handshape`.

use super::hand::{Digit, Digits, HandPart};

/// A handshape: a named one, perhaps halfway to a second, perhaps changed (`U, thumb out, index hooked`).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Configuration {
    /// The name of a handshape of the inventory, as written.
    pub base: String,
    /// A second handshape: the configuration lies halfway between the two (HamNoSys "between").
    pub between: Option<Box<Between>>,
    /// Changes to the whole, applied in order; where it lies between two, after they are mixed.
    pub changes: Vec<HandshapeChange>,
}

/// What a configuration lies halfway to: `between ( flat, thumb out ) and ( 5, round )`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Between {
    /// Changes to the first handshape alone, before the two are mixed.
    pub first: Vec<HandshapeChange>,
    /// The name of the second handshape.
    pub second: String,
    /// Changes to the second handshape alone.
    pub changes: Vec<HandshapeChange>,
}

impl Configuration {
    /// A named handshape without changes.
    pub fn named(base: impl Into<String>) -> Configuration {
        Configuration { base: base.into(), between: None, changes: Vec::new() }
    }

    /// Halfway between two named handshapes without changes.
    pub fn halfway(first: impl Into<String>, second: impl Into<String>) -> Configuration {
        let between = Between { first: Vec::new(), second: second.into(), changes: Vec::new() };
        Configuration { between: Some(Box::new(between)), ..Configuration::named(first) }
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
    /// `on ring pinky`: these fingers do what the handshape's own fingers do (HamNoSys's list of fingers): `1, on pinky` is
    /// the stretched little finger.
    On(Digits),
    /// `except index`: these digits keep what they had before the bends of the whole hand.
    Except(Digits),
    /// `tight` or `slack`: the opening between thumb and fingers of a C or of an open pinch.
    Opening(Opening),
    /// `index touching middle nail`: the first digit touches that part of the second (HamNoSys's finger crossing).
    Meet(Digit, HandPart, Digit),
    /// `thumb touching pad`: the part of the fingers that the thumb touches in a pinch.
    ThumbAt(HandPart),
    /// `index joints 4 1 0`: knuckle, middle and last joint bent by so many quarters of their range (SiGML's codes); no digits
    /// means the selected fingers.
    Joints(Digits, [u8; 3]),
}

/// How open a C or an open pinch is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Opening {
    /// Nearly closed (HamNoSys writes `hamthumbacrossmod`).
    Tight,
    /// Wide open (HamNoSys writes `hamthumbopenmod`).
    Slack,
}

impl Opening {
    /// Both.
    pub const ALL: [Opening; 2] = [Opening::Tight, Opening::Slack];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            Opening::Tight => "tight",
            Opening::Slack => "slack",
        }
    }
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
    /// Across the palm, under the closed fingers (hamthumbacrossmod hambetween).
    Enclosed,
}

impl ThumbPosition {
    /// All of them.
    pub const ALL: [ThumbPosition; 5] = [
        ThumbPosition::Along,
        ThumbPosition::Out,
        ThumbPosition::Across,
        ThumbPosition::Opposed,
        ThumbPosition::Enclosed,
    ];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            ThumbPosition::Along => "along",
            ThumbPosition::Out => "out",
            ThumbPosition::Across => "across",
            ThumbPosition::Opposed => "opposed",
            ThumbPosition::Enclosed => "enclosed",
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
