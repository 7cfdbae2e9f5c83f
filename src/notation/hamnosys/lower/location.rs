//! Places: levels of the body, of arms and hands, with sides and nearness, to placements and contacts.

use super::super::dictionary::Dictionary;
use super::super::syntax::{BodyLevel, BodyLevels, Contact, Face, HandLevel, HandLevels, HandPlace, Shape, Side, Site};
use super::shape::{acting_fingers, hand_part};
use crate::phonology::{
    self, ContactKind, Digits, Distance, Flank, Hand, HandPart, HandPoint, Lateral, LocationKind, Place, Placement,
    Sited,
};

/// What a place is read with.
#[derive(Clone, Copy)]
pub(crate) struct Places<'d> {
    /// Names of places.
    pub dictionary: &'d Dictionary,
    /// The hand that is placed.
    pub hand: Hand,
    /// Its shape, which says what a part of no finger belongs to.
    pub shape: Option<&'d Shape>,
    /// The other hand's shape.
    pub other: Option<&'d Shape>,
}

impl Places<'_> {
    /// A placement; `None` for what no model of ours holds.
    pub(crate) fn placement(&self, site: &Site) -> Option<Placement> {
        match site {
            Site::Body { level, behind, contact, with } => {
                let (place, lateral) = match level {
                    None => (Place::Body(self.neutral()), None),
                    Some(levels) => self.levels(levels)?,
                };
                Some(Placement {
                    lateral,
                    distance: distance(*contact),
                    behind: *behind,
                    with: with.as_ref().map(|w| self.own_point(w)),
                    ..Placement::at(place)
                })
            }
            Site::Hand { level, contact, with } => Some(Placement {
                distance: distance(*contact),
                with: with.as_ref().map(|w| self.own_point(w)),
                ..Placement::at(Place::OtherHand(self.other_point(level)))
            }),
            Site::Named(name) => Some(Placement::at(Place::Referent(name.clone()))),
        }
    }

    fn neutral(&self) -> String {
        self.dictionary.place("neutralspace").map_or("neutral", |(id, _)| id).to_owned()
    }

    fn levels(&self, levels: &BodyLevels) -> Option<(Place, Option<Lateral>)> {
        let (first, side) = self.level(&levels.first)?;
        let Some(second) = &levels.between else { return Some((first, side)) };
        let (second, other_side) = self.level(second)?;
        if second == first && other_side == side {
            return Some((first, side));
        }
        let sited = |place, lateral| Box::new(Sited { place, lateral });
        Some((Place::Between(sited(first, side), sited(second, other_side)), None))
    }

    fn level(&self, level: &BodyLevel) -> Option<(Place, Option<Lateral>)> {
        let (id, kind) = self.dictionary.place(&level.place)?;
        let face = level.face;
        match kind {
            LocationKind::Body | LocationKind::Space => Some((Place::Body(id.to_owned()), level.side.map(lateral))),
            LocationKind::Limb(part) => {
                let flank = flank(level.side, face, self.hand.other());
                Some((Place::OtherHand(HandPoint::new(Digits::NONE, part, flank)?), None))
            }
            LocationKind::Digit(digit) => {
                Some((Place::OtherHand(HandPoint::of_digit(digit, HandPart::Midjoint)?), None))
            }
            LocationKind::Part(_) => None,
        }
    }

    /// A point of the hand that is placed.
    pub(crate) fn own_point(&self, levels: &HandLevels) -> HandPoint {
        point(levels, self.hand, self.shape, self.dictionary)
    }

    /// A point of the other hand.
    pub(crate) fn other_point(&self, levels: &HandLevels) -> HandPoint {
        point(levels, self.hand.other(), self.other, self.dictionary)
    }
}

fn distance(contact: Option<Contact>) -> Distance {
    match contact {
        None => Distance::Unmarked,
        Some(Contact::Touch | Contact::Interlock | Contact::Cross) => Distance::Touch,
        Some(Contact::Close) => Distance::Close,
        Some(Contact::ArmExtended) => Distance::Extended,
    }
}

/// How two hands meet; hands beside each other of which nothing more is said are near.
pub(crate) fn contact_kind(contact: Option<Contact>) -> ContactKind {
    match contact {
        Some(Contact::Touch) => ContactKind::Touch,
        None | Some(Contact::Close | Contact::ArmExtended) => ContactKind::Close,
        Some(Contact::Interlock) => ContactKind::Interlocked,
        Some(Contact::Cross) => ContactKind::Crossed,
    }
}

fn lateral(side: Side) -> Lateral {
    use phonology::Side as Meant;
    match side {
        Side::LeftBeside => Lateral { side: Meant::Left, beside: true },
        Side::LeftAt => Lateral { side: Meant::Left, beside: false },
        Side::RightAt => Lateral { side: Meant::Right, beside: false },
        Side::RightBeside => Lateral { side: Meant::Right, beside: true },
    }
}

/// The face of a part of a hand. Its sides are named for a hand whose palm faces down and whose fingers point out: the thumb of
/// the strong hand is then on the left, that of the weak one on the right.
fn flank(side: Option<Side>, face: Option<Face>, hand: Hand) -> Option<Flank> {
    match (face, side) {
        (Some(Face::Dorsal), _) => Some(Flank::Dorsal),
        (Some(Face::Palmar), _) => Some(Flank::Palmar),
        (None, None) => None,
        (None, Some(Side::LeftBeside | Side::LeftAt)) => Some(match hand {
            Hand::Strong => Flank::Radial,
            Hand::Weak => Flank::Ulnar,
        }),
        (None, Some(Side::RightBeside | Side::RightAt)) => Some(match hand {
            Hand::Strong => Flank::Ulnar,
            Hand::Weak => Flank::Radial,
        }),
    }
}

fn point(levels: &HandLevels, hand: Hand, shape: Option<&Shape>, dictionary: &Dictionary) -> HandPoint {
    let one = |level: &HandLevel| spot(level, hand, shape, dictionary);
    let first = one(&levels.first);
    match levels.between.as_ref().map(one) {
        Some(second) if second != first => first.halfway(second),
        Some(_) | None => first,
    }
}

fn spot(level: &HandLevel, hand: Hand, shape: Option<&Shape>, dictionary: &Dictionary) -> HandPoint {
    let face = flank(level.side, level.face, hand);
    let (digits, part) = match &level.part {
        HandPlace::Hand(tag) => match dictionary.place(tag) {
            Some((_, LocationKind::Limb(part))) => (Digits::NONE, part),
            Some((_, LocationKind::Digit(digit))) => (Digits::of([digit]), HandPart::Midjoint),
            Some((_, LocationKind::Part(part))) => (acting_fingers(shape), part),
            Some((_, LocationKind::Body | LocationKind::Space)) | None => (Digits::NONE, HandPart::Palm),
        },
        HandPlace::Digits(digits, part) => {
            let digits = if digits.is_empty() { acting_fingers(shape) } else { Digits::of(digits.iter().copied()) };
            (digits, part.map_or(HandPart::Midjoint, hand_part))
        }
    };
    // Digits and parts fit by how they were found.
    HandPoint::new(digits, part, face).or_else(|| HandPoint::new(digits, part, None)).unwrap_or_else(palm)
}

/// The palm as a whole.
fn palm() -> HandPoint {
    match HandPoint::new(Digits::NONE, HandPart::Palm, None) {
        Some(palm) => palm,
        None => unreachable!("a palm needs no digit"),
    }
}
