//! The fingers of every frame: eased in joint space from shape to shape (Naert et al. 2021, §5.2).

use super::path_of_hand::Instant;
use super::plan::HandPlan;
use super::timeline::Timeline;
use super::write::Writer;
use crate::motion::pose::LocalPose;
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use crate::phonology::handshape::HandAngles;
use glam::DQuat;

/// The fingers' rotations, in the order of the hand's joints.
type Fingers = [DQuat; 15];

impl Writer<'_> {
    /// The fingers of every frame: formed early on the way there, changed with the stroke, loosened on the way back.
    pub(super) fn write_fingers(
        &self,
        plan: &HandPlan,
        timeline: &Timeline,
        instants: &[Instant],
        first: usize,
        poses: &mut [LocalPose],
    ) {
        let fps = self.options.fps.get();
        let easing = self.options.easing;
        let lead = self.grammar.movements.timing.handshape_lead;
        let loose = self.fingers(plan.side, &self.relaxed);
        let shapes: Vec<Fingers> = plan.keys.iter().map(|k| self.fingers(plan.side, &k.angles)).collect();
        let joints = self.signer.hand(plan.side).joints();
        let arcs = |a: &Fingers, b: &Fingers| -> [ShortArc; 15] { std::array::from_fn(|j| ShortArc::new(a[j], b[j])) };
        let along = |arcs: &[ShortArc; 15], w: f64| -> Fingers { std::array::from_fn(|j| arcs[j].eased(easing, w)) };
        let last = first + instants.len() - 1;
        // A key's shape, and the way to the next one's.
        let changes: Vec<[ShortArc; 15]> =
            (0..shapes.len()).map(|k| arcs(&shapes[k], &shapes[(k + 1).min(shapes.len() - 1)])).collect();
        let formed = |now: &Instant| match now.done {
            d if d <= 0.0 => shapes[now.key],
            d if d >= 1.0 => shapes[(now.key + 1).min(shapes.len() - 1)],
            d => along(&changes[now.key], d),
        };
        let there = arcs(&loose, &shapes[0]);
        let back = instants.last().map(|now| arcs(&formed(now), &loose));
        for (i, pose) in poses.iter_mut().enumerate() {
            let time = i as f64 / fps;
            let mut fingers = if i < first {
                let share = (time - timeline.start) / (timeline.stroke - timeline.start) / lead;
                if share <= 0.0 { loose } else { along(&there, easing.weight(share)) }
            } else if i <= last {
                formed(&instants[i - first])
            } else {
                let share = (time - timeline.hold_end) / (timeline.retracted - timeline.hold_end);
                match &back {
                    Some(back) if share < 1.0 => along(back, easing.weight(share)),
                    _ => loose,
                }
            };
            if i >= first
                && i <= last
                && let Some(bends) = instants[i - first].wiggle(plan)
            {
                for (finger, bend) in bends.into_iter().enumerate() {
                    // Joints come thumb first, three a digit; flexion is about ∓Z.
                    let knuckle = 3 * (finger + 1);
                    fingers[knuckle] *= DQuat::from_rotation_z(-bend * plan.side.sign());
                }
            }
            for (joint, rotation) in joints.iter().zip(fingers) {
                pose.set(*joint, rotation);
            }
        }
    }

    fn fingers(&self, side: Side, angles: &HandAngles) -> Fingers {
        let hand = self.signer.hand(side);
        let mut pose = self.neutral.clone();
        hand.apply(angles, &mut pose);
        hand.joints().map(|j| pose.rotation(j))
    }
}
