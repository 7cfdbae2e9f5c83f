//! Finger kinematics of the rig: round trips, mirror, directions.

use chereme::body::hand::HandRig;
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::handshape::{HandAngles, HandLimits};
use chereme::phonology::{Digit, Side};
use glam::DVec3;
use proptest::prelude::*;

pub fn skeleton() -> Skeleton {
    Skeleton::from_json(include_str!("../../assets/avatar.skeleton.json")).expect("the avatar's skeleton")
}

/// A hand within limits from 21 numbers between 0 and 1.
pub fn hand_within_limits(shares: [f64; 21]) -> HandAngles {
    let limits = HandLimits::ANATOMICAL;
    let mix = |l: chereme::phonology::handshape::Limits, w: f64| l.least + (l.greatest - l.least) * w;
    let mut angles = [0.0; 21];
    for (i, finger) in limits.fingers.iter().enumerate() {
        let mcp = mix(finger.mcp, shares[4 * i]);
        angles[4 * i] = mcp;
        angles[4 * i + 1] = mix(finger.abduction_at(mcp), shares[4 * i + 1]);
        angles[4 * i + 2] = mix(finger.pip, shares[4 * i + 2]);
        angles[4 * i + 3] = mix(finger.dip, shares[4 * i + 3]);
    }
    let thumb = [limits.radial, limits.palmar, limits.pronation, limits.thumb_mcp, limits.thumb_ip];
    for (k, limit) in thumb.into_iter().enumerate() {
        angles[16 + k] = mix(limit, shares[16 + k]);
    }
    HandAngles::from_array(angles)
}

fn any_hand() -> impl Strategy<Value = HandAngles> {
    proptest::array::uniform21(0.0..1.0f64).prop_map(hand_within_limits)
}

/// Where the tips are, model space.
fn tips(rig: &HandRig, skeleton: &Skeleton, angles: &HandAngles) -> [DVec3; 5] {
    let mut pose = LocalPose::rest(skeleton);
    rig.apply(angles, &mut pose);
    let model = pose.to_model(skeleton);
    Digit::ALL.map(|d| {
        let last = rig.of_digit(d)[2];
        model.point(last, skeleton[last].tail_model - skeleton[last].rest_model)
    })
}

proptest! {
    #[test]
    fn angles_measured_from_a_pose_are_the_angles_applied(hand in any_hand(), left in any::<bool>()) {
        let skeleton = skeleton();
        let rig = HandRig::new(&skeleton, if left { Side::Left } else { Side::Right }).expect("the avatar has hands");
        let mut pose = LocalPose::rest(&skeleton);
        rig.apply(&hand, &mut pose);
        prop_assert!(rig.angles_of(&pose).max_difference(&hand) < 1e-9, "{:?}", rig.angles_of(&pose));
    }

    #[test]
    fn the_left_hand_mirrors_the_right(hand in any_hand()) {
        let skeleton = skeleton();
        let [left, right] = [Side::Left, Side::Right].map(|side| {
            tips(&HandRig::new(&skeleton, side).expect("the avatar has hands"), &skeleton, &hand)
        });
        for (l, r) in left.iter().zip(right) {
            prop_assert!(l.distance(r * DVec3::new(-1.0, 1.0, 1.0)) < 1e-5, "{l} {r}");
        }
    }

    #[test]
    fn only_finger_joints_change(hand in any_hand()) {
        let skeleton = skeleton();
        let rig = HandRig::new(&skeleton, Side::Right).expect("the avatar has hands");
        let mut pose = LocalPose::rest(&skeleton);
        rig.apply(&hand, &mut pose);
        let own = rig.joints();
        for id in skeleton.ids().filter(|id| !own.contains(id)) {
            prop_assert_eq!(pose.rotation(id), glam::DQuat::IDENTITY);
        }
    }

    #[test]
    fn clamped_hands_are_within_limits(numbers in proptest::array::uniform21(-3.0..3.0f64)) {
        let clamped = HandLimits::ANATOMICAL.clamp(&HandAngles::from_array(numbers));
        prop_assert!(HandLimits::ANATOMICAL.hold(&clamped));
    }
}

#[test]
fn fingers_flex_to_the_palm_and_spread_from_the_middle_one() {
    let skeleton = skeleton();
    let rig = HandRig::new(&skeleton, Side::Left).expect("the avatar has hands");
    let flat = tips(&rig, &skeleton, &HandAngles::default());
    let mut hand = HandAngles::default();
    for finger in &mut hand.fingers {
        finger.mcp = 1.0;
    }
    let bent = tips(&rig, &skeleton, &hand);
    // The palm of the left hand faces −Y at rest.
    assert!((1..5).all(|i| bent[i].y < flat[i].y - 0.05));
    let mut hand = HandAngles::default();
    for finger in &mut hand.fingers {
        finger.abduction = 0.2;
    }
    let spread = tips(&rig, &skeleton, &hand);
    // The thumb's side is +Z: index and middle finger go there, the others away.
    assert!(spread[1].z > flat[1].z && spread[2].z > flat[2].z && spread[3].z < flat[3].z && spread[4].z < flat[4].z);
}

#[test]
fn the_thumb_goes_out_in_front_of_the_palm_and_closes() {
    let skeleton = skeleton();
    let rig = HandRig::new(&skeleton, Side::Left).expect("the avatar has hands");
    let thumb = |radial: f64, palmar: f64, pronation: f64, bend: f64| {
        let mut hand = HandAngles::default();
        let t = &mut hand.thumb;
        (t.radial, t.palmar, t.pronation, t.mcp, t.ip) = (radial, palmar, pronation, bend, bend);
        tips(&rig, &skeleton, &hand)[0]
    };
    let (along, out, front) = (thumb(0.1, 0.0, 0.0, 0.0), thumb(0.9, 0.0, 0.0, 0.0), thumb(0.1, 0.9, 0.0, 0.0));
    assert!(out.z > along.z + 0.05, "away from the hand is toward the thumb's side");
    assert!(front.y < along.y - 0.05, "in front is out of the palm");
    assert!(thumb(0.9, 0.0, 0.0, 1.0).z < out.z - 0.03, "unturned, it flexes across, to the little finger's side");
    assert!(thumb(0.1, 0.9, 1.5, 1.0).y > front.y + 0.01, "turned, it flexes back to the palm");
}
