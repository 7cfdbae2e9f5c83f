//! One value laid out in time: a curve through a few postures of face and body.

use crate::body::signer::{Shoulder, Turn};
use crate::motion::easing::smoothstep;
use crate::phonology::Channel;
use crate::phonology::expression::Step;

/// One value of a non-manual tier over a span of time.
#[derive(Debug, Clone)]
pub struct Cue {
    /// The tier.
    pub channel: Channel,
    pub(super) hold: Hold,
    pub(super) shapes: Vec<Shape>,
    pub(super) keys: Vec<Key>,
}

/// How a turn of head or eyes is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    /// Relative to what carries it.
    Carried,
    /// In space: eyes that look there go on looking there while the head turns.
    InSpace,
    /// A movement to and fro, through which eyes keep their aim.
    Beating,
    /// The head goes where the eyes go.
    WithGaze,
}

/// A posture that a cue goes through.
#[derive(Debug, Clone, Default)]
pub(super) struct Shape {
    /// Numbers of morphs and their weights.
    pub morphs: Vec<(usize, f64)>,
    pub turn: Turn,
    pub push: f64,
    pub shoulders: [Shoulder; 2],
}

/// At this instant the cue shows this share of a shape.
#[derive(Debug, Clone, Copy)]
pub(super) struct Key {
    pub at: f64,
    pub shape: usize,
    pub level: f64,
}

/// What the non-manual tiers do at one instant.
#[derive(Debug, Clone, Default)]
pub struct NonManualState {
    /// Numbers of morphs and weights; a number may come twice, the weights add up.
    pub morphs: Vec<(usize, f64)>,
    /// The head's turn.
    pub head: Turn,
    /// How far the head is pushed forward, radians of the neck.
    pub push: f64,
    /// The trunk's turn.
    pub torso: Turn,
    /// The eyes' turn in the head.
    pub eyes: Turn,
    /// The left and the right shoulder.
    pub shoulders: [Shoulder; 2],
    /// The part of the head's turn that goes to and fro.
    pub(super) beating: Turn,
    /// How much is said of the gaze, and how much of that holds in space; 0 to 1.
    pub(super) gaze: [f64; 2],
}

impl Shape {
    /// A step of the inventory on a rig with these morphs; what the rig lacks shows nothing.
    pub fn of(step: &Step, names: &[String]) -> Shape {
        let number = |name: &String| names.iter().position(|own| own == name);
        let morphs = step.morphs.iter().filter_map(|(name, weight)| Some((number(name)?, f64::from(*weight))));
        let (pitch, yaw, roll) = step.turn;
        let shoulder =
            |raised: f64, forward: f64| Shoulder { raised: raised.to_radians(), forward: forward.to_radians() };
        Shape {
            morphs: morphs.collect(),
            turn: Turn { pitch: pitch.to_radians(), yaw: yaw.to_radians(), roll: roll.to_radians() },
            push: step.push.to_radians(),
            shoulders: [shoulder(step.raise.0, step.hunch.0), shoulder(step.raise.1, step.hunch.1)],
        }
    }

    /// Adds a share of another shape.
    pub fn add(&mut self, other: &Shape, share: f64) {
        for (morph, weight) in &other.morphs {
            match self.morphs.iter_mut().find(|(own, _)| own == morph) {
                Some((_, own)) => *own += weight * share,
                None => self.morphs.push((*morph, weight * share)),
            }
        }
        turned(&mut self.turn, other.turn, share);
        self.push += other.push * share;
        moved(&mut self.shoulders, &other.shoulders, share);
    }
}

impl Cue {
    /// When it begins and ends to be seen, seconds.
    pub fn span(&self) -> (f64, f64) {
        let at = |key: Option<&Key>| key.map_or(0.0, |k| k.at);
        (at(self.keys.first()), at(self.keys.last()))
    }

    /// Adds what it does at an instant.
    pub(super) fn add_to(&self, state: &mut NonManualState, time: f64) {
        let next = self.keys.partition_point(|key| key.at <= time);
        let (Some(a), Some(b)) = (next.checked_sub(1).and_then(|i| self.keys.get(i)), self.keys.get(next)) else {
            return;
        };
        let share = smoothstep((time - a.at) / (b.at - a.at));
        let (from, to) = (a.level * (1.0 - share), b.level * share);
        if a.shape == b.shape {
            self.show(a.shape, from + to, state);
        } else {
            self.show(a.shape, from, state);
            self.show(b.shape, to, state);
        }
    }

    fn show(&self, shape: usize, level: f64, state: &mut NonManualState) {
        let Some(shape) = self.shapes.get(shape).filter(|_| level != 0.0) else { return };
        state.morphs.extend(shape.morphs.iter().map(|(morph, weight)| (*morph, weight * level.max(0.0))));
        moved(&mut state.shoulders, &shape.shoulders, level);
        state.push += shape.push * level;
        match self.channel {
            Channel::Torso => turned(&mut state.torso, shape.turn, level),
            Channel::Gaze => {
                turned(&mut state.eyes, shape.turn, level);
                state.gaze[0] += level;
                if self.hold == Hold::InSpace {
                    state.gaze[1] += level;
                }
            }
            Channel::Head
            | Channel::Shoulders
            | Channel::Brows
            | Channel::Lids
            | Channel::Nose
            | Channel::Cheeks
            | Channel::Mouth => {
                turned(&mut state.head, shape.turn, level);
                if self.hold == Hold::Beating {
                    turned(&mut state.beating, shape.turn, level);
                }
            }
        }
    }
}

/// Adds a share of a turn.
pub(super) fn turned(turn: &mut Turn, by: Turn, share: f64) {
    turn.pitch += by.pitch * share;
    turn.yaw += by.yaw * share;
    turn.roll += by.roll * share;
}

fn moved(shoulders: &mut [Shoulder; 2], by: &[Shoulder; 2], share: f64) {
    for (own, by) in shoulders.iter_mut().zip(by) {
        own.raised += by.raised * share;
        own.forward += by.forward * share;
    }
}
