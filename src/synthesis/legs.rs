//! Movements laid out in time: an interval's movement becomes legs, one after the other.
//!
//! Repetitions become legs: there, back, there again. What goes on at the same time becomes one list of legs
//! (`together`). Postures change evenly from the key before to the key after; where an action says what it becomes, it
//! is that action's legs that change them, from stop to stop. Times are those of `grammar/movements.ron`.

use super::leg::whole;
pub use super::leg::{FingerOrder, Leg, LegEnd, Stand, Stop, Turn, Wiggle, WristPlay};
use super::path::Path;
use super::repeat::Again;
use super::shape::{duration_of, pace, path_of};
use crate::phonology::movement_table::MovementTable;
use crate::phonology::symmetry::Turns;
use crate::phonology::{Action, Becoming, Digits, Manner, Motion, Movement};
use std::sync::Arc;

/// No interval has more legs: repetitions in repetitions come to an end.
pub const MOST_LEGS: usize = 400;
/// How far a hand bounces back, as a part of the way that it came.
const REBOUND: f64 = 0.25;
/// How long it takes to, seconds.
const REBOUND_S: f64 = 0.24;

/// Lays out the movement of one interval.
///
/// The legs last together as long as the movement; there is at least one.
pub fn lay_out(movement: &Movement, table: &MovementTable, turns: Turns) -> Vec<Leg> {
    let changes = |action: &Action| action.becoming.as_deref().is_some_and(changes_posture);
    let postures = if movement.any_action(&changes) { Postures::AtStops } else { Postures::Evenly };
    let layout = Layout { table, turns, postures };
    let mut legs = layout.legs(movement, &Stand::Before);
    legs.truncate(MOST_LEGS);
    if legs.is_empty() {
        legs.push(change(table.timing.change));
    }
    match postures {
        Postures::Evenly => {}
        Postures::AtStops => lead_to_the_key(&mut legs),
    }
    legs
}

/// A posture kept, or changed to the next key's, without a path.
pub fn change(duration: f64) -> Leg {
    Leg::still(duration, Turn::of_keys(0.0, 1.0))
}

/// Whether something becomes of shape or orientation.
fn changes_posture(becoming: &Becoming) -> bool {
    becoming.configuration.is_some() || becoming.orientation.is_some()
}

/// How an interval's legs change the posture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Postures {
    /// All of them from the key before to the key after.
    Evenly,
    /// Some actions say what the hand becomes.
    AtStops,
}

/// What movements are laid out with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layout<'t> {
    pub table: &'t MovementTable,
    pub turns: Turns,
    pub postures: Postures,
}

