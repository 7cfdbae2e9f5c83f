//! Placements and contacts to the places that HamNoSys writes.

use super::super::dictionary::Dictionary;
use super::super::syntax::{
    BodyLevel, BodyLevels, Constellation, Contact, Face, HandLevel, HandLevels, HandPlace, Side, Site,
};
use super::shape::finger_part;
use crate::phonology::{
    self, ContactKind, Distance, Flank, Hand, HandPart, HandPoint, Lateral, LocationKind, Place, Placement, Sited,
};

/// A placement of a hand as a site, or what of it HamNoSys cannot say.
pub(crate) fn site(placement: &Placement, hand: Hand, dictionary: &Dictionary) -> Result<Site, String> {
    if placement.offset.is_some() {
        return Err("HamNoSys has no offsets in centimetres".to_owned());
    }
    let contact = contact(placement.distance)?;
    let with = placement.with.map(|p| levels(p, hand, dictionary)).transpose()?;
    let behind = placement.behind;
    match &placement.place {
        Place::OtherHand(point) if is_arm(*point) => {
            let first = arm_level(*point, hand.other(), dictionary)?;
            Ok(Site::Body { level: Some(BodyLevels { first, between: None }), behind, contact, with })
        }
        Place::OtherHand(_) if behind => Err("HamNoSys has no place behind a hand".to_owned()),
        Place::OtherHand(point) => Ok(Site::Hand { level: levels(*point, hand.other(), dictionary)?, contact, with }),
        Place::Referent(name) => Ok(Site::Named(name.clone())),
        place => {
            let level = body(place, placement.lateral, hand, dictionary)?;
            Ok(Site::Body { level, behind, contact, with })
        }
    }
}

fn contact(distance: Distance) -> Result<Option<Contact>, String> {
    match distance {
        Distance::Unmarked => Ok(None),
        Distance::Touch => Ok(Some(Contact::Touch)),
        Distance::Close => Ok(Some(Contact::Close)),
        Distance::Extended => Ok(Some(Contact::ArmExtended)),
        Distance::Neutral => Err("HamNoSys has no symbol for the neutral distance".to_owned()),
        Distance::Metres(_) => Err("HamNoSys has no distances in centimetres".to_owned()),
    }
}

fn body(
    place: &Place,
    lateral: Option<Lateral>,
    hand: Hand,
    dictionary: &Dictionary,
) -> Result<Option<BodyLevels>, String> {
    let one = |place: &Place, lateral: Option<Lateral>| level(place, lateral, hand, dictionary);
    let Place::Between(a, b) = place else {
        return Ok(one(place, lateral)?.map(|first| BodyLevels { first, between: None }));
    };
    let own = |s: &Sited| one(&s.place, s.lateral.or(lateral));
    match (own(a)?, own(b)?) {
        (Some(first), Some(second)) => Ok(Some(BodyLevels { first, between: Some(second) })),
        (_, _) => Err("HamNoSys has no place between neutral space and the body".to_owned()),
    }
}

/// One place of body or arm; `None` is neutral space.
fn level(
    place: &Place,
    lateral: Option<Lateral>,
    hand: Hand,
    dictionary: &Dictionary,
) -> Result<Option<BodyLevel>, String> {
    let no = |what: &str| Err(format!("HamNoSys has no {what}"));
    match place {
        Place::Body(name) => {
            let tag =
                dictionary.place_tag(name).ok_or_else(|| format!("HamNoSys has no symbol for the place `{name}`"))?;
            match (tag, lateral) {
                ("neutralspace", None) => Ok(None),
                ("neutralspace", Some(_)) => no("sides of neutral space"),
                (tag, side) => {
                    let side = side.map(self::side);
                    Ok(Some(BodyLevel { place: tag.to_owned(), approximate: false, side, face: None }))
                }
            }
        }
        Place::OtherHand(point) if is_arm(*point) => arm_level(*point, hand.other(), dictionary).map(Some),
        Place::OtherHand(_) => no("place between a hand and the body"),
        Place::Space(_) => no("grid of signing space"),
        Place::Point(_) => no("points in metres"),
        Place::Between(..) => no("place between more than two"),
        Place::Referent(_) => no("place halfway to a named one"),
        Place::Towards(_) => no("pointing at a place"),
    }
}

