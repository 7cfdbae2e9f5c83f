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
/// The end of a finger that plays goes no farther than this, metres.
const MOST_PLAY_M: f64 = 0.065;
/// A finger that plays turns back at least so often, seconds.
const PLAY_S: f64 = 0.28;
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
    let reversals = series.each_ref().map(|s| extremes(s, LEAST_TURN).len());
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

/// Where a series is known to have turned back, each time at least so far from the extreme before.
fn extremes(values: &[f64], least: f64) -> Vec<usize> {
    let Some(&first) = values.first() else { return Vec::new() };
    let (mut low, mut high, mut rising, mut turned) = (first, first, None, Vec::new());
    for (n, &value) in values.iter().enumerate() {
        (low, high) = (low.min(value), high.max(value));
        match rising {
            None if value - low > least => (rising, high) = (Some(true), value),
            None if high - value > least => (rising, low) = (Some(false), value),
            Some(true) if high - value > least => {
                (rising, low) = (Some(false), value);
                turned.push(n);
            }
            Some(false) if value - low > least => {
                (rising, high) = (Some(true), value);
                turned.push(n);
            }
            None | Some(_) => {}
        }
    }
    turned
}

/// The fingers that play between two frames; none where there is no such play.
pub(super) fn fingers(seen: &Seen, from: usize, to: usize) -> Digits {
    let plays = |digit: &Digit| {
        let height: Vec<f64> = (from..=to).map(|i| seen.signals.forms[i].tip(*digit).y).collect();
        let turned = extremes(&height, LEAST_PLAY_M);
        let tip = |i: usize| seen.signals.forms[i].tip(*digit);
        let far = (from..=to).map(|i| tip(i).distance(tip(from))).fold(0.0, f64::max);
        // Fingers that take on one shape after another go farther and turn back less often than those that play.
        far < MOST_PLAY_M
            && turned.len() >= 3
            && (turned[turned.len() - 1] - turned[0]) as f64 / (turned.len() - 1) as f64
                <= PLAY_S * seen.signals.fps.get()
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
