//! Names of places: where a hand of a posed body is, in the words of descriptions.
//!
//! Every place is put where a description would put it (`synthesis::site`), and the nearest is taken: on the skin or close to it
//! (`skin`), in the signing space before a region of the body, at the neutral place or in a cell of the grid (`space`), on the other hand
//! (`meeting`). HamNoSys's places halfway between two are places too.

mod meeting;
mod skin;
mod space;

use super::Placed;
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Signer;
use crate::motion::pose::ModelPose;
use crate::phonology::location::{LocationInventory, LocationKind};
use crate::phonology::{Digit, Digits, Distance, Flank, HandPart, HandPoint, Lateral, Place, Placement, Side};
use glam::DVec3;
pub use meeting::Meeting;
use skin::OnSkin;
use space::{Hands, Spots};

/// Palms are mirrored that are so near to where a mirror at the middle of the body would put them, metres.
const MIRRORED_M: f64 = 0.06;

/// Tells where hands are.
///
/// ```
/// use chereme::corpus::annotate::Placer;
/// use chereme::motion::pose::LocalPose;
/// use chereme::phonology::{HandPoint, LocationInventory, Side, label};
/// use glam::DVec3;
/// let signer = chereme::avatar::signer().unwrap();
/// let placer = Placer::new(&signer, &LocationInventory::builtin());
/// let body = LocalPose::rest(&signer.skeleton).to_model(&signer.skeleton);
/// let nose = signer.landmarks.body_place("nose", None).unwrap().position(&body);
/// let (placed, off) = placer.name(Side::Right, (HandPoint::PALM, nose), nose, &body).unwrap();
/// assert!(off < 1e-9 && label::placement(&placed.placement) == "nose, touch");
/// assert_eq!(placer.point_of(&placed, Side::Right, &body), Some(nose));
/// // In the T-pose the hands are far from each other, and at no place of the skin.
/// assert_eq!(placer.meeting(Side::Right, HandPoint::PALM, &body), None);
/// let (placed, off) = placer.place(Side::Right, HandPoint::PALM, &body).unwrap();
/// assert!(off > 0.1 && placed.meeting.is_none());
/// ```
#[derive(Debug, Clone)]
pub struct Placer<'a> {
    signer: &'a Signer,
    skin: Vec<OnSkin>,
    spots: Spots,
    /// The points of each hand, left then right, that may touch.
    points: [Vec<(HandPoint, ContactPoint)>; 2],
}

impl<'a> Placer<'a> {
    /// A teller of the places of an inventory on a body. Places without a landmark are not told.
    pub fn new(signer: &'a Signer, locations: &LocationInventory) -> Placer<'a> {
        let rows = || locations.rows().iter().filter(|row| row.kind == LocationKind::Body);
        // Heights of the signing space before regions, arm lengths above the middle of the shoulders.
        let heights: Vec<(String, f64)> = rows().filter_map(|row| Some((row.id.clone(), row.space?))).collect();
        let spots = space::all_spots(&signer.landmarks, &heights);
        let points = [Side::Left, Side::Right].map(|side| {
            let on_hand = |point| signer.landmarks.hand_point(side, point).ok().map(|contact| (point, contact));
            // A face that has no landmark of its own is the part itself.
            let mut all: Vec<(HandPoint, ContactPoint)> = Vec::new();
            for (point, contact) in hand_points().filter_map(on_hand) {
                if !all.iter().any(|(_, known)| *known == contact) {
                    all.push((point, contact));
                }
            }
            all
        });
        Placer { signer, skin: skin::places(signer, rows()), spots, points }
    }

    /// Where a hand is in a pose, and how far it is from there, metres. `own` is the point with which its shape touches.
    pub fn place(&self, side: Side, own: HandPoint, model: &ModelPose) -> Option<(Placed, f64)> {
        let own_at = self.point(side, own, model)?;
        // An arm along the trunk is no place of the hand.
        let mut others = self.posed(side, model);
        others.retain(|(point, _)| !meeting::is_arm(*point));
        let palm = self.point(side, HandPoint::PALM, model)?;
        self.nearest(side, self.hands(model), (own, own_at), &others, palm, model)
    }

    /// The name of a place at which a point of a hand would be, and the palm at another; and how far it is from there, metres.
    pub fn name(&self, side: Side, own: (HandPoint, DVec3), palm: DVec3, model: &ModelPose) -> Option<(Placed, f64)> {
        self.nearest(side, self.hands(model), own, &[], palm, model)
    }

    /// What is touched; else the nearer of what the hand is close to, and where in space it is.
    fn nearest(
        &self,
        side: Side,
        hands: Hands,
        own: (HandPoint, DVec3),
        others: &[(HandPoint, DVec3)],
        palm: DVec3,
        model: &ModelPose,
    ) -> Option<(Placed, f64)> {
        if let Some(touching) = self.touching(own, others, model) {
            return Some(touching);
        }
        let (placed, off) = self.in_space(side, hands, palm, model)?;
        match self.close_to(own, others, model) {
            Some((close, near, cost)) if cost < off => Some((close, near)),
            Some(_) | None => Some((placed, off)),
        }
    }

    /// The place of some, in space, that a hand's palm is nearest to: as one chooses who is shown pictures of them. `None` of none.
    pub fn nearest_of<'p>(&self, places: &'p [Placement], palm: DVec3, model: &ModelPose) -> Option<&'p Placement> {
        let at = |p: &Placement| match p.place {
            Place::Space(cell) => Some(self.signer.landmarks.space(cell).position(model)),
            Place::Body(ref name) => self.signer.landmarks.body_place(name, p.lateral).ok().map(|l| l.position(model)),
            Place::OtherHand(_) | Place::Point(_) | Place::Between(..) | Place::Referent(_) | Place::Towards(_) => None,
        };
        let far = |p: &Placement| at(p).map_or(f64::INFINITY, |at| at.distance(palm));
        places.iter().min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// Where a placement puts a hand's point, for the placements that this tells; `None` for others.
    pub fn point_of(&self, placed: &Placed, side: Side, model: &ModelPose) -> Option<DVec3> {
        let placement = &placed.placement;
        let on_skin = || self.skin.iter().find(|s| s.place == placement.place && s.lateral == placement.lateral);
        match (&placement.place, placement.distance) {
            (Place::OtherHand(point), _) => self.point(side.other(), *point, model),
            (_, Distance::Touch) => on_skin().map(|s| s.over(0.0, model)),
            (_, Distance::Close) if on_skin().is_some_and(|s| !s.is_region) => {
                on_skin().map(|s| s.over(self.close(), model))
            }
            _ => {
                let meets = placed.meeting.is_some_and(|met| met.distance == Distance::Touch);
                let hands = if meets { Hands::Meeting } else { self.hands(model) };
                let found = self.spots(side, hands).iter().find(|spot| spot.placement == *placement);
                found.map(|spot| spot.landmark.position(model))
            }
        }
    }

