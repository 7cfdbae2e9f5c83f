//! What a hand does in one stretch of a movement: a leg.
//!
//! A leg is a path of the contact point (perhaps to a place), small movements of wrist and fingers on top, and the part
//! of a change of posture that is made meanwhile.

use super::path::Path;
use crate::motion::easing::Easing;
use crate::phonology::{Becoming, Contact, Digits, Placement, WristMotion};
use glam::DVec3;
use std::sync::Arc;

/// One leg of a movement.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    /// Seconds.
    pub duration: f64,
    /// The way of the contact point.
    pub path: Path,
    /// Where the way ends.
    pub end: LegEnd,
    /// The part of a change of posture that is made.
    pub posture: Turn,
    /// In what order the fingers change.
    pub fingers: FingerOrder,
    /// Movements of the wrist on top.
    pub wrist: Vec<WristPlay>,
    /// Playing fingers on top.
    pub wiggle: Vec<Wiggle>,
    /// A place that the hand touches half way.
    pub brushing: Option<Placement>,
    /// The name under which later placements find the end.
    pub names: Option<String>,
}

impl Leg {
    /// A hand that stays where it is, for so many seconds.
    pub fn still(duration: f64, posture: Turn) -> Leg {
        Leg {
            duration,
            path: Path::Still,
            end: LegEnd::Displaced,
            posture,
            fingers: FingerOrder::Together,
            wrist: Vec::new(),
            wiggle: Vec::new(),
            brushing: None,
            names: None,
        }
    }

    /// The leg from its end to its start; where it ends then is another matter.
    pub(super) fn reversed_in_time(self) -> Leg {
        let path = match self.path {
            Path::Backwards(path) => *path,
            path => Path::Backwards(Box::new(path)),
        };
        Leg {
            path,
            posture: self.posture.reversed(),
            wrist: self.wrist.into_iter().map(WristPlay::reversed).collect(),
            wiggle: self.wiggle.into_iter().map(Wiggle::reversed).collect(),
            names: None,
            ..self
        }
    }

    /// The leg in another time: wrist and fingers play as fast as before, so more or less often.
    pub(super) fn stretched(self, factor: f64) -> Leg {
        let cycles = |c: f64| if factor == 1.0 { c } else { (c.abs() * factor).round().max(1.0).copysign(c) };
        Leg {
            duration: self.duration * factor,
            wrist: self.wrist.into_iter().map(|w| WristPlay { cycles: cycles(w.cycles), ..w }).collect(),
            wiggle: self.wiggle.into_iter().map(|w| Wiggle { cycles: cycles(w.cycles), ..w }).collect(),
            ..self
        }
    }

    /// The leg in an interval, reflected at planes through the origin: vectors are multiplied by `signs`.
    pub(super) fn reflected(self, signs: DVec3) -> Leg {
        Leg { path: self.path.reflected(signs), end: self.end.reflected(signs), ..self }
    }
}

/// Where a leg ends.
#[derive(Debug, Clone, PartialEq)]
pub enum LegEnd {
    /// Where the path leads from the leg's start.
    Displaced,
    /// At a place.
    At(Placement),
    /// Where the hands meet.
    Meeting(Contact),
    /// Where it starts, having bounced back by this part of the way that leads there.
    Rebound(f64),
    /// Where an earlier leg of the same interval started.
    StartOf(usize),
    /// Where the hand was at an earlier key of the sign.
    AtKey(usize),
    /// Where the hand is at the key after the interval: as that key says, else going back along the movements from the
    /// next key that says where it is, else where the path leads.
    NextKey,
    /// As another end, and from there by a vector of model space, metres.
    Off(Box<LegEnd>, DVec3),
}

