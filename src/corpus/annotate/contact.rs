//! Contact: where the two hands meet.

use super::{Annotation, Value};
use crate::phonology::{Contact, ContactKind, Distance, Place, Side};

/// The stretches in which a hand's place is on the other one.
pub(super) fn contacts(annotation: &Annotation) -> Vec<Value<Contact>> {
    let mut found: Vec<Value<Contact>> = Vec::new();
    for hand in &annotation.hands {
        for placed in &hand.placement {
            let Place::OtherHand(other) = placed.value.placement.place else { continue };
            let kind = match placed.value.placement.distance {
                Distance::Touch => ContactKind::Touch,
                _ => ContactKind::Close,
            };
            let (strong, weak) = match hand.side {
                Side::Right => (placed.value.with, other),
                Side::Left => (other, placed.value.with),
            };
            let value = Contact { strong: Some(strong), weak: Some(weak), kind };
            // What both hands say is said once.
            let known = found.iter().any(|v| v.start.0 < placed.end.0 && placed.start.0 < v.end.0);
            if !known {
                found.push(Value { start: placed.start, end: placed.end, value, off: placed.off });
            }
        }
    }
    found.sort_by(|a, b| a.start.0.total_cmp(&b.start.0));
    found
}
