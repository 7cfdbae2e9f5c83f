//! The points that a name on the command line means, on the rig of a motion.

use super::super::Failure;
use crate::body::landmarks::Landmarks;
use crate::motion::point::{self, Point};
use crate::motion::skeleton::Skeleton;
use crate::notation::suggest::nearest;
use crate::phonology::{Lateral, Side};

/// The joints and tips of a name, in which `*` stands for any letters; else the place of the body that it names.
pub(super) fn points(skeleton: &Skeleton, name: &str) -> Result<Vec<Point>, Failure> {
    let found = point::matching(skeleton, name);
    if !found.is_empty() {
        return Ok(found);
    }
    // Only a rig with our joints has our landmarks.
    let landmarks = Landmarks::builtin(skeleton).ok();
    if let Some(landmarks) = &landmarks {
        let lower = name.trim().to_lowercase();
        let of = |side, rest: &str| (rest.to_owned(), Some(Lateral { side, beside: false }));
        let (id, lateral) = match lower.split_once(' ') {
            Some(("left", rest)) => of(Side::Left, rest),
            Some(("right", rest)) => of(Side::Right, rest),
            _ => (lower, None),
        };
        match landmarks.body_place(&id, lateral) {
            Ok(place) => {
                return Ok(vec![Point { name: name.trim().to_owned(), joint: place.joint, offset: place.offset }]);
            }
            Err(error) if landmarks.body_ids().any(|known| known == id) => {
                return Err(Failure::Usage(format!("--joint {name}: {error}")));
            }
            Err(_) => {}
        }
    }
    let all = point::all(skeleton);
    let places = landmarks.iter().flat_map(|l| l.body_ids());
    let hint = match nearest(name, all.iter().map(|p| p.name.as_str()).chain(places)) {
        Some(known) => format!("; did you mean `{known}`?"),
        None => {
            format!("; it has {} and others", all.iter().take(3).map(|p| &p.name[..]).collect::<Vec<_>>().join(", "))
        }
    };
    Err(Failure::Usage(format!("--joint {name}: the rig has no such joint, tip or place{hint}")))
}
