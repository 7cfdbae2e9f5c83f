//! Non-manual tiers written into frames: cues laid out between the keys, and what they do at an instant.

use super::face::{self, Cue};
use super::plan::HandPlan;
use super::timeline::Timeline;
use super::write::Writer;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::phonology::{NonManualValue, Place, Side};

impl Writer<'_> {
    pub(super) fn cues(&self, timeline: &Timeline, plans: &[HandPlan]) -> Result<Vec<Cue>, Error> {
        let model = self.planner.neutral;
        let eyes = self.signer.gaze_origin(model);
        let locate = |value: &NonManualValue| match value {
            NonManualValue::Towards(heading) => Ok(Some(heading.vector())),
            NonManualValue::At(placement) => {
                let place = match &placement.place {
                    // Seen from the strong hand, the other hand is the weak one.
                    Place::OtherHand(_) => plans.iter().find(|p| p.side == Side::Left).map(|p| p.start.position(model)),
                    _ => Some(self.planner.place(placement, self.sign)?.position(model)),
                };
                Ok(place.map(|p| p - eyes))
            }
            NonManualValue::Named(_) | NonManualValue::Mouthing(_) => Ok(None),
        };
        let mut cues = Vec::new();
        for (channel, values) in &self.sign.nonmanual {
            let expressions = &self.grammar.expressions;
            cues.extend(face::lay_out(*channel, values, &timeline.keys, timeline.hold_end, expressions, &locate)?);
        }
        Ok(cues)
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
