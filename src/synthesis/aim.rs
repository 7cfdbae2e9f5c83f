//! Pointing: a hand held so that its pointing ray passes through a place (Naert et al. 2021, §4.2).
//!
//! Any configuration may point: with the index where that is stretched, with the middle of three or four stretched
//! fingers, with whatever digit is stretched alone, and with the hand's own axis where none is. The wrist stands on the
//! line from the shoulder to the place, short of it by the hand's length and at most at nine tenths of the reach.

use super::plan::Planner;
use super::reach::natural_rotation;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::shortest_arc;
use crate::phonology::{Digit, Side};
use glam::{DQuat, DVec3};

/// The wrist is at most this part of the arm's length away from the shoulder.
const FARTHEST: f64 = 0.9;
/// And at least this part: nearer, the elbow would fold sharply.
const NEAREST: f64 = 0.4;
/// A digit is stretched where its tip is this far from its root, as a part of its bones' length.
const STRETCHED: f64 = 0.93;

/// A hand that points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aim {
    /// The wrist, model space, metres.
    pub wrist: DVec3,
    /// The hand's rotation, model space.
    pub rotation: DQuat,
}

/// The ray that a hand points with, in the hand's axes from the wrist, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    /// Where it starts: the root of a finger.
    pub from: DVec3,
    /// Where the digit ends.
    pub tip: DVec3,
}

impl Planner<'_> {
    /// The hand that points at a target, model space. `palm` is where the palm faces, where it is stated.
    pub(super) fn aim(&self, side: Side, shaped: &LocalPose, target: DVec3, palm: Option<DVec3>) -> Aim {
        let arm = self.signer.arm(side);
        let ray = self.ray(side, shaped);
        let shoulder = self.neutral.position(arm.upper);
        let toward = (target - shoulder).normalize_or(DVec3::Z);
        let reach = arm.length_m();
        let away = (target.distance(shoulder) - ray.tip.length()).clamp(NEAREST * reach, FARTHEST * reach);
        let wrist = shoulder + toward * away;
        let mut rotation = natural_rotation(arm, shoulder, wrist, DVec3::ZERO, Some(toward), palm);
        // The finger's root is beside the line: a few small turns bring its ray through the target.
        for _ in 0..8 {
            let from = wrist + rotation * ray.from;
            let along = rotation * (ray.tip - ray.from);
            rotation = (shortest_arc(along, target - from, DVec3::Y) * rotation).normalize();
        }
        Aim { wrist, rotation }
    }

    /// The pointing ray of a hand as its fingers are.
    pub(super) fn ray(&self, side: Side, shaped: &LocalPose) -> Ray {
        let (skeleton, hand) = (&self.signer.skeleton, self.signer.hand(side));
        let model = shaped.to_model(skeleton);
        let wrist_joint = self.signer.arm(side).hand;
        let (wrist, turned) = (model.position(wrist_joint), model.rotation(wrist_joint).inverse());
        let of = |digit: Digit| {
            let joints = hand.of_digit(digit);
            let bone = |j: crate::motion::skeleton::JointId| skeleton[j].tail_model - skeleton[j].rest_model;
            let tip = model.point(joints[2], bone(joints[2]));
            let root = model.position(joints[0]);
            let bones: f64 = joints.iter().map(|j| bone(*j).length()).sum();
            let stretched = root.distance(tip) > STRETCHED * bones;
            (stretched, Ray { from: turned * (root - wrist), tip: turned * (tip - wrist) })
        };
        let fingers: Vec<(Digit, Ray)> =
            Digit::FINGERS.into_iter().map(|d| (d, of(d))).filter(|(_, (s, _))| *s).map(|(d, (_, r))| (d, r)).collect();
        let chosen = match fingers.as_slice() {
            [] => None,
            many if many.len() > 2 => many.iter().find(|(d, _)| *d == Digit::Middle).or(many.first()),
            few => few.first(),
        };
        let (thumb_stretched, thumb) = of(Digit::Thumb);
        match chosen {
            Some((_, ray)) => *ray,
            None if thumb_stretched => thumb,
            None => {
                let (_, middle) = of(Digit::Middle);
                Ray { from: DVec3::ZERO, tip: middle.from }
            }
        }
    }
}
