//! Shares of many judgements, and what is most often taken for what.

use super::{Judged, Judgement};
use std::collections::BTreeMap;

/// How many of how many are right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Share {
    /// Strictly right.
    pub strict: usize,
    /// Loosely right.
    pub loose: usize,
    /// All.
    pub all: usize,
}

impl Share {
    /// The part that is strictly right, 0 to 1; 1 of none.
    pub fn strict(&self) -> f64 {
        part(self.strict, self.all)
    }

    /// The part that is loosely right, 0 to 1; 1 of none.
    pub fn loose(&self) -> f64 {
        part(self.loose, self.all)
    }

    fn add(&mut self, judgement: &Judgement) {
        self.all += 1;
        self.strict += usize::from(judgement.strict);
        self.loose += usize::from(judgement.loose);
    }
}

fn part(of: usize, all: usize) -> f64 {
    if all == 0 { 1.0 } else { of as f64 / all as f64 }
}

/// One value taken for another, and how often.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Confusion {
    /// What the description says.
    pub described: String,
    /// What was measured.
    pub measured: String,
    /// How often.
    pub count: usize,
}

/// The judgements of many signs.
///
/// ```
/// use chereme::evaluation::annotation::{Judged, Judgement, Tally};
/// let mut tally = Tally::default();
/// let right = Judgement {
///     judged: Judged::Palm, described: "up".into(), measured: "up".into(), strict: true, loose: true, excepted: false,
/// };
/// tally.add(&[right.clone(), Judgement { measured: "down".into(), strict: false, loose: false, excepted: true, ..right }]);
/// assert_eq!((tally.share(Judged::Palm, true).strict(), tally.share(Judged::Palm, false).strict()), (0.5, 1.0));
/// assert_eq!(tally.confusions(Judged::Palm)[0].measured, "down");
/// ```
#[derive(Debug, Clone, Default)]
pub struct Tally {
    with: BTreeMap<Judged, Share>,
    without: BTreeMap<Judged, Share>,
    confused: BTreeMap<(Judged, String, String), usize>,
}

impl Tally {
    /// Adds judgements.
    pub fn add(&mut self, judgements: &[Judgement]) {
        for judgement in judgements {
            self.with.entry(judgement.judged).or_default().add(judgement);
            if !judgement.excepted {
                self.without.entry(judgement.judged).or_default().add(judgement);
            }
            if !judgement.strict {
                let key = (judgement.judged, judgement.described.clone(), judgement.measured.clone());
                *self.confused.entry(key).or_default() += 1;
            }
        }
    }

    /// The share that is right of a component, with or without what the synthesis itself reports that it could not do.
    pub fn share(&self, judged: Judged, exceptions: bool) -> Share {
        let all = if exceptions { &self.with } else { &self.without };
        all.get(&judged).copied().unwrap_or_default()
    }

    /// What is taken for what, the most frequent first.
    pub fn confusions(&self, judged: Judged) -> Vec<Confusion> {
        let of = self.confused.iter().filter(|((j, ..), _)| *j == judged);
        let mut all: Vec<Confusion> = of
            .map(|((_, described, measured), count)| Confusion {
                described: described.clone(),
                measured: measured.clone(),
                count: *count,
            })
            .collect();
        all.sort_by_key(|confusion| std::cmp::Reverse(confusion.count));
        all
    }
}
