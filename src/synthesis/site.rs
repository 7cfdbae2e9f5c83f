//! Where a described placement is: names, sides and distances to points that ride on the body.

use super::anchor::Anchor;
use super::plan::{Instead, Known, Planner};
use super::posture::Part;
use super::shape::within;
use super::side_of;
use crate::body::signing_space::{MEETING_OUT_ARMS, ONE_HAND_ARMS, before_the_body};
use crate::diagnostics::Error;
use crate::phonology::symmetry::resolve;
use crate::phonology::{Distance, Hand, HandPoint, Hands, Lateral, Place, Placement, Side, Sign, Sited, Symmetry};
use glam::DVec3;

/// How far from the middle each of two hands is that nothing else sets apart, arm lengths: 13 cm on the avatar.
const HANDS_APART_ARMS: f64 = 0.27;
/// Nothing is farther away than this, metres.
const FARTHEST_M: f64 = 5.0;

/// Where placements are looked up for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asker<'s> {
    pub sign: &'s Sign,
    pub side: Side,
    /// Hands that meet are not set apart.
    pub meeting: Meeting,
    /// What counts instead of a place on the other hand.
    pub instead: Option<Instead>,
}

/// Whether two hands come together, or stay on their own sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meeting {
    Meets,
    Apart,
}

impl<'s> Asker<'s> {
    pub(super) fn of(part: Part<'s>, meeting: Meeting) -> Asker<'s> {
        Asker { sign: part.sign, side: side_of(part.hand), meeting, instead: part.instead }
    }
}

impl Planner<'_> {
    /// Out of the skin where a placement touches the body, model space.
    pub(super) fn outward(&self, placement: &Placement, side: Side) -> Option<DVec3> {
        let Place::Body(name) = &placement.place else { return None };
        let row = self.grammar.locations.get(name).filter(|row| row.id != "neutral" && self.touches(placement))?;
        let lateral = placement.lateral.or(row.paired.then_some(Lateral { side, beside: false }));
        Some(self.signer.landmarks.body_place(&row.id, lateral).ok()?.normal(self.neutral))
    }

    /// Whether a placement is at or near the skin, so that what touches matters.
    pub(super) fn touches(&self, placement: &Placement) -> bool {
        crate::phonology::operator::touches(placement, &self.grammar.locations)
    }

    /// Where a place is that no hand is put at, such as one that is looked at.
    ///
    /// # Errors
    /// A name that the inventory lacks.
    pub fn place(&self, placement: &Placement, sign: &Sign, known: &mut Known) -> Result<Anchor, Error> {
        let asker = Asker { sign, side: Side::Right, meeting: Meeting::Meets, instead: None };
        self.anchor(placement, asker, known)
    }

    /// Where a hand's placement is; `meets` where the hands meet there, and are not set apart.
    ///
    /// # Errors
    /// A name that the inventory lacks.
    pub fn place_of_hand(
        &self,
        placement: &Placement,
        (sign, side): (&Sign, Side),
        meets: bool,
        known: &mut Known,
    ) -> Result<Anchor, Error> {
        let meeting = if meets { Meeting::Meets } else { Meeting::Apart };
        self.anchor(placement, Asker { sign, side, meeting, instead: None }, known)
    }

    /// Where a hand is of which no place is said: at ease before the chest.
    pub(super) fn default_place(&self, asker: Asker, known: &mut Known) -> Result<Anchor, Error> {
        self.anchor(&Placement::at(Place::Body("chest".into())), asker, known)
    }

    /// Where a placement is.
    pub(super) fn anchor(&self, placement: &Placement, asker: Asker, known: &mut Known) -> Result<Anchor, Error> {
        let Asker { side, instead, .. } = asker;
        let landmarks = &self.signer.landmarks;
        let anchor = match &placement.place {
            Place::Body(name) => self.on_body(name, placement, asker)?,
            Place::OtherHand(point) => match instead {
                None => self.on_other_hand(*point, placement, side)?,
                Some(Instead::OwnPlace) => self.default_place(Asker { meeting: Meeting::Apart, ..asker }, known)?,
                Some(Instead::Middle) => self.default_place(Asker { meeting: Meeting::Meets, ..asker }, known)?,
            },
            Place::Space(cell) => {
                let landmark = landmarks.space(*cell);
                Anchor::Fixed(landmark.position(self.neutral))
            }
            Place::Point(point) if point.is_finite() => Anchor::Fixed(point.clamp_length_max(2.0 * FARTHEST_M)),
            Place::Point(_) => {
                known.warn("a point is no place; neutral space is taken".to_owned());
                self.default_place(asker, known)?
            }
            Place::Between(a, b) => {
                let mut half = |sited: &Sited| {
                    let lateral = sited.lateral.or(placement.lateral);
                    let one = Placement { place: sited.place.clone(), lateral, offset: None, ..placement.clone() };
                    self.anchor(&one, asker, known)
                };
                Anchor::Middle(vec![half(a)?, half(b)?])
            }
            Place::Referent(name) => match known.referents.get(name) {
                Some(place) => place.clone(),
                None => {
                    known
                        .warn(format!("nothing has been placed at the referent {name} before; neutral space is taken"));
                    self.default_place(asker, known)?
                }
            },
            // A hand that a movement leads there stops where a hand that points there would be.
            Place::Towards(target) => {
                let target = Placement { place: (**target).clone(), offset: None, ..placement.clone() };
                let target = self.anchor(&target, asker, known)?.position(self.neutral);
                let shoulder = self.neutral.position(landmarks.shoulder(side));
                let reach = landmarks.arm_length();
                let away = (target - shoulder).clamp_length(0.4 * reach, 0.9 * reach);
                Anchor::Fixed(shoulder + if away.is_finite() { away } else { DVec3::Z * 0.4 * reach })
            }
        };
        Ok(match placement.offset {
            Some((direction, metres)) => anchor.moved(direction.vector() * within(metres, 0.0, FARTHEST_M, 0.0)),
            None => anchor,
        })
    }

