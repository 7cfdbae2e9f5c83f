//! Placement: the nearest named place at each stop of the hand's way.
//!
//! A hand that touches skin is where its nearest point is; near the skin (`close`) its own point counts, that with which its shape
//! touches; farther away the palm is in the signing space before a region of the body, at the neutral place, or in a cell of the grid.
//! How descriptions put hands there is in `synthesis::site`; here every place is put where they would put it, and the nearest is taken.

use super::moves::{Stop, Thresholds, moves, stops};
use super::{Placed, Seen, Shape, Value, push_or_extend};
use crate::body::landmarks::{CLOSE_ARMS, ContactPoint, Landmark};
use crate::body::measure::HandForms;
use crate::body::signer::Signer;
use crate::body::signing_space::{ONE_HAND_ARMS, before_the_body};
use crate::motion::pose::ModelPose;
use crate::phonology::location::{LocationInventory, LocationKind};
use crate::phonology::{Digit, Digits, Distance, HandPart, HandPoint, Lateral, Place, Placement, Side, Sited, Space};
use glam::DVec3;

/// Stillness and moves of the palm, metres a second.
const GOING: Thresholds = Thresholds { still: 0.04, least: 0.12, valley: 0.5 };
/// A point so near to a place of the skin touches it, metres: places are points of skin that has an extent.
const TOUCHES_M: f64 = 0.03;
/// Another point than the shape's own must be so much nearer, metres.
const NOT_ITS_OWN_M: f64 = 0.012;
/// A hand is close to a place that is so near to where `close` would put it, metres.
const CLOSE_M: f64 = 0.04;
/// Hands touch whose points are so near, metres.
const HANDS_TOUCH_M: f64 = 0.015;
/// Hands are close to each other whose own point and any point are so near, metres.
const HANDS_CLOSE_M: f64 = 0.06;
/// A cell of the grid must be so much nearer than a place with a name, metres.
const NO_NAME_M: f64 = 0.03;

/// A place with the point of space that it means for a hand of a side.
struct Candidate {
    placement: Placement,
    at: DVec3,
    /// Added to its distance, metres.
    behind: f64,
}

/// Tells where hands are.
#[derive(Debug, Clone)]
pub struct Placer<'a> {
    signer: &'a Signer,
    /// Places of the skin: id, landmark with its side, half of the region's width in arm lengths.
    skin: Vec<(String, Option<Lateral>, Landmark)>,
    /// Heights of the signing space before regions: id, arm lengths.
    heights: Vec<(String, f64)>,
    /// The points of each hand, left then right, that may touch.
    points: [Vec<(HandPoint, ContactPoint)>; 2],
}

impl<'a> Placer<'a> {
    /// A teller of the places of an inventory on a body. Places without a landmark are not told.
    pub fn new(signer: &'a Signer, locations: &LocationInventory) -> Placer<'a> {
        let (mut skin, mut heights) = (Vec::new(), Vec::new());
        for row in locations.rows().iter().filter(|row| row.kind == LocationKind::Body) {
            heights.extend(row.space.map(|height| (row.id.clone(), height)));
            for lateral in laterals() {
                if let Ok(landmark) = signer.landmarks.body_place(&row.id, lateral) {
                    skin.push((row.id.clone(), lateral, landmark));
                }
            }
        }
        let points = [Side::Left, Side::Right].map(|side| {
            let on_hand = |point| signer.landmarks.hand_point(side, point).ok().map(|contact| (point, contact));
            hand_points().filter_map(on_hand).collect()
        });
        Placer { signer, skin, heights, points }
    }

    /// Where a hand is in a pose, and how far it is from there, metres. `own` is the point with which its shape touches.
    pub fn place(&self, side: Side, own: HandPoint, model: &ModelPose) -> Option<(Placed, f64)> {
        let points = &self.points[usize::from(side == Side::Right)];
        let on_hand = |point| self.signer.landmarks.hand_point(side, point).map(|p| p.position(model));
        let own_at = (own, on_hand(own).ok()?);
        let others: Vec<(HandPoint, DVec3)> = points.iter().map(|(p, contact)| (*p, contact.position(model))).collect();
        let touching = self.at_skin(own_at, &others, model);
        touching.or_else(|| self.before(side, on_hand(HandPoint::PALM).ok()?, model))
    }

    /// The name of a place that a point of a hand is at, whose palm would be at another; and how far it is from there, metres.
    pub fn name(&self, side: Side, own: (HandPoint, DVec3), palm: DVec3, model: &ModelPose) -> Option<(Placed, f64)> {
        self.at_skin(own, &[], model).or_else(|| self.before(side, palm, model))
    }

    fn before(&self, side: Side, palm: DVec3, model: &ModelPose) -> Option<(Placed, f64)> {
        let far = |c: &Candidate| c.at.distance(palm) + c.behind;
        let nearest = self.in_space(side, model).into_iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        let off = nearest.at.distance(palm);
        Some((Placed { placement: nearest.placement, with: HandPoint::PALM }, off))
    }

    /// The place of some that a hand's palm is nearest to: as one chooses who is shown pictures of them. `None` of none.
    pub fn nearest_of<'p>(&self, places: &'p [Placement], palm: DVec3, model: &ModelPose) -> Option<&'p Placement> {
        let at = |p: &Placement| match p.place {
            Place::Space(cell) => Some(self.signer.landmarks.space(cell).position(model)),
            Place::Body(ref name) => self.signer.landmarks.body_place(name, p.lateral).ok().map(|l| l.position(model)),
            _ => None,
        };
        let far = |p: &Placement| at(p).map_or(f64::INFINITY, |at| at.distance(palm));
        places.iter().min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// Where a placement puts a point of a hand, for the placements that this tells; `None` for others.
    pub fn point_of(&self, placement: &Placement, side: Side, model: &ModelPose) -> Option<DVec3> {
        let of_skin =
            |name: &str| self.skin.iter().find(|(id, lateral, _)| id == name && *lateral == placement.lateral);
        match (&placement.place, placement.distance) {
            (Place::Body(name), Distance::Touch) => of_skin(name).map(|(.., landmark)| landmark.position(model)),
            (Place::Body(name), Distance::Close) if !self.heights.iter().any(|(id, _)| id == name) => {
                of_skin(name).map(|(.., landmark)| self.over(landmark, model))
            }
            _ => self.in_space(side, model).into_iter().find(|c| c.placement == *placement).map(|c| c.at),
        }
    }

