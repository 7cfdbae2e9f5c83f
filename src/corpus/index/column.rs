//! The values of one component over all segments: labels, when they hold, and lists by term.

use super::intern::Interner;
use super::postings::Postings;
use super::{NONE, finite};
use crate::corpus::label::{Label, Vocabulary};
use crate::corpus::segment::{Component, Value};
use crate::time::Seconds;

/// The values of one component over all segments.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Column {
    /// The labels as they stand, each once, in the order in which they are met.
    pub(super) texts: Vec<String>,
    /// What they come to.
    pub(super) labels: Vec<Label>,
    /// Where the values of each segment begin, and after the last one where they end.
    pub(super) from: Vec<u32>,
    /// For each value, its label.
    pub(super) label: Vec<u32>,
    pub(super) start: Vec<f64>,
    pub(super) end: Vec<f64>,
    /// All terms, sorted.
    pub(super) terms: Vec<String>,
    /// The segments of each term.
    pub(super) by_term: Postings,
    /// Segments of which some question about this component has no answer.
    pub(super) open: Vec<u32>,
}

/// The values of one component, of all segments one after the other.
pub(super) struct Values {
    pub(super) texts: Vec<String>,
    pub(super) from: Vec<u32>,
    pub(super) label: Vec<u32>,
    pub(super) start: Vec<f64>,
    pub(super) end: Vec<f64>,
}

impl Values {
    pub(super) fn of<'a>(values: impl Iterator<Item = &'a [Value]>, segments: usize) -> Values {
        let mut texts = Interner::default();
        let mut from = Vec::with_capacity(segments + 1);
        let (mut label, mut start, mut end) = (Vec::with_capacity(segments), Vec::new(), Vec::new());
        for own in values {
            from.push(label.len() as u32);
            // Numbers of values fit as those of segments do; what does not is left out.
            for value in own.iter().take((NONE as usize).saturating_sub(label.len() + 1)) {
                label.push(texts.number(&value.label));
                start.push(finite(value.start));
                end.push(finite(value.end));
            }
        }
        from.push(label.len() as u32);
        Values { texts: texts.into_texts(), from, label, start, end }
    }
}

impl Column {
    pub(super) fn of(values: Values, component: Component, vocabulary: &Vocabulary) -> Column {
        let Values { texts, from, label, start, end } = values;
        let labels: Vec<Label> = texts.iter().map(|text| vocabulary.read(component, text)).collect();
        let mut terms: Vec<String> = labels.iter().flat_map(|l| l.terms.iter().cloned()).collect();
        terms.sort();
        terms.dedup();
        let number = |term: &String| terms.binary_search(term).expect("all terms are there") as u32;
        let numbers: Vec<Vec<u32>> = labels.iter().map(|l| l.terms.iter().map(number).collect()).collect();
        let partial: Vec<bool> = labels.iter().map(Label::is_partial).collect();
        let own = |i: usize| &label[from[i] as usize..from[i + 1] as usize];
        let by_term = Postings::several_each(from.len() - 1, terms.len(), |i, put| {
            own(i).iter().for_each(|l| numbers[*l as usize].iter().for_each(|term| put(*term)));
        });
        let is_open = |i: &u32| {
            let own = own(*i as usize);
            own.is_empty() || own.iter().any(|l| partial[*l as usize])
        };
        let open = (0..from.len() as u32 - 1).filter(is_open).collect();
        Column { texts, labels, from, label, start, end, terms, by_term, open }
    }

    pub(super) fn numbers(&self, segment: usize) -> &[u32] {
        &self.label[self.from[segment] as usize..self.from[segment + 1] as usize]
    }

    pub(super) fn values(&self, segment: usize) -> Vec<Value> {
        let all = self.from[segment] as usize..self.from[segment + 1] as usize;
        let value = |i: usize| Value {
            label: self.texts[self.label[i] as usize].clone(),
            start: Seconds(self.start[i]),
            end: Seconds(self.end[i]),
        };
        all.map(value).collect()
    }
}