impl LegEnd {
    /// The end with its vector multiplied by `signs` (reflection at planes through the origin).
    pub fn reflected(self, signs: DVec3) -> LegEnd {
        match self {
            LegEnd::Off(end, by) => LegEnd::Off(end, by * signs),
            LegEnd::Displaced
            | LegEnd::At(_)
            | LegEnd::Meeting(_)
            | LegEnd::Rebound(_)
            | LegEnd::StartOf(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey => self,
        }
    }

    /// The end in a list in which `by` legs stand before its own.
    pub(super) fn later(self, by: usize) -> LegEnd {
        match self {
            LegEnd::StartOf(leg) => LegEnd::StartOf(leg + by),
            LegEnd::Off(end, off) => LegEnd::Off(Box::new(end.later(by)), off),
            LegEnd::Displaced
            | LegEnd::At(_)
            | LegEnd::Meeting(_)
            | LegEnd::Rebound(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey => self,
        }
    }

    /// The end moved by a vector.
    pub(super) fn off(self, by: DVec3) -> LegEnd {
        match self {
            end if by == DVec3::ZERO => end,
            LegEnd::Off(end, before) => LegEnd::Off(end, before + by),
            end => LegEnd::Off(Box::new(end), by),
        }
    }

    /// Whether a place or a key says where it is, so that the path alone does not.
    pub(super) fn is_placed(&self) -> bool {
        match self {
            LegEnd::At(_) | LegEnd::Meeting(_) | LegEnd::AtKey(_) | LegEnd::NextKey => true,
            LegEnd::Displaced | LegEnd::Rebound(_) | LegEnd::StartOf(_) => false,
            LegEnd::Off(end, _) => end.is_placed(),
        }
    }
}

/// A posture that a hand comes to within an interval.
#[derive(Debug, Clone)]
pub enum Stand {
    /// That of the key before.
    Before,
    /// One in between.
    Within(Arc<Stop>),
    /// That of the key after; what it does not state stays as it is at the stop, if there is one.
    After(Option<Arc<Stop>>),
}

impl PartialEq for Stand {
    /// Stops are the same where they are one and the same.
    fn eq(&self, other: &Stand) -> bool {
        match (self, other) {
            (Stand::Before, Stand::Before) | (Stand::After(_), Stand::After(_)) => true,
            (Stand::Within(a), Stand::Within(b)) => Arc::ptr_eq(a, b),
            (Stand::Before | Stand::Within(_) | Stand::After(_), _) => false,
        }
    }
}

/// A posture between two keys: what changes, and from what.
#[derive(Debug)]
pub struct Stop {
    /// The posture before.
    pub from: Stand,
    /// What changes of it.
    pub becoming: Becoming,
}

/// A part of a change from one posture to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn {
    /// The posture at the change's start.
    pub from: Stand,
    /// The posture at its end.
    pub to: Stand,
    /// How much of the change is done at the leg's start and at its end, 0 to 1.
    pub share: (f64, f64),
}

impl Turn {
    /// A part of the change from the key before to the key after.
    pub fn of_keys(from: f64, to: f64) -> Turn {
        Turn { from: Stand::Before, to: Stand::After(None), share: (from, to) }
    }

    /// No change.
    pub fn none(at: &Stand) -> Turn {
        Turn { from: at.clone(), to: at.clone(), share: (0.0, 0.0) }
    }

    /// The same the other way round.
    pub fn reversed(self) -> Turn {
        Turn { share: (1.0 - self.share.1, 1.0 - self.share.0), ..Turn { from: self.to, to: self.from, ..self } }
    }

    /// The posture that the leg ends in, as far as it is one of the two.
    pub(super) fn end(&self) -> &Stand {
        if self.share.1 >= 0.5 { &self.to } else { &self.from }
    }

    /// Whether anything changes.
    pub(super) fn changes(&self) -> bool {
        self.from != self.to
    }
}

/// In what order the fingers change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FingerOrder {
    /// At the same time.
    #[default]
    Together,
    /// The thumb first, the little finger last.
    TowardPinky,
    /// The little finger first, the thumb last.
    TowardThumb,
}

impl FingerOrder {
    /// The share of a leg's time at which a digit (0 is the thumb) is, when the leg is at `share`.
    pub fn share(self, digit: usize, share: f64) -> f64 {
        // Each finger takes two fifths of the time, the last one begins when three fifths are over.
        let begins = |place: usize| 0.15 * place.min(4) as f64;
        let own = |place: usize| ((share - begins(place)) / 0.4).clamp(0.0, 1.0);
        match self {
            FingerOrder::Together => share,
            FingerOrder::TowardPinky => own(digit),
            FingerOrder::TowardThumb => own(4 - digit.min(4)),
        }
    }
}

/// A wrist movement to and fro during a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WristPlay {
    /// Which.
    pub motion: WristMotion,
    /// Radians to each side.
    pub amplitude: f64,
    /// Whole cycles during its time; below 0 they run backwards.
    pub cycles: f64,
    /// Share of a cycle that this hand is ahead.
    pub phase: f64,
    /// The shares of its time at the leg's start and end: 0 and 1 where it plays for the whole leg.
    pub part: (f64, f64),
}

impl WristPlay {
    fn reversed(self) -> WristPlay {
        WristPlay { cycles: -self.cycles, part: (1.0 - self.part.1, 1.0 - self.part.0), ..self }
    }
}

/// Playing fingers during a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wiggle {
    /// Which fingers.
    pub digits: Digits,
    /// Radians at the knuckle, from one extreme to the other.
    pub amplitude: f64,
    /// Whole cycles during its time; below 0 they run backwards.
    pub cycles: f64,
    /// The shares of its time at the leg's start and end: 0 and 1 where it plays for the whole leg.
    pub part: (f64, f64),
}

impl Wiggle {
    fn reversed(self) -> Wiggle {
        Wiggle { cycles: -self.cycles, part: (1.0 - self.part.1, 1.0 - self.part.0), ..self }
    }
}

/// The share of a change that is done at a share of a leg's time.
pub fn done_at(share: (f64, f64), time: f64, easing: Easing) -> f64 {
    share.0 + (share.1 - share.0) * easing.weight(time)
}

/// How long legs last together, seconds.
pub(super) fn whole(legs: &[Leg]) -> f64 {
    legs.iter().map(|leg| leg.duration).sum()
}
