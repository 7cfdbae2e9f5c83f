//! Rotations taken apart and put together: swing and twist, shortest arcs, rotation vectors.
//!
//! # Conventions
//! A rotation `q` is *swing · twist*: first it turns about the bone (twist), then it moves the bone (swing).
//! Angles are radians, right-handed about their axis. Axes need not be unit vectors. Every function
//! returns unit quaternions for any finite input; a quaternion without direction counts as the identity.

use glam::{DMat3, DQuat, DVec3};
use std::f64::consts::{PI, TAU};

/// The unit quaternion in the direction of `q`; the identity where `q` is zero or not finite.
///
/// A quaternion that is unit already (to 1e-15) is returned as it is.
///
/// ```
/// use chereme::motion::rotation::unit;
/// use glam::DQuat;
/// assert_eq!(unit(DQuat::from_xyzw(0.0, 3.0, 0.0, 0.0)), DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0));
/// assert_eq!(unit(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)), DQuat::IDENTITY);
/// ```
pub fn unit(q: DQuat) -> DQuat {
    let square = q.length_squared();
    if (square - 1.0).abs() <= 1e-15 {
        return q;
    }
    let largest = q.x.abs().max(q.y.abs()).max(q.z.abs()).max(q.w.abs());
    if !(q.is_finite() && largest > 0.0) {
        return DQuat::IDENTITY;
    }
    let scaled = DQuat::from_xyzw(q.x / largest, q.y / largest, q.z / largest, q.w / largest);
    scaled * (1.0 / scaled.length())
}

/// The unit vector in the direction of `v`, or `None` where `v` is zero or not finite.
///
/// ```
/// use chereme::motion::rotation::direction;
/// use glam::DVec3;
/// assert_eq!(direction(DVec3::new(0.0, 1e-200, 0.0)), Some(DVec3::Y));
/// assert_eq!(direction(DVec3::ZERO), None);
/// ```
pub fn direction(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (v.is_finite() && largest > 0.0).then(|| {
        let scaled = v / largest;
        scaled / scaled.length()
    })
}

/// A rotation as a turn about a bone followed by a move of the bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwingTwist {
    /// Moves the bone; its own axis is perpendicular to the bone.
    pub swing: DQuat,
    /// Turns about the bone.
    pub twist: DQuat,
}

/// Takes `q` apart: `q = swing · twist`, `twist` about `axis`.
///
/// Where the swing is a half turn the twist is undefined and is taken as none.
///
/// ```
/// use chereme::motion::rotation::{angle_between, swing_twist};
/// use glam::{DQuat, DVec3};
/// let q = DQuat::from_rotation_y(0.4) * DQuat::from_rotation_x(0.9);
/// let parts = swing_twist(q, DVec3::X);
/// assert!(angle_between(parts.twist, DQuat::from_rotation_x(0.9)) < 1e-9);
/// assert!(angle_between(parts.swing * parts.twist, q) < 1e-9);
/// ```
pub fn swing_twist(q: DQuat, axis: DVec3) -> SwingTwist {
    let q = unit(q);
    let Some(axis) = direction(axis) else {
        return SwingTwist { swing: q, twist: DQuat::IDENTITY };
    };
    let along = DVec3::new(q.x, q.y, q.z).dot(axis);
    if along.hypot(q.w) < 1e-12 {
        return SwingTwist { swing: q, twist: DQuat::IDENTITY };
    }
    let v = axis * along;
    let twist = unit(DQuat::from_xyzw(v.x, v.y, v.z, q.w));
    SwingTwist { swing: unit(q * twist.conjugate()), twist }
}

/// How far `q` turns about `axis`: the angle of its twist, in (−π, π].
///
/// ```
/// use chereme::motion::rotation::twist_angle;
/// use glam::{DQuat, DVec3};
/// let q = DQuat::from_rotation_y(0.4) * DQuat::from_rotation_x(-0.9);
/// assert!((twist_angle(q, DVec3::X) + 0.9).abs() < 1e-12);
/// ```
pub fn twist_angle(q: DQuat, axis: DVec3) -> f64 {
    let Some(axis) = direction(axis) else { return 0.0 };
    let q = unit(q);
    let along = DVec3::new(q.x, q.y, q.z).dot(axis);
    if along.hypot(q.w) < 1e-12 {
        return 0.0;
    }
    wrap(2.0 * along.atan2(q.w))
}

/// The share of a hand's twist that a leaf twist joint on the forearm takes.
///
/// `share` is the joint's place along the forearm, 0 at the elbow and 1 at the wrist; `twist` is the hand's
/// turn about the forearm, radians (not wrapped, so that a turn past π keeps its side).
///
/// ```
/// use chereme::motion::rotation::{angle_between, twist_share};
/// use glam::{DQuat, DVec3};
/// let third = twist_share(DVec3::X, 1.2, 1.0 / 3.0);
/// assert!(angle_between(third, DQuat::from_rotation_x(0.4)) < 1e-12);
/// ```
pub fn twist_share(axis: DVec3, twist: f64, share: f64) -> DQuat {
    let angle = twist * share;
    match direction(axis) {
        Some(axis) if angle.is_finite() => DQuat::from_axis_angle(axis, angle),
        _ => DQuat::IDENTITY,
    }
}

