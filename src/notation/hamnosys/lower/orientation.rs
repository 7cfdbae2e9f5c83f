//! Finger directions and palm rolls to directions in space.
//!
//! A palm symbol is a roll about the finger direction (facts/phonology.md §3); `.sign` text and the model have directions. A
//! palm halfway between two neighbouring symbols is a roll of a sixteenth of a turn.

use super::super::syntax::{Facing, Fingers, Palm};
use crate::phonology::roll::Roll;
use crate::phonology::{Direction, Heading, Orientation};
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::{Mutex, OnceLock, PoisonError};

/// Where fingers point.
pub(crate) fn heading(direction: Direction, between: Option<Direction>) -> Heading {
    match between {
        Some(other) if other != direction && other != direction.opposite() => Heading::Between(direction, other),
        Some(_) | None => Heading::Toward(direction),
    }
}

/// An orientation; what is not said is left open.
pub(crate) fn orientation(fingers: Option<&Fingers>, palm: Option<&Palm>) -> Orientation {
    let pointing = fingers.map(|f| heading(f.direction, f.between));
    // A palm without fingers is rolled about fingers that point out.
    let about = pointing.unwrap_or(Heading::Toward(Direction::OUT));
    Orientation {
        fingers: pointing,
        palm: palm.map(|p| facing(about, p)),
        along_path: fingers.is_some_and(|f| f.relative) || palm.is_some_and(|p| p.relative),
    }
}

fn facing(fingers: Heading, palm: &Palm) -> Heading {
    match (palm.facing, palm.between) {
        (Facing::Roll(roll), None) => sixteenth(fingers, 2 * eighths(roll)),
        (Facing::Roll(a), Some(Facing::Roll(b))) => sixteenth(fingers, middle(eighths(a), eighths(b))),
        (Facing::Roll(roll), Some(Facing::Toward(_))) => sixteenth(fingers, 2 * eighths(roll)),
        (Facing::Toward(d), other) => {
            let along = d.vector().dot(fingers.vector()).abs() > 0.95;
            match other {
                // It cannot face along the fingers: the nearest that it can.
                _ if along => sixteenth(fingers, 2 * eighths(Roll::nearest(fingers.vector(), d.vector()))),
                Some(Facing::Toward(e)) => heading(d, Some(e)),
                Some(Facing::Roll(_)) | None => Heading::Toward(d),
            }
        }
    }
}

/// The eighths of a turn of a roll, clockwise from up.
pub(crate) fn eighths(roll: Roll) -> u8 {
    Roll::all().position(|r| r == roll).unwrap_or(0) as u8
}

/// The sixteenths of a turn halfway between two rolls in eighths; opposite ones mean the first.
pub(crate) fn middle(a: u8, b: u8) -> u8 {
    let apart = (b + 8 - a) % 8;
    match apart {
        0..=3 => (2 * a + apart) % 16,
        4 => 2 * a,
        _ => (2 * a + 16 - (8 - apart)) % 16,
    }
}

/// Where a palm faces that is rolled by sixteenths of a turn, unit vector of model space.
pub(crate) fn rolled(fingers: DVec3, sixteenths: u8) -> DVec3 {
    let roll = |eighth: u8| Roll::all().nth(usize::from(eighth % 8)).map_or(DVec3::Y, |r| r.palm(fingers));
    let (up, right) = (roll(0), roll(2));
    let angle = TAU * f64::from(sixteenths) / 16.0;
    up * angle.cos() + right * angle.sin()
}

/// The heading that a palm faces, rolled by sixteenths of a turn. Headings are searched once for each pair.
fn sixteenth(fingers: Heading, sixteenths: u8) -> Heading {
    static KNOWN: OnceLock<Mutex<HashMap<(Heading, u8), Heading>>> = OnceLock::new();
    let known = KNOWN.get_or_init(Mutex::default);
    let key = (fingers, sixteenths);
    if let Some(found) = known.lock().unwrap_or_else(PoisonError::into_inner).get(&key) {
        return *found;
    }
    let found = crate::phonology::roll::facing(fingers, rolled(fingers.vector(), sixteenths));
    known.lock().unwrap_or_else(PoisonError::into_inner).insert(key, found);
    found
}

/// The sixteenths of a turn nearest to a palm that faces along `palm`, for fingers along `fingers`.
pub(crate) fn nearest_sixteenth(fingers: DVec3, palm: DVec3) -> u8 {
    let (up, right) = (rolled(fingers, 0), rolled(fingers, 4));
    let angle = palm.dot(right).atan2(palm.dot(up));
    (angle / TAU * 16.0).round().rem_euclid(16.0) as u8 % 16
}
