//! Non-manual tiers written into frames: cues laid out between the keys, and what they do at an instant.

use super::face::{Face, Scene, lay_out};
use super::plan::{HandPlan, Known};
use super::prepare::Prepared;
use super::schedule::Schedule;
use super::stage::Stage;
use super::timeline::Timeline;
use crate::body::signer::Shoulder;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::phonology::expression::Look;
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
    ) -> Result<Face, Error> {
        let (expressions, morphs) = (&self.grammar.expressions, &self.signer.morphs[..]);
        let mut cues = Vec::new();
        for (sign, timeline) in prepared.iter().zip(timelines) {
            let locate = |value: &NonManualValue| self.locate(value, Some(sign));
            let follow = |look: Look| self.follow(look, sign, timeline);
            let scene = Scene { expressions, morphs, locate: &locate, follow: &follow };
            for (channel, values) in &sign.sign.nonmanual {
                let laid_out = lay_out(*channel, values, &timeline.keys, timeline.sign_end, &scene);
                cues.extend(laid_out.map_err(|e| e.context(&plan.items[sign.item].gloss))?);
            }
        }
        for over in &plan.spans {
            let times = schedule.items.get(over.items.clone()).unwrap_or_default();
            if let [first, .., last] | [first @ last] = times {
                let locate = |value: &NonManualValue| self.locate(value, None);
                let inside = || prepared.iter().zip(timelines).filter(|(sign, _)| over.items.contains(&sign.item));
                let follow = |look: Look| inside().flat_map(|(sign, line)| self.follow(look, sign, line)).collect();
                let scene = Scene { expressions, morphs, locate: &locate, follow: &follow };
                let value = Keys::one(over.value.clone());
                let keys = [first.stroke.0];
                cues.extend(lay_out(over.channel, &value, &keys, last.hold_end.0, &scene)?);
            }
        }
        Ok(Face::new(cues))
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

    /// The directions from the eyes to the hands that are looked at, at the sign's keys, and their instants.
    fn follow(&self, look: Look, sign: &Prepared, timeline: &Timeline) -> Vec<(f64, DVec3)> {
        let eyes = self.signer.gaze_origin(&self.neutral_model);
        let seen = |side: Side| match look {
            Look::Hands | Look::Ahead | Look::Gaze => true,
            Look::Strong => side == Side::Right,
            Look::Weak => side == Side::Left,
        };
        let hands: Vec<_> = sign.hands.iter().filter(|hand| seen(hand.side)).collect();
        let at_key = |(key, instant): (usize, &f64)| {
            let place = |hand: &&HandPlan| {
                let gone = hand.legs.iter().rev().find(|leg| leg.interval < key).map(|leg| &leg.to);
                gone.unwrap_or(&hand.start).position(&self.neutral_model)
            };
            let mean = hands.iter().map(place).sum::<DVec3>() / hands.len().max(1) as f64;
            (*instant, mean - eyes)
        };
        if hands.is_empty() {
            return Vec::new();
        }
        timeline.keys.iter().enumerate().map(at_key).collect()
    }

    /// Writes the non-manuals of one instant; returns how the shoulders are moved.
    pub(super) fn express(&self, face: &Face, time: f64, pose: &mut LocalPose, weights: &mut [f32]) -> [Shoulder; 2] {
        let state = face.state_at(time);
        for (morph, weight) in &state.morphs {
            if let Some(own) = weights.get_mut(*morph) {
                *own = (f64::from(*own) + weight) as f32;
            }
        }
        if !state.morphs.is_empty() {
            weights.iter_mut().for_each(|weight| *weight = weight.clamp(0.0, 1.0));
        }
        if !state.torso.is_zero() {
            self.signer.turn_torso(state.torso, pose);
        }
        if !state.head.is_zero() {
            self.signer.turn_head(state.head, pose);
        }
        if state.push != 0.0 {
            self.signer.push_head(state.push, pose);
        }
        if !state.eyes.is_zero() {
            self.signer.turn_eyes(state.eyes, pose);
        }
        for (side, shoulder) in [Side::Left, Side::Right].into_iter().zip(state.shoulders) {
            if !shoulder.is_zero() {
                self.signer.move_shoulder(side, shoulder, pose);
            }
        }
        state.shoulders
    }
}
