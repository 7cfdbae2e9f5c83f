//! One captured transition against the interpolations between its ends.

use crate::evaluation::interpolation::timing::{Ends, Timing};
use crate::evaluation::kinematics::{Kind, Movement, Way, distance, smoothed, speed};
use crate::evaluation::statistics::describe::correlation;
use crate::motion::easing::{Easing, PAPER_STEEPNESS};
use crate::time::Seconds;
use glam::DVec3;
use std::fmt;

/// Samples of a speed profile over the whole of a transition, both ends included.
pub const PROFILE: usize = 101;
/// The least steepness of a sigmoid that is looked for: linear.
const FLATTEST: f64 = 0.01;
/// The greatest: a jump of a fiftieth of the time.
const STEEPEST: f64 = 40.0;

/// An interpolation that is compared with captured motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Model {
    /// The paper's equation 1.
    Slerp,
    /// Equation 2, with slerp at the eased weight.
    Cosine,
    /// Equation 3, k = 10, scaled to reach its ends.
    Sigmoid,
    /// The sigmoid whose k fits this transition best: one number of its own more than the others.
    Fitted,
    /// Minimum jerk.
    MinimumJerk,
}

impl Model {
    /// All of them.
    pub const ALL: [Model; 5] = [Model::Slerp, Model::Cosine, Model::Sigmoid, Model::Fitted, Model::MinimumJerk];

    /// Its easing; `k` is the fitted one's steepness.
    pub fn easing(self, k: f64) -> Easing {
        match self {
            Model::Slerp => Easing::Linear,
            Model::Cosine => Easing::Cosine,
            Model::Sigmoid => Easing::Sigmoid { k: PAPER_STEEPNESS },
            Model::Fitted => Easing::Sigmoid { k },
            Model::MinimumJerk => Easing::MinimumJerk,
        }
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Model::Slerp => "slerp",
            Model::Cosine => "cosine",
            Model::Sigmoid => "sigmoid, k = 10",
            Model::Fitted => "sigmoid, fitted k",
            Model::MinimumJerk => "minimum jerk",
        })
    }
}

/// How near an interpolation comes to the captured motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closeness {
    /// The root of the mean square distance over the transition, as a share of its amplitude.
    pub error: f64,
    /// Correlation of the speed profiles; `None` where one is level.
    pub correlation: Option<f64>,
    /// When the interpolation is fastest, over when the captured motion is; both from the transition's start.
    pub peak_time: f64,
    /// The greatest speed over that of the captured motion.
    pub peak_height: f64,
}

/// One captured transition with its interpolations.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// The take that it comes from.
    pub take: String,
    /// What moves.
    pub kind: Kind,
    /// From the take's start.
    pub start: Seconds,
    /// How long it lasts.
    pub duration: Seconds,
    /// How far the end is from the start, metres.
    pub amplitude: f64,
    /// How far the captured path is from the interpolated one whatever its timing, as a share of the amplitude: no easing
    /// comes nearer.
    pub path_error: f64,
    /// The fitted sigmoid's steepness.
    pub k: f64,
    /// In the order of [`Model::ALL`].
    pub models: [Closeness; 5],
    /// The captured speed in [`PROFILE`] samples, in amplitudes a duration.
    pub profile: Vec<f64>,
}

/// Compares the motion from frame `start` to frame `end` with the interpolations between these poses. Distances are taken as captured;
/// speeds of both are smoothed by the same Gaussian. `None` where there are fewer than four frames or the ends are one.
///
/// ```
/// use chereme::{evaluation::interpolation::{Model, compare}, time::Seconds};
/// use chereme::evaluation::kinematics::Movement;
/// use chereme::{motion::easing::Easing, time::Fps};
/// use glam::DVec3;
/// let place = |i: i32| DVec3::X * 0.3 * Easing::MinimumJerk.weight(f64::from(i - 20) / 30.0);
/// let movement = Movement::of_path("take", Fps::DEFAULT, (0..70).map(place).collect()).unwrap();
/// let transition = compare(&movement, 20, 50, Seconds(0.02)).unwrap();
/// assert!(transition.models[Model::MinimumJerk as usize].error < 1e-9);
/// ```
pub fn compare(movement: &Movement, start: usize, end: usize, smoothing: Seconds) -> Option<Transition> {
    compare_with(movement, start, end, smoothing, Ends::Whole)
}

/// As [`compare()`], with interpolations that are whole, or trimmed as the motion was.
pub(super) fn compare_with(
    movement: &Movement,
    start: usize,
    end: usize,
    smoothing: Seconds,
    ends: Ends,
) -> Option<Transition> {
    let frames = movement.frames().get(start..=end).filter(|frames| frames.len() >= 4)?;
    let amplitude = distance(&frames[0], &frames[frames.len() - 1]);
    if amplitude <= 1e-9 {
        return None;
    }
    let way = movement.way(start, end);
    let error = |easing: Easing| error(&way, frames, Timing::of(easing, ends)) / amplitude;
    let k = least(FLATTEST, STEEPEST, |k| error(Easing::Sigmoid { k }));
    let captured = speed_within(movement, start, end, smoothing);
    let models = Model::ALL.map(|model| {
        let easing = model.easing(k);
        let own = speed_of(movement, &way, Timing::of(easing, ends), frames.len(), smoothing);
        let (top, peak) = (highest(&captured), highest(&own));
        Closeness {
            error: error(easing),
            correlation: correlation(&own, &captured),
            peak_time: peak.0 / top.0.max(0.5),
            peak_height: peak.1 / top.1,
        }
    });
    let duration = Seconds((end - start) as f64 / movement.fps().get());
    let last = (captured.len() - 1) as f64;
    let scaled = |i: usize| at(&captured, last * i as f64 / (PROFILE - 1) as f64) * duration.0 / amplitude;
    Some(Transition {
        take: movement.take().to_owned(),
        kind: movement.kind(),
        start: Seconds(start as f64 / movement.fps().get()),
        duration,
        amplitude,
        path_error: path_error(&way, frames) / amplitude,
        k,
        models,
        profile: (0..PROFILE).map(scaled).collect(),
    })
}

