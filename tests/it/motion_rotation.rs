//! Rotations: laws on random input.

use super::motion_easing::any_rotation;
use chereme::motion::rotation::*;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use std::f64::consts::PI;

/// Every finite number, subnormal ones and zeros too.
pub fn finite() -> impl Strategy<Value = f64> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

pub fn any_direction() -> impl Strategy<Value = DVec3> {
    (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64)
        .prop_map(|(x, y, z)| DVec3::new(x, y, z))
        .prop_filter("has a direction", |v| v.length() > 1e-3)
        .prop_map(|v| v.normalize())
}

proptest! {
    #[test]
    fn swing_times_twist_is_the_rotation(q in any_rotation(), axis in any_direction()) {
        let parts = swing_twist(q, axis);
        prop_assert!(angle_between(parts.swing * parts.twist, q) < 1e-9);
        // The twist keeps the axis, the swing has no turn about it.
        prop_assert!((parts.twist * axis - axis).length() < 1e-9);
        prop_assert!(twist_angle(parts.swing, axis).abs() < 1e-6);
        let turned = DQuat::from_axis_angle(axis, twist_angle(q, axis));
        prop_assert!(angle_between(turned, parts.twist) < 1e-6);
    }

    #[test]
    fn swing_of_the_inverse_is_the_other_order(q in any_rotation(), axis in any_direction()) {
        // q = twist · swing′ as well, with the same twist.
        let parts = swing_twist(q, axis);
        let after = parts.twist.conjugate() * q;
        prop_assert!(twist_angle(after, axis).abs() < 1e-6);
    }

    #[test]
    fn shortest_arc_takes_from_to_to(a in any_direction(), b in any_direction(), fallback in any_direction()) {
        let q = shortest_arc(a, b, fallback);
        prop_assert!((q * a - b).length() < 1e-9);
        prop_assert!((angle_between(q, DQuat::IDENTITY) - a.angle_between(b)).abs() < 1e-6);
    }

    #[test]
    fn opposite_directions_turn_about_the_fallback(a in any_direction(), fallback in any_direction()) {
        let q = shortest_arc(a, -a, fallback);
        prop_assert!((q * a + a).length() < 1e-6);
        prop_assert!((q.length() - 1.0).abs() < 1e-12);
        let axis = perpendicular(fallback, a);
        prop_assert!((q * axis - axis).length() < 1e-6);
    }

    #[test]
    fn vector_and_rotation_read_back(q in any_rotation()) {
        prop_assert!(angle_between(from_vector(to_vector(q)), q) < 1e-9);
        prop_assert!(to_vector(q).length() <= PI + 1e-12);
    }

    #[test]
    fn angles_are_wrapped_and_unwrapped(angle in -1e3..1e3f64, previous in -50.0..50.0f64) {
        let wrapped = wrap(angle);
        prop_assert!(wrapped > -PI - 1e-9 && wrapped <= PI);
        let near = unwrap_near(previous, angle);
        prop_assert!((near - previous).abs() <= PI + 1e-9);
        prop_assert!(wrap(near - angle).abs() < 1e-9);
    }

    #[test]
    fn no_finite_input_gives_nan(v in prop::array::uniform10(finite())) {
        let (a, b, c) = (DVec3::new(v[0], v[1], v[2]), DVec3::new(v[3], v[4], v[5]), DVec3::new(v[6], v[7], v[8]));
        let q = DQuat::from_xyzw(v[0], v[3], v[6], v[9]);
        for q in [shortest_arc(a, b, c), swing_twist(q, a).swing, swing_twist(q, a).twist, from_vector(a), twist_share(a, v[9], v[8])] {
            prop_assert!((q.length() - 1.0).abs() < 1e-9, "{q:?}");
        }
        prop_assert!(to_vector(q).is_finite() && twist_angle(q, a).is_finite() && angle_between(q, -q).is_finite());
    }
}

#[test]
fn leaf_twists_share_the_hand_s_turn_by_their_place() {
    let hand = DQuat::from_rotation_x(1.2) * DQuat::from_rotation_z(0.5);
    let twist = twist_angle(hand, DVec3::X);
    for share in [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0] {
        let joint = twist_share(DVec3::X, twist, share);
        assert!((twist_angle(joint, DVec3::X) - share * twist).abs() < 1e-12);
    }
}
