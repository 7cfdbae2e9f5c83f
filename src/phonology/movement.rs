//! Hand movement: primitives, paths to places, and how they combine and repeat.

use super::configuration::Configuration;
use super::direction::{Direction, Heading};
use super::hand::Digits;
use super::orientation::Orientation;
use super::placement::{Contact, Placement};
use crate::time::Seconds;

/// The movement of one interval between two keys.
#[derive(Debug, Clone, PartialEq)]
pub enum Movement {
    /// One movement.
    Action(Box<Action>),
    /// One after the other within the interval (HamNoSys `hamseqbegin`).
    Sequence(Vec<Movement>),
    /// At the same time: `while` (HamNoSys `hamparbegin`).
    Together(Vec<Movement>),
    /// Blended into one (HamNoSys `hamfusionbegin`).
    Fused(Vec<Movement>),
    /// Several movements together performed more than once (HamNoSys's repetition of a bracket).
    Repeated(Box<Repeated>),
    /// Played backwards, from its end to its start. Keys that it names count from the sign's end.
    Backwards(Box<Movement>),
}

impl Movement {
    /// The same combination of other actions.
    pub fn map_actions(&self, f: &impl Fn(&Action) -> Action) -> Movement {
        let all = |parts: &[Movement]| parts.iter().map(|m| m.map_actions(f)).collect();
        match self {
            Movement::Action(action) => Movement::Action(Box::new(f(action))),
            Movement::Sequence(parts) => Movement::Sequence(all(parts)),
            Movement::Together(parts) => Movement::Together(all(parts)),
            Movement::Fused(parts) => Movement::Fused(all(parts)),
            Movement::Repeated(r) => {
                Movement::Repeated(Box::new(Repeated { movement: r.movement.map_actions(f), ..(**r).clone() }))
            }
            Movement::Backwards(inner) => Movement::Backwards(Box::new(inner.map_actions(f))),
        }
    }

    /// The same with its groups' repetitions changed; those of single actions stay.
    pub fn map_repetitions(&self, f: &impl Fn(Repetition) -> Repetition) -> Movement {
        let all = |parts: &[Movement]| parts.iter().map(|m| m.map_repetitions(f)).collect();
        match self {
            Movement::Action(action) => Movement::Action(action.clone()),
            Movement::Sequence(parts) => Movement::Sequence(all(parts)),
            Movement::Together(parts) => Movement::Together(all(parts)),
            Movement::Fused(parts) => Movement::Fused(all(parts)),
            Movement::Repeated(r) => Movement::Repeated(Box::new(Repeated {
                movement: r.movement.map_repetitions(f),
                repetition: f(r.repetition),
                alternating: r.alternating,
            })),
            Movement::Backwards(inner) => Movement::Backwards(Box::new(inner.map_repetitions(f))),
        }
    }

    /// The place that it ends at, where it says so.
    pub fn leads_to(&self) -> Option<&Placement> {
        match self {
            Movement::Action(action) if action.repetition.is_none() => action.target.as_ref(),
            Movement::Sequence(parts) => parts.last().and_then(Movement::leads_to),
            Movement::Action(_)
            | Movement::Together(_)
            | Movement::Fused(_)
            | Movement::Repeated(_)
            | Movement::Backwards(_) => None,
        }
    }

    /// Whether one of its actions is such.
    pub fn any_action(&self, is_such: &impl Fn(&Action) -> bool) -> bool {
        match self {
            Movement::Action(action) => is_such(action),
            Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => {
                parts.iter().any(|m| m.any_action(is_such))
            }
            Movement::Repeated(r) => r.movement.any_action(is_such),
            Movement::Backwards(inner) => inner.any_action(is_such),
        }
    }
}

/// A group of movements performed more than once. A single action has its repetition itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeated {
    /// What is repeated.
    pub movement: Movement,
    /// How.
    pub repetition: Repetition,
    /// The two hands take turns (HamNoSys `hamalternatingmotion`).
    pub alternating: bool,
}

