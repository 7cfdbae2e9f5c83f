//! Rotations as angles about axes, and back.
//!
//! Any unit quaternion is `Rz(a) · Rx(b) · Ry(c)`. Sums and differences of its parts give half the sum and half the
//! difference of `a` and `c` without a matrix and without an arc sine, so angles are good to the last digits next to
//! gimbal lock too (Bernardes and Viollet, "Quaternion to Euler angles conversion: a direct, general and
//! computationally efficient method", 2022).

use super::data::Axis;
use glam::DQuat;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Below this, the sum or the difference of the outer angles is noise: taking any other turns less than 1e-7 rad.
const LOCKED: f64 = 1e-8;

/// The rotation by an angle in radians about an axis.
pub(super) fn about(axis: Axis, angle: f64) -> DQuat {
    let (sin, cos) = (angle / 2.0).sin_cos();
    let v = axis.vector() * sin;
    DQuat::from_xyzw(v.x, v.y, v.z, cos)
}

/// Angles `[a, b, c]` in radians with `q = Rz(a) · Rx(b) · Ry(c)`, of all that there are those nearest to `before`.
///
/// So curves over frames have no jumps: angles go on beyond a half turn, and at gimbal lock they stay where they were.
pub(super) fn zxy(q: DQuat, before: [f64; 3]) -> [f64; 3] {
    let (plus, minus) = ((q.w + q.x, q.z + q.y), (q.w - q.x, q.z - q.y));
    let (size_plus, size_minus) = (plus.0.hypot(plus.1), minus.0.hypot(minus.1));
    // Half of a + c, and half of a − c.
    let mut half_sum = plus.1.atan2(plus.0);
    let mut half_difference = minus.1.atan2(minus.0);
    if size_plus < LOCKED {
        half_sum = before[0] - half_difference;
    } else if size_minus < LOCKED {
        half_difference = before[0] - half_sum;
    }
    let b = FRAC_PI_2 - 2.0 * size_minus.atan2(size_plus);
    let a = half_sum + half_difference;
    let c = half_sum - half_difference;
    nearest([a, b, c], before)
}

/// Of the two triples of angles about three different axes that make one rotation, each with any whole turns, the one nearest to
/// another; the middle angle is the second.
pub(super) fn nearest([a, b, c]: [f64; 3], before: [f64; 3]) -> [f64; 3] {
    let one = [near(a, before[0]), near(b, before[1]), near(c, before[2])];
    let other = [near(a + PI, before[0]), near(PI - b, before[1]), near(c + PI, before[2])];
    let way = |angles: &[f64; 3]| angles.iter().zip(before).map(|(x, y)| (x - y).powi(2)).sum::<f64>();
    // A hair's preference for the first, so that rounding does not choose.
    if way(&other) + 1e-9 < way(&one) { other } else { one }
}

/// The angle plus the whole turns that bring it nearest to another.
pub(super) fn near(angle: f64, other: f64) -> f64 {
    angle - TAU * ((angle - other) / TAU).round()
}
