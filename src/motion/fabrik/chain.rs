//! FABRIK for a chain of any number of joints.

use super::{InnerAngles, Options, Outcome, PRE_BEND, Solution, bend_side, within};
use crate::motion::rotation::{direction, perpendicular};
use glam::{DQuat, DVec3};

/// Moves a chain of joints so that its tip meets the target; the base stays.
///
/// No joint gives no joint; one alone stays. A chain bent less than [`PRE_BEND`] from the line to its target is
/// bent first. Where the longest bone keeps the tip from a near target the iterations find it out, and the outcome
/// is [`Outcome::TooNear`].
///
/// ```
/// use chereme::motion::fabrik::{Options, solve_chain};
/// use glam::DVec3;
/// let spine: Vec<DVec3> = (0..5).map(|i| DVec3::Y * 0.1 * f64::from(i)).collect();
/// let bent = solve_chain(&spine, DVec3::new(0.1, 0.3, 0.05), &Options::default());
/// assert!(bent.converged() && bent.residual_m <= 1e-3);
/// ```
pub fn solve_chain(start: &[DVec3], target: DVec3, options: &Options) -> Solution<Vec<DVec3>> {
    let mut joints = start.to_vec();
    let lengths: Vec<f64> = start.windows(2).map(|w| w[0].distance(w[1])).collect();
    let (Some(&base), Some(&tip)) = (start.first(), start.last()) else {
        return Solution { joints, residual_m: 0.0, iterations: 0, outcome: Outcome::Refused };
    };
    let total: f64 = lengths.iter().sum();
    let wanted = base.distance(target);
    let residual_m = tip.distance(target).min(f64::MAX);
    // False for NaN too, which an overflow may have left.
    let computable = total + wanted + residual_m < 1e75;
    if !computable {
        return Solution { joints, residual_m, iterations: 0, outcome: Outcome::Refused };
    }
    let tolerance = options.tolerance_m.max(0.0);
    if residual_m <= tolerance && options.may_stay() {
        return Solution { joints, residual_m, iterations: 0, outcome: Outcome::Converged };
    }
    if wanted >= total && options.limits.is_none() {
        let axis = direction(target - base).unwrap_or(DVec3::X);
        for (i, length) in lengths.iter().enumerate() {
            joints[i + 1] = joints[i] + axis * *length;
        }
        let residual_m = wanted - total;
        let outcome = if residual_m > tolerance { Outcome::TooFar } else { Outcome::Converged };
        return Solution { joints, residual_m, iterations: 0, outcome };
    }
    pre_bend(&mut joints, target, options);
    let mut iterations = 0;
    let mut residual_m = f64::INFINITY;
    while residual_m > tolerance && iterations < options.max_iterations {
        tip_to_base(&mut joints, &lengths, target);
        base_to_tip(&mut joints, &lengths, base, options.limits);
        residual_m = joints[joints.len() - 1].distance(target);
        iterations += 1;
    }
    if iterations == 0 {
        // No iteration was allowed: the pre-bent chain, its lengths intact.
        residual_m = joints[joints.len() - 1].distance(target);
    }
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    let outcome = if residual_m <= tolerance {
        Outcome::Converged
    } else if wanted < 2.0 * longest - total {
        Outcome::TooNear
    } else if wanted > total {
        Outcome::TooFar
    } else if options.limits.is_some() {
        Outcome::Limited
    } else {
        Outcome::IterationLimit
    };
    Solution { joints, residual_m, iterations, outcome }
}

/// Turns a chain that lies along the line to its target, and applies [`super::Pole::Always`].
fn pre_bend(joints: &mut [DVec3], target: DVec3, options: &Options) {
    let base = joints[0];
    let Some(axis) = direction(target - base).or_else(|| joints.get(1).and_then(|j| direction(*j - base))) else {
        return;
    };
    let widest = joints.iter().map(|j| *j - base).map(|v| (v - axis * v.dot(axis), v.length()));
    let (across, length) =
        widest.fold(
            (DVec3::ZERO, 0.0),
            |best, (a, l)| if a.length_squared() > best.0.length_squared() { (a, l) } else { best },
        );
    let straight = across.length() <= PRE_BEND.sin() * length;
    let side = bend_side(across, straight, axis, options.pole);
    if straight {
        // Turn the first bone alone: enough to leave the line, and every length is kept.
        let Some(&elbow) = joints.get(1) else { return };
        let first = elbow - base;
        let (size, sign) = (first.length(), 1f64.copysign(first.dot(axis)));
        let moved = base + (axis * (PRE_BEND.cos() * sign) + side * PRE_BEND.sin()) * size;
        for joint in &mut joints[1..] {
            *joint += moved - elbow;
        }
    } else if let super::Pole::Always(_) = options.pole {
        let from = perpendicular(across, axis);
        let angle = from.cross(side).dot(axis).atan2(from.dot(side));
        let turn = DQuat::from_axis_angle(axis, angle);
        for joint in &mut joints[1..] {
            *joint = base + turn * (*joint - base);
        }
    }
}

fn tip_to_base(joints: &mut [DVec3], lengths: &[f64], target: DVec3) {
    let last = joints.len() - 1;
    joints[last] = target;
    for i in (0..last).rev() {
        let along = direction(joints[i] - joints[i + 1]).unwrap_or(DVec3::X);
        joints[i] = joints[i + 1] + along * lengths[i];
    }
}

fn base_to_tip(joints: &mut [DVec3], lengths: &[f64], base: DVec3, limits: Option<InnerAngles>) {
    joints[0] = base;
    let mut before: Option<DVec3> = None;
    for i in 0..lengths.len() {
        let mut along = direction(joints[i + 1] - joints[i]).or(before).unwrap_or(DVec3::X);
        if let (Some(before), Some(limits)) = (before, limits) {
            along = within(before, along, limits);
        }
        joints[i + 1] = joints[i] + along * lengths[i];
        before = Some(along);
    }
}
