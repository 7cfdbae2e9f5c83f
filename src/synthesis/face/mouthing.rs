//! Words mouthed: sounds in the time of the sign, each sound's mouth shape coloured by its neighbours.
//!
//! Every sound has its part of the time, vowels more than consonants. In the middle of its part its shape stands;
//! between, the mouth moves on. A shape that lips or teeth must reach (m b p, f v: `firm: 1` in the inventory) is
//! reached whole, however short it is; others give way to the sounds beside them, `k` and `h` nearly altogether.

use super::cue::{Cue, Hold, Key, Shape};
use crate::phonology::Channel;
use crate::phonology::expression::Expressions;
use crate::phonology::sampa::{self, Sound};

/// A sound takes at least this long, seconds: twenty sounds a second.
const LEAST: f64 = 0.05;
/// An ordinary vowel is not drawn out longer, seconds.
const MOST: f64 = 0.45;
/// An ordinary vowel where nothing presses, seconds.
const USUAL: f64 = 0.16;
/// The mouth opens before the first sound, and goes back after the last one, seconds.
const BEFORE: f64 = 0.08;
const AFTER: f64 = 0.12;
/// The share of its time for which a sound's shape stands, and the least time where it must be seen, seconds.
const STANDS: f64 = 0.4;
const SEEN: f64 = 0.036;

/// How long a word takes where nothing presses, seconds.
pub(super) fn usual_time(word: &str) -> f64 {
    sampa::read(word).iter().map(|s| s.length).sum::<f64>() * USUAL
}

/// A word mouthed from `start` to `end`.
pub(super) fn mouthed(
    word: &str,
    (start, end): (f64, f64),
    level: f64,
    pace: f64,
    expressions: &Expressions,
    names: &[String],
) -> Option<Cue> {
    let time = ((end - start) / pace.max(1.0)).max(LEAST);
    let sounds = fitted(sampa::read(word), (time / LEAST + 1e-6) as usize);
    let own: Vec<(Shape, f64)> = sounds
        .iter()
        .map(|sound| match expressions.viseme(sound.sign) {
            Some(row) => (Shape::of(&row.base(), names), row.firm),
            None => (Shape::default(), 0.0),
        })
        .collect();
    let parts = parts(&sounds, time);
    let mut keys = Vec::with_capacity(2 * sounds.len() + 2);
    let mut at = start;
    keys.push(Key { at: at - BEFORE, shape: 0, level: 0.0 });
    for (n, part) in parts.iter().enumerate() {
        let firm = own.get(n).is_some_and(|(_, firm)| *firm >= 1.0);
        let stands = (part * STANDS).max(if firm { SEEN.min(0.9 * part) } else { 0.0 });
        let middle = at + part / 2.0;
        keys.push(Key { at: middle - stands / 2.0, shape: n, level });
        keys.push(Key { at: middle + stands / 2.0, shape: n, level });
        at += part;
    }
    keys.push(Key { at: at + AFTER, shape: sounds.len().checked_sub(1)?, level: 0.0 });
    let shapes = (0..own.len()).map(|n| coloured(&own, n)).collect();
    Some(Cue { channel: Channel::Mouth, hold: Hold::Carried, shapes, keys })
}

/// How long each sound takes: its share, and enough to be seen.
fn parts(sounds: &[Sound], time: f64) -> Vec<f64> {
    let whole: f64 = sounds.iter().map(|s| s.length).sum();
    let unit = (time / whole.max(1e-9)).min(MOST);
    let mut parts: Vec<f64> = sounds.iter().map(|s| (s.length * unit).max(LEAST)).collect();
    // What the short ones were given is taken from the long ones.
    let over: f64 = parts.iter().sum::<f64>() - whole * unit;
    let spare: f64 = parts.iter().map(|p| p - LEAST).sum();
    if over > 0.0 && spare > 0.0 {
        let keep = 1.0 - (over / spare).min(1.0);
        parts.iter_mut().for_each(|p| *p = LEAST + (*p - LEAST) * keep);
    }
    parts
}

/// At most so many sounds: those go first that show least.
fn fitted(mut sounds: Vec<Sound>, most: usize) -> Vec<Sound> {
    let most = most.max(1);
    // Rounds by how much a sound shows; within a round the last of a word goes first.
    for hidden in ["hkgNxR", "tdnszlrTDj", "@6", "iIeEyY", "SZHw"] {
        let mut at = sounds.len();
        while sounds.len() > most && at > 0 {
            at -= 1;
            if hidden.contains(sounds[at].sign) {
                sounds.remove(at);
            }
        }
    }
    // Then vowels but for the first one, then whatever is last: closed lips are what is read.
    while sounds.len() > most {
        let vowel = |s: &Sound| sampa::VOWELS.contains(s.sign);
        let first = sounds.iter().position(vowel);
        let last = sounds.iter().rposition(vowel).filter(|at| Some(*at) != first);
        sounds.remove(last.unwrap_or(sounds.len() - 1));
    }
    sounds
}

/// A sound's own shape with the shapes beside it, as far as it gives way.
fn coloured(own: &[(Shape, f64)], n: usize) -> Shape {
    let Some((shape, firm)) = own.get(n) else { return Shape::default() };
    let mut mixed = Shape::default();
    mixed.add(shape, *firm);
    // The sound that follows is prepared more than the last one lingers. A firm neighbour is a moment of its own.
    let beside = [(n.checked_sub(1), 0.4), (n.checked_add(1), 0.6)];
    let beside: Vec<(&Shape, f64)> = beside
        .into_iter()
        .filter_map(|(m, share)| {
            own.get(m?).map(|(shape, firm)| (shape, share * if *firm >= 1.0 { 0.15 } else { 1.0 }))
        })
        .collect();
    let whole: f64 = beside.iter().map(|(_, share)| share).sum();
    for (other, share) in &beside {
        mixed.add(other, (1.0 - firm) * share / whole.max(1e-9));
    }
    if beside.is_empty() {
        mixed.add(shape, 1.0 - firm);
    }
    mixed
}
