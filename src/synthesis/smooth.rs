//! Arms without jumps: where two frames of a stroke have nothing to do with each other, the way between is eased.
//!
//! A description may ask a wrist for more than a wrist can: then the nearest posture that it can take changes from one
//! side to the other between two frames. The arm goes over in joint space, in a time in which it can.

use super::reach::ArmFrame;
use super::stage::Stage;
use crate::body::arm::ArmRig;
use crate::motion::arm::ArmAngles;
use crate::motion::easing::Easing;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::angle_between;
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;

/// A joint of an arm that turns faster than this from one frame to the next jumps, radians a second, and so does a wrist
/// that goes faster than this, metres a second, if it is so many times as far as between the frames beside.
const JUMPS_RAD: f64 = 20.0;
const JUMPS_M: f64 = 4.0;
const BESIDE: f64 = 2.5;
/// How fast the arm goes over at most: the wrist, metres a second; shoulder and elbow, and the hand, radians a second.
const OVER_M: f64 = 2.6;
const OVER_ARM: f64 = 5.0;
const OVER_HAND: f64 = 10.0;
/// The peak speed of minimum jerk against its mean.
const PEAK: f64 = 1.875;

impl Stage<'_> {
    /// Eases the jumps of an arm in consecutive frames, one pose and one solution each.
    pub(super) fn smooth(&self, side: Side, solved: &[ArmFrame], poses: &mut [LocalPose]) {
        let arm = self.signer.arm(side);
        let fps = self.options.fps.get();
        let above = [arm.clavicle, arm.upper, arm.fore];
        for (first, last) in spans(arm, fps, solved, poses) {
            let arcs = above.map(|j| ShortArc::new(poses[first].rotation(j), poses[last].rotation(j)));
            let (from, to) = (solved[first].arm.angles, solved[last].arm.angles);
            for (i, pose) in poses.iter_mut().enumerate().take(last).skip(first + 1) {
                let weight = Easing::MinimumJerk.weight((i - first) as f64 / (last - first) as f64);
                for (joint, arc) in above.iter().zip(&arcs) {
                    pose.set(*joint, arc.at(weight));
                }
                write_wrist(arm, &from, &to, weight, pose);
            }
        }
    }
}

/// Turns forearm and wrist from some angles to others as wrists go, which is not always the shortest way.
pub(super) fn write_wrist(arm: &ArmRig, from: &ArmAngles, to: &ArmAngles, weight: f64, pose: &mut LocalPose) {
    let between = |of: fn(&ArmAngles) -> f64| of(from) + (of(to) - of(from)) * weight;
    let twist = between(|a| a.twist);
    pose.set(arm.hand, arm.rest.hand(twist, between(|a| a.flexion), between(|a| a.radial)));
    arm.write_twist(twist, pose);
}

/// The frames between which the arm goes over: from, to.
fn spans(arm: &ArmRig, fps: f64, solved: &[ArmFrame], poses: &[LocalPose]) -> Vec<(usize, usize)> {
    let turned = |a: usize, b: usize| arm.joints().map(|j| angle_between(poses[a].rotation(j), poses[b].rotation(j)));
    let moved = |a: usize, b: usize| solved[a].wrist.distance(solved[b].wrist);
    let steps: Vec<f64> = (1..poses.len()).map(|i| moved(i - 1, i) * fps).collect();
    let turns: Vec<f64> = (1..poses.len()).map(|i| turned(i - 1, i).into_iter().fold(0.0, f64::max) * fps).collect();
    let beside = |steps: &[f64], i: usize| {
        let near = [i.checked_sub(2), i.checked_sub(1), Some(i + 1), Some(i + 2)];
        let mut near: Vec<f64> = near.into_iter().flatten().filter_map(|n| steps.get(n).copied()).collect();
        near.sort_by(f64::total_cmp);
        near.get(near.len() / 2).copied().unwrap_or(0.0)
    };
    // How long the arm needs from one frame to another, seconds.
    let needs = |a: usize, b: usize| {
        let [clavicle, upper, fore, hand] = turned(a, b);
        let of_arm = clavicle.max(upper).max(fore) / OVER_ARM;
        PEAK * of_arm.max(hand / OVER_HAND).max(moved(a, b) / OVER_M)
    };
    let mut spans: Vec<(usize, usize)> = Vec::new();
    for (i, step) in steps.iter().enumerate() {
        // A fast turn is no jump where the frames beside turn as well.
        let leaps = |value: f64, least: f64, all: &[f64]| value > least && value > BESIDE * beside(all, i);
        if !(leaps(turns[i], JUMPS_RAD, &turns) || leaps(*step, JUMPS_M, &steps)) {
            continue;
        }
        let (mut first, mut last) = (i, i + 1);
        // Further off the arm may be elsewhere again, so the time is found step by step.
        for _ in 0..ROUNDS {
            let half = (needs(first, last) * fps / 2.0).ceil().max(2.0) as usize;
            let (wider, later) = (first.min(i.saturating_sub(half)), last.max((i + 1 + half).min(steps.len())));
            if (wider, later) == (first, last) {
                break;
            }
            (first, last) = (wider, later);
        }
        match spans.last_mut() {
            Some(before) if before.1 >= first => *before = (before.0.min(first), before.1.max(last)),
            Some(_) | None => spans.push((first, last)),
        }
    }
    spans
}

/// How often a span is made wider.
const ROUNDS: usize = 6;
