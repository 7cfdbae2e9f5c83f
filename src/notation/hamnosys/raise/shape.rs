//! A configuration to the shape that HamNoSys writes.

use super::super::dictionary::Dictionary;
use super::super::lower::shape::{acting_fingers, opens};
use super::super::syntax::{Bend, FingerPart, ListedFinger, Shape, ShapeClass, Thumb, ThumbSpecial};
use crate::phonology::{self, Configuration, Digit, Digits, HandPart, HandshapeChange, Opening, ThumbPosition};

/// The shape of a configuration, or what of it HamNoSys cannot say.
pub(crate) fn shape(
    configuration: &Configuration,
    language: Option<&str>,
    dictionary: &Dictionary,
) -> Result<Shape, String> {
    let named = |id: &str| {
        let shape = dictionary.shape(id, language).cloned();
        shape.ok_or_else(|| format!("HamNoSys has no symbols for the handshape `{id}`"))
    };
    let mut shape = named(&configuration.base)?;
    if let Some(between) = &configuration.between {
        changed(&mut shape, &between.first)?;
        let mut second = named(&between.second)?;
        changed(&mut second, &between.changes)?;
        let plain = Shape { main: second.main, ..Shape::of(second.main.class) } == second;
        if !plain || shape.between.is_some() {
            return Err(format!(
                "HamNoSys cannot write a hand halfway to `{}`: it is more than a class",
                between.second
            ));
        }
        shape.between = Some(second.main);
    }
    changed(&mut shape, &configuration.changes)?;
    Ok(shape)
}

fn changed(shape: &mut Shape, changes: &[HandshapeChange]) -> Result<(), String> {
    changes.iter().try_for_each(|change| apply(shape, *change))
}

fn apply(shape: &mut Shape, change: HandshapeChange) -> Result<(), String> {
    match change {
        HandshapeChange::Thumb(position) => return thumb(shape, position),
        HandshapeChange::Bend(digits, bend) => bent(shape, digits, self::bend(bend)?),
        HandshapeChange::Joints(digits, quarters) => bent(shape, digits, Bend::Quarters(quarters)),
        HandshapeChange::Spread(spread) => return spread_to(shape, spread),
        HandshapeChange::Cross(front, behind) => shape.crossings.push((front, FingerPart::Nail, behind)),
        HandshapeChange::ThumbBetween(a, b) => shape.thumb = Some(ThumbSpecial::Between(a, b)),
        HandshapeChange::On(digits) => return listed(shape, digits),
        HandshapeChange::Except(digits) => return excepted(shape, digits),
        HandshapeChange::Opening(opening) if opens(shape.main.class) => {
            shape.main.thumb = Some(match opening {
                Opening::Tight => Thumb::Across,
                Opening::Slack => Thumb::Open,
            });
        }
        HandshapeChange::Opening(opening) => {
            return Err(format!("`{}` says nothing of a hand that is no C", opening.name()));
        }
        HandshapeChange::Meet(first, part, second) => shape.crossings.push((first, finger_part(part)?, second)),
        HandshapeChange::ThumbAt(part) => shape.thumb = Some(ThumbSpecial::At(finger_part(part)?)),
    }
    Ok(())
}

fn thumb(shape: &mut Shape, position: ThumbPosition) -> Result<(), String> {
    let thumb = match position {
        ThumbPosition::Along => None,
        ThumbPosition::Out => Some(Thumb::Out),
        ThumbPosition::Across => Some(Thumb::Across),
        ThumbPosition::Opposed => Some(Thumb::Open),
        ThumbPosition::Enclosed => {
            shape.thumb = Some(ThumbSpecial::Enclosed);
            shape.main.thumb
        }
    };
    if position != ThumbPosition::Enclosed
        && opens(shape.main.class)
        && matches!(thumb, Some(Thumb::Across | Thumb::Open))
    {
        return Err(format!("`thumb {}` of a C would say how open it is", position.name()));
    }
    shape.main.thumb = thumb;
    Ok(())
}

