//! Two bones in closed form: the law of cosines for shoulder, elbow and wrist.
//!
//! The oracle beside [`super::fabrik`], and what is used near full stretch or fold, where FABRIK is slow.
//!
//! # Conventions
//! Model space, metres. The elbow's *swivel* is its angle about the axis from shoulder to wrist,
//! right-handed, from the given reference direction (made perpendicular to the axis): at swivel 0 the
//! elbow lies on the side of the reference.

use super::rotation::{direction, perpendicular};
use glam::DVec3;

/// An elbow and a wrist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoBone {
    /// Model space, metres.
    pub elbow: DVec3,
    /// Model space, metres.
    pub wrist: DVec3,
    /// From the wrist to the target; above 0 only where the target is too far or too near.
    pub residual_m: f64,
}

/// Places elbow and wrist for a target, in closed form.
///
/// A target too far stretches the arm toward it, one too near folds it; a target on the shoulder itself
/// is approached from the reference direction. Negative and non-finite lengths count as 0.
///
/// ```
/// use chereme::motion::two_bone::solve;
/// use glam::DVec3;
/// let arm = solve(DVec3::ZERO, DVec3::X * 0.5, 0.3, 0.4, 0.0, -DVec3::Y);
/// assert!((arm.wrist - DVec3::X * 0.5).length() < 1e-12);
/// assert!((arm.elbow - DVec3::new(0.18, -0.24, 0.0)).length() < 1e-12);
/// ```
pub fn solve(shoulder: DVec3, target: DVec3, upper_m: f64, fore_m: f64, swivel: f64, reference: DVec3) -> TwoBone {
    let clean = |l: f64| if l.is_finite() { l.max(0.0) } else { 0.0 };
    let (upper, fore) = (clean(upper_m), clean(fore_m));
    let gap = target - shoulder;
    let wanted = gap.length();
    let axis = direction(gap).or_else(|| direction(reference)).unwrap_or(DVec3::X);
    let reach = wanted.clamp((upper - fore).abs(), upper + fore);
    // Along the axis by the law of cosines, written so that squares do not cancel; across by Pythagoras.
    let along = if reach > 0.0 { 0.5 * (reach + (upper - fore) / reach * (upper + fore)) } else { 0.0 };
    let along = along.clamp(-upper, upper);
    let across = ((upper - along) * (upper + along)).max(0.0).sqrt();
    let side = perpendicular(reference, axis);
    let (sine, cosine) = if swivel.is_finite() { swivel.sin_cos() } else { (0.0, 1.0) };
    let side = side * cosine + axis.cross(side) * sine;
    let elbow = shoulder + axis * along + side * across;
    let wrist = shoulder + axis * reach;
    TwoBone { elbow, wrist, residual_m: (wanted - reach).abs().min(f64::MAX) }
}

/// The swivel of an elbow, in (−π, π]; `None` where the arm is straight or folded flat (elbow less than a
/// micrometre off the line from shoulder to wrist) or wrist and shoulder are one place.
///
/// ```
/// use chereme::motion::two_bone::{solve, swivel_of};
/// use glam::DVec3;
/// let arm = solve(DVec3::ZERO, DVec3::X * 0.5, 0.3, 0.4, 1.1, -DVec3::Y);
/// let swivel = swivel_of(DVec3::ZERO, arm.elbow, arm.wrist, -DVec3::Y).unwrap();
/// assert!((swivel - 1.1).abs() < 1e-9);
/// ```
pub fn swivel_of(shoulder: DVec3, elbow: DVec3, wrist: DVec3, reference: DVec3) -> Option<f64> {
    let axis = direction(wrist - shoulder)?;
    let arm = elbow - shoulder;
    let across = arm - axis * arm.dot(axis);
    if !(across.is_finite() && across.length() > 1e-6) {
        return None;
    }
    let side = perpendicular(reference, axis);
    Some(across.dot(axis.cross(side)).atan2(across.dot(side)))
}

/// The inner angle at the elbow (π is straight), radians; π where a bone has no length.
///
/// ```
/// use chereme::motion::two_bone::inner_angle;
/// use glam::DVec3;
/// assert!((inner_angle(DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y) - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// ```
pub fn inner_angle(shoulder: DVec3, elbow: DVec3, wrist: DVec3) -> f64 {
    let (Some(a), Some(b)) = (direction(shoulder - elbow), direction(wrist - elbow)) else {
        return std::f64::consts::PI;
    };
    2.0 * (a - b).length().atan2((a + b).length())
}

/// The distance from shoulder to wrist at an inner elbow angle.
///
/// ```
/// use chereme::motion::two_bone::distance_at;
/// assert!((distance_at(0.3, 0.4, std::f64::consts::FRAC_PI_2) - 0.5).abs() < 1e-12);
/// ```
pub fn distance_at(upper_m: f64, fore_m: f64, inner_angle: f64) -> f64 {
    let sine = (0.5 * inner_angle).sin();
    ((upper_m - fore_m).powi(2) + 4.0 * upper_m * fore_m * sine * sine).max(0.0).sqrt()
}