/// One movement with everything that may be said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Action {
    /// What moves, and how.
    pub motion: Motion,
    /// The place reached.
    pub target: Option<Placement>,
    /// A place brushed on the way (HamNoSys `hambrushing`).
    pub brushing: Option<Placement>,
    /// The manner, each at most once.
    pub manner: Vec<Manner>,
    /// How it repeats.
    pub repetition: Option<Repetition>,
    /// How long one performance lasts.
    pub duration: Option<Seconds>,
    /// How fast: its times are divided by it; 1 where nothing is said, from 0.05 to 20 (SiGML `speed`).
    pub pace: f64,
    /// The two hands take turns (HamNoSys `hamalternatingmotion`).
    pub alternating: bool,
    /// The posture that the hand takes on meanwhile and keeps from then on: within an interval what keys say between
    /// intervals (HamNoSys `hamreplace` in a bracket).
    pub becoming: Option<Box<Becoming>>,
    /// The name under which later placements find the place reached (HamNoSys `hamcoreftag`).
    pub names: Option<String>,
}

/// What changes of a posture during a movement. What is not stated stays as it was.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Becoming {
    /// The new configuration.
    pub configuration: Option<Configuration>,
    /// The new orientation.
    pub orientation: Option<Orientation>,
    /// How the hands meet then.
    pub contact: Option<Contact>,
}

impl Becoming {
    /// Whether nothing changes.
    pub fn is_empty(&self) -> bool {
        *self == Becoming::default()
    }
}

impl Action {
    /// A motion with nothing more said.
    pub fn new(motion: Motion) -> Action {
        Action {
            motion,
            target: None,
            brushing: None,
            manner: Vec::new(),
            repetition: None,
            duration: None,
            pace: 1.0,
            alternating: false,
            becoming: None,
            names: None,
        }
    }
}

/// What a hand does.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Nothing: the posture is held.
    Hold,
    /// Only what the other tiers change (HamNoSys `hamreplace`), and the way to a target.
    Change,
    /// Back to where the hand was at an earlier key.
    Return {
        /// The key, from 0, the start; not after the key that the interval begins at.
        key: usize,
    },
    /// A straight path.
    Straight {
        /// Where to.
        direction: Heading,
        /// How far.
        extent: Extent,
        /// Small waves on the way.
        overlay: Option<Overlay>,
    },
    /// A bent path: a chord and the side that it bulges to.
    Arc {
        /// Direction of the chord.
        direction: Heading,
        /// Length of the chord.
        extent: Extent,
        /// The side of the bend.
        bulge: Heading,
        /// How bent: the height of the bend is 0.25 (small), 0.5 (normal) or 0.9 (large) of the chord.
        depth: Size,
        /// Small waves on the way.
        overlay: Option<Overlay>,
    },
    /// A circle or an ellipse. Clockwise as seen by one who looks along the axis.
    Circle {
        /// The axis.
        axis: Heading,
        /// The radius: 3.2, 8 or 14 cm, or metres.
        extent: Extent,
        /// Where it starts (its top where not said).
        start: Clock,
        /// How many turns, above 0; not a whole number for arcs of a circle.
        turns: f64,
        /// An ellipse: its short axis is this part of the long one, whose direction follows.
        ellipse: Option<(f64, Direction)>,
        /// Growing (+) or shrinking (−) with each turn.
        growth: i8,
        /// Small waves on the way.
        overlay: Option<Overlay>,
    },
    /// A small movement of the wrist, to and fro.
    Wrist(WristMotion, Size),
    /// The fingers play (HamNoSys `hamfingerplay`); no digits means all fingers.
    Wiggle(Digits),
}

/// How far: a size that the grammar knows in metres for each kind of movement, or metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// Small, normal or large.
    Size(Size),
    /// Metres, above 0.
    Metres(f64),
}

/// Small, normal or large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Size {
    /// HamNoSys `hamsmallmod`.
    Small,
    /// Unmarked.
    #[default]
    Normal,
    /// HamNoSys `hamlargemod`.
    Large,
}

/// Waves along a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlay {
    /// Zigzag rather than wavy.
    pub zigzag: bool,
    /// How large the waves are.
    pub size: Size,
    /// The direction in which the path swings; across the path, as level as can be, where it is not said (HamNoSys's
    /// ellipse symbols).
    pub across: Option<Direction>,
    /// Waves that grow (+) or shrink (−).
    pub growth: i8,
}

impl Overlay {
    /// Waves of which only the kind and the size are said.
    pub fn new(zigzag: bool, size: Size) -> Overlay {
        Overlay { zigzag, size, across: None, growth: 0 }
    }
}

