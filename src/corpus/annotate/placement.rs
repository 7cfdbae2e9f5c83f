//! Placement: the nearest named place at each stop of the hand's way.

use super::moves::{Stop, Thresholds, moves, stops};
use super::placer::{Meeting, Placer};
use super::{Placed, Seen, Shape, Value, push_or_extend};
use crate::body::measure::HandForms;
use crate::phonology::{Distance, HandPoint};

/// Stillness and moves of the palm, metres a second.
const GOING: Thresholds = Thresholds { still: 0.04, least: 0.12, valley: 0.5 };

/// How much nearer to a place hands are that touch by chance, metres.
const NOT_TOUCHING_M: f64 = 0.01;

/// The places of a stretch, in order. Where hands touch, the place is that of the
/// points that do.
pub(super) fn placements(
    seen: &Seen,
    shapes: &[Value<Shape>],
    forms: &HandForms,
    placer: &Placer,
) -> Vec<Value<Placed>> {
    let profile = &seen.signals.path_speed;
    let all = moves(profile, GOING);
    let mut values: Vec<Value<Placed>> = Vec::new();
    for Stop { at, from, to } in stops(profile, &all, seen.start..=seen.end) {
        let own = own_point(shapes, seen.time(at).0, forms);
        let (side, model) = (seen.signals.side, &seen.models[at]);
        let met = placer.meeting(side, own, model);
        let touching = met.filter(|met| met.distance == Distance::Touch);
        // Hands that touch are where they touch, or where each is: whichever is nearer to a place with a name.
        let meeting = touching.and_then(|met| placer.place_of_meeting(side, met, model));
        let alone = placer.place(side, own, model);
        let nearer = |(_, off): &(Placed, f64)| meeting.as_ref().is_none_or(|(_, other)| off + NOT_TOUCHING_M < *other);
        let found = alone.filter(nearer).or(meeting.clone()).map(|(placed, off)| {
            let is_place = seen.goes_to_other && !placer.mirrored(model);
            (Placed { meeting: met.map(|met| Meeting { is_place, ..met }), ..placed }, off)
        });
        if let Some((value, off)) = found {
            let value = Value { start: seen.time(from), end: seen.time(to), value, off };
            push_or_extend(&mut values, value, |a, b| a.placement == b.placement && a.on_other() == b.on_other());
        }
    }
    values
}

/// The point with which the shape at an instant touches.
fn own_point(shapes: &[Value<Shape>], time: f64, forms: &HandForms) -> HandPoint {
    let shape = shapes.iter().find(|v| time <= v.end.0).or(shapes.last());
    shape.map_or(HandPoint::PALM, |v| forms.shapes()[v.value.number].touches_with)
}
