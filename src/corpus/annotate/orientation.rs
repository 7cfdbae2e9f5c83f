//! Orientation: where fingers and palm look at each stop of the hand's turning, each the nearest of the 26 directions.

use super::moves::{Thresholds, moves, stops};
use super::{Seen, Value, push_or_extend};
use crate::phonology::{Direction, Heading, Orientation};

/// Stillness and moves of the hand's turning, radians a second.
const TURNING: Thresholds = Thresholds { still: 0.2, least: 0.8, valley: 0.4 };

/// The orientations of a stretch, in order.
pub(super) fn orientations(seen: &Seen) -> Vec<Value<Orientation>> {
    let profile = &seen.signals.turn_speed;
    let all = moves(profile, TURNING);
    let mut values = Vec::new();
    for stop in stops(profile, &all, seen.start..=seen.end) {
        let (fingers, palm) = (seen.signals.fingers[stop.at], seen.signals.facing[stop.at]);
        let (Some(f), Some(p)) = (Direction::nearest(fingers), Direction::nearest(palm)) else { continue };
        let off = f.vector().angle_between(fingers).max(p.vector().angle_between(palm));
        let value =
            Orientation { fingers: Some(Heading::Toward(f)), palm: Some(Heading::Toward(p)), along_path: false };
        let value = Value { start: seen.time(stop.from), end: seen.time(stop.to), value, off };
        push_or_extend(&mut values, value, |a, b| a == b);
    }
    values
}
