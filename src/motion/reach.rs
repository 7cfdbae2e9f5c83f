//! Reaching with an arm: FABRIK, and the closed form where FABRIK is slow.
//!
//! FABRIK needs 4 iterations on average but 50 at .999 of the reach, and does not end near full fold. Beyond
//! [`FAR`] and below [`NEAR`] of the arm's length, and wherever it runs out of iterations, the same elbow plane
//! is solved in closed form.
//!
//! # Conventions
//! Model space, metres; the elbow's plane is that of [`super::fabrik`].

use super::fabrik::{InnerAngles, Options, Outcome, Pole, Solution, solve_arm};
use super::rotation::direction;
use super::two_bone::{distance_at, solve, swivel_of};
use glam::DVec3;

/// Beyond this share of the arm's length the closed form is used.
pub const FAR: f64 = 0.98;
/// Below this share of the arm's length the closed form is used.
pub const NEAR: f64 = 0.35;

/// Moves shoulder, elbow and wrist so that the wrist meets the target, whatever its distance.
///
/// ```
/// use chereme::motion::{fabrik::Options, reach::reach};
/// use glam::DVec3;
/// let start = [DVec3::ZERO, DVec3::new(0.2, -0.2, 0.0), DVec3::new(0.45, -0.15, 0.0)];
/// let near_full_stretch = DVec3::new(0.0, 0.0, 0.537);
/// let arm = reach(start, near_full_stretch, &Options::default());
/// assert!(arm.converged() && arm.residual_m < 1e-9);
/// ```
pub fn reach(start: [DVec3; 3], target: DVec3, options: &Options) -> Solution<[DVec3; 3]> {
    let [shoulder, elbow, wrist] = start;
    let (upper, fore) = (shoulder.distance(elbow), elbow.distance(wrist));
    let share = shoulder.distance(target) / (upper + fore);
    if (NEAR..=FAR).contains(&share) {
        let solution = solve_arm(start, target, options);
        if solution.outcome != Outcome::IterationLimit {
            return solution;
        }
    }
    // One iteration at no tolerance settles the plane, the limits and the refusals; then the elbow is exact.
    let planned = solve_arm(start, target, &Options { max_iterations: 0, ..*options });
    if planned.outcome != Outcome::IterationLimit && planned.outcome != Outcome::Limited {
        return planned;
    }
    let Some(axis) = direction(target - shoulder).or_else(|| direction(elbow - shoulder)) else {
        return planned;
    };
    let (least, greatest) = allowed(upper, fore, options.limits);
    let aim = shoulder + axis * shoulder.distance(target).clamp(least, greatest);
    let side = planned.joints[1] - shoulder;
    let exact = solve(shoulder, aim, upper, fore, 0.0, side);
    let residual_m = exact.wrist.distance(target);
    let outcome = if residual_m <= options.tolerance_m.max(1e-12) { Outcome::Converged } else { planned.outcome };
    Solution { joints: [shoulder, exact.elbow, exact.wrist], residual_m, iterations: planned.iterations, outcome }
}

/// The distances from shoulder to wrist that the limits allow.
fn allowed(upper: f64, fore: f64, limits: Option<InnerAngles>) -> (f64, f64) {
    let whole = ((upper - fore).abs(), upper + fore);
    match limits {
        Some(l) => {
            let (fold, stretch) = (distance_at(upper, fore, l.least), distance_at(upper, fore, l.greatest));
            if fold <= stretch { (fold, stretch) } else { whole }
        }
        None => whole,
    }
}

/// The same arm with its elbow swivelled about the line from shoulder to wrist, to `swivel` from `reference`
/// (see [`super::two_bone`]); a straight arm stays.
///
/// ```
/// use chereme::motion::reach::swivelled;
/// use glam::DVec3;
/// let arm = [DVec3::ZERO, DVec3::new(0.2, -0.2, 0.0), DVec3::X * 0.4];
/// let raised = swivelled(arm, std::f64::consts::PI, -DVec3::Y);
/// assert!((raised[1] - DVec3::new(0.2, 0.2, 0.0)).length() < 1e-12);
/// ```
pub fn swivelled(arm: [DVec3; 3], swivel: f64, reference: DVec3) -> [DVec3; 3] {
    let [shoulder, elbow, wrist] = arm;
    let turn = swivel_of(shoulder, elbow, wrist, reference).zip(direction(wrist - shoulder));
    match turn {
        Some((now, axis)) if swivel.is_finite() => {
            let turn = glam::DQuat::from_axis_angle(axis, swivel - now);
            [shoulder, shoulder + turn * (elbow - shoulder), wrist]
        }
        _ => arm,
    }
}

/// Options with the elbow toward `pole`, whatever the start pose.
///
/// ```
/// use chereme::motion::fabrik::Pole;
/// use glam::DVec3;
/// assert_eq!(chereme::motion::reach::toward(-DVec3::Y).pole, Pole::Always(-DVec3::Y));
/// ```
pub fn toward(pole: DVec3) -> Options {
    Options { pole: Pole::Always(pole), ..Options::default() }
}
