//! Arms without jumps: where two frames of a stroke have nothing to do with each other, the way between is eased.
//!
//! A description may ask a wrist for more than a wrist can: then the nearest posture that it can take changes from one
//! side to the other between two frames. The arm goes over in joint space, in a time in which it can.

use super::stage::Stage;
use crate::motion::easing::Easing;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{angle_between, twist_angle};
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use glam::DVec3;

/// Faster than this a wrist does not go from frame to frame by itself, metres a second; nor a joint, radians a second.
const JUMPS_M: f64 = 4.0;
const JUMPS_RAD: f64 = 25.0;
/// And so many times as far as between the frames beside.
const BESIDE: f64 = 3.0;
/// How fast the arm goes over at most, metres and radians a second.
const OVER_M: f64 = 2.6;
const OVER_RAD: f64 = 10.0;

impl Stage<'_> {
    /// Eases the jumps of an arm in consecutive frames. `wrists` is where its wrist is in each of them. Whether there
    /// were any.
    pub(super) fn smooth(&self, side: Side, wrists: &[DVec3], poses: &mut [LocalPose]) -> bool {
        let arm = self.signer.arm(side);
        let joints = [arm.clavicle, arm.upper, arm.fore, arm.hand];
        let fps = self.options.fps.get();
        let steps: Vec<(f64, f64)> = poses
            .windows(2)
            .zip(wrists.windows(2))
            .map(|(pair, at)| {
                let turned = joints.map(|j| angle_between(pair[0].rotation(j), pair[1].rotation(j)));
                (at[0].distance(at[1]) * fps, turned.into_iter().fold(0.0, f64::max) * fps)
            })
            .collect();
        let spans = spans(&steps, fps);
        for (first, last) in &spans {
            let arcs = joints.map(|j| ShortArc::new(poses[*first].rotation(j), poses[*last].rotation(j)));
            for i in first + 1..*last {
                let weight = Easing::MinimumJerk.weight((i - first) as f64 / (last - first) as f64);
                for (joint, arc) in joints.iter().zip(&arcs) {
                    poses[i].set(*joint, arc.at(weight));
                }
                let twist = twist_angle(poses[i].rotation(arm.hand), arm.rest.fore());
                arm.write_twist(twist, &mut poses[i]);
            }
        }
        !spans.is_empty()
    }
}

/// The frames between which the arm goes over: from, to. `steps` are speeds between frames, metres and radians a second.
fn spans(steps: &[(f64, f64)], fps: f64) -> Vec<(usize, usize)> {
    let mut spans: Vec<(usize, usize)> = Vec::new();
    for (i, (metres, radians)) in steps.iter().enumerate() {
        let beside = |of: fn(&(f64, f64)) -> f64| {
            let near = [i.checked_sub(2), i.checked_sub(1), Some(i + 1), Some(i + 2)];
            let mut near: Vec<f64> = near.into_iter().flatten().filter_map(|n| steps.get(n).map(of)).collect();
            near.sort_by(f64::total_cmp);
            near.get(near.len() / 2).copied().unwrap_or(0.0)
        };
        let jumps = *metres > JUMPS_M && *metres > BESIDE * beside(|s| s.0)
            || *radians > JUMPS_RAD && *radians > BESIDE * beside(|s| s.1);
        if !jumps {
            continue;
        }
        // Peak speed of minimum jerk is 1.875 times the mean.
        let seconds = 1.875 * (metres / fps / OVER_M).max(radians / fps / OVER_RAD);
        let half = (seconds * fps / 2.0).ceil().max(2.0) as usize;
        let (first, last) = (i.saturating_sub(half), (i + 1 + half).min(steps.len()));
        match spans.last_mut() {
            Some(before) if before.1 >= first => before.1 = before.1.max(last),
            Some(_) | None => spans.push((first, last)),
        }
    }
    spans
}
