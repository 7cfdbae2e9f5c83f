//! Places.

use super::element::Element;
use super::unsayable;
use super::words::{ARM, BODY, CONTACT, FLANK, Flank, PART, number};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{
    BodyLevel, BodyLevels, Constellation, Face, HandLevel, HandLevels, HandPlace, Location, Side, Site,
};

pub(super) fn location(location: &Location) -> Result<Element, Error> {
    match location {
        Location::One(one) => site(one),
        Location::Split(Some(strong), weak) => {
            let mut element = Element::of("split_location", vec![site(strong)?]);
            element.children.extend(weak.as_ref().map(site).transpose()?);
            Ok(element)
        }
        Location::Split(None, _) => unsayable("gestural SiGML has no place for the weak hand alone"),
        Location::Constellation(both) => constellation(both),
    }
}

fn constellation(both: &Constellation) -> Result<Element, Error> {
    let mut element = Element::new("handconstellation");
    if let Some(contact) = both.contact {
        element.word("contact", contact, &CONTACT);
    }
    if let Some((touched, touching)) = &both.points {
        element.children.extend([hand("location_hand", touched)?, hand("location_hand", touching)?]);
    }
    match &both.at {
        Some(Site::Hand { .. }) => {
            return unsayable("gestural SiGML has hands at each other at a place of the body, not of a hand");
        }
        Some(at @ (Site::Body { .. } | Site::Named(_))) => element.children.push(site(at)?),
        None => {}
    }
    Ok(element)
}

/// One place.
pub(super) fn site(site: &Site) -> Result<Element, Error> {
    let (mut element, contact, with) = match site {
        Site::Named(name) => {
            let mut element = Element::new("use_locname");
            element.set("use_locname", name.as_str());
            return Ok(element);
        }
        Site::Body { level, behind, contact, with } => {
            let mut element = Element::new("location_bodyarm");
            if let Some(levels) = level {
                body(&mut element, levels)?;
            }
            element.mark("behind", *behind);
            (element, contact, with)
        }
        Site::Hand { level, contact, with } => (hand("location_hand", level)?, contact, with),
    };
    if let Some(contact) = contact {
        element.word("contact", *contact, &CONTACT);
    }
    element.children.extend(with.as_ref().map(|with| hand("location_hand", with)).transpose()?);
    Ok(element)
}

fn body(element: &mut Element, levels: &BodyLevels) -> Result<(), Error> {
    let mut level = |level: &BodyLevel, [location, side]: [&'static str; 2]| -> Result<(), Error> {
        element.set(location, body_place(&level.place)?);
        if let Some(flank) = flank(level.side, level.face)? {
            element.word::<Flank>(side, flank, &FLANK);
        }
        Ok(())
    };
    level(&levels.first, ["location", "side"])?;
    if let Some(second) = &levels.between {
        level(second, ["second_location", "second_side"])?;
        exact(second.approximate)?;
    }
    element.mark("approx_location", levels.first.approximate);
    Ok(())
}

/// A place of the body or arm that readers know.
pub(super) fn body_place(place: &str) -> Result<&'static str, Error> {
    match BODY.iter().chain(ARM).find(|known| **known == place) {
        Some(known) => Ok(known),
        None => unsayable(&format!("gestural SiGML knows no place `{place}` of the body")),
    }
}

/// The one attribute for side and face.
pub(super) fn flank(side: Option<Side>, face: Option<Face>) -> Result<Option<Flank>, Error> {
    match (side, face) {
        (Some(_), Some(_)) => unsayable("gestural SiGML says the side or the face of a place, not both"),
        (Some(side), None) => Ok(Some(Flank::Side(side))),
        (None, face) => Ok(face.map(Flank::Face)),
    }
}

/// The other end of a place halfway between two is never only approximate.
fn exact(approximate: bool) -> Result<(), Error> {
    match approximate {
        true => unsayable("gestural SiGML says of the first of two places only that it is approximate"),
        false => Ok(()),
    }
}

fn hand(name: &'static str, levels: &HandLevels) -> Result<Element, Error> {
    let mut element = Element::new(name);
    hand_level(&mut element, &levels.first, ["location", "digits", "side"])?;
    if let Some(second) = &levels.between {
        let before = element.attributes.len();
        hand_level(&mut element, second, ["second_location", "second_digits", "second_side"])?;
        if element.attributes.len() == before {
            return unsayable("the other end of a place halfway between two should be named");
        }
        exact(second.approximate)?;
    }
    element.mark("approx_location", levels.first.approximate);
    Ok(element)
}

fn hand_level(element: &mut Element, level: &HandLevel, names: [&'static str; 3]) -> Result<(), Error> {
    let [location, digits, side] = names;
    match &level.part {
        HandPlace::Hand(place) => match ARM.iter().find(|known| *known == place) {
            Some(known) => element.set(location, *known),
            None => return unsayable(&format!("gestural SiGML knows no place `{place}` of the hand")),
        },
        HandPlace::Digits(list, part) => {
            if let Some(part) = part {
                element.word(location, *part, &PART);
            }
            let numbers: String = list.iter().map(|digit| number(*digit)).collect();
            if numbers.char_indices().any(|(i, c)| numbers[..i].contains(c)) {
                return unsayable("a place on digits has each digit once");
            }
            if !numbers.is_empty() {
                element.set(digits, numbers);
            }
        }
    }
    if let Some(flank) = flank(level.side, level.face)? {
        element.word::<Flank>(side, flank, &FLANK);
    }
    Ok(())
}
