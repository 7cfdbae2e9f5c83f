//! A tier's values between the instants of a sign's keys, as cues.

use super::cue::{Cue, Hold, Shape};
use super::curve::{Span, turn_towards};
use super::mouthing::{mouthed, usual_time};
use crate::diagnostics::Error;
use crate::phonology::expression::{Expression, Expressions, Look, Step};
use crate::phonology::{Channel, Keys, NonManual, NonManualValue};
use glam::DVec3;

/// What values are laid out with: the inventory, the rig's morphs, and where things are.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The inventory.
    pub expressions: &'a Expressions,
    /// Names of the rig's morphs.
    pub morphs: &'a [String],
    /// The direction from the eyes to the place of `towards` and `at`.
    pub locate: &'a dyn Fn(&NonManualValue) -> Result<Option<DVec3>, Error>,
    /// The directions from the eyes to the hands that are looked at, with their instants; none where no hand acts.
    pub follow: &'a dyn Fn(Look) -> Vec<(f64, DVec3)>,
}

/// A value is there at least so long, seconds.
const LEAST: f64 = 0.05;
/// What a value takes of a sequence where nothing else says it, seconds.
const USUAL: f64 = 0.4;

/// Lays out a tier's values between the instants of the sign's keys.
///
/// `keys` are the instants of the N + 1 keys; a value holds until the next stated one, the last one until `end`. A
/// word is mouthed until the last key: the hold at the sign's end is silent.
///
/// # Errors
/// Names the tier and the value that the inventory lacks.
pub fn lay_out(
    channel: Channel,
    values: &Keys<NonManual>,
    keys: &[f64],
    end: f64,
    scene: &Scene,
) -> Result<Vec<Cue>, Error> {
    let stated: Vec<(usize, &NonManual)> = values.iter().collect();
    let stroke_end = keys.last().copied().unwrap_or(end);
    let mut cues = Vec::new();
    for (i, (key, value)) in stated.iter().enumerate() {
        let start = keys.get(*key).copied().unwrap_or(end);
        let next = stated.get(i + 1).and_then(|(next, _)| keys.get(*next)).copied();
        let until = match next {
            Some(next) => next,
            None if channel == Channel::Mouth && says(value) && stroke_end > start + 0.2 => stroke_end,
            None => end,
        };
        cues.extend(lay_out_value(channel, value, (start, until), scene)?);
    }
    Ok(cues)
}

/// Lays out one value of a tier from a start to an end, seconds.
///
/// # Errors
/// Names the tier and the value that the inventory lacks.
pub fn lay_out_value(
    channel: Channel,
    value: &NonManual,
    (start, end): (f64, f64),
    scene: &Scene,
) -> Result<Vec<Cue>, Error> {
    let mut cues = Vec::new();
    let span = Span { channel, start, end: end.max(start + LEAST), level: 1.0, pace: 1.0 };
    Tier { channel, scene }.lay(value, span, &mut cues)?;
    Ok(cues)
}

/// Whether a word is mouthed, alone or among other values.
fn says(value: &NonManual) -> bool {
    match &value.value {
        NonManualValue::Mouthing(_) => true,
        NonManualValue::Sequence(parts) | NonManualValue::Together(parts) => parts.iter().any(says),
        NonManualValue::Named(_) | NonManualValue::Towards(_) | NonManualValue::At(_) => false,
    }
}

struct Tier<'a> {
    channel: Channel,
    scene: &'a Scene<'a>,
}

