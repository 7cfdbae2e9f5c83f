//! Configuration: the nearest handshape of the inventory at each stop of the fingers.

use super::moves::{Thresholds, moves, stops};
use super::{Seen, Shape, Value, push_or_extend};
use crate::body::measure::HandForms;
use crate::time::Seconds;

/// Stillness and moves of the digits' ends in the hand, metres a second.
const FORMING: Thresholds = Thresholds { still: 0.02, least: 0.06, valley: 0.4 };

/// The handshapes of a stretch, in order; shapes that are the same on the hand are one value. While the fingers play, the hand keeps
/// the shape that it had before.
pub(super) fn configurations(seen: &Seen, forms: &HandForms, playing: &[(Seconds, Seconds)]) -> Vec<Value<Shape>> {
    let profile = &seen.signals.form_speed;
    let all = moves(profile, FORMING);
    let mut values: Vec<Value<Shape>> = Vec::new();
    for stop in stops(profile, &all, seen.start..=seen.end) {
        let (at, start, end) = (seen.time(stop.at), seen.time(stop.from), seen.time(stop.to));
        let plays = playing.iter().any(|(from, to)| at.0 > from.0 + 0.02 && at.0 < to.0 - 0.02);
        if let (true, Some(last)) = (plays, values.last_mut()) {
            last.end = end;
            continue;
        }
        let Some(nearest) = forms.nearest(&seen.signals.forms[stop.at]) else { continue };
        let shape = Shape { number: nearest.shape, id: forms.shapes()[nearest.shape].id.clone() };
        let value = Value { start, end, value: shape, off: nearest.distance };
        push_or_extend(&mut values, value, |a, b| forms.are_same(a.number, b.number));
    }
    values
}
