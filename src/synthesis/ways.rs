//! The ways between strokes, and from and to the neutral pose, eased in joint space (Naert et al. 2021, §4.2).
//!
//! A hand goes straight from one stroke to its next one, the handshape forming early; where it has time for it, or the
//! line rests, it returns to the neutral pose meanwhile.

use super::smooth::write_wrist;
use super::stage::{Posture, Stage};
use super::stroke::Stint;
use crate::body::arm::{ArmRig, WristLimits};
use crate::motion::arm::ArmAngles;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::twist_angle;
use crate::motion::short_arc::ShortArc;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;
use glam::DQuat;
use std::ops::Range;

/// A way of one arm: its frames, and its two ends in seconds.
pub(super) struct Way {
    pub side: Side,
    pub frames: Range<usize>,
    pub from: Posture,
    pub to: Posture,
    /// When it begins and ends; the arm stands still before and after.
    pub begin: f64,
    pub end: f64,
    /// The part of the way after which the handshape is there.
    pub lead: f64,
}

/// When a hand that has time for it leaves for the neutral pose and comes from it, seconds.
pub(super) struct AtRest {
    /// The neutral pose is reached.
    pub from: f64,
    /// It is left.
    pub until: f64,
}

/// A way strays that leaves the wrist's limits by so much, radians.
const STRAYS: f64 = 0.012;

impl Stage<'_> {
    /// A hand at rest on one side.
    pub(super) fn at_rest(&self, side: Side) -> Posture {
        self.posture(side, &self.neutral)
    }

    /// Writes the frames between two strokes of one hand: straight, or by the neutral pose.
    pub(super) fn write_between(&self, a: &Stint, b: &Stint, rest: Option<AtRest>, poses: &mut [LocalPose]) {
        let fps = self.options.fps.get();
        let (begin, end) = (a.last as f64 / fps, b.first as f64 / fps);
        let (from, to) = (self.posture(a.side, &poses[a.last]), self.posture(a.side, &poses[b.first]));
        let lead = self.grammar.movements.timing.handshape_lead;
        let frames = a.last + 1..b.first;
        match rest {
            None => self.write_way(&Way { side: a.side, frames, from, to, begin, end, lead }, poses),
            Some(rest) => {
                let still = self.at_rest(a.side);
                let middle = (((rest.from + rest.until) / 2.0 * fps).round() as usize).clamp(frames.start, frames.end);
                let away = Way {
                    side: a.side,
                    frames: frames.start..middle,
                    from,
                    to: still,
                    begin,
                    end: rest.from,
                    lead: 1.0,
                };
                self.write_way(&away, poses);
                let back =
                    Way { side: a.side, frames: middle..frames.end, from: still, to, begin: rest.until, end, lead };
                self.write_way(&back, poses);
            }
        }
    }

    /// Writes the frames before a hand's first stroke, which it prepares from `begin` on.
    pub(super) fn write_preparation(&self, stint: &Stint, begin: f64, poses: &mut [LocalPose]) {
        let end = stint.first as f64 / self.options.fps.get();
        let (from, to) = (self.at_rest(stint.side), self.posture(stint.side, &poses[stint.first]));
        let lead = self.grammar.movements.timing.handshape_lead;
        self.write_way(&Way { side: stint.side, frames: 0..stint.first, from, to, begin, end, lead }, poses);
    }

    /// Writes the frames after a hand's last stroke; it is back at rest at `end`.
    pub(super) fn write_retraction(&self, stint: &Stint, end: f64, poses: &mut [LocalPose]) {
        let begin = stint.last as f64 / self.options.fps.get();
        let (from, to) = (self.posture(stint.side, &poses[stint.last]), self.at_rest(stint.side));
        let frames = stint.last + 1..poses.len();
        self.write_way(&Way { side: stint.side, frames, from, to, begin, end, lead: 1.0 }, poses);
    }

    fn write_way(&self, way: &Way, poses: &mut [LocalPose]) {
        let (fps, easing) = (self.options.fps.get(), self.options.easing);
        let arm = self.signer.arm(way.side);
        let arm_joints = arm.joints();
        let finger_joints = self.signer.hand(way.side).joints();
        let arm_arcs: [ShortArc; 4] = std::array::from_fn(|j| ShortArc::new(way.from.arm[j], way.to.arm[j]));
        let finger_arcs: [ShortArc; 15] =
            std::array::from_fn(|j| ShortArc::new(way.from.fingers[j], way.to.fingers[j]));
        let wrist = over_the_limits(arm, way.from.arm[3], way.to.arm[3]);
        let whole = (way.end - way.begin).max(1e-9);
        let ease =
            |joints: &[JointId], arcs: &[ShortArc], ends: (&[DQuat], &[DQuat]), share: f64, pose: &mut LocalPose| {
                let weight = easing.weight(share);
                for (j, joint) in joints.iter().enumerate() {
                    let rotation = match share {
                        s if s <= 0.0 => ends.0[j],
                        s if s >= 1.0 => ends.1[j],
                        _ => arcs[j].eased(easing, weight),
                    };
                    pose.set(*joint, rotation);
                }
            };
        for i in way.frames.clone() {
            let pose = &mut poses[i];
            let share = (i as f64 / fps - way.begin) / whole;
            ease(&arm_joints, &arm_arcs, (&way.from.arm, &way.to.arm), share, pose);
            ease(&finger_joints, &finger_arcs, (&way.from.fingers, &way.to.fingers), share / way.lead, pose);
            self.signer.hand(way.side).limit_spread(pose);
            match &wrist {
                Some((from, to)) => write_wrist(arm, from, to, easing.weight(share), pose),
                None => {
                    let twist = twist_angle(pose.rotation(arm.hand), arm.rest.fore());
                    arm.write_twist(twist, pose);
                }
            }
        }
    }
}

/// The wrist's angles at both ends of a way whose short arc would turn the forearm or bend the wrist farther than they go, where
/// both ends lie within the limits: then the way leads through the middle.
fn over_the_limits(arm: &ArmRig, from: DQuat, to: DQuat) -> Option<(ArmAngles, ArmAngles)> {
    let limits = WristLimits::ANATOMICAL;
    let outside = |hand: DQuat| limits.excess(&arm.rest.angles(hand)) > STRAYS * STRAYS;
    let arc = ShortArc::new(from, to);
    let strays = [0.2, 0.35, 0.5, 0.65, 0.8].into_iter().any(|weight| outside(arc.at(weight)));
    (strays && !outside(from) && !outside(to)).then(|| (arm.rest.angles(from), arm.rest.angles(to)))
}