/// Whether a point belongs to the arm, which HamNoSys writes as it writes the body.
fn is_arm(point: HandPoint) -> bool {
    let arm = [HandPart::UpperArm, HandPart::Elbow, HandPart::ElbowInside, HandPart::LowerArm];
    point.second().is_none() && arm.contains(&point.part())
}

fn arm_level(point: HandPoint, hand: Hand, dictionary: &Dictionary) -> Result<BodyLevel, String> {
    let (side, face) = sides(point.flank(), hand);
    Ok(BodyLevel { place: limb_tag(point.part(), dictionary)?, approximate: false, side, face })
}

fn limb_tag(part: HandPart, dictionary: &Dictionary) -> Result<String, String> {
    let is_it = |tag: &&str| matches!(dictionary.place(tag), Some((_, LocationKind::Limb(p))) if p == part);
    let tag = dictionary.place_tag(part.name()).filter(is_it);
    tag.map(str::to_owned).ok_or_else(|| format!("HamNoSys has no symbol for the {}", part.name()))
}

fn side(lateral: Lateral) -> Side {
    match (lateral.side, lateral.beside) {
        (phonology::Side::Left, true) => Side::LeftBeside,
        (phonology::Side::Left, false) => Side::LeftAt,
        (phonology::Side::Right, false) => Side::RightAt,
        (phonology::Side::Right, true) => Side::RightBeside,
    }
}

/// Side and face of a flank, for a palm that faces down.
fn sides(flank: Option<Flank>, hand: Hand) -> (Option<Side>, Option<Face>) {
    match (flank, hand) {
        (None, _) => (None, None),
        (Some(Flank::Dorsal), _) => (None, Some(Face::Dorsal)),
        (Some(Flank::Palmar), _) => (None, Some(Face::Palmar)),
        (Some(Flank::Radial), Hand::Strong) | (Some(Flank::Ulnar), Hand::Weak) => (Some(Side::LeftBeside), None),
        (Some(Flank::Ulnar), Hand::Strong) | (Some(Flank::Radial), Hand::Weak) => (Some(Side::RightBeside), None),
    }
}

/// A point of a hand as HamNoSys names it.
pub(crate) fn levels(point: HandPoint, hand: Hand, dictionary: &Dictionary) -> Result<HandLevels, String> {
    let one = |p: HandPoint| -> Result<HandLevel, String> {
        let (side, face) = sides(p.flank(), hand);
        let part = match finger_part(p.part()) {
            Ok(part) => HandPlace::Digits(p.digits().iter().collect(), Some(part)),
            Err(_) => HandPlace::Hand(limb_tag(p.part(), dictionary)?),
        };
        Ok(HandLevel { part, approximate: false, side, face })
    };
    Ok(HandLevels { first: one(point.first())?, between: point.second().map(one).transpose()? })
}

/// A contact of two hands; `at` is where both are.
pub(crate) fn constellation(
    contact: &phonology::Contact,
    at: Option<Site>,
    dictionary: &Dictionary,
) -> Result<Constellation, String> {
    let points = match (contact.strong, contact.weak) {
        (Some(strong), Some(weak)) => {
            Some((levels(weak, Hand::Weak, dictionary)?, levels(strong, Hand::Strong, dictionary)?))
        }
        (None, None) => None,
        (Some(_), None) | (None, Some(_)) => {
            return Err("HamNoSys names the points of both hands or of none".to_owned());
        }
    };
    let kind = match contact.kind {
        ContactKind::Touch => Contact::Touch,
        ContactKind::Close => Contact::Close,
        ContactKind::Crossed => Contact::Cross,
        ContactKind::Interlocked => Contact::Interlock,
        ContactKind::Metres(_) => return Err("HamNoSys has no distances in centimetres".to_owned()),
    };
    Ok(Constellation { points, contact: Some(kind), at })
}
