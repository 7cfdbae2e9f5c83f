//! The curves of values: held, to and fro, through steps, following a hand.

use super::cue::{Cue, Hold, Key, Shape};
use crate::body::signer::Turn;
use crate::phonology::Channel;
use crate::phonology::expression::Expression;
use glam::DVec3;

/// A movement to and fro takes at least so long, seconds.
const LEAST_BEAT: f64 = 0.1;
/// Each beat of a nod or shake is a little smaller than the one before; the last one has this share of the first.
const LAST_BEAT: f64 = 0.7;

/// Seconds in which a value comes and goes: eyes jump, heads swing, trunks lean.
fn ramp(channel: Channel) -> f64 {
    match channel {
        Channel::Gaze => 0.08,
        Channel::Lids => 0.12,
        Channel::Mouth => 0.16,
        Channel::Brows | Channel::Nose | Channel::Cheeks => 0.2,
        Channel::Shoulders => 0.25,
        Channel::Head => 0.28,
        Channel::Torso => 0.36,
    }
}

/// When, how much and how fast.
#[derive(Debug, Clone, Copy)]
pub struct Span {
    /// The tier.
    pub channel: Channel,
    /// Seconds.
    pub start: f64,
    /// Seconds.
    pub end: f64,
    /// How much of the inventory's value.
    pub level: f64,
    /// How fast it comes, beats and goes; 1 is usual.
    pub pace: f64,
}

impl Span {
    /// Comes around the start, stays, goes around the end; neighbours cross at half their height between them.
    pub fn held(&self, shape: Shape, hold: Hold) -> Cue {
        self.through(vec![(shape, self.start, self.end)], hold)
    }

    /// Shapes that each stay from a start to an end.
    fn through(&self, shapes: Vec<(Shape, f64, f64)>, hold: Hold) -> Cue {
        let least = shapes.iter().map(|(_, a, b)| b - a).fold(f64::INFINITY, f64::min);
        let half = (ramp(self.channel) / self.pace).min(least) / 2.0;
        // Where ramps meet, the second key is a hair later.
        let hair = half * 0.02;
        let mut keys = vec![Key { at: self.start - half, shape: 0, level: 0.0 }];
        for (n, (_, a, b)) in shapes.iter().enumerate() {
            keys.push(Key { at: a + half, shape: n, level: self.level });
            keys.push(Key { at: (b - half).max(a + half + hair), shape: n, level: self.level });
        }
        keys.push(Key { at: self.end + half, shape: shapes.len().saturating_sub(1), level: 0.0 });
        let shapes = shapes.into_iter().map(|(shape, ..)| shape).collect();
        Cue { channel: self.channel, hold, shapes, keys }
    }

    /// To and fro: to both sides for a shake, there and back for a nod.
    pub fn beating(&self, row: &Expression, shape: Shape) -> Cue {
        let (cycles, period) = self.cycles(row.beats, row.times);
        let fading = self.channel == Channel::Head && cycles > 1;
        let mut keys = vec![Key { at: self.start, shape: 0, level: 0.0 }];
        for n in 0..cycles {
            let share = if fading { 1.0 - (1.0 - LAST_BEAT) * f64::from(n) / f64::from(cycles - 1) } else { 1.0 };
            let mut key = |phase: f64, level: f64| {
                keys.push(Key {
                    at: self.start + (f64::from(n) + phase) * period,
                    shape: 0,
                    level: level * self.level,
                });
            };
            if row.swings() {
                key(0.25, share);
                key(0.75, -share);
            } else {
                key(0.5, share);
                key(1.0, 0.0);
            }
        }
        if row.swings() {
            keys.push(Key { at: self.start + f64::from(cycles) * period, shape: 0, level: 0.0 });
        }
        Cue { channel: self.channel, hold: Hold::Beating, shapes: vec![shape], keys }
    }