    /// A placement at a named place of the body, or in the signing space before it.
    fn on_body(&self, name: &str, placement: &Placement, asker: Asker) -> Result<Anchor, Error> {
        let Asker { sign, side, .. } = asker;
        let meeting = asker.meeting == Meeting::Meets;
        let landmarks = &self.signer.landmarks;
        let row = self.grammar.locations.get(name).ok_or_else(|| Error::new(format!("no place is called {name}")))?;
        // A weak hand with places of its own says where each of the two is.
        let both = matches!(sign.hands, Hands::Both(Some(_))) && sign.weak.placement.is_empty();
        if let (Some(height), Some(space)) = (row.space, before_the_body(placement.distance)) {
            let across = match placement.lateral {
                Some(Lateral { side, beside: true }) => side.sign() * space.beside,
                Some(Lateral { side, beside: false }) => side.sign() * space.at,
                None if meeting => 0.0,
                None if both => side.sign() * space.apart,
                None => side.sign() * ONE_HAND_ARMS,
            };
            let out = space.out + if meeting { MEETING_OUT_ARMS } else { 0.0 };
            let out = if placement.behind { -out } else { out };
            return Ok(Anchor::over(&landmarks.before(DVec3::new(across, height, out)), 0.0));
        }
        // Two hands before the body are a little narrower than the shoulders; on it, each is on its own side.
        let apart = both && !meeting && placement.lateral.is_none() && !row.paired && !self.touches(placement);
        let lateral = match apart {
            true => None,
            false => placement.lateral.or_else(|| self.unsaid_side(sign, side, row.paired, &row.id, meeting)),
        };
        let landmark = landmarks.body_place(&row.id, lateral)?;
        let from = (landmark.position(self.neutral), landmark.normal(self.neutral));
        let own_side = DVec3::X * side.sign() * if apart { HANDS_APART_ARMS * landmarks.arm_length() } else { 0.0 };
        Ok(Anchor::over(&landmark, self.metres(placement, side, row.unmarked, from)).moved(own_side))
    }

    /// How far along its normal a placement is from its place, metres.
    fn metres(&self, placement: &Placement, side: Side, unmarked: Distance, from: (DVec3, DVec3)) -> f64 {
        let landmarks = &self.signer.landmarks;
        let (shoulder, reach) = (self.neutral.position(landmarks.shoulder(side)), landmarks.arm_length());
        let metres = landmarks.metres(placement.distance, unmarked, from, shoulder, reach);
        let metres = within(metres, 0.0, FARTHEST_M, 0.0);
        // Behind a place is the far side of it: past its thickness, here a hand's length.
        if placement.behind { -landmarks.hand_length() - metres } else { metres }
    }

    /// A placement on the other hand or arm, whether that acts or hangs.
    fn on_other_hand(&self, point: HandPoint, placement: &Placement, side: Side) -> Result<Anchor, Error> {
        let contact = self.signer.landmarks.hand_point(side.other(), point)?;
        let from = (contact.position(self.neutral), contact.normal(self.neutral));
        Ok(Anchor::over_contact(&contact, self.metres(placement, side, Distance::Touch, from)))
    }

    /// The side of a place that is meant when none is said: places that come in two are on the hand's own side; two
    /// hands are set apart; one hand in neutral space is before its own shoulder.
    fn unsaid_side(&self, sign: &Sign, side: Side, paired: bool, id: &str, meeting: bool) -> Option<Lateral> {
        let both = matches!(sign.hands, Hands::Both(Some(Symmetry { .. })));
        let apart = both && !meeting;
        (paired || apart || (id == "neutral" && !meeting)).then_some(Lateral { side, beside: false })
    }

    /// What the other hand is touched at where a contact leaves it open: what its configuration touches with.
    pub(super) fn open_point(&self, sign: &Sign, hand: Hand, key: usize) -> Result<HandPoint, Error> {
        let said = resolve(sign, hand);
        let unsaid = crate::phonology::Configuration::named("rest");
        self.grammar.touches_with(said.configuration.at(key).unwrap_or(&unsaid), sign)
    }
}