    fn over(&self, landmark: &Landmark, model: &ModelPose) -> DVec3 {
        landmark.position(model) + landmark.normal(model) * CLOSE_ARMS * self.signer.landmarks.arm_length()
    }

    /// A hand that touches the skin of trunk or head, or is close to a place that is no region.
    fn at_skin(
        &self,
        (own, own_at): (HandPoint, DVec3),
        all: &[(HandPoint, DVec3)],
        model: &ModelPose,
    ) -> Option<(Placed, f64)> {
        let mut best: Option<(f64, f64, Placed)> = None;
        let mut offer =
            |cost: f64, off: f64, with: HandPoint, name: &str, lateral: Option<Lateral>, distance: Distance| {
                if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                    let placement = Placement { lateral, distance, ..Placement::at(Place::Body(name.to_owned())) };
                    best = Some((cost, off, Placed { placement, with }));
                }
            };
        for (name, lateral, landmark) in &self.skin {
            let at = landmark.position(model);
            let off = own_at.distance(at);
            if off < TOUCHES_M {
                offer(off, off, own, name, *lateral, Distance::Touch);
            }
            for (point, there) in all {
                let off = there.distance(at);
                if off + NOT_ITS_OWN_M < TOUCHES_M {
                    offer(off + NOT_ITS_OWN_M, off, *point, name, *lateral, Distance::Touch);
                }
            }
            let off = own_at.distance(self.over(landmark, model));
            if off < CLOSE_M && !self.heights.iter().any(|(id, _)| id == name) {
                offer(off * TOUCHES_M / CLOSE_M, off, own, name, *lateral, Distance::Close);
            }
        }
        best.map(|(_, off, placed)| (placed, off))
    }

    /// The places of the signing space: before regions of the body, the neutral place, the cells of the grid.
    fn in_space(&self, side: Side, model: &ModelPose) -> Vec<Candidate> {
        let landmarks = &self.signer.landmarks;
        let mut all = Vec::new();
        for (name, height) in &self.heights {
            for distance in [Distance::Close, Distance::Unmarked, Distance::Extended] {
                let Some(space) = before_the_body(distance) else { continue };
                let across = |lateral: Option<Lateral>| match lateral {
                    None => ONE_HAND_ARMS * side.sign(),
                    Some(Lateral { side, beside: false }) => side.sign() * space.at,
                    Some(Lateral { side, beside: true }) => side.sign() * space.beside,
                };
                let at = |across: f64| landmarks.before(DVec3::new(across, *height, space.out)).position(model);
                let place = || Place::Body(name.clone());
                for lateral in laterals() {
                    let placement = Placement { lateral, distance, ..Placement::at(place()) };
                    all.push(Candidate { placement, at: at(across(lateral)), behind: 0.0 });
                }
                // Halfway from the middle to a side, and from there to beside it.
                for side in [Side::Left, Side::Right] {
                    let [near, far] = [false, true].map(|beside| Some(Lateral { side, beside }));
                    for (a, b) in [(None, near), (near, far)] {
                        let half = |lateral| Box::new(Sited { place: place(), lateral });
                        let placement = Placement { distance, ..Placement::at(Place::Between(half(a), half(b))) };
                        let middle = (across(a) + across(b)) / 2.0;
                        all.push(Candidate { placement, at: at(middle), behind: 0.0 });
                    }
                }
            }
        }
        for lateral in laterals() {
            if let Ok(landmark) = landmarks.body_place("neutral", lateral) {
                let placement = Placement { lateral, ..Placement::at(Place::Body("neutral".into())) };
                all.push(Candidate { placement, at: landmark.position(model), behind: 0.0 });
            }
        }
        for cell in cells() {
            let placement = Placement::at(Place::Space(cell));
            all.push(Candidate { placement, at: landmarks.space(cell).position(model), behind: NO_NAME_M });
        }
        all
    }

    /// Where the two hands are on each other: the point of the given side, that of the other one, and how near. `own` is the point
    /// with which the given hand's shape touches.
    pub fn meeting(
        &self,
        side: Side,
        own: HandPoint,
        model: &ModelPose,
    ) -> Option<(HandPoint, HandPoint, Distance, f64)> {
        let of = |side: Side| &self.points[usize::from(side == Side::Right)];
        let posed = |side: Side| of(side).iter().map(|(p, c)| (*p, c.position(model))).collect::<Vec<_>>();
        let others = posed(side.other());
        let nearest =
            |at: DVec3| others.iter().map(|(p, there)| (*p, at.distance(*there))).min_by(|a, b| a.1.total_cmp(&b.1));
        let own_at = self.signer.landmarks.hand_point(side, own).ok()?.position(model);
        let (other, off) = nearest(own_at)?;
        if off < HANDS_TOUCH_M {
            return Some((own, other, Distance::Touch, off));
        }
        let any = posed(side).into_iter().filter_map(|(p, at)| nearest(at).map(|(other, off)| (p, other, off)));
        let (with, touched, least) = any.min_by(|a, b| a.2.total_cmp(&b.2))?;
        if least < HANDS_TOUCH_M {
            return Some((with, touched, Distance::Touch, least));
        }
        (off < HANDS_CLOSE_M).then_some((own, other, Distance::Close, off))
    }

    /// The places of a stretch, in order.
    pub(super) fn placements(&self, seen: &Seen, shapes: &[Value<Shape>], forms: &HandForms) -> Vec<Value<Placed>> {
        let profile = &seen.signals.path_speed;
        let all = moves(profile, GOING);
        let mut values: Vec<Value<Placed>> = Vec::new();
        for Stop { at, from, to } in stops(profile, &all, seen.start..=seen.end) {
            let time = seen.time(at);
            let own = own_point(shapes, time.0, forms);
            let model = &seen.models[at];
            let side = seen.signals.side;
            let on_other = self.meeting(side, own, model).filter(|_| seen.goes_to_other && !self.mirrored(model));
            let found = match on_other {
                Some((with, other, distance, off)) => {
                    let placement = Placement { distance, ..Placement::at(Place::OtherHand(other)) };
                    Some((Placed { placement, with }, off))
                }
                None => self.place(side, own, model),
            };
            if let Some((value, off)) = found {
                let value = Value { start: seen.time(from), end: seen.time(to), value, off };
                push_or_extend(&mut values, value, |a, b| a.placement == b.placement);
            }
        }
        values
    }

    /// Whether the palms are where a mirror at the middle of the body would put them, within 6 cm: then both hands are at one place.
    fn mirrored(&self, model: &ModelPose) -> bool {
        let palm = |side| self.signer.landmarks.hand_point(side, HandPoint::PALM).map(|p| p.position(model));
        let (Ok(left), Ok(right)) = (palm(Side::Left), palm(Side::Right)) else { return false };
        let joints = [Side::Left, Side::Right].map(|side| model.position(self.signer.landmarks.shoulder(side)));
        let (middle, across) = ((joints[0] + joints[1]) / 2.0, (joints[0] - joints[1]).normalize_or(DVec3::X));
        let (l, r) = (left - middle, right - middle);
        (l - (r - across * (2.0 * r.dot(across)))).length() < 0.06
    }
}

