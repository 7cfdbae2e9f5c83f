//! Speed of points, without the noise of the sensor.

use crate::time::{Fps, Seconds};
use glam::DVec3;

/// The path of points, smoothed by a Gaussian of this standard deviation (cut off at three, nearer to the ends one-sided). Zero leaves
/// the path as it is.
///
/// ```
/// use chereme::{evaluation::kinematics::smoothed, time::{Fps, Seconds}};
/// use glam::DVec3;
/// let still = vec![vec![DVec3::ONE]; 9];
/// assert!(smoothed(&still, Fps::DEFAULT, Seconds(0.02)).iter().all(|frame| frame[0].distance(DVec3::ONE) < 1e-12));
/// ```
pub fn smoothed(frames: &[Vec<DVec3>], fps: Fps, deviation: Seconds) -> Vec<Vec<DVec3>> {
    let sigma = deviation.0 * fps.get();
    if !(sigma.is_finite() && sigma > 0.0) {
        return frames.to_vec();
    }
    let reach = ((3.0 * sigma).ceil() as usize).clamp(1, frames.len().max(1));
    let weights: Vec<f64> = (0..=reach).map(|d| (-0.5 * (d as f64 / sigma).powi(2)).exp()).collect();
    let at = |i: usize| {
        let window = i.saturating_sub(reach)..(i + reach + 1).min(frames.len());
        let mut sum = vec![DVec3::ZERO; frames[i].len()];
        let mut all = 0.0;
        for j in window {
            let weight = weights[i.abs_diff(j)];
            all += weight;
            sum.iter_mut().zip(&frames[j]).for_each(|(s, p)| *s += *p * weight);
        }
        sum.into_iter().map(|s| s / all).collect()
    };
    (0..frames.len()).map(at).collect()
}

/// How far two frames of points are apart, metres: the root of the mean square over the points.
///
/// ```
/// use chereme::evaluation::kinematics::distance;
/// use glam::DVec3;
/// assert_eq!(distance(&[DVec3::ZERO, DVec3::ZERO], &[DVec3::X, -DVec3::Y]), 1.0);
/// ```
pub fn distance(a: &[DVec3], b: &[DVec3]) -> f64 {
    let points = a.len().min(b.len()).max(1) as f64;
    (a.iter().zip(b).map(|(p, q)| p.distance_squared(*q)).sum::<f64>() / points).sqrt()
}

/// The speed of points, m/s, by central differences (one-sided at the ends).
///
/// ```
/// use chereme::{evaluation::kinematics::speed, time::Fps};
/// use glam::DVec3;
/// let path = vec![vec![DVec3::ZERO], vec![DVec3::X], vec![DVec3::X * 2.0]];
/// assert_eq!(speed(&path, Fps::new(10.0).unwrap()), [10.0, 10.0, 10.0]);
/// ```
pub fn speed(frames: &[Vec<DVec3>], fps: Fps) -> Vec<f64> {
    let last = frames.len().saturating_sub(1);
    let at = |i: usize| {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(last));
        distance(&frames[before], &frames[after]) * fps.get() / (after - before).max(1) as f64
    };
    (0..frames.len()).map(at).collect()
}
