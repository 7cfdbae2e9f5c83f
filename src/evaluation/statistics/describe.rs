//! Values in few numbers: mean, spread, quartiles; and how two curves go together.

/// What a box plot shows of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// How many.
    pub n: usize,
    /// Their mean.
    pub mean: f64,
    /// Their standard deviation, with n − 1; 0 for one value.
    pub sd: f64,
    /// The lower quartile.
    pub q1: f64,
    /// The median.
    pub median: f64,
    /// The upper quartile.
    pub q3: f64,
    /// The least value that lies no more than 1.5 interquartile ranges below the lower quartile.
    pub whisker_low: f64,
    /// The greatest value that lies no more than 1.5 interquartile ranges above the upper quartile.
    pub whisker_high: f64,
}

/// Describes values; `None` where there is none, or one that is not finite.
///
/// ```
/// use chereme::evaluation::statistics::describe::summary;
/// let summary = summary(&[1.0, 2.0, 3.0, 4.0, 100.0]).unwrap();
/// assert_eq!((summary.mean, summary.median, summary.q3, summary.whisker_high), (22.0, 3.0, 4.0, 4.0));
/// ```
pub fn summary(values: &[f64]) -> Option<Summary> {
    let sorted = sorted(values)?;
    let n = sorted.len();
    let mean = mean(values)?;
    let squares = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
    let sd = if n > 1 { (squares / (n - 1) as f64).sqrt() } else { 0.0 };
    let (q1, median, q3) = (of_sorted(&sorted, 0.25), of_sorted(&sorted, 0.5), of_sorted(&sorted, 0.75));
    let reach = 1.5 * (q3 - q1);
    let whisker_low = sorted.iter().copied().find(|v| *v >= q1 - reach).unwrap_or(q1).min(q1);
    let whisker_high = sorted.iter().rev().copied().find(|v| *v <= q3 + reach).unwrap_or(q3).max(q3);
    Some(Summary { n, mean, sd, q1, median, q3, whisker_low, whisker_high })
}

/// The mean; `None` of nothing.
pub fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The quantile at a share from 0 to 1, linear between values (as in numpy and R's type 7); `None` of nothing.
///
/// ```
/// use chereme::evaluation::statistics::describe::quantile;
/// assert_eq!(quantile(&[4.0, 1.0, 2.0], 0.25), Some(1.5));
/// ```
pub fn quantile(values: &[f64], share: f64) -> Option<f64> {
    sorted(values).map(|sorted| of_sorted(&sorted, share))
}

/// The values in order; `None` where there is none, or one that is not finite.
fn sorted(values: &[f64]) -> Option<Vec<f64>> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    (!sorted.is_empty() && sorted.iter().all(|v| v.is_finite())).then_some(sorted)
}

fn of_sorted(sorted: &[f64], share: f64) -> f64 {
    let at = share.clamp(0.0, 1.0) * (sorted.len() - 1) as f64;
    let below = at.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + (sorted[above] - sorted[below]) * (at - below as f64)
}

/// Pearson's correlation of two curves over the same instants; `None` where one of them is level, or they differ in length.
///
/// ```
/// use chereme::evaluation::statistics::describe::correlation;
/// assert!((correlation(&[1.0, 2.0, 4.0], &[2.0, 4.0, 8.0]).unwrap() - 1.0).abs() < 1e-12);
/// assert_eq!(correlation(&[1.0, 1.0], &[1.0, 2.0]), None);
/// ```
pub fn correlation(a: &[f64], b: &[f64]) -> Option<f64> {
    if a.len() != b.len() {
        return None;
    }
    let (mean_a, mean_b) = (mean(a)?, mean(b)?);
    let sum = |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(x, y)| f(x - mean_a, y - mean_b)).sum::<f64>();
    let (ab, aa, bb) = (sum(&|x, y| x * y), sum(&|x, _| x * x), sum(&|_, y| y * y));
    // Level up to rounding is level.
    let level = |squares: f64, mean: f64| squares <= (1e-9 * mean).powi(2) * a.len() as f64;
    (!level(aa, mean_a) && !level(bb, mean_b)).then(|| (ab / (aa * bb).sqrt()).clamp(-1.0, 1.0))
}
