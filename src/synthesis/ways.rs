//! The ways from the neutral pose to the stroke and back, eased in joint space (Naert et al. 2021, §4.2).

use super::plan::HandPlan;
use super::reach::ArmFrame;
use super::timeline::Timeline;
use super::write::Writer;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::twist_angle;
use crate::motion::short_arc::ShortArc;
use glam::DVec3;

impl Writer<'_> {
    /// Eases the arm's joints from the neutral pose to the stroke and back (Naert et al. 2021, §4.2).
    pub(super) fn write_ways(
        &self,
        plan: &HandPlan,
        timeline: &Timeline,
        first: usize,
        last: usize,
        poses: &mut [LocalPose],
    ) {
        let fps = self.options.fps.get();
        let arm = self.signer.arm(plan.side);
        let joints = [arm.clavicle, arm.upper, arm.fore, arm.hand];
        let rotations = |pose: &LocalPose| joints.map(|j| pose.rotation(j));
        let (start, end) = (rotations(&poses[first]), rotations(&poses[last]));
        let neutral = rotations(&self.neutral);
        let there: [ShortArc; 4] = std::array::from_fn(|j| ShortArc::new(neutral[j], start[j]));
        let back: [ShortArc; 4] = std::array::from_fn(|j| ShortArc::new(end[j], neutral[j]));
        let (begun, ended) = (first as f64 / fps, last as f64 / fps);
        for (i, pose) in poses.iter_mut().enumerate() {
            let time = i as f64 / fps;
            let (arcs, share) = if i < first {
                (&there, (time - timeline.start) / (begun - timeline.start).max(1e-9))
            } else if i > last {
                (&back, (time - ended) / (timeline.retracted - ended).max(1e-9))
            } else {
                continue;
            };
            // Before the preparation and after the retraction the arm hangs still.
            let still = if i < first { share <= 0.0 } else { share >= 1.0 };
            let weight = self.options.easing.weight(share);
            for (j, joint) in joints.iter().enumerate() {
                let rotation = if still { neutral[j] } else { arcs[j].eased(self.options.easing, weight) };
                pose.set(*joint, rotation);
            }
            let twist = twist_angle(pose.rotation(arm.hand), arm.rest.fore());
            arm.write_twist(twist, pose);
        }
    }

    /// Where the wrist is in every frame: as solved in the stroke, by forward kinematics of the arm elsewhere.
    pub(super) fn wrists(&self, plan: &HandPlan, solved: &[ArmFrame], first: usize, poses: &[LocalPose]) -> Vec<DVec3> {
        let arm = self.signer.arm(plan.side);
        let skeleton = &self.signer.skeleton;
        let trunk = skeleton[arm.clavicle].parent.unwrap_or(arm.clavicle);
        let model = self.planner.neutral;
        let (base, turn) = (model.position(arm.clavicle), model.rotation(trunk));
        (0..poses.len())
            .map(|i| match i.checked_sub(first).and_then(|n| solved.get(n)) {
                Some(frame) => frame.wrist,
                None => {
                    let (mut at, mut turned) = (base, turn * poses[i].rotation(arm.clavicle));
                    for joint in [arm.upper, arm.fore, arm.hand] {
                        at += turned * skeleton.offset(joint);
                        turned *= poses[i].rotation(joint);
                    }
                    at
                }
            })
            .collect()
    }
}
