//! What a check of a motion may find.

use crate::phonology::Side;
use crate::time::Seconds;
use std::fmt;

/// What is the matter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// A number that is none.
    NotFinite,
    /// A bone is longer or shorter than at rest.
    BoneLength,
    /// A wrist is faster than anyone signs.
    TooFast,
    /// A wrist is faster than signers usually are.
    Fast,
    /// A joint turns faster than a body's does.
    Jump,
    /// An elbow bends otherwise than a hinge does, or too far.
    Elbow,
    /// A wrist or forearm is bent or turned beyond its limits.
    Wrist,
    /// A finger is bent or spread beyond its limits.
    Finger,
    /// A finger is twisted, as none can be.
    FingerTwist,
    /// A hand is in the trunk or the head.
    InBody,
    /// A hand is away from what it should touch, and nothing was said of it.
    Contact,
    /// Fingers or palm look elsewhere than stated, and nothing was said of it.
    Orientation,
    /// The sign is over too soon.
    Short,
    /// The sign lasts too long.
    Long,
    /// A hand does not reach what it should touch, as its report says.
    OutOfReach,
    /// Fingers or palm look elsewhere than stated as a wrist goes no further, as its report says.
    BeyondWrist,
}

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Weight {
    /// The motion cannot be used.
    Fault,
    /// Worth a look.
    Warning,
    /// Known: the body cannot do what the description asks for, and the report of the motion says so.
    Exception,
}

impl Weight {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Weight::Fault => "fault",
            Weight::Warning => "warning",
            Weight::Exception => "exception",
        }
    }
}

/// What a finding is measured in; values are kept in SI units and radians.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unit {
    /// How many.
    Count,
    /// Kept in metres, shown in millimetres.
    Millimetres,
    /// Kept in radians, shown in degrees.
    Degrees,
    /// Metres a second.
    MetresASecond,
    /// Seconds.
    Seconds,
}

impl Unit {
    /// Its symbol.
    pub fn symbol(self) -> &'static str {
        match self {
            Unit::Count => "",
            Unit::Millimetres => " mm",
            Unit::Degrees => "°",
            Unit::MetresASecond => " m/s",
            Unit::Seconds => " s",
        }
    }

    /// A value as it is shown.
    pub fn shown(self, value: f64) -> f64 {
        match self {
            Unit::Millimetres => value * 1e3,
            Unit::Degrees => value.to_degrees(),
            Unit::Count | Unit::MetresASecond | Unit::Seconds => value,
        }
    }

    fn decimals(self) -> usize {
        match self {
            Unit::Count => 0,
            Unit::Millimetres | Unit::Degrees => 1,
            Unit::MetresASecond | Unit::Seconds => 2,
        }
    }
}

impl Kind {
    /// All kinds, the gravest first.
    pub const ALL: [Kind; 16] = [
        Kind::NotFinite,
        Kind::BoneLength,
        Kind::TooFast,
        Kind::Fast,
        Kind::Jump,
        Kind::Elbow,
        Kind::Wrist,
        Kind::Finger,
        Kind::FingerTwist,
        Kind::InBody,
        Kind::Contact,
        Kind::Orientation,
        Kind::Short,
        Kind::Long,
        Kind::OutOfReach,
        Kind::BeyondWrist,
    ];

    /// In a few words.
    pub fn name(self) -> &'static str {
        match self {
            Kind::NotFinite => "not a number",
            Kind::BoneLength => "bone length changes",
            Kind::TooFast => "wrist faster than anyone signs",
            Kind::Fast => "fast wrist",
            Kind::Jump => "joint jumps",
            Kind::Elbow => "elbow beyond its limits",
            Kind::Wrist => "wrist beyond its limits",
            Kind::Finger => "finger beyond its limits",
            Kind::FingerTwist => "finger twisted",
            Kind::InBody => "hand in the body",
            Kind::Contact => "contact missed",
            Kind::Orientation => "orientation missed",
            Kind::Short => "sign too short",
            Kind::Long => "sign too long",
            Kind::OutOfReach => "contact out of reach",
            Kind::BeyondWrist => "orientation beyond the wrist",
        }
    }

    /// How much it matters.
    pub fn weight(self) -> Weight {
        match self {
            Kind::NotFinite | Kind::BoneLength | Kind::TooFast => Weight::Fault,
            Kind::Fast
            | Kind::Jump
            | Kind::Elbow
            | Kind::Wrist
            | Kind::Finger
            | Kind::FingerTwist
            | Kind::InBody
            | Kind::Contact
            | Kind::Orientation
            | Kind::Short
            | Kind::Long => Weight::Warning,
            Kind::OutOfReach | Kind::BeyondWrist => Weight::Exception,
        }
    }

    /// What it is measured in.
    pub fn unit(self) -> Unit {
        match self {
            Kind::NotFinite => Unit::Count,
            Kind::BoneLength | Kind::InBody | Kind::Contact | Kind::OutOfReach => Unit::Millimetres,
            Kind::TooFast | Kind::Fast => Unit::MetresASecond,
            Kind::Short | Kind::Long => Unit::Seconds,
            Kind::Jump
            | Kind::Elbow
            | Kind::Wrist
            | Kind::Finger
            | Kind::FingerTwist
            | Kind::Orientation
            | Kind::BeyondWrist => Unit::Degrees,
        }
    }
}

/// One thing that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// What is the matter.
    pub kind: Kind,
    /// The hand or arm that it is about; `None` for the whole body.
    pub side: Option<Side>,
    /// When, from the clip's start.
    pub time: Seconds,
    /// What was measured: SI units, radians.
    pub measured: f64,
    /// What it should not pass.
    pub bound: f64,
    /// The joint, the key, the place: in words.
    pub what: String,
}

impl Finding {
    /// How far the measured value lies beyond the bound.
    pub fn excess(&self) -> f64 {
        (self.measured - self.bound).abs()
    }
}

/// `right hand at 0.53 s: 23.1° (bound 5.0°), palm at key 1`
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.side {
            Some(Side::Left) => write!(f, "left hand ")?,
            Some(Side::Right) => write!(f, "right hand ")?,
            None => {}
        }
        let (unit, decimals) = (self.kind.unit(), self.kind.unit().decimals());
        let [measured, bound] = [self.measured, self.bound].map(|value| unit.shown(value));
        let symbol = unit.symbol();
        write!(f, "at {}: {measured:.decimals$}{symbol} (bound {bound:.decimals$}{symbol}), {}", self.time, self.what)
    }
}

/// The worst of the values of a series, to be told where it passes a bound.
#[derive(Debug, Clone, Default)]
pub(super) struct Worst {
    /// Value, bound, frame, what.
    at: Option<(f64, f64, usize, String)>,
}

impl Worst {
    /// Looks at a value of a frame; `what` is asked for where it is the worst yet.
    pub fn look(&mut self, value: f64, bound: f64, frame: usize, what: impl FnOnce() -> String) {
        let over = value - bound;
        if over > 0.0 && self.at.as_ref().is_none_or(|(worst, its_bound, ..)| over > worst - its_bound) {
            self.at = Some((value, bound, frame, what()));
        }
    }

    /// The finding, where a value passed its bound.
    pub fn finding(self, kind: Kind, side: Option<Side>, time_of: impl Fn(usize) -> Seconds) -> Option<Finding> {
        self.at.map(|(measured, bound, frame, what)| Finding {
            kind,
            side,
            time: time_of(frame),
            measured,
            bound,
            what,
        })
    }
}
