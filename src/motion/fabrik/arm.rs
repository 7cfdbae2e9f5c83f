//! FABRIK for shoulder, elbow and wrist, reduced to one number.
//!
//! The first pass puts the wrist on the target, so the start wrist does not matter: everything stays in the
//! plane of shoulder, target and elbow. In that plane let the shoulder be the origin, the target (r, 0) and the
//! elbow (x, y) on the circle of radius l₁. One iteration is then
//!
//! - tip to base: e′ = t + u (e − t) with u = l₂ / d, d = |e − t| = √(l₁² + r² − 2 r x);
//! - base to tip: e″ = l₁ e′ / |e′| with |e′|² = r² + l₂² + 2 u r (x − r),
//!
//! so x alone carries it on. The wrist lies on the line from elbow to target, |d − l₂| from the target:
//! the residual. No vector is touched between the first and the last iteration; the iterates are those of
//! [`super::solve_chain`].

use super::{Options, Outcome, PRE_BEND, Solution, bend_side, within};
use crate::motion::rotation::direction;
use crate::motion::two_bone::distance_at;
use glam::DVec3;

/// The lengths and the elbow's place in the plane of shoulder, target and elbow.
struct Plane {
    upper: f64,
    fore: f64,
    reach: f64,
}

impl Plane {
    /// From an elbow at `x` to the target.
    fn to_target(&self, x: f64) -> f64 {
        (self.upper * self.upper + self.reach * self.reach - 2.0 * self.reach * x).max(TINY).sqrt()
    }

    /// The elbow's `x` after one iteration, from the one before and its distance to the target.
    ///
    /// Both passes with numerator and root multiplied by d: two roots and one division in all.
    fn iterate(&self, x: f64, distance: f64) -> f64 {
        let back = self.fore * (x - self.reach);
        let scaled = distance * (self.reach * self.reach + self.fore * self.fore) + 2.0 * self.reach * back;
        let square = distance * scaled;
        let x = self.upper * (distance * self.reach + back) / square.max(TINY).sqrt();
        // On the circle, also where rounding has left nothing of the square.
        x.clamp(-self.upper, self.upper)
    }
}

/// Squares below this are rounding noise; keeps divisions finite.
const TINY: f64 = 1e-30;
/// sin and cos of [`PRE_BEND`].
const PRE_BEND_SINE: f64 = 0.017_452_406_437_283_51;
const PRE_BEND_COSINE: f64 = 0.999_847_695_156_391_2;
const _: () = assert!(PRE_BEND > 0.017_453 && PRE_BEND < 0.017_454);

/// Moves shoulder, elbow and wrist so that the wrist meets the target; the shoulder stays.
///
/// With limits on the inner angle of the elbow (which for two bones are limits on the distance from shoulder to
/// wrist) the wrist comes as near to the target as they let it.
///
/// ```
/// use chereme::motion::fabrik::{Options, solve_arm};
/// use glam::DVec3;
/// let start = [DVec3::ZERO, DVec3::new(0.2, -0.2, 0.0), DVec3::new(0.45, -0.15, 0.0)];
/// let target = DVec3::new(0.3, 0.1, 0.3);
/// let arm = solve_arm(start, target, &Options::default());
/// assert!(arm.converged() && arm.joints[2].distance(target) <= 1e-3);
/// ```
pub fn solve_arm(start: [DVec3; 3], target: DVec3, options: &Options) -> Solution<[DVec3; 3]> {
    let [shoulder, elbow, wrist] = start;
    let first = elbow - shoulder;
    let gap = target - shoulder;
    let (upper_square, reach_square) = (first.length_squared(), gap.length_squared());
    let fore_square = (wrist - elbow).length_squared();
    // False for NaN too, which an overflow may have left.
    let computable = upper_square + reach_square + fore_square < 1e150;
    if !computable {
        let residual_m = (target - wrist).length().min(f64::MAX);
        return Solution { joints: start, residual_m, iterations: 0, outcome: Outcome::Refused };
    }
    let tolerance = options.tolerance_m.max(0.0);
    if options.may_stay() && wrist.distance_squared(target) <= tolerance * tolerance {
        let residual_m = wrist.distance(target);
        return Solution { joints: start, residual_m, iterations: 0, outcome: Outcome::Converged };
    }
    let (upper, fore, wanted) = (upper_square.sqrt(), fore_square.sqrt(), reach_square.sqrt());
    let axis = if wanted > 1e-12 { gap * (1.0 / wanted) } else { direction(first).unwrap_or(DVec3::X) };

    // What the bones, then the limits, leave of the distance from shoulder to wrist.
    let (mut least, mut greatest) = ((upper - fore).abs(), upper + fore);
    let mut short = if wanted > greatest { Outcome::TooFar } else { Outcome::TooNear };
    if let Some(limits) = options.limits {
        let (fold, stretch) = (distance_at(upper, fore, limits.least), distance_at(upper, fore, limits.greatest));
        if fold <= stretch && (wanted < fold || wanted > stretch) {
            short = Outcome::Limited;
            (least, greatest) = (fold, stretch);
        }
    }
    let reach = wanted.clamp(least, greatest);
    let missed = (wanted - reach).abs();

    let x = first.dot(axis);
    let across = first - axis * x;
    let straight = across.length_squared() <= upper_square * (PRE_BEND_SINE * PRE_BEND_SINE);
    let side = bend_side(across, straight, axis, options.pole);
    let mut x = if straight { upper * PRE_BEND_COSINE.copysign(x) } else { x };

    let flat = reach <= (upper - fore).abs() || reach >= upper + fore;
    let mut iterations = 0;
    let mut outcome = Outcome::Converged;
    if flat {
        // Stretched or folded flat: on the line, exactly.
        x = if reach >= upper + fore || upper >= fore { upper } else { -upper };
        let tip = axis * reach;
        let joints = [shoulder, shoulder + axis * x, shoulder + tip];
        let outcome = if missed > tolerance { short } else { outcome };
        return Solution { joints, residual_m: missed, iterations, outcome };
    }
    let plane = Plane { upper, fore, reach };
    let mut distance = plane.to_target(x);
    loop {
        let off = (distance - fore).abs();
        if off <= tolerance && iterations > 0 {
            break;
        }
        if iterations == options.max_iterations {
            outcome = Outcome::IterationLimit;
            break;
        }
        x = plane.iterate(x, distance);
        distance = plane.to_target(x);
        iterations += 1;
    }
    x = x.clamp(-upper, upper);
    let y = ((upper - x) * (upper + x)).sqrt();
    let bone = axis * x + side * y;
    let aim = axis * reach;
    let mut along = (aim - bone) * (1.0 / (aim - bone).length().max(TINY));
    if let (Some(limits), Some(before)) = (options.limits, direction(bone)) {
        along = within(before, along, limits);
    }
    let tip = bone + along * fore;
    let residual_m = (gap - tip).length();
    if missed > tolerance {
        outcome = short;
    } else if outcome == Outcome::Converged && residual_m > tolerance + 1e-12 {
        // The tolerance had bent the elbow past its limit, and the final clamp took that back.
        outcome = Outcome::Limited;
    }
    Solution { joints: [shoulder, shoulder + bone, shoulder + tip], residual_m, iterations, outcome }
}