/// The least rotation that takes the direction `from` to `to`.
///
/// Where the two are opposite every half turn would do: it turns about `fallback_axis` (made perpendicular to `from`).
///
/// ```
/// use chereme::motion::rotation::shortest_arc;
/// use glam::DVec3;
/// let q = shortest_arc(DVec3::X, -DVec3::X, DVec3::Y);
/// assert!((q * DVec3::X + DVec3::X).length() < 1e-12);
/// assert!((q * DVec3::Y - DVec3::Y).length() < 1e-12);
/// ```
pub fn shortest_arc(from: DVec3, to: DVec3, fallback_axis: DVec3) -> DQuat {
    let (Some(from), Some(to)) = (direction(from), direction(to)) else {
        return DQuat::IDENTITY;
    };
    let sum = from + to;
    if sum.length_squared() > 1e-14 {
        // A reflection through the bisector, stable to within 1e-7 rad of opposite.
        let half = sum / sum.length();
        let v = from.cross(half);
        return unit(DQuat::from_xyzw(v.x, v.y, v.z, from.dot(half)));
    }
    let axis = perpendicular(fallback_axis, from);
    DQuat::from_xyzw(axis.x, axis.y, axis.z, 0.0)
}

/// The rotation that takes one pair of perpendicular unit vectors to another.
///
/// ```
/// use chereme::motion::rotation::{angle_between, frame_to_frame};
/// use glam::{DQuat, DVec3};
/// let quarter = frame_to_frame((DVec3::X, DVec3::Y), (DVec3::Y, -DVec3::X));
/// assert!(angle_between(quarter, DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2)) < 1e-12);
/// ```
pub fn frame_to_frame(from: (DVec3, DVec3), to: (DVec3, DVec3)) -> DQuat {
    let from = DMat3::from_cols(from.0, from.1, from.0.cross(from.1));
    let to = DMat3::from_cols(to.0, to.1, to.0.cross(to.1));
    unit(DQuat::from_mat3(&(to * from.transpose())))
}

/// The part of `v` perpendicular to the unit vector `axis`, as a unit vector; where nothing is left of
/// `v`, some fixed perpendicular of `axis`.
///
/// ```
/// use chereme::motion::rotation::perpendicular;
/// use glam::DVec3;
/// assert_eq!(perpendicular(DVec3::new(5.0, 2.0, 0.0), DVec3::X), DVec3::Y);
/// assert!(perpendicular(DVec3::X, DVec3::X).dot(DVec3::X).abs() < 1e-12);
/// ```
pub fn perpendicular(v: DVec3, axis: DVec3) -> DVec3 {
    let v = direction(v).unwrap_or(DVec3::ZERO);
    let left = v - axis * v.dot(axis);
    match direction(left) {
        Some(unit) if left.length_squared() > 1e-16 => unit,
        _ => axis.any_orthonormal_vector(),
    }
}

/// `q` or `−q`, whichever is nearer to `previous`: the same rotation, without a jump of sign.
///
/// ```
/// use chereme::motion::rotation::continuous;
/// use glam::DQuat;
/// let q = DQuat::from_rotation_x(0.2);
/// assert_eq!(continuous(q, -q), q);
/// ```
pub fn continuous(previous: DQuat, q: DQuat) -> DQuat {
    if previous.dot(q) < 0.0 { -q } else { q }
}

/// The angle of the rotation between two orientations, in [0, π].
///
/// ```
/// use chereme::motion::rotation::angle_between;
/// use glam::DQuat;
/// assert!((angle_between(DQuat::from_rotation_x(0.2), -DQuat::from_rotation_x(0.5)) - 0.3).abs() < 1e-12);
/// ```
pub fn angle_between(a: DQuat, b: DQuat) -> f64 {
    let (a, b) = (unit(a), unit(b));
    let b = continuous(a, b);
    4.0 * (b - a).length().atan2((b + a).length())
}

/// The rotation vector of `q` (axis times angle, the angle in [0, π]): the logarithm.
///
/// ```
/// use chereme::motion::rotation::to_vector;
/// use glam::{DQuat, DVec3};
/// assert!((to_vector(DQuat::from_rotation_z(0.7)) - DVec3::Z * 0.7).length() < 1e-12);
/// ```
pub fn to_vector(q: DQuat) -> DVec3 {
    let q = continuous(DQuat::IDENTITY, unit(q));
    let v = DVec3::new(q.x, q.y, q.z);
    let sine = v.length();
    if sine < 1e-150 { DVec3::ZERO } else { v * (2.0 * sine.atan2(q.w) / sine) }
}

/// The rotation of a rotation vector (axis times angle): the exponential.
///
/// ```
/// use chereme::motion::rotation::{angle_between, from_vector};
/// use glam::{DQuat, DVec3};
/// assert!(angle_between(from_vector(DVec3::X * 0.7), DQuat::from_rotation_x(0.7)) < 1e-12);
/// ```
pub fn from_vector(v: DVec3) -> DQuat {
    let angle = v.length();
    match direction(v) {
        Some(axis) if angle.is_finite() => DQuat::from_axis_angle(axis, angle),
        _ => DQuat::IDENTITY,
    }
}

/// The angle brought into (−π, π].
///
/// ```
/// use chereme::motion::rotation::wrap;
/// assert!((wrap(7.0) - (7.0 - std::f64::consts::TAU)).abs() < 1e-12);
/// ```
pub fn wrap(angle: f64) -> f64 {
    if !angle.is_finite() {
        return 0.0;
    }
    let within = angle.rem_euclid(TAU);
    if within > PI { within - TAU } else { within }
}

/// The angle equal to `angle` up to full turns that lies nearest to `previous`.
///
/// ```
/// use chereme::motion::rotation::unwrap_near;
/// assert!((unwrap_near(3.1, -3.1) - 3.1831853).abs() < 1e-6);
/// ```
pub fn unwrap_near(previous: f64, angle: f64) -> f64 {
    if previous.is_finite() { previous + wrap(angle - previous) } else { wrap(angle) }
}
