//! Places of the signing space: before regions of the body, the neutral place, the cells of the grid.

use super::super::Placed;
use super::{Placer, halves, laterals};
use crate::body::landmarks::{Landmark, Landmarks};
use crate::body::signing_space::{Before, MEETING_OUT_ARMS, ONE_HAND_ARMS, before_the_body};
use crate::motion::pose::ModelPose;
use crate::phonology::{Distance, HandPoint, Lateral, Place, Placement, Side, Sited, Space};
use glam::DVec3;

/// A cell of the grid must be so much nearer than a place with a name, metres.
const NO_NAME_M: f64 = 0.03;

/// A place with the point of space that it means for a hand of a side.
#[derive(Debug, Clone)]
pub(super) struct Spot {
    pub placement: Placement,
    pub landmark: Landmark,
    /// Added to its distance, metres.
    behind: f64,
}

/// The spots for each side, left then right, and for each way that hands are there.
pub(super) type Spots = [[Vec<Spot>; 3]; 2];

/// How the hands are there, of which no side is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Hands {
    /// One hand is before the middle, a little to its own side.
    Alone,
    /// Each of two hands is apart from the middle, on its own side.
    Apart,
    /// Two hands meet in the middle.
    Meeting,
}

impl Placer<'_> {
    /// The place of the signing space that a palm is nearest to, and how far off, metres.
    pub(super) fn in_space(&self, side: Side, hands: Hands, palm: DVec3, model: &ModelPose) -> Option<(Placed, f64)> {
        let far = |spot: &Spot| spot.landmark.position(model).distance(palm);
        let all = self.spots(side, hands).iter().map(|spot| (spot, far(spot)));
        let (nearest, off) = all.min_by(|a, b| (a.1 + a.0.behind).total_cmp(&(b.1 + b.0.behind)))?;
        Some((Placed::at(nearest.placement.clone(), HandPoint::PALM), off))
    }

    /// All places of the signing space for a hand of a side.
    pub(super) fn spots(&self, side: Side, hands: Hands) -> &[Spot] {
        &self.spots[usize::from(side == Side::Right)][hands as usize]
    }
}

/// All places of the signing space before a body with regions at these heights.
pub(super) fn all_spots(landmarks: &Landmarks, heights: &[(String, f64)]) -> Spots {
    [Side::Left, Side::Right]
        .map(|side| [Hands::Alone, Hands::Apart, Hands::Meeting].map(|hands| spots_of(landmarks, heights, side, hands)))
}

fn spots_of(landmarks: &Landmarks, heights: &[(String, f64)], side: Side, hands: Hands) -> Vec<Spot> {
    let mut all = Vec::new();
    for distance in [Distance::Close, Distance::Unmarked, Distance::Extended] {
        if let Some(space) = before_the_body(distance) {
            let out = space.out + if hands == Hands::Meeting { MEETING_OUT_ARMS } else { 0.0 };
            before(heights, side, hands, &space, &mut |across, height, lateral, place| {
                let landmark = landmarks.before(DVec3::new(across, height, out));
                let placement = Placement { lateral, distance, ..Placement::at(place) };
                all.push(Spot { placement, landmark, behind: 0.0 });
            });
        }
    }
    for lateral in laterals() {
        if let Ok(landmark) = landmarks.body_place("neutral", lateral) {
            let placement = Placement { lateral, ..Placement::at(Place::Body("neutral".into())) };
            all.push(Spot { placement, landmark, behind: 0.0 });
        }
    }
    for cell in cells() {
        let placement = Placement::at(Place::Space(cell));
        all.push(Spot { placement, landmark: landmarks.space(cell), behind: NO_NAME_M });
    }
    all
}

/// The places before the regions of the body: how far to the left, the height, the side that is said, the place. What no side is
/// said of depends on the hands.
fn before(
    heights: &[(String, f64)],
    side: Side,
    hands: Hands,
    space: &Before,
    put: &mut dyn FnMut(f64, f64, Option<Lateral>, Place),
) {
    let across = |lateral: Option<Lateral>| match lateral {
        None => match hands {
            Hands::Alone => ONE_HAND_ARMS * side.sign(),
            Hands::Apart => space.apart * side.sign(),
            Hands::Meeting => 0.0,
        },
        Some(Lateral { side, beside: false }) => side.sign() * space.at,
        Some(Lateral { side, beside: true }) => side.sign() * space.beside,
    };
    let half = |name: &str, lateral| Box::new(Sited { place: Place::Body(name.to_owned()), lateral });
    for (name, height) in heights {
        for lateral in laterals() {
            put(across(lateral), *height, lateral, Place::Body(name.clone()));
        }
        for (a, b) in halves() {
            put((across(a) + across(b)) / 2.0, *height, None, Place::Between(half(name, a), half(name, b)));
        }
    }
    // Regions lie on each other from the head down; the tops of the shoulders lie beside.
    let middle: Vec<_> = heights.iter().filter(|(name, _)| name != "shouldertop").collect();
    for pair in middle.windows(2) {
        let [(a, high), (b, low)] = [pair[0], pair[1]];
        let height = (high + low) / 2.0;
        for lateral in laterals() {
            put(across(lateral), height, None, Place::Between(half(a, lateral), half(b, lateral)));
        }
        for (near, far) in halves() {
            let middle = (across(near) + across(far)) / 2.0;
            put(middle, height, None, Place::Between(half(a, near), half(b, far)));
        }
    }
}

/// The 26 cells about the middle one, which is the neutral place.
fn cells() -> impl Iterator<Item = Space> {
    let axis = || -1i8..=1;
    let all =
        axis().flat_map(move |left| axis().flat_map(move |high| axis().map(move |far| Space { left, high, far })));
    all.filter(|cell| *cell != Space::default())
}
