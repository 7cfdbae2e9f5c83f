//! Contact: where the two hands meet.

use super::{Annotation, Value};
use crate::phonology::{Contact, ContactKind, Distance, Side};

/// The stretches in which the hands touch or are close to each other.
pub(super) fn contacts(annotation: &Annotation) -> Vec<Value<Contact>> {
    let mut found: Vec<Value<Contact>> = Vec::new();
    for hand in &annotation.hands {
        for placed in &hand.placement {
            let Some(met) = placed.value.meeting else { continue };
            let kind = if met.distance == Distance::Touch { ContactKind::Touch } else { ContactKind::Close };
            let (strong, weak) = match hand.side {
                Side::Right => (met.with, met.other),
                Side::Left => (met.other, met.with),
            };
            let value = Contact { strong: Some(strong), weak: Some(weak), kind };
            // What both hands say is said once.
            let known = found.iter().any(|v| v.start.0 < placed.end.0 && placed.start.0 < v.end.0);
            if !known {
                found.push(Value { start: placed.start, end: placed.end, value, off: met.off });
            }
        }
    }
    found.sort_by(|a, b| a.start.0.total_cmp(&b.start.0));
    found
}