impl Layout<'_> {
    /// The legs of a movement that begins in a posture.
    pub(super) fn legs(&self, movement: &Movement, at: &Stand) -> Vec<Leg> {
        match movement {
            Movement::Action(action) => self.of_action(action, at),
            Movement::Sequence(parts) => self.sequence(parts, at),
            Movement::Repeated(group) => self.of_group(group, at),
            Movement::Backwards(inner) => backwards(self.legs(inner, at)),
            Movement::Together(parts) => self.together(parts, at),
            Movement::Fused(parts) => match super::together::first_repeating(parts) {
                Some((action, once)) => {
                    let again = Again::of(action.repetition, self.turns.behind(action));
                    self.again(&again, at, &|at| self.fused(&once, at))
                }
                None => self.fused(parts, at),
            },
        }
    }

    fn sequence(&self, parts: &[Movement], at: &Stand) -> Vec<Leg> {
        let mut legs: Vec<Leg> = Vec::new();
        let mut at = at.clone();
        let mut lengths = Vec::with_capacity(parts.len());
        for part in parts {
            if legs.len() > MOST_LEGS {
                break;
            }
            let before = legs.len();
            legs.extend(self.legs(part, &at).into_iter().map(|leg| Leg { end: leg.end.later(before), ..leg }));
            at = legs.last().map_or(at, |leg| leg.posture.end().clone());
            lengths.push((part, before..legs.len()));
        }
        if self.postures == Postures::Evenly {
            let shares = even_shares(&legs);
            for (part, range) in lengths {
                let (Some(first), Some(last)) = (shares.get(range.start), shares.get(range.end.saturating_sub(1)))
                else {
                    continue;
                };
                let (low, high) = (first.0, last.1);
                for (leg, even) in legs[range.clone()].iter_mut().zip(&shares[range]) {
                    // A group that repeats comes back to the posture that it began with.
                    let within = |share: f64| low + (high - low) * share;
                    leg.posture.share = match part {
                        Movement::Repeated(_) => (within(leg.posture.share.0), within(leg.posture.share.1)),
                        Movement::Action(_)
                        | Movement::Sequence(_)
                        | Movement::Together(_)
                        | Movement::Fused(_)
                        | Movement::Backwards(_) => *even,
                    };
                }
            }
        }
        legs
    }

    fn of_action(&self, action: &Action, at: &Stand) -> Vec<Leg> {
        let timing = &self.table.timing;
        let mut legs = Vec::new();
        if action.manner.contains(&Manner::Rest) {
            legs.push(Leg::still(timing.rest / pace(action), self.resting(at, 0.0)));
        }
        let before = legs.len();
        let again = Again::of(action.repetition, self.turns.behind(action));
        let own = self.again(&again, at, &|at| vec![self.leg_of(action, at)]);
        legs.extend(own.into_iter().map(|leg| Leg { end: leg.end.later(before), ..leg }));
        let end = legs.last().map_or(at, |leg| leg.posture.end()).clone();
        if action.manner.contains(&Manner::Bouncing) {
            let bounce = Leg::still(REBOUND_S / pace(action), self.resting(&end, 1.0));
            legs.push(Leg { end: LegEnd::Rebound(REBOUND), ..bounce });
        }
        if action.manner.contains(&Manner::Halt) {
            legs.push(Leg::still(timing.halt / pace(action), self.resting(&end, 1.0)));
        }
        legs
    }

    /// A posture that is kept: `share` says at which of the two keys, where postures change evenly.
    fn resting(&self, at: &Stand, share: f64) -> Turn {
        match self.postures {
            Postures::Evenly => Turn::of_keys(share, share),
            Postures::AtStops => Turn::none(at),
        }
    }

    /// One performance of an action.
    fn leg_of(&self, action: &Action, at: &Stand) -> Leg {
        let table = self.table;
        let behind = self.turns.behind(action);
        let duration = duration_of(action, table);
        let mut leg = Leg::still(duration, self.turn_of(action, at));
        leg.path = path_of(&action.motion, table, behind);
        leg.end = match (&action.target, &action.motion) {
            _ if action.becoming.as_ref().is_some_and(|b| b.contact.is_some()) => {
                action.becoming.as_ref().and_then(|b| b.contact).map_or(LegEnd::Displaced, LegEnd::Meeting)
            }
            (Some(target), _) => LegEnd::At(target.clone()),
            (None, Motion::Return { key }) => LegEnd::AtKey(*key),
            (None, _) => LegEnd::Displaced,
        };
        match &action.motion {
            Motion::Wrist(motion, size) => leg.wrist.push(WristPlay {
                motion: *motion,
                amplitude: table.wrist.amplitude(*motion, *size).to_radians(),
                cycles: (duration * table.wrist.frequency * pace(action)).round().max(1.0),
                phase: if behind { 0.5 } else { 0.0 },
                part: (0.0, 1.0),
            }),
            Motion::Wiggle(digits) => leg.wiggle.push(Wiggle {
                digits: if digits.is_empty() { Digits::FINGERS } else { *digits },
                amplitude: table.wiggle.amplitude.to_radians(),
                cycles: (duration * table.wiggle.frequency * pace(action)).round().max(1.0),
                part: (0.0, 1.0),
            }),
            Motion::Hold
            | Motion::Change
            | Motion::Return { .. }
            | Motion::Straight { .. }
            | Motion::Arc { .. }
            | Motion::Circle { .. } => {}
        }
        let order = |manner: &Manner| match manner {
            Manner::TowardPinky => Some(FingerOrder::TowardPinky),
            Manner::TowardThumb => Some(FingerOrder::TowardThumb),
            Manner::Fast | Manner::Slow | Manner::Tense | Manner::Rest | Manner::Halt | Manner::Bouncing => None,
        };
        leg.fingers = action.manner.iter().find_map(order).unwrap_or_default();
        leg.brushing.clone_from(&action.brushing);
        leg.names.clone_from(&action.names);
        leg
    }

    fn turn_of(&self, action: &Action, at: &Stand) -> Turn {
        match (self.postures, action.becoming.as_deref()) {
            (Postures::Evenly, _) => Turn::of_keys(0.0, 1.0),
            (Postures::AtStops, Some(becoming)) if changes_posture(becoming) => {
                let stop = Stop { from: at.clone(), becoming: becoming.clone() };
                Turn { from: at.clone(), to: Stand::Within(Arc::new(stop)), share: (0.0, 1.0) }
            }
            (Postures::AtStops, _) => Turn::none(at),
        }
    }

    /// Blended into one leg.
    fn fused(&self, parts: &[Movement], at: &Stand) -> Vec<Leg> {
        let legs = self.sequence(parts, at);
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return Vec::new() };
        let duration = whole(&legs) * 0.7;
        let posture = match self.postures {
            Postures::Evenly => Turn::of_keys(0.0, 1.0),
            Postures::AtStops => {
                Turn { from: first.posture.from.clone(), to: last.posture.end().clone(), share: (0.0, 1.0) }
            }
        };
        let mut joined = Leg::still(duration, posture);
        let mut paths = Vec::with_capacity(parts.len());
        for part in parts {
            let own = self.legs(part, at);
            paths.push(squeezed(&own));
            let longer = if whole(&own) > 0.0 { duration / whole(&own) } else { 1.0 };
            for leg in own {
                let leg = Leg { duration: leg.duration, ..leg }.stretched(longer);
                joined.wrist.extend(leg.wrist);
                joined.wiggle.extend(leg.wiggle);
                joined.brushing = leg.brushing.or(joined.brushing);
                joined.names = leg.names.or(joined.names);
                if leg.end.is_placed() {
                    joined.end = leg.end;
                }
            }
        }
        joined.path = Path::Fused(paths);
        vec![joined]
    }
}