/// A place on the clock face of a circle, in eighths of a turn clockwise from the top: 0 to 7.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Clock(u8);

impl Clock {
    /// The place, or `None` above 7.
    pub fn new(eighths: u8) -> Option<Clock> {
        (eighths < 8).then_some(Clock(eighths))
    }

    /// The place across the clock face.
    pub fn opposite(self) -> Clock {
        Clock((self.0 + 4) % 8)
    }

    /// Eighths of a turn, clockwise from the top.
    pub fn eighths(self) -> u8 {
        self.0
    }
}

/// Secondary movements of the wrist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WristMotion {
    /// Bending to the palm and back.
    Nod,
    /// Bending to the thumb's and the little finger's side.
    Swing,
    /// Turning about the forearm.
    Twist,
    /// Stirring, clockwise as the signer sees it.
    StirClockwise,
    /// Stirring the other way.
    StirCounterclockwise,
}

impl WristMotion {
    /// All of them.
    pub const ALL: [WristMotion; 5] = [
        WristMotion::Nod,
        WristMotion::Swing,
        WristMotion::Twist,
        WristMotion::StirClockwise,
        WristMotion::StirCounterclockwise,
    ];

    /// The same the other way round: stirring turns back, what goes to and fro is its own reverse.
    pub fn reversed(self) -> WristMotion {
        match self {
            WristMotion::StirClockwise => WristMotion::StirCounterclockwise,
            WristMotion::StirCounterclockwise => WristMotion::StirClockwise,
            WristMotion::Nod | WristMotion::Swing | WristMotion::Twist => self,
        }
    }

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            WristMotion::Nod => "nod",
            WristMotion::Swing => "swing",
            WristMotion::Twist => "twist",
            WristMotion::StirClockwise => "stir-clockwise",
            WristMotion::StirCounterclockwise => "stir-counterclockwise",
        }
    }
}

/// Manner of a movement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Manner {
    /// HamNoSys `hamfast`.
    Fast,
    /// HamNoSys `hamslow`.
    Slow,
    /// HamNoSys `hamtense`.
    Tense,
    /// HamNoSys `hamrest`: a rest before it.
    Rest,
    /// HamNoSys `hamhalt`: a sudden stop.
    Halt,
    /// SiGML `bouncing`: back a little after the end.
    Bouncing,
    /// The fingers change one after the other, the little finger last (HamNoSys `hamreplace hamincreasing`).
    TowardPinky,
    /// The fingers change one after the other, the thumb last.
    TowardThumb,
}

impl Manner {
    /// All of them.
    pub const ALL: [Manner; 8] = [
        Manner::Fast,
        Manner::Slow,
        Manner::Tense,
        Manner::Rest,
        Manner::Halt,
        Manner::Bouncing,
        Manner::TowardPinky,
        Manner::TowardThumb,
    ];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            Manner::Fast => "fast",
            Manner::Slow => "slow",
            Manner::Tense => "tense",
            Manner::Rest => "rest",
            Manner::Halt => "halt",
            Manner::Bouncing => "bouncing",
            Manner::TowardPinky => "toward-pinky",
            Manner::TowardThumb => "toward-thumb",
        }
    }
}

/// How a movement repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Repetition {
    /// In what way.
    pub kind: RepetitionKind,
    /// Performances in all, from 2 ("several" is 3); there and back once is 1.
    pub times: u8,
    /// Each larger (+) or smaller (−) than the one before.
    pub growth: i8,
    /// Each performance is moved on from the one before (HamNoSys's repetition with an arrow).
    pub shift: Option<Shift>,
}

impl Repetition {
    /// So many performances, all alike and in one place.
    pub fn new(kind: RepetitionKind, times: u8) -> Repetition {
        Repetition { kind, times, growth: 0, shift: None }
    }
}

/// How far the place of a movement is moved between its repetitions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Shift {
    /// Where to.
    pub direction: Direction,
    /// How far all repetitions together lead; the sizes of straight paths.
    pub size: Size,
}

/// The ways to repeat.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RepetitionKind {
    /// Back to the start, then again.
    FromStart,
    /// From where it ended, on.
    Continue,
    /// There and back again.
    ToAndFro,
}
