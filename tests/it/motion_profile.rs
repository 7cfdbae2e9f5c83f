//! Kinematic profiles of known motions.

use chereme::motion::easing::Easing;
use chereme::motion::profile::{acceleration, fwhm, jerk, length, peak, peaks, speed};
use chereme::time::Fps;
use glam::DVec3;
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
