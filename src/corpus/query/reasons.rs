//! Why a segment was found, in short sentences.

use super::prepare::{Prepared, Ready, named};
use super::{Asked, Field, Hit, Order, Query};
use crate::corpus::index::{Index, Named};
use crate::corpus::label::Truth;
use crate::corpus::segment::Component;
use crate::phonology::Side;

impl Index {
    /// Why a hit of [`Index::find`] was found: a sentence a condition, in the query's order, such as `configuration 4 is 0.05 from 5`,
    /// `placement is not known`, `duration is 0.80 s, below 1.20 s`.
    ///
    /// A hit of another index or query gets reasons that may not hold; one beyond the index none.
    pub fn reasons(&self, query: &Query, hit: &Hit) -> Vec<String> {
        if hit.segment >= self.len() {
            return Vec::new();
        }
        let prepared = Prepared::of(self, query, Some(hit.segment));
        prepared.conditions.iter().map(|ready| self.reason(ready, hit.segment)).collect()
    }

    fn reason(&self, ready: &Ready, segment: usize) -> String {
        let (condition, truth) = (ready.condition, ready.judge(self, segment).0);
        let field = condition.field;
        let name = field.name();
        if truth == Truth::Unknown {
            return self.unknown(field, segment);
        }
        let is = self.shown(field, segment);
        match &condition.asked {
            Asked::Missing if condition.negated => format!("{name} is known: {is}"),
            Asked::Missing => format!("{name} is not known"),
            Asked::Near { patterns, .. } => {
                let single = patterns.iter().all(|pattern| pattern.parts.len() == 1);
                let nearest = ready.near().filter(|_| single).and_then(|table| table.nearest_value(self, segment));
                match (nearest, ready.judge(self, segment).1) {
                    (Some((label, part, distance)), _) => format!("{name} {label} is {distance:.2} from {part}"),
                    (None, Some(distance)) => format!("{name} {is} is {distance:.2} from {}", condition.written),
                    (None, None) => format!("{name} is {is}"),
                }
            }
            Asked::Times(order, _) => {
                let words = match (order, condition.negated) {
                    (Order::Equal, false) => "as asked",
                    (Order::Equal, true) => "not",
                    (Order::Less, _) => "below",
                    (Order::AtMost, _) => "at most",
                    (Order::More, _) => "above",
                    (Order::AtLeast, _) => "at least",
                };
                format!("{name} is {is}, {words} {}", condition.written)
            }
            Asked::Hands(_) | Asked::Names(_) | Asked::Values(_) if condition.negated => {
                format!("{name} is {is}, not {}", condition.written)
            }
            Asked::Hands(_) | Asked::Names(_) | Asked::Values(_) => format!("{name} is {is}"),
        }
    }

    /// What is not known.
    fn unknown(&self, field: Field, segment: usize) -> String {
        let nothing = field.component().is_none_or(|c| self.label_numbers(c, segment).is_empty());
        match field {
            Field::Hand if self.side(segment).is_some() => "the dominant hand is not known".to_owned(),
            _ if nothing => format!("{} is not known", field.name()),
            _ => format!("{} is not known, only {}", field.name(), self.shown(field, segment)),
        }
    }

    /// What a segment has of a field.
    fn shown(&self, field: Field, segment: usize) -> String {
        let about = self.about(segment);
        match field {
            Field::Hand => match self.side(segment) {
                Some(Side::Right) => "right".to_owned(),
                Some(Side::Left) => "left".to_owned(),
                None => "not known".to_owned(),
            },
            Field::Duration => format!("{:.2} s", self.duration(segment)),
            Field::Start => format!("{:.2} s", self.start(segment)),
            Field::Gloss | Field::Recording | Field::Signer => {
                let text = match named(field) {
                    Some(Named::Gloss) => self.gloss_text(segment),
                    Some(Named::Signer) => about.and_then(|a| a.signer.as_deref()),
                    _ => about.map(|a| a.name.as_str()),
                };
                text.unwrap_or("not known").to_owned()
            }
            Field::Value(_) | Field::Fingers | Field::Palm => {
                let component = field.component().unwrap_or(Component::Configuration);
                let labels = self.label_numbers(component, segment).iter();
                let texts: Vec<&str> = labels.map(|n| self.labels(component)[*n as usize].text.as_str()).collect();
                texts.join(" > ")
            }
        }
    }
}
