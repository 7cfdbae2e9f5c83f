//! Postures: an element for the shape, one for the fingers, one for the palm, as the field writes them.

use super::element::Element;
use super::unsayable;
use super::words::{BEND, CLASS, FLANK, Flank, OPENING, PART, SUCCESSIVE, THUMB, is_cee, letters, number, roll};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{
    Bend, BentClass, BodyLevel, Facing, FingerList, Fingers, Palm, Posture, Shape, Split, Thumb, ThumbSpecial,
};
use crate::phonology::Digit;

/// The elements of a posture.
pub(super) fn posture(posture: &Posture) -> Result<Vec<Element>, Error> {
    let parts = [
        posture.shape.as_ref().map(|part| split(part, shape)).transpose()?,
        posture.fingers.as_ref().map(|part| split(part, fingers)).transpose()?,
        posture.palm.as_ref().map(|part| split(part, palm)).transpose()?,
    ];
    Ok(parts.into_iter().flatten().collect())
}

fn split<T>(part: &Split<T>, one: fn(&T) -> Result<Element, Error>) -> Result<Element, Error> {
    let of = |hand: &Option<T>| hand.as_ref().map_or_else(|| Ok(Element::new("handconfig")), one);
    match part {
        Split::Both(value) => one(value),
        Split::Each(None, None) => unsayable("a split posture should be said of one of the hands at least"),
        Split::Each(strong, weak) => Ok(Element::of("split_handconfig", vec![of(strong)?, of(weak)?])),
    }
}

fn shape(shape: &Shape) -> Result<Element, Error> {
    let mut element = Element::new("handconfig");
    class(&mut element, &shape.main, ["handshape", "thumbpos", "ceeopening", "mainbend"])?;
    if let Some(second) = &shape.between {
        let names = ["second_handshape", "second_thumbpos", "second_ceeopening", "second_mainbend"];
        class(&mut element, second, names)?;
    }
    element.mark("approx_shape", shape.approximate);
    listed(&mut element, shape)?;
    for (digit, bend) in &shape.bends {
        // A bend without a digit means the index finger.
        let name = match digit {
            Some(Digit::Thumb) => "bend1",
            Some(Digit::Index) | None => "bend2",
            Some(Digit::Middle) => "bend3",
            Some(Digit::Ring) => "bend4",
            Some(Digit::Pinky) => "bend5",
        };
        if element.attributes.iter().any(|(other, _)| *other == name) {
            return unsayable("gestural SiGML bends each digit once");
        }
        element.set(name, bend_word(*bend)?);
    }
    let names = [("contactpair", "contactkind"), ("second_contactpair", "second_contactkind")];
    if shape.crossings.len() > names.len() {
        return unsayable("gestural SiGML has two pairs of digits that touch, not more");
    }
    for ((first, part, second), (pair, kind)) in shape.crossings.iter().zip(names) {
        element.set(pair, two(*first, *second)?);
        element.word(kind, *part, &PART);
    }
    match shape.thumb {
        Some(ThumbSpecial::Between(first, second)) => element.set("thumbbetween", two(first, second)?),
        Some(ThumbSpecial::Enclosed) => element.mark("thumbenclosed", true),
        Some(ThumbSpecial::At(part)) => element.word("thumbcontact", part, &PART),
        Some(ThumbSpecial::Exempted) | None => {}
    }
    if let Some(order) = shape.successive {
        element.word("successivefingers", order, &SUCCESSIVE);
    }
    Ok(element)
}

fn two(first: Digit, second: Digit) -> Result<String, Error> {
    if first == second {
        return unsayable("two digits that touch, or that the thumb is between, are not the same one");
    }
    Ok(String::from_iter([number(first), number(second)]))
}

