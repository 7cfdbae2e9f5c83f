//! Directions of space to finger directions and palm rolls.

use super::super::lower::orientation::nearest_sixteenth;
use super::super::syntax::{Facing, Fingers, Palm};
use crate::phonology::roll::Roll;
use crate::phonology::{Direction, Heading, Orientation};

/// The finger direction of an orientation.
pub(crate) fn fingers(o: &Orientation) -> Option<Fingers> {
    let (direction, between) = match o.fingers? {
        Heading::Toward(d) => (d, None),
        Heading::Between(a, b) => (a, Some(b)),
    };
    Some(Fingers { direction, between, relative: o.along_path })
}

/// The palm symbol of an orientation, about its fingers or, where they are not said, about those `before`.
pub(crate) fn palm(o: &Orientation, before: Option<Heading>) -> Option<Palm> {
    let facing = o.palm?;
    let about = o.fingers.or(before).unwrap_or(Heading::Toward(Direction::OUT)).vector();
    let sixteenths = nearest_sixteenth(about, facing.vector());
    let roll =
        |eighth: u8| Roll::all().nth(usize::from(eighth % 8)).map_or(Facing::Toward(Direction::DOWN), Facing::Roll);
    let facing = roll(sixteenths / 2);
    let between = (sixteenths % 2 == 1).then(|| roll(sixteenths / 2 + 1));
    Some(Palm { facing, between, relative: o.along_path && o.fingers.is_none(), approximate: false })
}
