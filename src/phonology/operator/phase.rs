//! Operators on signs of several phases: each phase changed, their order turned round, or all of them made one.

use super::compound::{Part, Unsaid, joined};
use super::{keys_of, plain};
use crate::diagnostics::Error;
use crate::phonology::{Motion, Sign};

/// The sign with each of its phases changed.
pub(super) fn each(sign: &Sign, one: impl Fn(&Sign) -> Sign) -> Sign {
    Sign { then: sign.then.iter().map(&one).collect(), ..one(sign) }
}

/// The sign with each of its phases changed, where every one can be.
pub(super) fn try_each(sign: &Sign, mut one: impl FnMut(&Sign) -> Result<Sign, Error>) -> Result<Sign, Error> {
    let first = one(sign)?;
    Ok(Sign { then: sign.then.iter().map(one).collect::<Result<_, _>>()?, ..first })
}

/// The phases from the last to the first, each changed. What is said of the whole sign stays with it, its duration and speed too; a
/// phase that comes to the front has none of its own.
///
/// A hand that stayed between two phases stays between the same two. Non-manual values of keys that the new first phase
/// lacks stand at its last one.
pub(super) fn backwards(sign: &Sign, one: impl Fn(&Sign) -> Sign) -> Sign {
    if sign.then.is_empty() {
        return one(sign);
    }
    let stays: Vec<bool> = sign.then.iter().map(|phase| phase.holds_over).rev().collect();
    let mut all: Vec<Sign> = alone(sign).map(|phase| one(&phase)).collect();
    all.reverse();
    let first = performed(sign, &all[0]);
    let last = first.intervals;
    let nonmanual = first.nonmanual.iter().map(|(channel, values)| {
        (*channel, keys_of(values.iter().map(|(key, v)| (key.min(last), v.clone())).collect()))
    });
    let nonmanual = nonmanual.collect();
    let later = all[1..].iter().zip(stays);
    let then = later.map(|(phase, holds_over)| Sign { holds_over, ..phase.clone() });
    Sign { nonmanual, then: then.collect(), ..first }
}

/// The phases as further ones: without what is said of the whole sign, which the first one's duration and speed are.
pub(super) fn alone(sign: &Sign) -> impl Iterator<Item = Sign> {
    let first = performed(&Sign::named(""), sign);
    std::iter::once(first).chain(sign.then.iter().cloned())
}

/// What is said of the whole sign `of`, with the hands and manual tiers of a phase.
fn performed(of: &Sign, phase: &Sign) -> Sign {
    Sign {
        hands: phase.hands,
        intervals: phase.intervals,
        strong: phase.strong.clone(),
        weak: phase.weak.clone(),
        contact: phase.contact.clone(),
        ..of.clone()
    }
}

/// All phases of a sign as one, joined as a compound joins signs.
///
/// # Errors
/// More movements than a phase may have.
pub(super) fn flattened(sign: &Sign) -> Result<Sign, Error> {
    if sign.then.is_empty() {
        return Ok(sign.clone());
    }
    let parts: Vec<Part> = sign.phases().map(|sign| Part { sign, before: plain(Motion::Change) }).collect();
    let whole = joined(&parts, sign.name.clone(), Unsaid::Neutral)?;
    Ok(Sign { then: Vec::new(), ..performed(sign, &whole) })
}
