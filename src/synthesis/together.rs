//! Movements at the same time as one list of legs: the longest decides, shorter ones are stretched.
//!
//! One part gives the legs; what the others do is cut along them. Paths add up.

use super::leg::{Leg, LegEnd, Stand, Turn, Wiggle, WristPlay, whole};
use super::legs::{Layout, Postures, squeezed};
use super::path::Path;
use super::repeat::Again;
use crate::phonology::{Action, Becoming, Motion, Movement};
use glam::DVec3;

impl Layout<'_> {
    /// The legs of movements at the same time.
    pub(super) fn together(&self, parts: &[Movement], at: &Stand) -> Vec<Leg> {
        if let Some((action, once)) = repeated_as_one(parts) {
            let again = Again::of(action.repetition, self.turns.behind(action));
            return self.again(&again, at, &|at| self.merged(&once, at));
        }
        self.merged(parts, at)
    }

    fn merged(&self, parts: &[Movement], at: &Stand) -> Vec<Leg> {
        let parts = one_becoming(parts);
        let all: Vec<Vec<Leg>> = parts.iter().map(|part| self.legs(part, at)).filter(|l| !l.is_empty()).collect();
        let longest = all.iter().map(|legs| whole(legs)).fold(0.0, f64::max);
        let stretched = all.into_iter().map(|legs| {
            let factor = if whole(&legs) > 0.0 { longest / whole(&legs) } else { 1.0 };
            legs.into_iter().map(|leg| leg.stretched(factor)).collect::<Vec<_>>()
        });
        let mut all: Vec<Vec<Leg>> = stretched.collect();
        if let Some(joined) = self.one_leg(&all, longest) {
            return vec![joined];
        }
        let Some(leading) = (0..all.len()).max_by_key(|n| (leads(&all[*n]), all.len() - n)) else { return Vec::new() };
        let mut legs = all.remove(leading);
        for other in &all {
            self.lay_over(&mut legs, other, longest);
        }
        legs
    }

    /// Parts of one leg each are one leg.
    fn one_leg(&self, all: &[Vec<Leg>], duration: f64) -> Option<Leg> {
        if all.is_empty() || all.iter().any(|legs| legs.len() != 1) {
            return None;
        }
        let legs: Vec<&Leg> = all.iter().flatten().collect();
        let turning = legs.iter().find(|leg| leg.posture.changes()).or(legs.first())?;
        let mut joined = Leg { duration, fingers: turning.fingers, ..Leg::still(duration, turning.posture.clone()) };
        for leg in &legs {
            joined.wrist.extend(leg.wrist.iter().copied());
            joined.wiggle.extend(leg.wiggle.iter().copied());
            if leg.end != LegEnd::Displaced {
                joined.end = leg.end.clone();
            }
            if leg.fingers != Default::default() {
                joined.fingers = leg.fingers;
            }
            joined.brushing = leg.brushing.clone().or(joined.brushing);
            joined.names = leg.names.clone().or(joined.names);
        }
        joined.path = Path::Sum(legs.into_iter().map(|leg| leg.path.clone()).collect());
        Some(joined)
    }

    /// Adds what another part does to legs of the same time.
    fn lay_over(&self, legs: &mut [Leg], other: &[Leg], duration: f64) {
        let path = squeezed(other);
        if path.length(8) > 1e-9 {
            carried(legs, 0, &path);
        }
        let end = other.last().map(|leg| &leg.end).filter(|end| end.is_placed());
        if let (Some(end), Some(last)) = (end, legs.last_mut())
            && !last.end.is_placed()
        {
            last.end = end.clone();
        }
        let mut from = 0.0;
        for theirs in other {
            let span = (from, from + theirs.duration);
            from = span.1;
            play_along(legs, theirs, span, duration);
            if self.postures == Postures::AtStops && theirs.posture.changes() {
                turn_along(legs, theirs, span);
            }
        }
        if let Some(last) = legs.last_mut() {
            last.names = last.names.clone().or_else(|| other.iter().find_map(|leg| leg.names.clone()));
            last.brushing = last.brushing.clone().or_else(|| other.iter().find_map(|leg| leg.brushing.clone()));
        }
    }
}

/// How much a part wants to be the one that gives the legs: where postures stop, then where ways end.
fn leads(legs: &[Leg]) -> (usize, usize, usize) {
    let turning = legs.iter().filter(|leg| leg.posture.from != Stand::Before && leg.posture.changes()).count();
    (turning, legs.len(), legs.iter().filter(|leg| leg.end.is_placed()).count())
}