fn bend(bend: phonology::Bend) -> Result<Bend, String> {
    use phonology::Bend as Meant;
    match bend {
        Meant::Bent => Ok(Bend::Bent),
        Meant::HalfBent => Ok(Bend::HalfBent),
        Meant::Round => Ok(Bend::Round),
        Meant::Hooked => Ok(Bend::Hooked),
        Meant::DoubleBent => Ok(Bend::DoubleBent),
        Meant::DoubleHooked => Ok(Bend::DoubleHooked),
        Meant::Straight | Meant::Closed => Err(format!("HamNoSys has no symbol for a `{}` finger", bend.name())),
    }
}

fn bent(shape: &mut Shape, digits: Digits, bend: Bend) {
    if digits.is_empty() {
        shape.main.bend = Some(bend);
        return;
    }
    for digit in digits.iter() {
        shape.bends.retain(|(d, _)| d.unwrap_or(Digit::Index) != digit);
        shape.bends.push((Some(digit), bend));
    }
}

fn spread_to(shape: &mut Shape, spread: bool) -> Result<(), String> {
    shape.main.class = match (shape.main.class, spread) {
        (ShapeClass::Finger23 | ShapeClass::Finger23Spread, true) => ShapeClass::Finger23Spread,
        (ShapeClass::Finger23 | ShapeClass::Finger23Spread, false) => ShapeClass::Finger23,
        (ShapeClass::Flat | ShapeClass::Finger2345, true) => ShapeClass::Finger2345,
        (ShapeClass::Flat | ShapeClass::Finger2345, false) => ShapeClass::Flat,
        (class, _) if acting_fingers(Some(shape)).iter().count() == 1 => class,
        (_, _) => return Err("HamNoSys can spread two fingers or all, not those of this hand".to_owned()),
    };
    Ok(())
}

fn fingers_of(digits: Digits) -> Vec<ListedFinger> {
    let fingers = digits.iter().filter(|d| *d != Digit::Thumb);
    fingers.map(|finger| ListedFinger { finger, opposed: false }).collect()
}

fn listed(shape: &mut Shape, digits: Digits) -> Result<(), String> {
    let fingers = fingers_of(digits);
    let takes = match shape.main.class {
        ShapeClass::Finger2 => fingers.len() == 1,
        ShapeClass::Finger23 | ShapeClass::Finger23Spread => fingers.len() >= 2,
        ShapeClass::Pinch12 | ShapeClass::Pinch12Open | ShapeClass::Cee12 | ShapeClass::Cee12Open => {
            !fingers.is_empty()
        }
        ShapeClass::Fist | ShapeClass::Flat | ShapeClass::Finger2345 | ShapeClass::PinchAll | ShapeClass::CeeAll => {
            false
        }
    };
    if !takes || digits.contains(Digit::Thumb) {
        return Err("HamNoSys cannot name these fingers for this hand shape".to_owned());
    }
    shape.fingers = fingers;
    Ok(())
}

fn excepted(shape: &mut Shape, digits: Digits) -> Result<(), String> {
    if digits.contains(Digit::Thumb) {
        shape.thumb = Some(ThumbSpecial::Exempted);
    }
    let fingers = fingers_of(digits);
    if fingers.is_empty() || shape.fingers == fingers {
        return Ok(());
    }
    if !shape.fingers.is_empty() {
        return Err("HamNoSys lists fingers once: those that act or those left out of the bend".to_owned());
    }
    shape.fingers = fingers;
    Ok(())
}

/// A part of a digit as HamNoSys has it.
pub(crate) fn finger_part(part: HandPart) -> Result<FingerPart, String> {
    match part {
        HandPart::Tip => Ok(FingerPart::Tip),
        HandPart::Nail => Ok(FingerPart::Nail),
        HandPart::Pad => Ok(FingerPart::Pad),
        HandPart::Midjoint => Ok(FingerPart::MidJoint),
        HandPart::Base => Ok(FingerPart::Base),
        HandPart::Side => Ok(FingerPart::Side),
        HandPart::Palm
        | HandPart::Back
        | HandPart::ThumbSide
        | HandPart::PinkySide
        | HandPart::ThumbBall
        | HandPart::Wrist
        | HandPart::WristBack
        | HandPart::WristPulse
        | HandPart::LowerArm
        | HandPart::Elbow
        | HandPart::ElbowInside
        | HandPart::UpperArm => Err(format!("the {} is no part of a finger", part.name())),
    }
}
