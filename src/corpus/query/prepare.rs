//! A query made ready for one index: names looked up, lists found, distances to all labels taken once.

use super::near::{NearTable, Nearness};
use super::{Asked, Condition, Field, HandName, Order, Pattern, Query};
use crate::corpus::index::{Index, Named, Union};
use crate::corpus::label::Truth;
use crate::corpus::segment::Component;
use crate::phonology::Side;

/// A query and the index that it is asked of.
pub(super) struct Prepared<'a> {
    pub(super) index: &'a Index,
    pub(super) conditions: Vec<Ready<'a>>,
}

/// A condition made ready.
pub(super) struct Ready<'a> {
    pub(super) condition: &'a Condition,
    test: Test<'a>,
}

/// What is left to test of each segment.
enum Test<'a> {
    Names(Named, Vec<u32>),
    Hands(&'a [HandName]),
    Values(Component, &'a [Pattern]),
    Near(NearTable<'a>),
    Times(Field, Order, &'a [f64]),
    Missing(Field),
}

/// What names a field's values have, where they are names.
pub(super) fn named(field: Field) -> Option<Named> {
    match field {
        Field::Gloss => Some(Named::Gloss),
        Field::Recording => Some(Named::Recording),
        Field::Signer => Some(Named::Signer),
        Field::Hand | Field::Value(_) | Field::Fingers | Field::Palm | Field::Duration | Field::Start => None,
    }
}

impl<'a> Prepared<'a> {
    /// For all segments, or for one alone: then no more is made ready than that one needs.
    pub(super) fn of(index: &'a Index, query: &'a Query, only: Option<usize>) -> Prepared<'a> {
        let ready = |condition: &'a Condition| {
            let field = condition.field;
            let test = match (&condition.asked, named(field), field.component()) {
                (Asked::Missing, ..) => Test::Missing(field),
                (Asked::Names(names), Some(of), _) => {
                    Test::Names(of, names.iter().filter_map(|name| index.names(of).number(name)).collect())
                }
                (Asked::Hands(hands), ..) => Test::Hands(hands),
                (Asked::Values(patterns), _, Some(component)) => Test::Values(component, patterns),
                (Asked::Near { patterns, bound }, _, Some(component)) => {
                    Test::Near(NearTable::of(index, component, patterns, *bound, only))
                }
                (Asked::Times(order, times), ..) => Test::Times(field, *order, times),
                // A query made by hand may ask for what the field does not have: nothing is that.
                (Asked::Names(_) | Asked::Values(_) | Asked::Near { .. }, ..) => Test::Hands(&[]),
            };
            Ready { condition, test }
        };
        Prepared { index, conditions: query.conditions.iter().map(ready).collect() }
    }

    /// The truth of all conditions together, and the sum of the distances that are known.
    pub(super) fn judge(&self, segment: usize) -> (Truth, f64) {
        let (mut all, mut sum) = (Truth::Yes, 0.0);
        for ready in &self.conditions {
            let (truth, distance) = ready.judge(self.index, segment);
            all = all.min(truth);
            sum += distance.unwrap_or(0.0);
            if all == Truth::No {
                break;
            }
        }
        (all, sum)
    }

    /// For each condition that only listed segments can meet, their lists.
    pub(super) fn lists(&self) -> Vec<Union<'a>> {
        self.conditions.iter().filter_map(|ready| ready.lists(self.index)).map(Union::of).collect()
    }

    /// The segments of which it may be unknown whether they meet the query.
    pub(super) fn open(&self) -> Union<'a> {
        let lists = self.conditions.iter().map(|ready| ready.open(self.index));
        Union::of(lists.filter(|list| !list.is_empty()).collect())
    }

    /// Whether hits are ranked by distance.
    pub(super) fn is_ranked(&self) -> bool {
        self.conditions.iter().any(|ready| ready.near().is_some())
    }
}

