//! Orientation reconstruction: forward kinematics of the rotations gives the positions back.

use super::motion_easing::any_rotation;
use super::motion_rotation::{any_direction, finite};
use chereme::motion::arm::{ArmHint, ArmPose, ArmRest, ROLL_SEEN, orient};
use chereme::motion::rotation::{angle_between, to_vector};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

const UPPER_M: f64 = 0.242;
const FORE_M: f64 = 0.239;

fn check(rest: ArmRest, side: f64, parent: DQuat, arm: [DVec3; 3], hand: DQuat, hint: Option<ArmHint>) -> ArmPose {
    let pose = orient(&rest, parent, arm, hand, hint);
    let (upper, fore) = (parent * pose.upper, parent * pose.upper * pose.fore);
    let elbow = arm[0] + upper * DVec3::X * side * UPPER_M;
    let wrist = elbow + fore * DVec3::X * side * FORE_M;
    assert!(
        elbow.distance(arm[1]) < 1e-9 && wrist.distance(arm[2]) < 1e-7,
        "{} {}",
        elbow.distance(arm[1]),
        wrist.distance(arm[2])
    );
    assert!(angle_between(fore * pose.hand, hand) < 1e-9, "the hand's model rotation");
    assert!(angle_between(pose.hand_twist * pose.hand_swing, pose.hand) < 1e-9);
    pose
}

fn place(shoulder: DVec3, a: DVec3, b: DVec3) -> [DVec3; 3] {
    [shoulder, shoulder + a * UPPER_M, shoulder + a * UPPER_M + b * FORE_M]
}

proptest! {
    #[test]
    fn positions_come_back_and_the_elbow_is_a_hinge(
        parent in any_rotation(), hand in any_rotation(), a in any_direction(), b in any_direction(), left in any::<bool>(),
    ) {
        let (rest, side) = if left { (ArmRest::left(), 1.0) } else { (ArmRest::right(), -1.0) };
        let pose = check(rest, side, parent, place(DVec3::Y, a, b), hand, None);
        if pose.angles.elbow > ROLL_SEEN && pose.angles.elbow < 3.1 {
            // A turn about the one hinge axis, forward, by the elbow's flexion.
            let turn = to_vector(pose.fore);
            prop_assert!((turn - rest.hinge() * pose.angles.elbow).length() < 1e-6, "{turn}");
        }
        prop_assert!(pose.angles.elbow >= 0.0);
        // The swing has no turn about the forearm.
        prop_assert!(to_vector(pose.hand_swing).dot(rest.fore()).abs() < 1e-6);
        let swing = to_vector(pose.hand_swing).length();
        prop_assert!((pose.angles.flexion.hypot(pose.angles.radial) - swing).abs() < 1e-6);
    }

    #[test]
    fn a_straight_elbow_keeps_the_roll_of_its_hint(parent in any_rotation(), a in any_direction(), roll in any_direction()) {
        prop_assume!(a.cross(roll).length() > 0.05);
        let hint = ArmHint { hinge_model: roll, twist: 0.0 };
        let pose = check(ArmRest::left(), 1.0, parent, place(DVec3::ZERO, a, a), DQuat::IDENTITY, Some(hint));
        let kept = (roll - a * roll.dot(a)).normalize();
        prop_assert!(pose.hinge_model.distance(kept) < 1e-9);
        let hinge = parent * pose.upper * ArmRest::left().hinge();
        prop_assert!(hinge.distance(kept) < 1e-7);
    }

    #[test]
    fn no_finite_input_gives_nan(v in prop::array::uniform20(finite())) {
        let at = |i: usize| DVec3::new(v[i], v[i + 1], v[i + 2]);
        let turn = |i: usize| DQuat::from_xyzw(v[i], v[i + 1], v[i + 2], v[i + 3]);
        let hint = ArmHint { hinge_model: at(17), twist: v[0] };
        let pose = orient(&ArmRest::left(), turn(9), [at(0), at(3), at(6)], turn(13), Some(hint));
        for q in [pose.upper, pose.fore, pose.hand, pose.hand_twist, pose.hand_swing] {
            prop_assert!((q.length() - 1.0).abs() < 1e-9, "{pose:?}");
        }
        let a = pose.angles;
        prop_assert!([a.elbow, a.twist, a.flexion, a.radial].iter().all(|x| x.is_finite()));
        if let Some(rest) = ArmRest::new(at(0), at(3), at(6), at(9), at(12)) {
            let pose = orient(&rest, turn(9), [at(0), at(3), at(6)], turn(13), None);
            prop_assert!((pose.fore.length() - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn rest_is_the_identity() {
    for (rest, side) in [(ArmRest::left(), 1.0), (ArmRest::right(), -1.0)] {
        let arm = place(DVec3::Y, DVec3::X * side, DVec3::X * side);
        let pose = check(rest, side, DQuat::IDENTITY, arm, DQuat::IDENTITY, None);
        for q in [pose.upper, pose.fore, pose.hand] {
            assert!(angle_between(q, DQuat::IDENTITY) < 1e-9);
        }
    }
}

#[test]
fn the_wrist_s_angles_have_their_anatomical_signs() {
    for (rest, side) in [(ArmRest::left(), 1.0), (ArmRest::right(), -1.0)] {
        let arm = place(DVec3::ZERO, DVec3::X * side, DVec3::new(side, 0.0, 0.2).normalize());
        let straight = orient(&rest, DQuat::IDENTITY, arm, DQuat::IDENTITY, None);
        let fore = straight.upper * straight.fore;
        // Toward the palm is down, toward the thumb is forward.
        let down = orient(&rest, DQuat::IDENTITY, arm, fore * DQuat::from_rotation_z(-0.5 * side), None).angles;
        assert!((down.flexion - 0.5).abs() < 1e-9 && down.radial.abs() < 1e-9, "{down:?}");
        let forward = orient(&rest, DQuat::IDENTITY, arm, fore * DQuat::from_rotation_y(-0.3 * side), None).angles;
        assert!((forward.radial - 0.3).abs() < 1e-9 && forward.flexion.abs() < 1e-9, "{forward:?}");
    }
}

#[test]
fn a_turning_hand_passes_a_half_turn_without_a_jump() {
    let arm = place(DVec3::ZERO, DVec3::X, DVec3::Z);
    let mut hint = None;
    let mut before: Option<f64> = None;
    for i in 0..100 {
        let hand = DQuat::from_rotation_z(0.05 * f64::from(i));
        let pose = orient(&ArmRest::left(), DQuat::IDENTITY, arm, hand, hint);
        if let Some(before) = before {
            assert!((pose.angles.twist - before).abs() < 0.2, "{i}: {before} {}", pose.angles.twist);
        }
        before = Some(pose.angles.twist);
        hint = Some(pose.hint());
    }
}

#[test]
fn an_arm_that_straightens_and_bends_again_keeps_its_roll() {
    let mut hint = None;
    let mut before: Option<DQuat> = None;
    for i in -60..=60 {
        let flexion = (f64::from(i) / 60.0).abs() * 0.6;
        let fore = DVec3::new(flexion.cos(), 0.0, flexion.sin());
        let pose =
            check(ArmRest::left(), 1.0, DQuat::IDENTITY, place(DVec3::ZERO, DVec3::X, fore), DQuat::IDENTITY, hint);
        if let Some(before) = before {
            assert!(angle_between(before, pose.upper) < 1e-6);
        }
        before = Some(pose.upper);
        hint = Some(pose.hint());
    }
}
