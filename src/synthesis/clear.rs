//! Hands kept out of the body: where a way would lead through it, it leads along its skin.
//!
//! A description says where a hand starts, which way it goes and how far, not how the body curves. Ours is moved out by
//! the depth of its deepest point, and smoothly into and out of that. A point that is to touch the skin stays on it.

use super::reach::HandTarget;
use super::stage::Stage;
use crate::body::solid::HAND_M;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::phonology::{Digit, HandPart, HandPoint, Side};
use glam::{DQuat, DVec3};

/// Joints lie under the skin and the body's surface is coarse, so they may be so deep, metres.
const ALLOWED: f64 = 0.006;
/// A hand that touches the skin is moved by so little at most, metres; by so many times more than its contact point is away from
/// the skin.
const AT_TOUCH: (f64, f64) = (0.003, 3.0);
/// A contact point so near to the skin touches it, metres.
const TOUCHES: f64 = 0.01;
/// How long it takes to get out of the way, seconds.
const EASE: f64 = 0.12;

impl Stage<'_> {
    /// Moves the targets of consecutive frames out of the body. `models` is empty where the body stands still.
    pub(super) fn keep_clear(&self, side: Side, models: &[ModelPose], poses: &[LocalPose], targets: &mut [HandTarget]) {
        let tips = self.tips(side);
        let model_of = |n: usize| models.get(n).unwrap_or(&self.neutral_model);
        let way = |(n, (target, pose)): (usize, (&HandTarget, &LocalPose))| {
            self.way_clear(target, model_of(n), || self.probes(side, &tips, pose))
        };
        let ways: Vec<DVec3> = targets.iter().zip(poses).enumerate().map(way).collect();
        if ways.iter().all(|way| *way == DVec3::ZERO) {
            return;
        }
        let around = (EASE * self.options.fps.get()).round().max(1.0) as usize;
        let near = |i: usize, all: usize| i.saturating_sub(around)..(i + around + 1).min(all);
        let longest = |range: &[DVec3]| {
            range.iter().copied().fold(DVec3::ZERO, |a, b| if b.length() > a.length() { b } else { a })
        };
        let widened: Vec<DVec3> = (0..ways.len()).map(|i| longest(&ways[near(i, ways.len())])).collect();
        for (i, target) in targets.iter_mut().enumerate() {
            let range = near(i, widened.len());
            let count = range.len() as f64;
            let way = widened[range].iter().sum::<DVec3>() / count;
            let way = way.clamp_length_max(self.leeway(target, model_of(i)));
            target.point += way;
            target.aside_m = way.length();
        }
    }

    /// The way by which one target is out of the body.
    fn way_clear(&self, target: &HandTarget, model: &ModelPose, probes: impl FnOnce() -> Vec<DVec3>) -> DVec3 {
        let wrist = target.point - target.rotation * target.offset;
        if self.signer.solid.is_beyond(HAND_M, wrist, model) {
            return DVec3::ZERO;
        }
        let places: Vec<DVec3> = probes().into_iter().map(|offset| wrist + target.rotation * offset).collect();
        let mut way = DVec3::ZERO;
        // Out of the trunk a hand may come to the head.
        for _ in 0..3 {
            let deepest = places
                .iter()
                .map(|place| self.signer.solid.depth(*place + way, model))
                .max_by(|a, b| a.0.total_cmp(&b.0));
            match deepest {
                Some((deep, out)) if deep > ALLOWED => way += out * (deep - ALLOWED),
                Some(_) | None => break,
            }
        }
        way
    }

    /// How far a target may be moved, metres: a contact point stays on what it touches.
    fn leeway(&self, target: &HandTarget, model: &ModelPose) -> f64 {
        let (deep, _) = self.signer.solid.depth(target.point, model);
        let off_skin = deep.abs().min(self.signer.solid.from_landmark(target.point, model));
        AT_TOUCH.0 + AT_TOUCH.1 * (off_skin - TOUCHES).max(0.0)
    }

    /// The tip of each digit from its last joint, in that joint's axes.
    fn tips(&self, side: Side) -> [DVec3; 5] {
        Digit::ALL.map(|digit| {
            let point = HandPoint::of_digit(digit, HandPart::Tip);
            let found = point.and_then(|point| self.signer.landmarks.hand_point(side, point).ok());
            found.and_then(|point| point.parts().first().map(|part| part.offset)).unwrap_or_default()
        })
    }

    /// Points of a hand from its wrist, in the hand's axes: the wrist, and every digit's joints and tip.
    fn probes(&self, side: Side, tips: &[DVec3; 5], pose: &LocalPose) -> Vec<DVec3> {
        let skeleton = &self.signer.skeleton;
        let joints = self.signer.hand(side).joints();
        let mut probes = Vec::with_capacity(1 + 4 * tips.len());
        probes.push(DVec3::ZERO);
        for (digit, tip) in joints.chunks(3).zip(tips) {
            let (mut at, mut turned) = (DVec3::ZERO, DQuat::IDENTITY);
            for joint in digit {
                at += turned * skeleton.offset(*joint);
                turned *= pose.rotation(*joint);
                probes.push(at);
            }
            probes.push(at + turned * *tip);
        }
        probes
    }
}