impl<'a> Ready<'a> {
    /// The distances of a near condition.
    pub(super) fn near(&self) -> Option<&NearTable<'a>> {
        match &self.test {
            Test::Near(table) => Some(table),
            Test::Names(..) | Test::Hands(_) | Test::Values(..) | Test::Times(..) | Test::Missing(_) => None,
        }
    }

    /// Whether a segment meets the condition; for near ones also its distance, where it is known.
    pub(super) fn judge(&self, index: &Index, segment: usize) -> (Truth, Option<f64>) {
        let mut distance = None;
        let truth = match &self.test {
            Test::Names(of, numbers) => match index.name_number(*of, segment) {
                Some(number) => Truth::of(numbers.contains(&number)),
                None => Truth::Unknown,
            },
            Test::Hands(hands) => hands.iter().map(|hand| is_hand(index, segment, *hand)).max().unwrap_or(Truth::No),
            Test::Values(component, patterns) => {
                let numbers = index.label_numbers(*component, segment);
                let truth = |pattern| in_order(index, *component, numbers, pattern);
                patterns.iter().map(truth).max().unwrap_or(Truth::No)
            }
            Test::Near(table) => {
                let Nearness { truth, distance: near } = table.nearness(index, segment);
                distance = near;
                truth
            }
            Test::Times(field, order, times) => {
                let time = if *field == Field::Start { index.start(segment) } else { index.duration(segment) };
                Truth::of(times.iter().any(|asked| order.holds(time, *asked)))
            }
            Test::Missing(field) => Truth::of(is_missing(index, segment, *field)),
        };
        (if self.condition.negated { !truth } else { truth }, distance)
    }

    /// Lists that have all segments that meet the condition for sure; `None` where there are none to walk.
    fn lists(&self, index: &'a Index) -> Option<Vec<&'a [u32]>> {
        if self.condition.negated {
            return None;
        }
        match &self.test {
            Test::Names(of, numbers) => Some(numbers.iter().map(|n| index.names(*of).segments(*n)).collect()),
            Test::Values(component, patterns) => {
                // Of all terms that a pattern needs the rarest one has the shortest list.
                let rarest = |pattern: &Pattern| {
                    let terms = pattern.parts.iter().flat_map(|part| &part.terms);
                    terms.map(|term| index.with_term(*component, term)).min_by_key(|list| list.len())
                };
                patterns.iter().map(rarest).collect()
            }
            Test::Hands(_) | Test::Near(_) | Test::Times(..) | Test::Missing(_) => None,
        }
    }

    /// The segments of which the condition may be unknown.
    fn open(&self, index: &'a Index) -> &'a [u32] {
        match &self.test {
            Test::Names(of, _) => index.without(*of),
            Test::Hands(hands) => {
                let by_role = hands.iter().any(|hand| matches!(hand, HandName::Strong | HandName::Weak));
                index.without_hand()[usize::from(by_role)]
            }
            Test::Values(component, _) => index.open(*component),
            Test::Near(table) => index.open(table.component),
            Test::Times(..) | Test::Missing(_) => &[],
        }
    }
}

fn is_hand(index: &Index, segment: usize, hand: HandName) -> Truth {
    let Some(side) = index.side(segment) else { return Truth::Unknown };
    let role = |role: fn(Side) -> Side| match index.about(segment).and_then(|about| about.dominant) {
        Some(dominant) => Truth::of(side == role(dominant)),
        None => Truth::Unknown,
    };
    match hand {
        HandName::Side(wanted) => Truth::of(side == wanted),
        HandName::Strong => role(|side| side),
        HandName::Weak => role(Side::other),
    }
}

/// Whether nothing is known of a field.
fn is_missing(index: &Index, segment: usize, field: Field) -> bool {
    if let Some(of) = named(field) {
        return index.name_number(of, segment).is_none();
    }
    match field {
        Field::Hand => index.side(segment).is_none(),
        Field::Fingers | Field::Palm => {
            let says = |number: &u32| {
                let label = &index.labels(Component::Orientation)[*number as usize];
                label.terms.iter().any(|term| term.split(' ').next() == Some(field.name()))
            };
            !index.label_numbers(Component::Orientation, segment).iter().any(says)
        }
        Field::Value(component) => index.label_numbers(component, segment).is_empty(),
        Field::Gloss | Field::Recording | Field::Signer | Field::Duration | Field::Start => false,
    }
}

/// Whether values, in time order, are as a pattern: each part by a value of its own, in order.
fn in_order(index: &Index, component: Component, numbers: &[u32], pattern: &Pattern) -> Truth {
    let labels = index.labels(component);
    if numbers.is_empty() {
        return Truth::Unknown;
    }
    if let [part] = &pattern.parts[..] {
        return numbers.iter().map(|n| labels[*n as usize].matches(part)).max().unwrap_or(Truth::No);
    }
    // The best truth of having met so many parts so far.
    let mut met = vec![Truth::No; pattern.parts.len() + 1];
    met[0] = Truth::Yes;
    for number in numbers {
        for (k, part) in pattern.parts.iter().enumerate().rev() {
            met[k + 1] = met[k + 1].max(met[k].min(labels[*number as usize].matches(part)));
        }
    }
    met[pattern.parts.len()]
}
