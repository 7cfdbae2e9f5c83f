//! Intervals of means and medians where values come in clusters: transitions of one take are no independent witnesses.
//!
//! The percentile bootstrap (Efron 1979) over whole clusters: takes are drawn with replacement, each with all its values.

use super::describe::{mean, quantile};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Draws, where nothing else is asked for.
pub const DRAWS: usize = 2000;

/// What is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Statistic {
    /// The mean of all values.
    Mean,
    /// Their median.
    Median,
}

impl Statistic {
    /// The statistic of values; `None` of nothing.
    pub fn of(self, values: &[f64]) -> Option<f64> {
        match self {
            Statistic::Mean => mean(values),
            Statistic::Median => quantile(values, 0.5),
        }
    }
}

/// An estimate with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The statistic of all values.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// How many values.
    pub n: usize,
    /// How many clusters they come from; with one, the interval is the value alone and says nothing.
    pub clusters: usize,
}

/// The statistic of values in clusters (empty ones are left out) with its interval; `None` where there is no value, or one
/// that is not finite. The same seed gives the same interval.
///
/// ```
/// use chereme::evaluation::statistics::bootstrap::{Statistic, estimate};
/// let takes = vec![vec![1.0, 2.0], vec![3.0], vec![2.0, 2.5, 1.5]];
/// let mean = estimate(&takes, Statistic::Mean, 1000, 7).unwrap();
/// assert_eq!((mean.value, mean.n, mean.clusters), (2.0, 6, 3));
/// assert!(1.0 < mean.low && mean.low < 2.0 && 2.0 < mean.high && mean.high <= 3.0);
/// ```
pub fn estimate(clusters: &[Vec<f64>], statistic: Statistic, draws: usize, seed: u64) -> Option<Estimate> {
    let clusters: Vec<&[f64]> = clusters.iter().map(Vec::as_slice).filter(|c| !c.is_empty()).collect();
    let all = clusters.concat();
    if !all.iter().all(|v| v.is_finite()) {
        return None;
    }
    let value = statistic.of(&all)?;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut drawn = Vec::with_capacity(all.len() * 2);
    let mut estimates = Vec::with_capacity(draws);
    for _ in 0..draws {
        drawn.clear();
        for _ in 0..clusters.len() {
            drawn.extend_from_slice(clusters[below(&mut random, clusters.len())]);
        }
        estimates.extend(statistic.of(&drawn));
    }
    let end = |share| quantile(&estimates, share).unwrap_or(value);
    Some(Estimate { value, low: end(0.025), high: end(0.975), n: all.len(), clusters: clusters.len() })
}

/// A number below `n`, all equally likely but for 2⁻⁶⁴ · n.
pub(crate) fn below(random: &mut ChaCha8Rng, n: usize) -> usize {
    ((u128::from(random.next_u64()) * n as u128) >> 64) as usize
}
