//! Non-manual tiers written into frames: cues laid out between the keys, and what they do at an instant.

use super::face::{self, Cue};
use super::plan::Known;
use super::prepare::Prepared;
use super::schedule::Schedule;
use super::stage::Stage;
use super::timeline::Timeline;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::phonology::{Keys, NonManualValue, Place, Side, Sign};
use crate::score::plan::Plan;
use glam::DVec3;

impl Stage<'_> {
    /// The cues of a plan: those of its signs between their keys, and those that go over several items.
    pub(super) fn cues(
        &self,
        plan: &Plan,
        prepared: &[Prepared],
        timelines: &[Timeline],
        schedule: &Schedule,
    ) -> Result<Vec<Cue>, Error> {
        let expressions = &self.grammar.expressions;
        let mut cues = Vec::new();
        for (sign, timeline) in prepared.iter().zip(timelines) {
            let locate = |value: &NonManualValue| self.locate(value, Some(sign));
            for (channel, values) in &sign.sign.nonmanual {
                let laid_out = face::lay_out(*channel, values, &timeline.keys, timeline.sign_end, expressions, &locate);
                cues.extend(laid_out.map_err(|e| e.context(&plan.items[sign.item].gloss))?);
            }
        }
        for over in &plan.spans {
            let times = schedule.items.get(over.items.clone()).unwrap_or_default();
            if let [first, .., last] | [first @ last] = times {
                let locate = |value: &NonManualValue| self.locate(value, None);
                let value = Keys::one(over.value.clone());
                let keys = [first.stroke.0];
                cues.extend(face::lay_out(over.channel, &value, &keys, last.hold_end.0, expressions, &locate)?);
            }
        }
        Ok(cues)
    }

    /// The direction from the eyes that a value turns to.
    fn locate(&self, value: &NonManualValue, sign: Option<&Prepared>) -> Result<Option<DVec3>, Error> {
        let model = &self.neutral_model;
        let eyes = self.signer.gaze_origin(model);
        let place = match value {
            NonManualValue::Towards(heading) => return Ok(Some(heading.vector())),
            NonManualValue::At(placement) => match (&placement.place, sign) {
                // Seen from the strong hand, the other hand is the weak one.
                (Place::OtherHand(_), sign) => {
                    let other = sign.and_then(|s| s.hands.iter().find(|h| h.side == Side::Left));
                    other.map(|h| h.start.position(model))
                }
                (_, Some(sign)) => {
                    Some(self.planner().place(placement, sign.sign, &mut sign.known.clone())?.position(model))
                }
                (_, None) => {
                    let known = &mut Known::default();
                    Some(self.planner().place(placement, &Sign::named(""), known)?.position(model))
                }
            },
            NonManualValue::Named(_)
            | NonManualValue::Mouthing(_)
            | NonManualValue::Sequence(_)
            | NonManualValue::Together(_) => None,
        };
        Ok(place.map(|p| p - eyes))
    }

    /// Writes the non-manuals of one instant; returns how far the shoulders are raised.
    pub(super) fn express(&self, cues: &[Cue], time: f64, pose: &mut LocalPose, weights: &mut [f32]) -> [f64; 2] {
        let state = face::state_at(cues, time, &self.signer.morphs);
        for (morph, weight) in state.morphs {
            weights[morph] = (f64::from(weights[morph]) + weight).clamp(0.0, 1.0) as f32;
        }
        if !state.torso.is_zero() {
            self.signer.turn_torso(state.torso, pose);
        }
        if !state.head.is_zero() {
            self.signer.turn_head(state.head, pose);
        }
        if !state.eyes.is_zero() {
            self.signer.turn_eyes(state.eyes, pose);
        }
        for side in [Side::Left, Side::Right] {
            let angle = state.shoulders[side as usize];
            if angle != 0.0 {
                self.signer.raise_shoulder(side, angle, pose);
            }
        }
        state.shoulders
    }
}