/// The point with which the shape at an instant touches.
pub(super) fn own_point(shapes: &[Value<Shape>], time: f64, forms: &HandForms) -> HandPoint {
    let shape = shapes.iter().find(|v| time <= v.end.0).or(shapes.last());
    shape.map_or(HandPoint::PALM, |v| forms.shapes()[v.value.number].touches_with)
}

/// No side, each side of a place, and beside each.
fn laterals() -> impl Iterator<Item = Option<Lateral>> {
    let sides = [Side::Left, Side::Right].into_iter();
    std::iter::once(None).chain(sides.flat_map(|side| [false, true].map(|beside| Some(Lateral { side, beside }))))
}

/// The 26 cells about the middle one, which is the neutral place.
fn cells() -> impl Iterator<Item = Space> {
    let axis = || -1i8..=1;
    let all =
        axis().flat_map(move |left| axis().flat_map(move |high| axis().map(move |far| Space { left, high, far })));
    all.filter(|cell| *cell != Space::default())
}

/// The points of a hand and arm that touch: of the limb, and of each digit.
fn hand_points() -> impl Iterator<Item = HandPoint> {
    let limb = HandPart::OF_THE_LIMB.into_iter().chain([HandPart::Wrist]);
    let limb = limb.filter_map(|part| HandPoint::new(Digits::NONE, part, None));
    let digits =
        Digit::ALL.into_iter().flat_map(|digit| HandPart::OF_A_DIGIT.map(|part| HandPoint::of_digit(digit, part)));
    limb.chain(digits.flatten())
}
