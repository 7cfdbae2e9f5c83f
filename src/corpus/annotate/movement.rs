//! Movement: what the hand does between its stops, the way of its palm first, then wrist and fingers.
//!
//! A move of the palm that is no more than the hand turning about another of its points (a fingertip, the wrist) is no way but a
//! turn. Moves that come again are told once, with how often (`repetition`).

use super::moves::{Move, Thresholds, moves};
use super::repetition::{Part, joined};
use super::shape::{LEAST_WAY_M, shape_of};
use super::{Seen, Value, play};
use crate::body::landmarks::ContactPoint;
use crate::body::measure::HandForm;
use crate::motion::profile::length;
use crate::motion::rotation::angle_between;
use crate::phonology::{Action, Motion, Movement};
use glam::DVec3;

/// Stillness and moves of the palm, metres a second.
const GOING: Thresholds = Thresholds { still: 0.03, least: 0.08, valley: 0.35 };
/// Shorter stretches between two ways are none, seconds.
const LEAST_S: f64 = 0.12;
/// A hand turns about a point that goes less than this part of the palm's way, where that is short.
const PIVOT: f64 = 0.4;
/// A point stands that goes less than this part of the palm's way.
const STANDS: f64 = 0.2;
/// A hand that turns farther on its way has points with different ways, radians (6°).
const TURNS_ON_ITS_WAY: f64 = 0.1;
/// How much plainer the way of another point must be than the palm's, as a part of the way.
const NOT_THE_PALM: f64 = 0.015;
/// A hand that turns farther than this changes, radians (15°).
const TURNS: f64 = 0.26;
/// A hand changes whose digits' ends go farther than this, metres.
const FORMS_M: f64 = 0.012;

/// The movements of a stretch, in order: each move for itself, and those that come again as one.
pub(super) struct Movements {
    pub moves: Vec<Value<Movement>>,
    pub joined: Vec<Value<Movement>>,
}

/// The movements of a stretch; `own` finds the point with which a form touches.
pub(super) fn movements(seen: &Seen, own: &impl Fn(&HandForm) -> Option<ContactPoint>) -> Movements {
    if seen.end <= seen.start {
        return Movements { moves: Vec::new(), joined: Vec::new() };
    }
    let value = |part: &Part| Value {
        start: seen.time(part.from),
        end: seen.time(part.to),
        value: part.movement.clone(),
        off: part.off,
    };
    let parts = parts(seen, own);
    Movements { moves: parts.iter().map(value).collect(), joined: joined(parts).iter().map(value).collect() }
}

/// The moves one by one, ways and what lies between them.
fn parts(seen: &Seen, own: &impl Fn(&HandForm) -> Option<ContactPoint>) -> Vec<Part> {
    let all = moves(&seen.signals.path_speed, GOING);
    let inside: Vec<Move> = all.into_iter().filter(|m| m.peak > seen.start && m.peak < seen.end).collect();
    let ways = rounded(seen, &inside).into_iter().filter_map(|m| way(seen, &m, own));
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
    // The holds before and after what a hand does are phases, and no movements.
    let held = |part: &Part| matches!(&part.movement, Movement::Action(action) if action.motion == Motion::Hold);
    if parts.iter().any(|part| !held(part)) {
        let first = parts.iter().position(|part| !held(part)).unwrap_or(0);
        let last = parts.iter().rposition(|part| !held(part)).unwrap_or(parts.len() - 1);
        parts = parts[first..=last].to_vec();
    }
    parts
}

/// Moves with those made one that draw something round together: narrow ellipses are slow at their ends.
fn rounded(seen: &Seen, moves: &[Move]) -> Vec<Move> {
    let palm = &seen.signals.palm;
    let is_round = |from: usize, to: usize| {
        let drawn = shape_of(&palm[from..=to]);
        drawn.is_some_and(|d| matches!(d.motion, Motion::Circle { .. }) && d.unlike < 0.12)
    };
    let mut out: Vec<Move> = Vec::new();
    let mut rest = moves;
    while let [first, ..] = rest {
        // Two or three moves without a stop between them, none of them round.
        let joins = |n: &usize| {
            let some = &rest[..*n];
            let flows = some.windows(2).all(|w| w[1].start <= w[0].end + 1);
            flows && !some.iter().any(|m| is_round(m.start, m.end)) && is_round(first.start, some[n - 1].end)
        };
        let taken = (2..=rest.len().min(3)).find(joins).unwrap_or(1);
        let fastest = rest[..taken].iter().max_by(|a, b| {
            let speed = |m: &Move| seen.signals.path_speed[m.peak];
            speed(a).total_cmp(&speed(b))
        });
        out.push(Move { start: first.start, peak: fastest.unwrap_or(first).peak, end: rest[taken - 1].end });
        rest = &rest[taken..];
    }
    out
}

/// One move of the hand, where it is a way.
///
/// The hand that turns on its way has points with many ways: that of the plainest shape is told.
fn way(seen: &Seen, of: &Move, own: &impl Fn(&HandForm) -> Option<ContactPoint>) -> Option<Part> {
    let (from, to) = (of.start.max(seen.start), of.end.min(seen.end));
    let signals = seen.signals;
    let palm = &signals.palm[from..=to];
    let whole = length(palm);
    if whole < LEAST_WAY_M {
        return None;
    }
    let touching = [from, to].into_iter().filter_map(|i| own(&signals.forms[i]));
    let followed = |point: ContactPoint| -> Vec<DVec3> {
        (from..=to).map(|i| point.position(&seen.models[i]) - signals.origins[i]).collect()
    };
    let mut ways = vec![palm.to_vec(), signals.wrist[from..=to].to_vec(), signals.front[from..=to].to_vec()];
    ways.extend(touching.map(followed));
    let turned = angle_between(signals.rotations[from], signals.rotations[to]) > TURNS_ON_ITS_WAY
        || play::formed(&signals.forms[from], &signals.forms[to]) > FORMS_M;
    let still = |way: &Vec<DVec3>| {
        let own = length(way);
        own < STANDS * whole || own < PIVOT * whole && whole < 0.1
    };
    if turned && ways.iter().any(still) || play::wrist(seen, from, to).is_some() && ways.iter().any(still) {
        return None;
    }
    let candidates = if turned { &ways[..] } else { &ways[..1] };
    let drawn = candidates.iter().enumerate().filter_map(|(n, way)| {
        let drawn = shape_of(way)?;
        // The palm's way unless another is plainer; a short way of another point says little.
        let aside = if n == 0 { 0.0 } else { NOT_THE_PALM + (whole / length(way).max(1e-9) - 1.0).max(0.0) * 0.02 };
        Some((drawn.unlike + aside, drawn))
    });
    let (_, drawn) = drawn.min_by(|a, b| a.0.total_cmp(&b.0))?;
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
        // A palm that swings with its wrist draws no waves of its own.
        if let Movement::Action(action) = &mut all[0]
            && let Motion::Straight { overlay, .. } = &mut action.motion
        {
            *overlay = None;
        }
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
    let turned = angle_between(signals.rotations[from], signals.rotations[to]);
    let formed = play::formed(&signals.forms[from], &signals.forms[to]);
    Some(part(if turned > TURNS || formed > FORMS_M { Motion::Change } else { Motion::Hold }))
}
