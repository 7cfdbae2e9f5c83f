//! Near conditions: how far a segment's values are from what is asked.

use super::Pattern;
use crate::corpus::index::Index;
use crate::corpus::label::{Label, Truth};
use crate::corpus::segment::Component;

/// The distances of all labels of a component from the parts of patterns.
pub(super) struct NearTable<'a> {
    pub(super) component: Component,
    bound: Option<f64>,
    /// For each pattern, for each part, the distance from each label; not a number where they cannot be compared.
    distances: Vec<Vec<Vec<f64>>>,
    patterns: &'a [Pattern],
}

/// How near a segment is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nearness {
    pub(super) truth: Truth,
    /// The distance; `None` where it is not known, or there are fewer values than the pattern has.
    pub(super) distance: Option<f64>,
}

impl<'a> NearTable<'a> {
    /// The distances of all labels, or of those that one segment has.
    pub(super) fn of(
        index: &Index,
        component: Component,
        patterns: &'a [Pattern],
        bound: Option<f64>,
        only: Option<usize>,
    ) -> NearTable<'a> {
        let labels = index.labels(component);
        let distance = |label: &Label, part: &Label| label.features.distance(&part.features).unwrap_or(f64::NAN);
        let from = |part: &Label| -> Vec<f64> {
            let Some(segment) = only else { return labels.iter().map(|label| distance(label, part)).collect() };
            let mut all = vec![f64::NAN; labels.len()];
            for number in index.label_numbers(component, segment) {
                all[*number as usize] = distance(&labels[*number as usize], part);
            }
            all
        };
        let distances = patterns.iter().map(|pattern| pattern.parts.iter().map(from).collect()).collect();
        NearTable { component, bound, distances, patterns }
    }

    /// How near a segment is: the least distance of any pattern.
    pub(super) fn nearness(&self, index: &Index, segment: usize) -> Nearness {
        let numbers = index.label_numbers(self.component, segment);
        let least = self.distances.iter().filter_map(|parts| least(parts, numbers)).min_by(f64::total_cmp);
        let all = |number: &u32| self.distances.iter().flatten().all(|part| !part[*number as usize].is_nan());
        let within = |distance: f64| self.bound.is_none_or(|bound| distance <= bound);
        let truth = match least {
            Some(distance) if within(distance) => Truth::Yes,
            // Where a value cannot be compared, it might be the one.
            _ if numbers.is_empty() || !numbers.iter().all(all) => Truth::Unknown,
            _ => Truth::No,
        };
        Nearness { truth, distance: least }
    }

    /// The value of a segment and the pattern's part that are nearest to each other, with their distance, for a reason.
    pub(super) fn nearest_value<'i>(&self, index: &'i Index, segment: usize) -> Option<(&'i str, &'a str, f64)> {
        let numbers = index.label_numbers(self.component, segment);
        let parts = self
            .distances
            .iter()
            .zip(self.patterns)
            .flat_map(|(of_pattern, pattern)| of_pattern.iter().zip(&pattern.parts));
        let pairs = parts.flat_map(|(distances, part)| {
            let text = |n: &u32| index.labels(self.component)[*n as usize].text.as_str();
            numbers.iter().map(move |n| (text(n), part.text.as_str(), distances[*n as usize]))
        });
        pairs.filter(|pair| !pair.2.is_nan()).min_by(|a, b| a.2.total_cmp(&b.2))
    }
}

/// The least mean distance of values, in time order, from the parts of a pattern, each by a value of its own.
fn least(parts: &[Vec<f64>], numbers: &[u32]) -> Option<f64> {
    if let [only] = parts {
        let known = numbers.iter().map(|n| only[*n as usize]).filter(|d| !d.is_nan());
        return known.min_by(f64::total_cmp);
    }
    let mut sums = vec![f64::INFINITY; parts.len() + 1];
    sums[0] = 0.0;
    for number in numbers {
        for (k, part) in parts.iter().enumerate().rev() {
            let distance = part[*number as usize];
            if !distance.is_nan() {
                sums[k + 1] = sums[k + 1].min(sums[k] + distance);
            }
        }
    }
    Some(sums[parts.len()] / parts.len() as f64).filter(|mean| mean.is_finite())
}
