//! Non-manual tiers: curves of face morphs, and turns of head, trunk, shoulders and eyes.

use crate::body::signer::Turn;
use crate::diagnostics::Error;
use crate::motion::easing::smoothstep;
use crate::phonology::expression::{Expression, Expressions};
use crate::phonology::{Channel, Keys, NonManual, NonManualValue, Side};
use glam::DVec3;

/// One value of a non-manual tier over a span of time.
#[derive(Debug, Clone)]
pub struct Cue {
    /// Seconds from the clip's start.
    pub start: f64,
    /// Seconds from the clip's start.
    pub end: f64,
    channel: Channel,
    effect: Effect,
    amount: f64,
}

#[derive(Debug, Clone)]
enum Effect {
    Expression(Expression),
    Turned(Turn),
}

/// What the non-manual tiers do at one instant.
#[derive(Debug, Clone, Default)]
pub struct NonManualState {
    /// Morph names and weights; a name may come twice, the weights add up.
    pub morphs: Vec<(usize, f64)>,
    /// The head's turn.
    pub head: Turn,
    /// The trunk's turn.
    pub torso: Turn,
    /// The eyes' turn.
    pub eyes: Turn,
    /// How far the left and the right shoulder are raised, radians.
    pub shoulders: [f64; 2],
}

/// Seconds in which a value comes and goes.
const RAMP: f64 = 0.18;

/// Lays out a tier's values between the instants of the sign's keys.
///
/// `keys` are the instants of the N + 1 keys; a value holds until the next stated one, the last one until `end`.
/// `locate` gives the direction from the eyes to a placement's place.
///
/// # Errors
/// Names the tier and the value that the inventory lacks.
pub fn lay_out(
    channel: Channel,
    values: &Keys<NonManual>,
    keys: &[f64],
    end: f64,
    expressions: &Expressions,
    locate: &dyn Fn(&NonManualValue) -> Result<Option<DVec3>, Error>,
) -> Result<Vec<Cue>, Error> {
    let stated: Vec<(usize, &NonManual)> = values.iter().collect();
    let mut cues = Vec::new();
    for (i, (key, value)) in stated.iter().enumerate() {
        let start = keys.get(*key).copied().unwrap_or(end);
        let until = stated.get(i + 1).and_then(|(next, _)| keys.get(*next)).copied().unwrap_or(end);
        // A value stated at the last key alone is held while the sign ends.
        let until = until.max(start + 0.05);
        let amount = value.amount.factor();
        let cue = |start: f64, end: f64, effect: Effect| Cue { start, end, channel, effect, amount };
        match &value.value {
            NonManualValue::Named(name) => {
                let found = expressions
                    .find(channel, name)
                    .ok_or_else(|| Error::new(format!("{} knows no `{name}`", channel.name())))?;
                cues.push(cue(start, until, Effect::Expression(found.clone())));
            }
            NonManualValue::Mouthing(sounds) => {
                let shapes: Vec<&Expression> = sounds.chars().filter_map(|s| expressions.viseme(s)).collect();
                let each = (until - start) / shapes.len().max(1) as f64;
                for (n, shape) in shapes.into_iter().enumerate() {
                    let at = start + n as f64 * each;
                    cues.push(cue(at, at + each, Effect::Expression(shape.clone())));
                }
            }
            other => {
                if let Some(direction) = locate(other)? {
                    cues.push(cue(start, until, Effect::Turned(turn_towards(direction, channel))));
                }
            }
        }
    }
    Ok(cues)
}

/// The turn that looks along a direction; heads and trunks go only part of the way.
fn turn_towards(direction: DVec3, channel: Channel) -> Turn {
    let d = direction.normalize_or(DVec3::Z);
    let level = (d.x * d.x + d.z * d.z).sqrt();
    let (share, most) = match channel {
        Channel::Gaze => (1.0, 40f64.to_radians()),
        Channel::Head => (0.6, 45f64.to_radians()),
        _ => (0.3, 20f64.to_radians()),
    };
    let limit = |angle: f64| (angle * share).clamp(-most, most);
    Turn { pitch: limit((-d.y).atan2(level)), yaw: limit(d.x.atan2(d.z)), roll: 0.0 }
}

/// What all cues together do at an instant. `morphs` are the names of the clip's morphs.
pub fn state_at(cues: &[Cue], time: f64, morphs: &[String]) -> NonManualState {
    let mut state = NonManualState::default();
    for cue in cues {
        let level = cue.amount * envelope(time, cue.start, cue.end);
        if level == 0.0 {
            continue;
        }
        match &cue.effect {
            Effect::Turned(turn) => add(cue.channel, *turn, level, &mut state),
            Effect::Expression(e) => {
                let beat = |swing: bool| {
                    let phase = std::f64::consts::TAU * e.beats * (time - cue.start);
                    match (e.beats > 0.0, swing) {
                        (false, _) => 1.0,
                        // Shakes and sways swing to both sides; nods, blinks and shrugs go and come back.
                        (true, true) => phase.sin(),
                        (true, false) => (1.0 - phase.cos()) / 2.0,
                    }
                };
                for (name, weight) in &e.morphs {
                    if let Some(i) = morphs.iter().position(|m| m == name) {
                        state.morphs.push((i, f64::from(*weight) * level * beat(false)));
                    }
                }
                let (pitch, yaw, roll) = e.turn;
                let swings = beat(true) * level;
                let turn = Turn {
                    pitch: pitch.to_radians() * level * beat(false),
                    yaw: yaw.to_radians() * swings,
                    roll: roll.to_radians() * swings,
                };
                add(cue.channel, turn, 1.0, &mut state);
                for (side, degrees) in [(Side::Left, e.raise.0), (Side::Right, e.raise.1)] {
                    state.shoulders[side as usize] += degrees.to_radians() * level * beat(false);
                }
            }
        }
    }
    state
}

fn add(channel: Channel, turn: Turn, level: f64, state: &mut NonManualState) {
    let part = match channel {
        Channel::Torso => &mut state.torso,
        Channel::Gaze => &mut state.eyes,
        Channel::Head
        | Channel::Shoulders
        | Channel::Brows
        | Channel::Lids
        | Channel::Nose
        | Channel::Cheeks
        | Channel::Mouth => &mut state.head,
    };
    part.pitch += turn.pitch * level;
    part.yaw += turn.yaw * level;
    part.roll += turn.roll * level;
}

/// Comes before the start and goes after the end, smoothly.
fn envelope(time: f64, start: f64, end: f64) -> f64 {
    let ramp = RAMP.min((end - start).max(0.05));
    // Neighbours cross at half their height on the border between them.
    smoothstep((time - start + ramp / 2.0) / ramp) * smoothstep((end + ramp / 2.0 - time) / ramp)
}
