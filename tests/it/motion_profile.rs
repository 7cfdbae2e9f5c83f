//! Kinematic profiles of known motions.

use crate::signing::world;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::curve::{Measure, Reference, of_clip};
use chereme::motion::difference::{Tolerance, compare};
use chereme::motion::easing::Easing;
use chereme::motion::point;
use chereme::motion::pose::LocalPose;
use chereme::motion::profile::{acceleration, fwhm, jerk, length, peak, peaks, speed};
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use proptest::prelude::*;

#[test]
fn minimum_jerk_has_its_known_peaks() {
    let fps = Fps::new(500.0).unwrap();
    let path: Vec<DVec3> = (0..=500).map(|i| DVec3::X * Easing::MinimumJerk.weight(f64::from(i) / 500.0)).collect();
    let fastest = peak(&speed(&path, fps), fps).unwrap();
    assert!((fastest.value - 1.875).abs() < 1e-3 && (fastest.time.0 - 0.5).abs() < 1e-9);
    // 10/√3 at (1 ∓ 1/√3)/2; jerk 30 in the middle.
    let strongest = peak(&acceleration(&path, fps), fps).unwrap();
    assert!((strongest.value - 5.7735).abs() < 0.01, "{strongest:?}");
    assert!((jerk(&path, fps)[250] - 30.0).abs() < 0.1);
    assert!((length(&path) - 1.0).abs() < 1e-9);
    assert_eq!(peaks(&speed(&path, fps), 0.1).len(), 1);
}

#[test]
fn there_and_back_has_two_peaks() {
    let way = |w: f64| Easing::default().weight(if w < 0.5 { 2.0 * w } else { 2.0 - 2.0 * w });
    let path: Vec<DVec3> = (0..=240).map(|i| DVec3::Y * way(f64::from(i) / 240.0)).collect();
    assert_eq!(peaks(&speed(&path, Fps::DEFAULT), 0.2).len(), 2);
}

proptest! {
    #[test]
    fn profiles_of_any_length_are_finite(xs in prop::collection::vec(-1e3..1e3f64, 0..20)) {
        let path: Vec<DVec3> = xs.iter().map(|x| DVec3::new(*x, -x, 0.5)).collect();
        for profile in [speed(&path, Fps::DEFAULT), acceleration(&path, Fps::DEFAULT), jerk(&path, Fps::DEFAULT)] {
            prop_assert_eq!(profile.len(), path.len());
            prop_assert!(profile.iter().all(|v| v.is_finite()));
            prop_assert_eq!(peak(&profile, Fps::DEFAULT).is_some(), !path.is_empty());
            if let Some(width) = fwhm(&profile, Fps::DEFAULT) {
                prop_assert!(width.0 >= 0.0 && width.0 <= path.len() as f64 / 60.0);
            }
        }
    }
}

/// A body that is carried along and turned, with fingers that bend: one clip at rest in space, one moved.
fn carried(turn: f64, way: DVec3) -> Clip {
    let signer = &world().signer;
    let (hips, finger) = (signer.skeleton.joint("Hips").unwrap(), signer.skeleton.joint("RightHandIndex2").unwrap());
    let frame = |i: u32| {
        let mut pose = LocalPose::rest(&signer.skeleton);
        pose.root_model += way * f64::from(i);
        pose.set(hips, DQuat::from_rotation_y(turn * f64::from(i)));
        pose.set(finger, DQuat::from_rotation_z(0.02 * f64::from(i)));
        Frame { pose, weights: vec![] }
    };
    let frames = (0..12).map(frame).collect();
    Clip::new(signer.skeleton.clone(), Fps::DEFAULT, vec![].into(), frames).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// What carries the body is not seen from the body, and what carries the hand not from the wrist.
    #[test]
    fn a_frame_does_not_see_what_carries_it(turn in -0.2..0.2f64, x in -0.1..0.1f64, y in -0.1..0.1f64) {
        let (still, moved) = (carried(0.0, DVec3::ZERO), carried(turn, DVec3::new(x, y, 0.03)));
        let tips = point::matching(still.skeleton(), "RightHand*Tip");
        prop_assert_eq!(tips.len(), 5);
        for reference in [Reference::Body, Reference::Wrist] {
            let of = |clip| of_clip(clip, &tips, reference, &Measure::ALL).unwrap();
            let comparison = compare(&of(&still), &of(&moved), |_| Tolerance::Absolute(1e-6)).unwrap();
            // Differences of fourth order blow rounding up by the frame rate's cube.
            let worst = comparison.differences.iter().find(|d| d.measure != Measure::Jerk).unwrap();
            prop_assert!(!worst.is_fault(), "{}", worst);
        }
        let floor = |clip| of_clip(clip, &tips, Reference::Floor, &[Measure::Height]).unwrap();
        let rise = compare(&floor(&still), &floor(&moved), |_| Tolerance::Absolute(1e-6)).unwrap();
        prop_assert!((rise.differences[0].size() - 11.0 * y.abs()).abs() < 1e-9);
    }
}

#[test]
fn a_tip_moves_and_its_joint_does_not() {
    let clip = carried(0.0, DVec3::ZERO);
    let speed = |name| {
        let points = point::matching(clip.skeleton(), name);
        of_clip(&clip, &points, Reference::Floor, &[Measure::Speed]).unwrap().curves()[0].values[5]
    };
    assert!(speed("RightHandIndex2") < 1e-9);
    // 0.02 radians a frame, 60 frames a second, on the two last phalanges.
    assert!((speed("RightHandIndexTip") - 1.2 * 0.045).abs() < 0.015, "{}", speed("RightHandIndexTip"));
}

#[test]
fn profiles_that_are_none_are_refused() {
    let clip = carried(0.0, DVec3::ZERO);
    let tip = point::matching(clip.skeleton(), "RightHandIndexTip");
    let twice = of_clip(&clip, &tip, Reference::Floor, &[Measure::X, Measure::X]).unwrap_err();
    assert!(twice.to_string().contains("RightHandIndexTip floor x is there twice"));
    let head = point::matching(clip.skeleton(), "Head");
    assert!(of_clip(&clip, &head, Reference::Wrist, &[Measure::X]).is_err());
    let (x, y) =
        (of_clip(&clip, &tip, Reference::Floor, &[Measure::X]), of_clip(&clip, &tip, Reference::Floor, &[Measure::Y]));
    assert!(
        compare(&x.unwrap(), &y.unwrap(), |_| Tolerance::Absolute(1.0)).unwrap_err().to_string().contains("no curve")
    );
}