impl Tier<'_> {
    fn lay(&self, value: &NonManual, span: Span, cues: &mut Vec<Cue>) -> Result<(), Error> {
        let pace = if value.pace.is_finite() && value.pace > 0.0 { value.pace } else { 1.0 };
        let span =
            Span { level: span.level * value.amount.factor(), pace: (span.pace * pace).clamp(0.05, 20.0), ..span };
        match &value.value {
            NonManualValue::Named(name) => {
                let found = self.scene.expressions.find(self.channel, name);
                let unknown = || Error::new(format!("{} knows no `{name}`", self.channel.name()));
                cues.extend(self.expression(found.ok_or_else(unknown)?, span));
            }
            // Some lexica write a mouth gesture's tag where the sounds should be.
            NonManualValue::Mouthing(word) => match self.gesture(word) {
                Some(row) => cues.extend(self.expression(row, span)),
                None => cues.extend(self.word(word, span)),
            },
            NonManualValue::Towards(_) | NonManualValue::At(_) => {
                if let Some(direction) = (self.scene.locate)(&value.value)? {
                    let shape = Shape { turn: turn_towards(direction, self.channel), ..Shape::default() };
                    cues.push(span.held(shape, Hold::InSpace));
                }
            }
            NonManualValue::Together(parts) => {
                for part in parts {
                    self.lay(part, span, cues)?;
                }
            }
            NonManualValue::Sequence(parts) => {
                let times: Vec<f64> = parts.iter().map(|part| self.usual_time(part)).collect();
                let unit = (span.end - span.start) / times.iter().sum::<f64>().max(1e-9);
                let mut start = span.start;
                for (part, time) in parts.iter().zip(times) {
                    self.lay(part, Span { start, end: start + time * unit, ..span }, cues)?;
                    start += time * unit;
                }
            }
        }
        Ok(())
    }

    /// What a value takes of a sequence, relative to the others, seconds.
    fn usual_time(&self, value: &NonManual) -> f64 {
        let own = match &value.value {
            NonManualValue::Mouthing(word) if self.gesture(word).is_none() => usual_time(word),
            NonManualValue::Sequence(parts) => parts.iter().map(|p| self.usual_time(p)).sum(),
            NonManualValue::Together(parts) => parts.iter().map(|p| self.usual_time(p)).fold(0.0, f64::max),
            NonManualValue::Mouthing(_)
            | NonManualValue::Named(_)
            | NonManualValue::Towards(_)
            | NonManualValue::At(_) => USUAL,
        };
        let pace = if value.pace.is_finite() { value.pace.clamp(0.05, 20.0) } else { 1.0 };
        (own / pace).max(LEAST)
    }

    fn gesture(&self, word: &str) -> Option<&Expression> {
        let row = |channel| self.scene.expressions.tagged(channel, word);
        row(Channel::Mouth).or_else(|| row(Channel::Cheeks)).filter(|_| word.len() > 2)
    }

    fn expression(&self, row: &Expression, span: Span) -> Option<Cue> {
        let shape = |step: &Step| Shape::of(step, self.scene.morphs);
        if !row.says.is_empty() {
            return self.word(&row.says, span);
        }
        match row.look {
            Some(Look::Ahead) => return Some(span.held(shape(&row.base()), Hold::InSpace)),
            Some(Look::Gaze) => return Some(span.held(Shape::default(), Hold::WithGaze)),
            Some(look @ (Look::Hands | Look::Strong | Look::Weak)) => {
                return Some(span.following(&(self.scene.follow)(look)));
            }
            None => {}
        }
        let base = shape(&row.base());
        let whole = |step: &Step| {
            let mut shape = shape(step);
            shape.add(&base, 1.0);
            shape
        };
        let steps: Vec<(Shape, f64)> = row.steps.iter().map(|step| (whole(step), step.share)).collect();
        Some(match (steps.is_empty(), row.beats > 0.0) {
            (true, false) => span.held(base, Hold::Carried),
            (true, true) => span.beating(row, base),
            (false, beats) => span.stepping(steps, if beats { Some((row.beats, row.times)) } else { None }),
        })
    }

    fn word(&self, word: &str, span: Span) -> Option<Cue> {
        let times = (span.start, span.end);
        mouthed(word, times, span.level, span.pace, self.scene.expressions, self.scene.morphs)
    }
}
