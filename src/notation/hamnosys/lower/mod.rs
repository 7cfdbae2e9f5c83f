//! What HamNoSys and SiGML mean: the tree as written to a [`Sign`].
//!
//! - Each action of a phase's own line is an interval, so a phase with n actions has n + 1 keys; what `hamreplace` changes is
//!   said at the key after it, and inside brackets by the movement.
//! - Palm symbols are rolls and become directions. What a replacement leaves open keeps its symbol, not its direction.
//! - A weak hand that does what the symmetry says has no tiers of its own.
//! - Several phases become phases of one sign; non-manual tiers hold over all of them.
//!
//! The normal form, in which reading and writing again are the identity: `hametc` is dropped; a place is named once; on a
//! hand, `at` and `beside` are the same side; repetition symbols are added up; a replacement says only what changes.

pub(super) mod action;
pub(super) mod location;
mod nonmanual;
pub(super) mod orientation;
pub(super) mod phase;
pub(super) mod shape;

use super::dictionary::Dictionary;
use super::syntax;
use crate::diagnostics::Diagnostic;
use crate::phonology::{Channel, Keys, NonManual, Sign};
use crate::time::Seconds;

/// The sign that a tree describes, and what was assumed or left out. `None` for one of which nothing is left.
///
/// ```
/// use chereme::notation::hamnosys::{Dictionary, lower, parse};
/// let (tree, faults) = parse::sign("hamflathand,hamextfingero,hampalmd,hamchest,hammoveu");
/// assert_eq!(faults, []);
/// let (sign, warnings) = lower(&tree.unwrap(), Dictionary::builtin(), "");
/// assert_eq!(warnings, []);
/// assert_eq!(sign.unwrap().intervals, 1);
/// ```
pub fn lower(tree: &syntax::Sign, dictionary: &Dictionary, language: &str) -> (Option<Sign>, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let mut phases = Vec::with_capacity(tree.phases.len());
    let mut nonmanual = nonmanual::nonmanuals(&tree.nonmanual, dictionary, &mut diagnostics);
    for written in &tree.phases {
        let (sign, body) = phase::phase(written, dictionary, &mut diagnostics);
        add_body(&mut nonmanual, body);
        phases.push(sign);
    }
    if phases.is_empty() && nonmanual.is_empty() {
        let fault = Diagnostic::fault(tree.span.0, "nothing is written: no posture and no non-manual value")
            .label("an empty sign");
        diagnostics.push(fault);
        return (None, diagnostics);
    }
    let mut phases = phases.into_iter();
    let mut sign = phases.next().unwrap_or_else(|| Sign::named(""));
    sign.then = phases.collect();
    sign.name = tree.gloss.clone().unwrap_or_default();
    sign.language = language.to_owned();
    nonmanual.sort_by_key(|(channel, _)| *channel);
    sign.nonmanual = nonmanual;
    sign.speed = nonmanual::pace(speed(tree.timing));
    sign.duration = tree.timing.duration.filter(|d| *d > 0.0 && *d <= 60.0).map(Seconds);
    (Some(sign), diagnostics)
}

/// How fast the whole sign is: a time scale of 2 is half as fast.
fn speed(timing: syntax::Timing) -> Option<f64> {
    match (timing.speed, timing.timescale) {
        (None, None) => None,
        (speed, scale) => Some(speed.unwrap_or(1.0) / scale.filter(|s| *s > 0.0).unwrap_or(1.0)),
    }
}

/// Adds what parts of the body do where the non-manual tiers say nothing of them.
fn add_body(nonmanual: &mut Vec<(Channel, Keys<NonManual>)>, body: Vec<(usize, Channel, NonManual)>) {
    for channel in Channel::ALL {
        if nonmanual.iter().any(|(c, _)| *c == channel) {
            continue;
        }
        let mut said: Vec<(usize, NonManual)> =
            body.iter().filter(|(_, c, _)| *c == channel).map(|(key, _, v)| (*key, v.clone())).collect();
        said.dedup_by_key(|(key, _)| *key);
        if let Some(keys) = Keys::new(said).filter(|k| !k.is_empty()) {
            nonmanual.push((channel, keys));
        }
    }
}
