//! Kinematic profiles: how fast a point moves, over time.
//!
//! Naert et al. compare interpolations by the speed of wrist and fingertips (figures 6 and 10).
//!
//! # Conventions
//! Points in metres, one a frame; speeds in m/s, accelerations in m/s², jerks in m/s³. Central
//! differences inside, one-sided ones at the two ends; sample `i` is at `i / fps`. A path of one point stands still.

use crate::time::{Fps, FrameIndex, Seconds};
use glam::DVec3;

/// The time derivative of a sampled vector.
///
/// ```
/// use chereme::{motion::profile::derivative, time::Fps};
/// use glam::DVec3;
/// let fps = Fps::new(10.0).unwrap();
/// let path: Vec<DVec3> = (0..5).map(|i| DVec3::X * f64::from(i)).collect();
/// assert_eq!(derivative(&path, fps), vec![DVec3::X * 10.0; 5]);
/// ```
pub fn derivative(samples: &[DVec3], fps: Fps) -> Vec<DVec3> {
    let last = samples.len().saturating_sub(1);
    (0..samples.len())
        .map(|i| {
            let (before, after) = (i.saturating_sub(1), (i + 1).min(last));
            let frames = (after - before).max(1) as f64;
            (samples[after] - samples[before]) * (fps.get() / frames)
        })
        .collect()
}

fn lengths(samples: &[DVec3]) -> Vec<f64> {
    samples.iter().map(|v| v.length()).collect()
}

/// The speed along a path, m/s.
///
/// ```
/// use chereme::{motion::profile::speed, time::Fps};
/// use glam::DVec3;
/// let path = [DVec3::ZERO, DVec3::new(0.03, 0.04, 0.0)];
/// assert_eq!(speed(&path, Fps::DEFAULT), [3.0, 3.0]);
/// ```
pub fn speed(path: &[DVec3], fps: Fps) -> Vec<f64> {
    lengths(&derivative(path, fps))
}

/// The size of the acceleration along a path, m/s².
///
/// ```
/// use chereme::{motion::profile::acceleration, time::Fps};
/// use glam::DVec3;
/// let fall: Vec<DVec3> = (0..60).map(|i| DVec3::Y * -4.905 * (f64::from(i) / 60.0).powi(2)).collect();
/// assert!((acceleration(&fall, Fps::DEFAULT)[30] - 9.81).abs() < 1e-6);
/// ```
pub fn acceleration(path: &[DVec3], fps: Fps) -> Vec<f64> {
    lengths(&derivative(&derivative(path, fps), fps))
}

/// The size of the jerk along a path, m/s³.
///
/// ```
/// use chereme::{motion::profile::jerk, time::Fps};
/// use glam::DVec3;
/// let cubic: Vec<DVec3> = (0..60).map(|i| DVec3::X * (f64::from(i) / 60.0).powi(3)).collect();
/// assert!((jerk(&cubic, Fps::DEFAULT)[30] - 6.0).abs() < 1e-6);
/// ```
pub fn jerk(path: &[DVec3], fps: Fps) -> Vec<f64> {
    lengths(&derivative(&derivative(&derivative(path, fps), fps), fps))
}

/// The length of a path, metres.
///
/// ```
/// use glam::DVec3;
/// assert_eq!(chereme::motion::profile::length(&[DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y]), 2.0);
/// ```
pub fn length(path: &[DVec3]) -> f64 {
    path.windows(2).map(|w| w[0].distance(w[1])).sum()
}

/// The greatest value of a profile, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// In the profile's unit.
    pub value: f64,
    /// From the profile's start.
    pub time: Seconds,
}

/// The greatest value of a profile and its instant (the first of equals); `None` for an empty one.
///
/// ```
/// use chereme::{motion::profile::peak, time::{Fps, Seconds}};
/// let peak = peak(&[0.0, 1.0, 3.0, 1.0], Fps::new(2.0).unwrap()).unwrap();
/// assert_eq!((peak.value, peak.time), (3.0, Seconds(1.0)));
/// ```
pub fn peak(profile: &[f64], fps: Fps) -> Option<Peak> {
    let (i, value) = highest(profile)?;
    Some(Peak { value, time: fps.time_of(FrameIndex(i)) })
}

fn highest(profile: &[f64]) -> Option<(usize, f64)> {
    let later = |best: (usize, f64), now: (usize, f64)| if now.1 > best.1 { now } else { best };
    profile.iter().copied().enumerate().reduce(later)
}

/// The full width at half maximum of the profile's highest peak: how long it stays above half the peak.
///
/// Crossings are found linearly between samples; where the profile does not fall to half, its end counts.
///
/// ```
/// use chereme::{motion::profile::fwhm, time::Fps};
/// let triangle = [0.0, 1.0, 2.0, 1.0, 0.0];
/// assert_eq!(fwhm(&triangle, Fps::new(1.0).unwrap()).unwrap().0, 2.0);
/// ```
pub fn fwhm(profile: &[f64], fps: Fps) -> Option<Seconds> {
    let (top, value) = highest(profile)?;
    let half = 0.5 * value;
    // How far a crossing lies beyond the last sample above half.
    let beyond = |inside: f64, outside: f64| if inside > outside { (inside - half) / (inside - outside) } else { 0.0 };
    let start = match (0..top).rev().find(|&i| profile[i] < half) {
        Some(i) => (i + 1) as f64 - beyond(profile[i + 1], profile[i]),
        None => 0.0,
    };
    let end = match (top + 1..profile.len()).find(|&i| profile[i] < half) {
        Some(i) => (i - 1) as f64 + beyond(profile[i - 1], profile[i]),
        None => (profile.len() - 1) as f64,
    };
    Some(Seconds((end - start) / fps.get()))
}

/// The indices of local maxima at least `least` high, a plateau counted once at its first sample.
///
/// ```
/// use chereme::motion::profile::peaks;
/// assert_eq!(peaks(&[0.0, 2.0, 0.5, 0.6, 0.5, 3.0, 3.0, 0.0], 1.0), [1, 5]);
/// ```
pub fn peaks(profile: &[f64], least: f64) -> Vec<usize> {
    let rises = |i: usize| i == 0 || profile[i] > profile[i - 1];
    let falls = |i: usize| profile[i..].iter().find(|v| **v != profile[i]).is_none_or(|v| *v < profile[i]);
    (0..profile.len()).filter(|&i| profile[i] >= least && rises(i) && falls(i)).collect()
}
