//! Places of the signing space: before regions of the body, the neutral place, the cells of the grid.

use super::super::Placed;
use super::{Placer, halves, laterals};
use crate::body::signing_space::{Before, MEETING_OUT_ARMS, ONE_HAND_ARMS, before_the_body};
use crate::motion::pose::ModelPose;
use crate::phonology::{Distance, HandPoint, Lateral, Place, Placement, Side, Sited, Space};
use glam::DVec3;

/// A cell of the grid must be so much nearer than a place with a name, metres.
const NO_NAME_M: f64 = 0.03;

/// A place with the point of space that it means for a hand of a side.
pub(super) struct Spot {
    pub placement: Placement,
    pub at: DVec3,
    /// Added to its distance, metres.
    behind: f64,
}

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
        let far = |c: &Spot| c.at.distance(palm) + c.behind;
        let nearest = self.spots(side, hands, model).into_iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        let off = nearest.at.distance(palm);
        Some((Placed::at(nearest.placement, HandPoint::PALM), off))
    }

    /// All places of the signing space for a hand of a side.
    pub(super) fn spots(&self, side: Side, hands: Hands, model: &ModelPose) -> Vec<Spot> {
        let landmarks = &self.signer.landmarks;
        let mut all = Vec::with_capacity(600);
        for distance in [Distance::Close, Distance::Unmarked, Distance::Extended] {
            if let Some(space) = before_the_body(distance) {
                self.before(side, hands, distance, &space, model, &mut all);
            }
        }
        for lateral in laterals() {
            if let Ok(landmark) = landmarks.body_place("neutral", lateral) {
                let placement = Placement { lateral, ..Placement::at(Place::Body("neutral".into())) };
                all.push(Spot { placement, at: landmark.position(model), behind: 0.0 });
            }
        }
        for cell in cells() {
            let placement = Placement::at(Place::Space(cell));
            all.push(Spot { placement, at: landmarks.space(cell).position(model), behind: NO_NAME_M });
        }
        all
    }

    /// The places before the regions of the body. What no side is said of depends on the hands.
    fn before(
        &self,
        side: Side,
        hands: Hands,
        distance: Distance,
        space: &Before,
        model: &ModelPose,
        all: &mut Vec<Spot>,
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
        let out = space.out + if hands == Hands::Meeting { MEETING_OUT_ARMS } else { 0.0 };
        let mut put = |across: f64, height: f64, lateral: Option<Lateral>, place: Place| {
            let at = self.signer.landmarks.before(DVec3::new(across, height, out)).position(model);
            all.push(Spot { placement: Placement { lateral, distance, ..Placement::at(place) }, at, behind: 0.0 });
        };
        for (name, height) in &self.heights {
            let place = || Place::Body(name.clone());
            for lateral in laterals() {
                put(across(lateral), *height, lateral, place());
            }
            for (a, b) in halves() {
                let half = |lateral| Box::new(Sited { place: place(), lateral });
                let middle = (across(a) + across(b)) / 2.0;
                put(middle, *height, None, Place::Between(half(a), half(b)));
            }
        }
        for ((a, high), (b, low)) in self.neighbours() {
            for lateral in laterals() {
                let half = |name: &str| Box::new(Sited { place: Place::Body(name.to_owned()), lateral });
                put(across(lateral), (high + low) / 2.0, None, Place::Between(half(a), half(b)));
            }
            for (left, right) in halves() {
                let half = |name: &str, lateral| Box::new(Sited { place: Place::Body(name.to_owned()), lateral });
                let middle = (across(left) + across(right)) / 2.0;
                put(middle, (high + low) / 2.0, None, Place::Between(half(a, left), half(b, right)));
            }
        }
    }

    /// Regions of the body that lie on each other, with their heights, from the head down; the tops of the shoulders lie beside.
    fn neighbours(&self) -> impl Iterator<Item = ((&str, f64), (&str, f64))> {
        let middle: Vec<(&str, f64)> =
            self.heights.iter().filter(|(name, _)| name != "shouldertop").map(|(n, h)| (n.as_str(), *h)).collect();
        (1..middle.len()).map(move |i| (middle[i - 1], middle[i]))
    }
}

/// The 26 cells about the middle one, which is the neutral place.
fn cells() -> impl Iterator<Item = Space> {
    let axis = || -1i8..=1;
    let all =
        axis().flat_map(move |left| axis().flat_map(move |high| axis().map(move |far| Space { left, high, far })));
    all.filter(|cell| *cell != Space::default())
}
