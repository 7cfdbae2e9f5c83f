//! Asking an index: which segments meet a query, in what order.

use super::Query;
use super::prepare::Prepared;
use crate::corpus::index::Index;
use crate::corpus::label::Truth;

/// How many hits are wanted, and which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The most hits.
    pub limit: usize,
    /// Segments of which something is not known that is asked for are left out.
    pub strict: bool,
}

impl Default for Options {
    /// The first hundred, those too of which not all is known.
    fn default() -> Options {
        Options { limit: 100, strict: false }
    }
}

/// A segment that was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Its number in the index.
    pub segment: usize,
    /// Whether it meets all conditions; else something that is asked is not known of it.
    pub sure: bool,
    /// The sum of the distances of all near conditions, as far as they are known.
    pub distance: f64,
}

impl Index {
    /// The segments that meet a query: the sure ones first, then by distance, then in the index's order.
    ///
    /// ```
    /// use chereme::corpus::index::Index;
    /// use chereme::corpus::query::{Options, parse};
    /// use chereme::corpus::{label::Vocabulary, segment::{Segment, Value}};
    /// use chereme::diagnostics::Source;
    /// use chereme::motion::skeleton::Skeleton;
    /// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
    /// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
    /// let mut five = Segment::default();
    /// five.values[0].push(Value { label: "4".into(), start: five.start, end: five.end });
    /// let index = Index::build(&[], &[Segment::default(), five], &vocabulary);
    /// let query = parse(&Source::new("query", "configuration~5:0.3"), &vocabulary).unwrap().query;
    /// let hits = index.find(&query, &Options::default());
    /// assert_eq!(hits.iter().map(|hit| (hit.segment, hit.sure)).collect::<Vec<_>>(), [(1, true), (0, false)]);
    /// assert_eq!(index.reasons(&query, &hits[1]), ["configuration is not known"]);
    /// ```
    pub fn find(&self, query: &Query, options: &Options) -> Vec<Hit> {
        let prepared = Prepared::of(self, query, None);
        let ranked = prepared.is_ranked();
        let mut best = Best::new(options.limit, ranked);
        self.sure(&prepared, &mut best);
        let mut hits = best.hits(true);
        if !options.strict && hits.len() < options.limit {
            let mut best = Best::new(options.limit - hits.len(), ranked);
            self.unsure(&prepared, &mut best);
            hits.extend(best.hits(false));
        }
        hits
    }

    /// Walks all lists together, each to the least number that the others allow (leapfrog join, Veldhuizen 2014).
    fn sure(&self, prepared: &Prepared, best: &mut Best) {
        let mut lists = prepared.lists();
        let mut least = 0;
        while (least as usize) < self.len() && !best.is_full() {
            let mut candidate = least;
            for list in &mut lists {
                match list.from(candidate) {
                    Some(next) => candidate = next,
                    None => return,
                }
            }
            // A list that jumped ahead makes those before it look again.
            if candidate == least || lists.len() <= 1 {
                let (truth, distance) = prepared.judge(candidate as usize);
                if truth == Truth::Yes {
                    best.put(distance, candidate);
                }
                least = candidate + 1;
            } else {
                least = candidate;
            }
        }
    }

    fn unsure(&self, prepared: &Prepared, best: &mut Best) {
        let mut open = prepared.open();
        let mut least = 0;
        while let Some(candidate) = open.from(least)
            && !best.is_full()
        {
            let (truth, distance) = prepared.judge(candidate as usize);
            if truth == Truth::Unknown {
                best.put(distance, candidate);
            }
            least = candidate + 1;
        }
    }
}

/// The best hits so far, of those that come in the index's order.
struct Best {
    limit: usize,
    ranked: bool,
    found: Vec<(f64, u32)>,
    /// No hit beyond this distance is wanted any more.
    worst: f64,
}

impl Best {
    fn new(limit: usize, ranked: bool) -> Best {
        Best { limit, ranked, found: Vec::new(), worst: f64::INFINITY }
    }

    /// Whether no later segment can be better.
    fn is_full(&self) -> bool {
        self.found.len() >= self.limit && (!self.ranked || self.limit == 0)
    }

    fn put(&mut self, distance: f64, segment: u32) {
        // A later one that is as far comes after.
        if self.ranked && distance >= self.worst {
            return;
        }
        self.found.push((distance, segment));
        if self.ranked && self.found.len() >= self.limit.saturating_mul(2).max(64) {
            self.cut();
        }
    }

    /// Leaves the best ones, in order.
    fn cut(&mut self) {
        self.found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        self.found.truncate(self.limit);
        if let Some(last) = self.found.last().filter(|_| self.found.len() == self.limit) {
            self.worst = last.0;
        }
    }

    fn hits(mut self, sure: bool) -> Vec<Hit> {
        self.cut();
        let hit = |(distance, segment): (f64, u32)| Hit { segment: segment as usize, sure, distance };
        self.found.into_iter().map(hit).collect()
    }
}
