//! Whether groups of ratings differ: Kruskal–Wallis over several, Mann–Whitney over two.

use super::gamma::{chi_square_tail, normal_tail};
use super::ranks::ranks;

/// The greatest size of the smaller group for which Mann–Whitney is exact, as in scipy.
const SMALL: usize = 8;
/// The greatest product of group sizes that is counted exactly.
const MOST_PAIRS: usize = 20_000;

/// The test of Kruskal and Wallis (1952).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KruskalWallis {
    /// The statistic, corrected for ties.
    pub h: f64,
    /// Degrees of freedom: groups less one.
    pub df: usize,
    /// The chance of an H as great if the groups do not differ, by chi-square.
    pub p: f64,
    /// The effect: ε² = H / (n − 1), the share of the spread of ranks that the groups explain.
    pub epsilon_squared: f64,
}

/// Whether any of several groups of values differs from the others; empty groups are left out.
///
/// `None` with fewer than two groups, and where all values are equal.
///
/// ```
/// use chereme::evaluation::statistics::kruskal_wallis;
/// let test = kruskal_wallis(&[&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]]).unwrap();
/// assert!((test.h - 3.857142857142857).abs() < 1e-12 && (test.p - 0.04953461).abs() < 1e-7);
/// ```
pub fn kruskal_wallis(groups: &[&[f64]]) -> Option<KruskalWallis> {
    let groups: Vec<&[f64]> = groups.iter().copied().filter(|g| !g.is_empty()).collect();
    let all = groups.concat();
    let n = all.len() as f64;
    if groups.len() < 2 {
        return None;
    }
    let ranked = ranks(&all);
    let left = 1.0 - ranked.ties / (n * n * n - n);
    if left <= 0.0 {
        return None;
    }
    let mut rest = &ranked.ranks[..];
    let mut sum = 0.0;
    for group in &groups {
        let (own, others) = rest.split_at(group.len());
        // About the mean rank, so that nothing great is taken from something great.
        let apart = own.iter().map(|r| r - (n + 1.0) / 2.0).sum::<f64>();
        sum += apart * apart / own.len() as f64;
        rest = others;
    }
    let h = 12.0 / (n * (n + 1.0)) * sum / left;
    let df = groups.len() - 1;
    Some(KruskalWallis { h, df, p: chi_square_tail(h, df as f64), epsilon_squared: h / (n - 1.0) })
}

/// How the p of Mann–Whitney was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// All orders were counted: a small group and no ties.
    Exact,
    /// By the normal distribution, corrected for ties and for continuity.
    Normal,
}

/// The test of Mann and Whitney (1947).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MannWhitney {
    /// Pairs in which the first group's value is the greater; equal ones count a half.
    pub u: f64,
    /// The chance of a U as far from its middle if the groups do not differ.
    pub p: f64,
    /// How p was found.
    pub method: Method,
    /// The rank-biserial correlation: the share of pairs that favour the first group less the share that favour the
    /// second, from −1 to 1.
    pub rank_biserial: f64,
}

/// Whether one group's values tend to be greater than the other's; two-sided. `None` where a group is empty.
///
/// Exact where the smaller group has at most 8 values and no two values are equal, else normal.
///
/// ```
/// use chereme::evaluation::statistics::{Method, mann_whitney};
/// let test = mann_whitney(&[4.0, 5.0, 6.0], &[1.0, 2.0, 3.0]).unwrap();
/// assert_eq!((test.u, test.rank_biserial, test.method), (9.0, 1.0, Method::Exact));
/// assert!((test.p - 0.1).abs() < 1e-12);
/// ```
pub fn mann_whitney(first: &[f64], second: &[f64]) -> Option<MannWhitney> {
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let (m, n) = (first.len() as f64, second.len() as f64);
    let ranked = ranks(&[first, second].concat());
    let u = ranked.ranks[..first.len()].iter().sum::<f64>() - m * (m + 1.0) / 2.0;
    let counted = first.len().min(second.len()) <= SMALL && first.len() * second.len() <= MOST_PAIRS;
    let (p, method) = match ranked.ties == 0.0 && counted {
        true => (exact(first.len(), second.len(), u), Method::Exact),
        false => (normal(m, n, u, ranked.ties), Method::Normal),
    };
    Some(MannWhitney { u, p, method, rank_biserial: 2.0 * u / (m * n) - 1.0 })
}

/// Two-sided p by the normal distribution.
fn normal(m: f64, n: f64, u: f64, ties: f64) -> f64 {
    let all = m + n;
    let variance = m * n / 12.0 * (all + 1.0 - ties / (all * (all - 1.0)));
    if variance <= 0.0 {
        return 1.0;
    }
    let apart = (u - m * n / 2.0).abs() - 0.5;
    (2.0 * normal_tail(apart / variance.sqrt())).min(1.0)
}

/// Two-sided p by counting the orders of m and n values: how many have each U (Mann and Whitney 1947).
fn exact(m: usize, n: usize, u: f64) -> f64 {
    let (m, n) = (m.min(n), m.max(n));
    // U of either group is as far from the middle; U is whole without ties.
    let u = u.max((m * n) as f64 - u).round() as usize;
    let mut chances = vec![0.0; m * n + 1];
    chances[0] = 1.0;
    // The generating function Π (1 − xⁿ⁺ⁱ) / (1 − xⁱ), i = 1..m, divided through by the number of orders as it grows.
    for i in 1..=m {
        for at in (n + i..=m * n).rev() {
            chances[at] -= chances[at - n - i];
        }
        for at in i..=m * n {
            chances[at] += chances[at - i];
        }
        let orders = (n + i) as f64 / i as f64;
        chances.iter_mut().for_each(|c| *c /= orders);
    }
    (2.0 * chances[u.min(m * n)..].iter().sum::<f64>()).min(1.0)
}