/// A class with thumb and bend. A C that is neither tight nor slack says where its thumb is.
fn class(element: &mut Element, class: &BentClass, names: [&'static str; 4]) -> Result<(), Error> {
    let [shape, position, opening, bend] = names;
    element.word(shape, class.class, &CLASS);
    match class.thumb {
        Some(thumb @ (Thumb::Across | Thumb::Open)) if is_cee(class.class) => element.word(opening, thumb, &OPENING),
        Some(thumb) => element.word(position, thumb, &THUMB),
        None => {}
    }
    if let Some(value) = class.bend {
        element.set(bend, bend_word(value)?);
    }
    Ok(())
}

fn bend_word(bend: Bend) -> Result<String, Error> {
    match bend {
        Bend::Quarters(quarters) if quarters.iter().all(|q| *q <= 4) => {
            Ok(quarters.iter().map(|q| char::from(b'0' + *q)).collect())
        }
        Bend::Quarters(_) => unsayable("a bend in quarters has three numbers from 0 to 4"),
        Bend::Bent | Bend::Round | Bend::Hooked | Bend::DoubleBent | Bend::DoubleHooked | Bend::HalfBent => {
            Ok((BEND.word)(bend).to_owned())
        }
    }
}

/// The list of fingers under the name of what it means, and a thumb that the bend leaves alone.
fn listed(element: &mut Element, shape: &Shape) -> Result<(), Error> {
    let fingers: String = shape.fingers.iter().map(|f| number(f.finger)).collect();
    let again = |(i, c): (usize, char)| fingers[..i].contains(c);
    if fingers.contains('1') || fingers.char_indices().any(again) {
        return unsayable("the list of fingers of a shape has each finger once, and not the thumb");
    }
    let thumb = if shape.thumb == Some(ThumbSpecial::Exempted) { "1" } else { "" };
    let (special, exempted) = match shape.lists() {
        FingerList::Special => (fingers.as_str(), ""),
        FingerList::Exempted => ("", fingers.as_str()),
        FingerList::SpecialAndExempted => (fingers.as_str(), fingers.as_str()),
    };
    if !special.is_empty() {
        element.set("specialfingers", special);
    }
    if !(thumb.is_empty() && exempted.is_empty()) {
        element.set("exempteddigits", [thumb, exempted].concat());
    }
    let opposed: String = shape.fingers.iter().filter(|f| f.opposed).map(|f| number(f.finger)).collect();
    if !opposed.is_empty() {
        element.set("opposedfinger", opposed);
    }
    Ok(())
}

fn fingers(fingers: &Fingers) -> Result<Element, Error> {
    let mut element = Element::new("handconfig");
    element.direction("extfidir", fingers.direction);
    if let Some(second) = fingers.between {
        element.direction("second_extfidir", second);
    }
    element.mark("rel_extfidir", fingers.relative);
    Ok(element)
}

/// A palm. `abs_palmor` holds for both its values, and is written where one would else be read as a palm symbol.
fn palm(palm: &Palm) -> Result<Element, Error> {
    let values = [Some(palm.facing), palm.between];
    let (mut absolute, mut symbol) = (false, false);
    for facing in values.into_iter().flatten() {
        match facing {
            Facing::Roll(_) => symbol = true,
            Facing::Toward(toward) => absolute |= roll(&letters(toward)).is_some(),
        }
    }
    if absolute && symbol {
        return unsayable("gestural SiGML has no palm halfway between a palm symbol and a direction of space");
    }
    let mut element = Element::new("handconfig");
    for (facing, name) in values.into_iter().zip(["palmor", "second_palmor"]) {
        match facing {
            Some(Facing::Roll(roll)) => element.set(name, roll.tag()),
            Some(Facing::Toward(toward)) => element.direction(name, toward),
            None => {}
        }
    }
    element.mark("abs_palmor", absolute);
    element.mark("rel_palmor", palm.relative);
    element.mark("approx_palmor", palm.approximate);
    Ok(element)
}

/// The part of the body that moves, in the place of a hand.
pub(super) fn body_part(part: &BodyLevel) -> Result<Element, Error> {
    let mut element = Element::new("handconfig");
    element.set("bodypart", super::place::body_place(&part.place)?);
    if let Some(flank) = super::place::flank(part.side, part.face)? {
        element.word::<Flank>("side", flank, &FLANK);
    }
    element.mark("approx_location", part.approximate);
    Ok(element)
}
