//! Marker positions (millimetres): shoulder, elbow and hand of one arm.

use crate::diagnostics::Error;
use crate::evaluation::kinematics::Movement;
use crate::format::markers::Markers;
use glam::DVec3;

const METRES: f64 = 0.001;
/// The marker of the hand, by preference.
const HANDS: [&str; 3] = ["hand_top", "wrist", "hand"];

/// The arm of a table whose markers are named `… shoulder`, `… elbow`, `hand_top`. Where a marker was not seen, it is taken to have gone
/// straight from where it was to where it is seen again.
pub(super) fn arm(take: &str, markers: &Markers) -> Result<Movement, Error> {
    let fps = markers.rate().ok_or_else(|| Error::new("the table does not say its frame rate"))?;
    let ends_in = |part: &str| markers.names().iter().position(|name| name.to_lowercase().ends_with(part));
    let marker =
        |part: &str| ends_in(part).ok_or_else(|| Error::new(format!("there is no marker whose name ends in `{part}`")));
    let hand = HANDS.iter().find_map(|part| ends_in(part));
    let hand = hand.ok_or_else(|| Error::new(format!("there is no marker of a hand: {}", HANDS.join(", "))))?;
    let [shoulder, elbow, hand] = [marker("shoulder")?, marker("elbow")?, hand].map(|at| {
        let seen: Vec<Option<DVec3>> = markers.frames().map(|frame| frame[at].map(|p| p * METRES)).collect();
        filled(&seen).ok_or_else(|| Error::new(format!("the marker {} is never seen", markers.names()[at])))
    });
    let (shoulder, elbow, hand) = (shoulder?, elbow?, hand?);
    let frames = (0..hand.len()).map(|i| [shoulder[i], elbow[i], hand[i]]).collect();
    Movement::of_arm(take, fps, frames).ok_or_else(|| Error::new("there is no row of positions"))
}

/// A path without gaps; `None` where nothing is seen at all.
fn filled(seen: &[Option<DVec3>]) -> Option<Vec<DVec3>> {
    let known: Vec<(usize, DVec3)> = seen.iter().enumerate().filter_map(|(i, p)| p.map(|p| (i, p))).collect();
    let (first, last) = (known.first()?, known.last()?);
    let mut next = 0;
    let at = |i: usize| {
        while next + 1 < known.len() && known[next + 1].0 <= i {
            next += 1;
        }
        let ((a, p), (b, q)) = (known[next], known[(next + 1).min(known.len() - 1)]);
        match i {
            i if i <= first.0 => first.1,
            i if i >= last.0 => last.1,
            i => p.lerp(q, (i - a) as f64 / (b - a).max(1) as f64),
        }
    };
    Some((0..seen.len()).map(at).collect())
}
