//! Movement: what the hand does between its stops, the way of its palm first, then wrist and fingers.
//!
//! A move of the palm that is no more than the hand turning about another of its points (a fingertip, the wrist) is no way but a
//! turn. Moves that come again are told once, with how often (`repetition`).

use super::moves::{Move, Thresholds, moves};
use super::repetition::{Part, joined};
use super::shape::{LEAST_WAY_M, shape_of};
use super::{Seen, Value, play};
use crate::motion::profile::length;
use crate::phonology::{Action, Motion, Movement};
use glam::DVec3;

/// Stillness and moves of the palm, metres a second.
const GOING: Thresholds = Thresholds { still: 0.03, least: 0.08, valley: 0.35 };
/// Shorter stretches between two ways are none, seconds.
const LEAST_S: f64 = 0.12;
/// A hand turns about a point that goes less than this part of the palm's way.
const PIVOT: f64 = 0.4;
/// A hand that turns farther than this changes, radians (15°).
const TURNS: f64 = 0.26;
/// A hand changes whose digits' ends go farther than this, metres.
const FORMS_M: f64 = 0.012;

/// The movements of a stretch, in order.
pub(super) fn movements(seen: &Seen) -> Vec<Value<Movement>> {
    if seen.end <= seen.start {
        return Vec::new();
    }
    let parts = joined(parts(seen));
    let value = |part: Part| Value {
        start: seen.time(part.from),
        end: seen.time(part.to),
        value: part.movement,
        off: part.off,
    };
    parts.into_iter().map(value).collect()
}

/// The moves one by one, ways and what lies between them.
fn parts(seen: &Seen) -> Vec<Part> {
    let all = moves(&seen.signals.path_speed, GOING);
    let ways: Vec<Part> =
        all.iter().filter(|m| m.peak > seen.start && m.peak < seen.end).filter_map(|m| way(seen, m)).collect();
    let mut parts = Vec::new();
    let mut at = seen.start;
    let long = |from: usize, to: usize| to > from && (to - from) as f64 / seen.signals.fps.get() > LEAST_S;
    for way in ways {
        if long(at, way.from) {
            parts.extend(in_place(seen, at, way.from));
        }
        at = way.to;
        parts.push(way);
    }
    if long(at, seen.end) {
        parts.extend(in_place(seen, at, seen.end));
    }
    parts
}

/// One move of the palm, where it is a way.
fn way(seen: &Seen, of: &Move) -> Option<Part> {
    let (from, to) = (of.start.max(seen.start), of.end.min(seen.end));
    let signals = seen.signals;
    let palm = &signals.palm[from..=to];
    let whole = length(palm);
    let pivots = [&signals.wrist, &signals.front].iter().any(|point| length(&point[from..=to]) < PIVOT * whole);
    if whole < LEAST_WAY_M || (pivots && whole < 0.1) {
        return None;
    }
    let drawn = shape_of(palm)?;
    let movement = Movement::Action(Box::new(Action::new(drawn.motion)));
    Some(Part { from, to, movement: with_play(seen, from, to, movement), chord: drawn.chord, off: drawn.off })
}

/// A way with what wrist and fingers do meanwhile.
fn with_play(seen: &Seen, from: usize, to: usize, way: Movement) -> Movement {
    let playing = play::fingers(seen, from, to);
    let mut all = vec![way];
    if !playing.is_empty() {
        all.push(Movement::Action(Box::new(Action::new(Motion::Wiggle(playing)))));
    }
    if let Some(play) = play::wrist(seen, from, to) {
        all.push(play.movement());
    }
    if all.len() == 1 { all.remove(0) } else { Movement::Together(all) }
}

/// What a hand does that goes nowhere: its wrist or its fingers play, it changes, or it holds.
fn in_place(seen: &Seen, from: usize, to: usize) -> Option<Part> {
    let part = |motion: Motion| Part {
        from,
        to,
        movement: Movement::Action(Box::new(Action::new(motion))),
        chord: DVec3::ZERO,
        off: 0.0,
    };
    if let Some(play) = play::wrist(seen, from, to) {
        return Some(Part { movement: play.movement(), ..part(Motion::Hold) });
    }
    let playing = play::fingers(seen, from, to);
    if !playing.is_empty() {
        return Some(part(Motion::Wiggle(playing)));
    }
    let signals = seen.signals;
    let turned = crate::motion::rotation::angle_between(signals.rotations[from], signals.rotations[to]);
    let formed = play::formed(&signals.forms[from], &signals.forms[to]);
    Some(part(if turned > TURNS || formed > FORMS_M { Motion::Change } else { Motion::Hold }))
}