/// Legs from `first` on, in time with another path that carries them along.
pub(super) fn carried(legs: &mut [Leg], first: usize, path: &Path) {
    let duration = whole(&legs[first..]).max(1e-9);
    let mut shares = Vec::with_capacity(legs.len() - first);
    let mut at = 0.0;
    for leg in &legs[first..] {
        let from = at / duration;
        at += leg.duration;
        shares.push((from, (at / duration).min(1.0)));
    }
    for n in 0..shares.len() {
        let (from, to) = shares[n];
        let here = path.at(to);
        let along = match (from, to) {
            (0.0, 1.0) => path.clone(),
            (from, to) => Path::Part(from, to, Box::new(path.clone())),
        };
        let leg = &mut legs[first + n];
        leg.path = match std::mem::replace(&mut leg.path, Path::Still) {
            Path::Still => along,
            own => Path::Sum(vec![own, along]),
        };
        // Coming back to where another leg started, it has been carried on meanwhile.
        let start = match &leg.end {
            LegEnd::StartOf(earlier) => Some(*earlier),
            LegEnd::Off(end, _) => match **end {
                LegEnd::StartOf(earlier) => Some(earlier),
                _ => None,
            },
            LegEnd::Displaced
            | LegEnd::At(_)
            | LegEnd::Meeting(_)
            | LegEnd::Rebound(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey => None,
        };
        if let Some((was, _)) = start.and_then(|earlier| shares.get(earlier.checked_sub(first)?)) {
            let on: DVec3 = here - path.at(*was);
            leg.end = std::mem::replace(&mut leg.end, LegEnd::Displaced).off(on);
        }
    }
}

/// Wrist and fingers of another part's leg, over the legs that go on meanwhile.
fn play_along(legs: &mut [Leg], theirs: &Leg, (begin, end): (f64, f64), duration: f64) {
    if theirs.wrist.is_empty() && theirs.wiggle.is_empty() || end <= begin {
        return;
    }
    let mut at = 0.0;
    for leg in legs {
        let span = (at, at + leg.duration);
        at = span.1;
        if span.1 <= begin + 1e-9 * duration || span.0 >= end - 1e-9 * duration {
            continue;
        }
        let own = |t: f64| (t - begin) / (end - begin);
        let within = |part: (f64, f64)| {
            let at = |share: f64| part.0 + (part.1 - part.0) * share;
            (at(own(span.0)), at(own(span.1)))
        };
        leg.wrist.extend(theirs.wrist.iter().map(|w| WristPlay { part: within(w.part), ..*w }));
        leg.wiggle.extend(theirs.wiggle.iter().map(|w| Wiggle { part: within(w.part), ..*w }));
    }
}

/// A change of posture of another part's leg, over the legs that go on meanwhile; those after it keep what it came to.
fn turn_along(legs: &mut [Leg], theirs: &Leg, (begin, end): (f64, f64)) {
    if legs.iter().any(|leg| leg.posture.changes() && leg.posture.from != theirs.posture.from) {
        return;
    }
    let mut at = 0.0;
    for leg in legs {
        let span = (at, at + leg.duration);
        at = span.1;
        let share = |t: f64| ((t - begin) / (end - begin).max(1e-9)).clamp(0.0, 1.0);
        let (from, to) = (theirs.posture.from.clone(), theirs.posture.to.clone());
        let (a, b) = (share(span.0), share(span.1));
        let done = |s: f64| theirs.posture.share.0 + (theirs.posture.share.1 - theirs.posture.share.0) * s;
        if b > 0.0 || a > 0.0 {
            leg.posture =
                if a >= 1.0 { Turn::none(theirs.posture.end()) } else { Turn { from, to, share: (done(a), done(b)) } };
            leg.fingers = theirs.fingers;
        }
    }
}

/// Single movements of which one says how often: in text, `up while wiggle, repeated 2` repeats both. The action that
/// says it, and what is performed each time; `None` where each part repeats for itself.
fn repeated_as_one(parts: &[Movement]) -> Option<(&Action, Vec<Movement>)> {
    let actions: Vec<&Action> = parts
        .iter()
        .map(|part| match part {
            Movement::Action(action) => Some(&**action),
            Movement::Sequence(_)
            | Movement::Together(_)
            | Movement::Fused(_)
            | Movement::Repeated(_)
            | Movement::Backwards(_) => None,
        })
        .collect::<Option<_>>()?;
    let mut repeating = actions.iter().filter(|a| a.repetition.is_some());
    let one = *repeating.next().filter(|_| actions.iter().filter(|a| a.repetition.is_some()).count() == 1)?;
    let plays = |a: &Action| match a.motion {
        Motion::Wrist(..) | Motion::Wiggle(_) | Motion::Hold | Motion::Change => a.target.is_none(),
        Motion::Return { .. } | Motion::Straight { .. } | Motion::Arc { .. } | Motion::Circle { .. } => false,
    };
    let as_one = plays(one) || actions.iter().all(|a| std::ptr::eq(*a, one) || plays(a) && a.becoming.is_none());
    let once = actions.iter().map(|a| Movement::Action(Box::new(Action { repetition: None, ..(*a).clone() })));
    as_one.then(|| (one, once.collect()))
}

/// Single movements blended into one of which some says how often: that is said of the whole.
pub(super) fn first_repeating(parts: &[Movement]) -> Option<(&Action, Vec<Movement>)> {
    let action = parts.iter().find_map(|part| match part {
        Movement::Action(action) if action.repetition.is_some() => Some(&**action),
        Movement::Action(_)
        | Movement::Sequence(_)
        | Movement::Together(_)
        | Movement::Fused(_)
        | Movement::Repeated(_)
        | Movement::Backwards(_) => None,
    })?;
    let once = parts.iter().map(|part| part.map_actions(&|a| Action { repetition: None, ..a.clone() }));
    Some((action, once.collect()))
}

/// The parts with all that single actions become said by one of them.
fn one_becoming(parts: &[Movement]) -> Vec<Movement> {
    let of = |part: &Movement| match part {
        Movement::Action(action) => action.becoming.as_deref().cloned(),
        Movement::Sequence(_)
        | Movement::Together(_)
        | Movement::Fused(_)
        | Movement::Repeated(_)
        | Movement::Backwards(_) => None,
    };
    let said: Vec<usize> = (0..parts.len()).filter(|n| of(&parts[*n]).is_some()).collect();
    let mut parts = parts.to_vec();
    if said.len() < 2 {
        return parts;
    }
    let all = said.iter().filter_map(|n| of(&parts[*n])).fold(Becoming::default(), |all, next| Becoming {
        configuration: all.configuration.or(next.configuration),
        orientation: all.orientation.or(next.orientation),
        contact: all.contact.or(next.contact),
    });
    let mut whole = Some(Box::new(all));
    for n in said {
        if let Movement::Action(action) = &mut parts[n] {
            action.becoming = whole.take();
        }
    }
    parts
}
