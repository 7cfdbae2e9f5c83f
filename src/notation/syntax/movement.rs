//! Movements as written.

use super::{Configuration, Contact, Duration, Length, Orientation, Placement};
use crate::diagnostics::Spanned;
use crate::phonology::{Clock, Digits, Direction, Heading, Manner, Overlay, Repetition, Size, WristMotion};

/// A movement as written.
#[derive(Debug, Clone, PartialEq)]
pub enum Movement {
    /// One movement.
    Action(Box<Action>),
    /// `( … then … )`, `fused ( … then … )`; a group of one is only a bracket, and is not kept.
    Group {
        /// Whether the parts are blended.
        fused: bool,
        /// The parts.
        parts: Vec<Movement>,
    },
    /// `… while …`
    Together(Vec<Movement>),
    /// `( … ) repeated 2`
    Repeated(Box<Repeated>),
    /// `backwards ( … )`
    Backwards(Box<Movement>),
}

/// A group performed more than once.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeated {
    /// What stands in the brackets.
    pub movement: Movement,
    /// `repeated 2`, `continued 2`, `to and fro 2`
    pub repetition: Repetition,
    /// `alternating`
    pub alternating: bool,
}

/// One movement with what is said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Action {
    /// What the hand does.
    pub motion: Motion,
    /// `to PLACE`
    pub target: Option<Placement>,
    /// `brushing PLACE`
    pub brushing: Option<Placement>,
    /// `fast`, `tense`, …
    pub manner: Vec<Manner>,
    /// `repeated 2`, `continued 2`, `to and fro 2`
    pub repetition: Option<Repetition>,
    /// `duration 0.4s`
    pub duration: Option<Duration>,
    /// `speed 1.5`
    pub pace: Option<f64>,
    /// `alternating`
    pub alternating: bool,
    /// `becoming ( … )`
    pub becoming: Option<Box<Becoming>>,
    /// `named "A"`
    pub names: Option<String>,
}

impl Action {
    /// A motion of which nothing more is said.
    pub fn new(motion: Motion) -> Action {
        Action {
            motion,
            target: None,
            brushing: None,
            manner: Vec::new(),
            repetition: None,
            duration: None,
            pace: None,
            alternating: false,
            becoming: None,
            names: None,
        }
    }
}

/// What changes of a posture during a movement, as written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Becoming {
    /// `configuration 5`
    pub configuration: Option<Configuration>,
    /// `orientation palm up`
    pub orientation: Option<Orientation>,
    /// `contact strong palm touches weak back`
    pub contact: Option<Contact>,
}

/// What a hand does, as written.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// `hold`
    Hold,
    /// `change`; not written where a target follows.
    Change,
    /// `back`, `back to key 2`: the key, counted from 1, the start.
    Return(Spanned<usize>),
    /// A direction alone.
    Straight {
        /// Where to.
        direction: Heading,
        /// How far.
        extent: Extent,
        /// `zigzag`, `wavy`
        overlay: Option<Overlay>,
    },
    /// `arc …`
    Arc {
        /// Direction of the chord.
        direction: Heading,
        /// Length of the chord.
        extent: Extent,
        /// `bulging HEADING`
        bulge: Option<Heading>,
        /// `small bend`, `large bend`
        depth: Size,
        /// `zigzag`, `wavy`
        overlay: Option<Overlay>,
    },
    /// `circle …`
    Circle {
        /// `axis HEADING`
        axis: Heading,
        /// `radius 5cm`, `small`, `large`
        extent: Extent,
        /// `from 3`
        start: Clock,
        /// `turns 2`
        turns: f64,
        /// `flattened 0.5 along up`
        ellipse: Option<(f64, Direction)>,
        /// `growing`, `shrinking 2`
        growth: i8,
        /// `zigzag`, `wavy`
        overlay: Option<Overlay>,
    },
    /// `nod`, `twist large`
    Wrist(WristMotion, Size),
    /// `wiggle`, `wiggle index middle`
    Wiggle(Digits),
}

/// How far, as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// `small`, `large`, or nothing.
    Size(Size),
    /// `12cm`
    Length(Length),
}
