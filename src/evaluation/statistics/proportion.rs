//! Rates, such as how often a sign was recognised.

use super::Z95;

/// A share with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// The share.
    pub share: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// The share of `hits` among `n`, with the score interval of Wilson (1927); `None` where n is 0 or less than the hits.
///
/// ```
/// use chereme::evaluation::statistics::wilson;
/// let rate = wilson(8, 10).unwrap();
/// assert!((rate.low - 0.49016247).abs() < 1e-7 && (rate.high - 0.94331784).abs() < 1e-7);
/// ```
pub fn wilson(hits: usize, n: usize) -> Option<Rate> {
    if n == 0 || hits > n {
        return None;
    }
    let (share, n) = (hits as f64 / n as f64, n as f64);
    let z = Z95 * Z95 / n;
    let middle = (share + z / 2.0) / (1.0 + z);
    let half = Z95 / (1.0 + z) * (share * (1.0 - share) / n + z / (4.0 * n)).sqrt();
    Some(Rate { share, low: (middle - half).clamp(0.0, share), high: (middle + half).clamp(share, 1.0) })
}