    /// Where a point of a hand is.
    fn point(&self, side: Side, point: HandPoint, model: &ModelPose) -> Option<DVec3> {
        self.signer.landmarks.hand_point(side, point).ok().map(|p| p.position(model))
    }

    /// The points of a hand that may touch, with where they are.
    fn posed(&self, side: Side, model: &ModelPose) -> Vec<(HandPoint, DVec3)> {
        let of = &self.points[usize::from(side == Side::Right)];
        of.iter().map(|(p, contact)| (*p, contact.position(model))).collect()
    }

    /// How the hands are that do not touch.
    fn hands(&self, model: &ModelPose) -> Hands {
        if self.mirrored(model) { Hands::Apart } else { Hands::Alone }
    }

    /// Whether both hands are at one place, each on its own side: the palms are mirrored at the middle of the body, within 6 cm.
    pub(super) fn mirrored(&self, model: &ModelPose) -> bool {
        let palm = |side| self.point(side, HandPoint::PALM, model);
        let (Some(left), Some(right)) = (palm(Side::Left), palm(Side::Right)) else { return false };
        let joints = [Side::Left, Side::Right].map(|side| model.position(self.signer.landmarks.shoulder(side)));
        let (middle, across) = ((joints[0] + joints[1]) / 2.0, (joints[0] - joints[1]).normalize_or(DVec3::X));
        let (l, r) = (left - middle, right - middle);
        (l - (r - across * (2.0 * r.dot(across)))).length() < MIRRORED_M
    }
}

/// No side, each side of a place, and beside each.
fn laterals() -> impl Iterator<Item = Option<Lateral>> {
    let sides = [Side::Left, Side::Right].into_iter();
    std::iter::once(None).chain(sides.flat_map(|side| [false, true].map(|beside| Some(Lateral { side, beside }))))
}

/// The pairs of sides between which a hand may be: from the middle to a side, and from there to beside it.
fn halves() -> impl Iterator<Item = (Option<Lateral>, Option<Lateral>)> {
    [Side::Left, Side::Right].into_iter().flat_map(|side| {
        let [near, far] = [false, true].map(|beside| Some(Lateral { side, beside }));
        [(None, near), (near, far)]
    })
}

/// The points of a hand and arm that touch: of the limb, and of each digit, as a whole and on each of its faces.
fn hand_points() -> impl Iterator<Item = HandPoint> {
    let limb = HandPart::OF_THE_LIMB.into_iter().chain([HandPart::Wrist]);
    let limb = limb.filter_map(|part| HandPoint::new(Digits::NONE, part, None));
    let of = |digit: Digit| {
        let parts = HandPart::OF_A_DIGIT.into_iter();
        parts.flat_map(move |part| {
            let flanks = std::iter::once(None).chain(Flank::ALL.map(Some));
            flanks.filter_map(move |flank| HandPoint::new(Digits::of([digit]), part, flank))
        })
    };
    limb.chain(Digit::ALL.into_iter().flat_map(of))
}