/// The share of the time that a frame is at.
fn share(frame: usize, frames: usize) -> f64 {
    frame as f64 / (frames - 1) as f64
}

/// Root mean square distance, metres.
fn error(way: &Way, frames: &[Vec<DVec3>], easing: Timing) -> f64 {
    let squares = frames.iter().enumerate().map(|(i, captured)| {
        let weight = easing.weight(share(i, frames.len()));
        distance(captured, &way.at(weight)).powi(2)
    });
    (squares.sum::<f64>() / frames.len() as f64).sqrt()
}

/// The same to the nearest place of the way, whatever its instant.
fn path_error(way: &Way, frames: &[Vec<DVec3>]) -> f64 {
    let nearest =
        |f: &Vec<DVec3>| way.samples().windows(2).map(|s| to_line(f, &s[0], &s[1])).fold(f64::INFINITY, f64::min);
    (frames.iter().map(|f| nearest(f).powi(2)).sum::<f64>() / frames.len() as f64).sqrt()
}

/// How far points are from the nearest place between two others.
fn to_line(points: &[DVec3], from: &[DVec3], to: &[DVec3]) -> f64 {
    let all = || points.iter().zip(from).zip(to);
    let along = all().map(|((p, a), b)| (*p - *a).dot(*b - *a)).sum::<f64>();
    let length = from.iter().zip(to).map(|(a, b)| a.distance_squared(*b)).sum::<f64>();
    let share = if length > 0.0 { (along / length).clamp(0.0, 1.0) } else { 0.0 };
    let squares = all().map(|((p, a), b)| p.distance_squared(a.lerp(*b, share))).sum::<f64>();
    (squares / points.len().max(1) as f64).sqrt()
}

/// The captured speed from one frame to another; smoothing looks beyond them.
fn speed_within(movement: &Movement, start: usize, end: usize, smoothing: Seconds) -> Vec<f64> {
    let pad = padding(movement, smoothing);
    let (from, to) = (start.saturating_sub(pad), (end + pad).min(movement.frames().len() - 1));
    let all = speed(&smoothed(&movement.frames()[from..=to], movement.fps(), smoothing), movement.fps());
    all[start - from..=end - from].to_vec()
}

/// The speed of an interpolation that stands still before and after.
fn speed_of(movement: &Movement, way: &Way, easing: Timing, frames: usize, smoothing: Seconds) -> Vec<f64> {
    let pad = padding(movement, smoothing);
    let clamped = |i: usize| share(i.saturating_sub(pad).min(frames - 1), frames);
    let path: Vec<Vec<DVec3>> = (0..frames + 2 * pad).map(|i| way.at(easing.weight(clamped(i)))).collect();
    speed(&smoothed(&path, movement.fps(), smoothing), movement.fps())[pad..pad + frames].to_vec()
}

/// The frames that smoothing and differences look beyond an instant.
fn padding(movement: &Movement, smoothing: Seconds) -> usize {
    (3.0 * smoothing.0.max(0.0) * movement.fps().get()).ceil() as usize + 2
}

/// Place (in samples, between them by a parabola) and height of the greatest value.
fn highest(profile: &[f64]) -> (f64, f64) {
    let later = |best: (usize, f64), now: (usize, f64)| if now.1 > best.1 { now } else { best };
    let (i, top) = profile.iter().copied().enumerate().reduce(later).unwrap_or_default();
    let (Some(before), Some(after)) = (i.checked_sub(1).map(|b| profile[b]), profile.get(i + 1)) else {
        return (i as f64, top);
    };
    let bend = before - 2.0 * top + after;
    let shift = if bend < -1e-12 * top.abs() { (0.5 * (before - after) / bend).clamp(-0.5, 0.5) } else { 0.0 };
    (i as f64 + shift, top)
}

/// A profile between its samples.
fn at(profile: &[f64], place: f64) -> f64 {
    let below = (place.floor() as usize).min(profile.len() - 1);
    let above = (below + 1).min(profile.len() - 1);
    profile[below] + (profile[above] - profile[below]) * (place - below as f64)
}

/// Where a function is least: the best of a grid, then by the golden section between its neighbours.
fn least(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 24;
    let grid: Vec<f64> = (0..=STEPS).map(|i| low + (high - low) * (i as f64 / STEPS as f64).powi(2)).collect();
    let values: Vec<f64> = grid.iter().map(|x| f(*x)).collect();
    let best = (0..=STEPS).min_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    let (mut a, mut b) = (grid[best.saturating_sub(1)], grid[(best + 1).min(STEPS)]);
    let golden = (5f64.sqrt() - 1.0) / 2.0;
    while b - a > 1e-4 {
        let (c, d) = (b - golden * (b - a), a + golden * (b - a));
        if f(c) < f(d) { b = d } else { a = c }
    }
    (a + b) / 2.0
}
