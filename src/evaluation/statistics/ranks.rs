//! Ranks, with equal values sharing the mean of theirs.

/// The ranks of values.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranks {
    /// One a value, from 1; equal values have the mean of the ranks that they take up.
    pub ranks: Vec<f64>,
    /// Σ (t³ − t) over the sets of t equal values: what ties take from the spread of ranks.
    pub ties: f64,
}

/// Ranks values; those that are no number come last.
///
/// ```
/// use chereme::evaluation::statistics::ranks;
/// let ranked = ranks(&[3.0, 1.0, 3.0]);
/// assert_eq!((ranked.ranks, ranked.ties), (vec![2.5, 1.0, 2.5], 6.0));
/// ```
pub fn ranks(values: &[f64]) -> Ranks {
    let mut order: Vec<usize> = (0..values.len()).collect();
    // −0 and 0 are one value.
    order.sort_by(|&a, &b| (values[a] + 0.0).total_cmp(&(values[b] + 0.0)));
    let mut ranks = vec![0.0; values.len()];
    let mut ties = 0.0;
    let mut start = 0;
    for same in order.chunk_by(|&a, &b| values[a] == values[b]) {
        let t = same.len() as f64;
        let rank = start as f64 + (t + 1.0) / 2.0;
        same.iter().for_each(|&i| ranks[i] = rank);
        ties += t * t * t - t;
        start += same.len();
    }
    Ranks { ranks, ties }
}
