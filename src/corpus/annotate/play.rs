//! Secondary movements: the wrist to and fro (nod, swing, twist, stirring), and fingers that play.

use super::Seen;
use crate::body::measure::HandForm;
use crate::motion::rotation::to_vector;
use crate::phonology::{Action, Digit, Digits, Motion, Movement, Size, WristMotion};
use glam::DVec3;

/// Extremes of a wrist's play are at least so far apart, radians (7°).
const LEAST_TURN: f64 = 0.12;
/// Extremes of a finger's play are at least so far apart at its end, metres.
const LEAST_PLAY_M: f64 = 0.012;
/// A hand stirs whose smaller turn of two is at least this part of the larger one.
const STIRS: f64 = 0.5;

/// A wrist's play: what, how often there and back, and how far to each side, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Play {
    pub motion: WristMotion,
    pub cycles: f64,
    pub amplitude: f64,
}

impl Play {
    /// As a movement.
    pub fn movement(self) -> Movement {
        let small = match self.motion {
            WristMotion::Nod => (15.0, 27.0),
            WristMotion::Twist => (18.0, 35.0),
            WristMotion::Swing | WristMotion::StirClockwise | WristMotion::StirCounterclockwise => (11.0, 18.0),
        };
        let degrees = self.amplitude.to_degrees();
        let size = if degrees < small.0 {
            Size::Small
        } else if degrees < small.1 {
            Size::Normal
        } else {
            Size::Large
        };
        Movement::Action(Box::new(Action::new(Motion::Wrist(self.motion, size))))
    }
}

/// The play of the wrist between two frames, if there is one.
pub(super) fn wrist(seen: &Seen, from: usize, to: usize) -> Option<Play> {
    let signals = seen.signals;
    let out = signals.side.sign();
    let first = signals.rotations[from];
    let turns: Vec<DVec3> = (from..=to).map(|i| to_vector(first.inverse() * signals.rotations[i])).collect();
    // Flexion, radial deviation and the turn about the forearm, in the hand's axes.
    let series = [-DVec3::Z * out, -DVec3::Y * out, -DVec3::X]
        .map(|axis| turns.iter().map(|t| t.dot(axis)).collect::<Vec<f64>>());
    let ranges = series.each_ref().map(|s| range(s));
    let reversals = series.each_ref().map(|s| extremes(s, LEAST_TURN));
    let main = (0..3).max_by(|a, b| ranges[*a].total_cmp(&ranges[*b]))?;
    // A turn that leads on is no play, however it swings on its way.
    let net = turns.last()?.length();
    if reversals[main] < 3 || ranges[main] < LEAST_TURN || net > 0.6 * ranges[main] {
        return None;
    }
    let cycles = reversals[main] as f64 / 2.0;
    let amplitude = ranges[main] / 2.0;
    let motion = match main {
        2 => WristMotion::Twist,
        _ if ranges[1 - main] > STIRS * ranges[main] && reversals[1 - main] >= 2 => stirs(&series, out),
        0 => WristMotion::Nod,
        _ => WristMotion::Swing,
    };
    Some(Play { motion, cycles, amplitude })
}

/// Which way a hand stirs: the area that flexion and deviation draw.
fn stirs(series: &[Vec<f64>; 3], out: f64) -> WristMotion {
    let (flexion, radial) = (&series[0], &series[1]);
    let area: f64 =
        (1..flexion.len()).map(|i| flexion[i - 1] * radial[i] * out - flexion[i] * radial[i - 1] * out).sum();
    if area < 0.0 { WristMotion::StirClockwise } else { WristMotion::StirCounterclockwise }
}

fn range(values: &[f64]) -> f64 {
    let (least, most) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
    most - least
}

/// How many extremes a series has that are at least so far from the one before.
pub(super) fn extremes(values: &[f64], least: f64) -> usize {
    let Some(&first) = values.first() else { return 0 };
    let (mut low, mut high, mut rising, mut count) = (first, first, None, 0);
    for &value in values {
        (low, high) = (low.min(value), high.max(value));
        match rising {
            None if value - low > least => (rising, high, count) = (Some(true), value, count),
            None if high - value > least => (rising, low, count) = (Some(false), value, count),
            Some(true) if high - value > least => (rising, low, count) = (Some(false), value, count + 1),
            Some(false) if value - low > least => (rising, high, count) = (Some(true), value, count + 1),
            None | Some(_) => {}
        }
    }
    count
}

/// The fingers that play between two frames; none where there is no such play.
pub(super) fn fingers(seen: &Seen, from: usize, to: usize) -> Digits {
    let plays = |digit: &Digit| {
        let height: Vec<f64> = (from..=to).map(|i| seen.signals.forms[i].tip(*digit).y).collect();
        extremes(&height, LEAST_PLAY_M) >= 3
    };
    Digits::of(Digit::FINGERS.into_iter().filter(plays))
}

/// Whether a movement has fingers that play.
pub(super) fn wiggles(movement: &Movement) -> bool {
    movement.any_action(&|action| matches!(action.motion, Motion::Wiggle(_)))
}

/// How far the forms of two frames are apart at the digits' ends, at most, metres.
pub(super) fn formed(a: &HandForm, b: &HandForm) -> f64 {
    a.tips_apart(b)
}