/// The shares of the time of all legs at which each begins and ends.
fn even_shares(legs: &[Leg]) -> Vec<(f64, f64)> {
    let all = whole(legs).max(1e-9);
    let mut done = 0.0;
    legs.iter()
        .map(|leg| {
            let from = done / all;
            done += leg.duration;
            (from, done / all)
        })
        .collect()
}

/// Spreads the change of posture evenly over legs.
pub(super) fn evenly(legs: &mut [Leg]) {
    let shares = even_shares(legs);
    legs.iter_mut().zip(shares).for_each(|(leg, share)| leg.posture.share = share);
}

/// The legs after the last stop lead on to the key's posture; where there is none, the last change does.
fn lead_to_the_key(legs: &mut [Leg]) {
    let last = legs.iter().rposition(|leg| leg.posture.changes()).unwrap_or(0);
    let (before, trailing) = legs.split_at_mut(last + 1);
    let Some(changing) = before.last_mut() else { return };
    let end = changing.posture.end().clone();
    let stop = match &end {
        Stand::Within(stop) => Some(stop.clone()),
        Stand::Before | Stand::After(_) => None,
    };
    if trailing.is_empty() {
        changing.posture.to = Stand::After(stop);
        return;
    }
    evenly(trailing);
    for leg in trailing {
        leg.posture.from = end.clone();
        leg.posture.to = Stand::After(stop.clone());
    }
}

/// The displacement of legs as one path; what a place says is not in it.
pub(super) fn squeezed(legs: &[Leg]) -> Path {
    if let [only] = legs {
        return only.path.clone();
    }
    let (mut starts, mut at) = (Vec::with_capacity(legs.len()), glam::DVec3::ZERO);
    let mut parts = Vec::with_capacity(legs.len());
    for leg in legs {
        starts.push(at);
        let there = match &leg.end {
            LegEnd::StartOf(n) => starts.get(*n).copied(),
            LegEnd::Off(end, by) => match **end {
                LegEnd::StartOf(n) => starts.get(n).map(|start| *start + *by),
                _ => None,
            },
            LegEnd::Displaced
            | LegEnd::At(_)
            | LegEnd::Meeting(_)
            | LegEnd::Rebound(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey => None,
        };
        let end = there.unwrap_or(at + leg.path.end());
        let rest = end - at - leg.path.end();
        let path = match rest.length() > 1e-9 {
            true => Path::Sum(vec![leg.path.clone(), Path::Straight(rest)]),
            false => leg.path.clone(),
        };
        parts.push((leg.duration, path));
        at = end;
    }
    Path::Chain(parts)
}

/// The legs from the last to the first, each from its end to its start.
fn backwards(legs: Vec<Leg>) -> Vec<Leg> {
    let starts: Vec<LegEnd> = (0..legs.len()).map(|i| start_of(&legs, i)).collect();
    let reversed = legs.into_iter().zip(starts).rev();
    let mut legs: Vec<Leg> = reversed
        .map(|(leg, start)| {
            let was = leg.posture.clone();
            let leg = Leg { end: start, ..leg.reversed_in_time() };
            match (&was.from, &was.to) {
                // Played backwards between two keys, it still leads from the one before to the one after.
                (Stand::Before, Stand::After(None)) => {
                    Leg { posture: Turn::of_keys(1.0 - was.share.1, 1.0 - was.share.0), ..leg }
                }
                (Stand::Before | Stand::Within(_) | Stand::After(_), _) => leg,
            }
        })
        .collect();
    // The last stop of the way there is not where the way back begins.
    if let Some(first) = legs.first_mut().filter(|leg| matches!(leg.posture.from, Stand::Within(_))) {
        first.posture = Turn::none(first.posture.end());
    }
    legs
}

/// Where a leg began, said as the end of the same leg played backwards.
fn start_of(legs: &[Leg], leg: usize) -> LegEnd {
    let Some(before) = leg.checked_sub(1).map(|i| &legs[i]) else { return LegEnd::NextKey };
    match &before.end {
        LegEnd::At(place) => LegEnd::At(place.clone()),
        LegEnd::Meeting(contact) => LegEnd::Meeting(*contact),
        LegEnd::StartOf(earlier) => start_of(legs, *earlier),
        // Its own path leads there, unless a place lies on the way.
        LegEnd::Displaced if legs[leg].end == LegEnd::Displaced => LegEnd::Displaced,
        LegEnd::Displaced => start_of(legs, leg - 1).off(before.path.end()),
        // A leg that was itself backwards or went back to a key: as far as its path leads.
        LegEnd::AtKey(_) | LegEnd::NextKey | LegEnd::Off(..) | LegEnd::Rebound(_) => LegEnd::Displaced,
    }
}
