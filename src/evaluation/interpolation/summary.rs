//! Many transitions in few numbers, with intervals over takes.

use super::compare::{Closeness, Model, PROFILE, Transition};
use crate::evaluation::kinematics::Kind;
use crate::evaluation::statistics::bootstrap::{DRAWS, Estimate, Statistic, estimate};
use crate::evaluation::statistics::describe::quantile;
use std::collections::BTreeMap;

/// An estimate, where there is one.
pub type Interval = Option<Estimate>;

/// What the transitions of one kind say.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// What moves.
    pub kind: Kind,
    /// How many transitions.
    pub transitions: usize,
    /// Of how many takes.
    pub takes: usize,
    /// Median duration, seconds.
    pub duration: Interval,
    /// Median amplitude, metres.
    pub amplitude: Interval,
    /// Median steepness of the fitted sigmoid.
    pub k: Interval,
    /// Mean of what no easing can mend, a share of the amplitude.
    pub path_error: Interval,
    /// When the captured motion is fastest: the median share of the duration.
    pub peak_at: Interval,
    /// Its greatest speed: the median, in mean speeds (amplitudes a duration).
    pub peak_speed: Interval,
    /// In the order of [`Model::ALL`].
    pub rows: Vec<Row>,
    /// Captured speed, in amplitudes a duration: lower quartile, mean and upper quartile at [`PROFILE`] instants.
    pub profile: Vec<[f64; 3]>,
}

/// What an interpolation is worth.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The interpolation.
    pub model: Model,
    /// Mean error, a share of the amplitude.
    pub error: Interval,
    /// Mean correlation of the speed profiles.
    pub correlation: Interval,
    /// Median ratio of the peaks' times.
    pub peak_time: Interval,
    /// Median ratio of the peaks' heights.
    pub peak_height: Interval,
    /// Mean difference of the error from that of the sigmoid with k = 10, transition by transition: negative is nearer to the captured motion.
    pub against_sigmoid: Interval,
    /// How often it is the nearest of those without a number of their own (the fitted one does not take part).
    pub nearest: f64,
}

/// Summarises transitions by kind; the seed is the bootstrap's.
///
/// ```
/// use chereme::evaluation::interpolation::{Model, Rule, find, summarise};
/// use chereme::evaluation::kinematics::Movement;
/// use chereme::{motion::easing::Easing, time::Fps};
/// use glam::DVec3;
/// let place = |i: i32| DVec3::X * 0.3 * Easing::MinimumJerk.weight(f64::from(i - 20) / 30.0);
/// let movement = Movement::of_path("take", Fps::DEFAULT, (0..70).map(place).collect()).unwrap();
/// let reports = summarise(&find(&movement, &Rule::default()), 0);
/// assert_eq!((reports[0].transitions, reports[0].rows.len()), (1, Model::ALL.len()));
/// ```
pub fn summarise(transitions: &[Transition], seed: u64) -> Vec<Report> {
    let mut kinds: BTreeMap<Kind, Vec<&Transition>> = BTreeMap::new();
    transitions.iter().for_each(|t| kinds.entry(t.kind).or_default().push(t));
    kinds.into_iter().map(|(kind, all)| report(kind, &all, seed)).collect()
}

fn report(kind: Kind, all: &[&Transition], seed: u64) -> Report {
    let mut takes: BTreeMap<&str, Vec<&Transition>> = BTreeMap::new();
    all.iter().for_each(|t| takes.entry(&t.take).or_default().push(t));
    let over = |statistic, value: &dyn Fn(&Transition) -> Option<f64>| {
        let clusters: Vec<Vec<f64>> =
            takes.values().map(|take| take.iter().filter_map(|t| value(t)).collect()).collect();
        estimate(&clusters, statistic, DRAWS, seed)
    };
    let median = |value: &dyn Fn(&Transition) -> f64| over(Statistic::Median, &|t| Some(value(t)));
    let row = |(i, &model): (usize, &Model)| {
        let of = |statistic, value: &dyn Fn(&Closeness) -> Option<f64>| over(statistic, &|t| value(&t.models[i]));
        let sigmoid = |t: &Transition| t.models[Model::Sigmoid as usize].error;
        Row {
            model,
            error: of(Statistic::Mean, &|c| Some(c.error)),
            correlation: of(Statistic::Mean, &|c| c.correlation),
            peak_time: of(Statistic::Median, &|c| Some(c.peak_time)),
            peak_height: of(Statistic::Median, &|c| Some(c.peak_height)),
            against_sigmoid: over(Statistic::Mean, &|t| Some(t.models[i].error - sigmoid(t))),
            nearest: all.iter().filter(|t| nearest(t) == Some(model)).count() as f64 / all.len().max(1) as f64,
        }
    };
    Report {
        kind,
        transitions: all.len(),
        takes: takes.len(),
        duration: median(&|t| t.duration.0),
        amplitude: median(&|t| t.amplitude),
        k: median(&|t| t.k),
        path_error: over(Statistic::Mean, &|t| Some(t.path_error)),
        peak_at: median(&|t| peak(&t.profile).0),
        peak_speed: median(&|t| peak(&t.profile).1),
        rows: Model::ALL.iter().enumerate().map(row).collect(),
        profile: (0..PROFILE).map(|i| band(&all.iter().map(|t| t.profile[i]).collect::<Vec<_>>())).collect(),
    }
}

/// The interpolation without a number of its own that is nearest.
fn nearest(transition: &Transition) -> Option<Model> {
    let fixed = Model::ALL.into_iter().zip(&transition.models).filter(|(model, _)| *model != Model::Fitted);
    fixed.min_by(|a, b| a.1.error.total_cmp(&b.1.error)).map(|(model, _)| model)
}

/// Share of the time and height of the peak.
fn peak(profile: &[f64]) -> (f64, f64) {
    let later = |best: (usize, f64), now: (usize, f64)| if now.1 > best.1 { now } else { best };
    let (i, top) = profile.iter().copied().enumerate().reduce(later).unwrap_or_default();
    (i as f64 / (PROFILE - 1) as f64, top)
}

fn band(values: &[f64]) -> [f64; 3] {
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    [quantile(values, 0.25).unwrap_or(mean), mean, quantile(values, 0.75).unwrap_or(mean)]
}