    /// Through steps once in the time of the value, or again and again.
    pub fn stepping(&self, steps: Vec<(Shape, f64)>, beats: Option<(f64, u32)>) -> Cue {
        let whole: f64 = steps.iter().map(|(_, share)| share).sum();
        let Some((beats, times)) = beats else {
            let mut at = self.start;
            let part = |(shape, share): (Shape, f64)| {
                let from = at;
                at += share / whole * (self.end - self.start);
                (shape, from, at)
            };
            let shapes = steps.into_iter().map(part).collect();
            return self.through(shapes, Hold::Carried);
        };
        let (cycles, period) = self.cycles(beats, times);
        let mut keys = vec![Key { at: self.start - period / 4.0, shape: 0, level: 0.0 }];
        let mut at = self.start;
        for _ in 0..cycles {
            for (n, (_, share)) in steps.iter().enumerate() {
                let part = share / whole * period;
                keys.push(Key { at: at + part / 2.0, shape: n, level: self.level });
                at += part;
            }
        }
        keys.push(Key { at: at + period / 4.0, shape: steps.len().saturating_sub(1), level: 0.0 });
        let shapes = steps.into_iter().map(|(shape, _)| shape).collect();
        Cue { channel: self.channel, hold: Hold::Beating, shapes, keys }
    }

    /// Eyes on a moving hand; straight ahead where no hand acts.
    pub fn following(&self, seen: &[(f64, DVec3)]) -> Cue {
        if seen.is_empty() {
            return self.held(Shape::default(), Hold::InSpace);
        }
        let half = (ramp(self.channel) / self.pace).min(self.end - self.start) / 2.0;
        let (first, last) = (self.start + half, (self.end - half).max(self.start + half + 1e-3));
        let mut keys = vec![Key { at: self.start - half, shape: 0, level: 0.0 }];
        let mut shapes = Vec::new();
        for (n, (at, direction)) in seen.iter().enumerate() {
            shapes.push(Shape { turn: turn_towards(*direction, self.channel), ..Shape::default() });
            let after = keys.last().map_or(first, |k: &Key| k.at + 1e-3);
            let at = if n == 0 { first } else { at.clamp(first, last) };
            keys.push(Key { at: at.max(after), shape: n, level: self.level });
        }
        let end = keys.last().map_or(last, |k| k.at.max(last) + 1e-3);
        keys.push(Key { at: end, shape: shapes.len() - 1, level: self.level });
        keys.push(Key { at: end + 2.0 * half, shape: shapes.len() - 1, level: 0.0 });
        Cue { channel: self.channel, hold: Hold::InSpace, shapes, keys }
    }

    /// How many cycles there is time for, and how long one takes, seconds.
    fn cycles(self, beats: f64, times: u32) -> (u32, f64) {
        let time = self.end - self.start;
        let period = (1.0 / (beats * self.pace)).max(LEAST_BEAT);
        // A last cycle that three quarters of the time are there for is made, a little fast.
        let fit = (time / period + 0.25).floor().clamp(1.0, 10_000.0) as u32;
        let cycles = if times > 0 { fit.min(times) } else { fit };
        (cycles, period.min((time / f64::from(cycles)).max(LEAST_BEAT)))
    }
}

/// The turn that looks along a direction; heads and trunks go only part of the way.
pub fn turn_towards(direction: DVec3, channel: Channel) -> Turn {
    let d = direction.normalize_or(DVec3::Z);
    let level = (d.x * d.x + d.z * d.z).sqrt();
    let (share, most) = match channel {
        Channel::Gaze => (1.0, 40f64.to_radians()),
        Channel::Head => (0.6, 45f64.to_radians()),
        Channel::Torso
        | Channel::Shoulders
        | Channel::Brows
        | Channel::Lids
        | Channel::Nose
        | Channel::Cheeks
        | Channel::Mouth => (0.3, 20f64.to_radians()),
    };
    let limit = |angle: f64| (angle * share).clamp(-most, most);
    Turn { pitch: limit((-d.y).atan2(level)), yaw: limit(d.x.atan2(d.z)), roll: 0.0 }
}
