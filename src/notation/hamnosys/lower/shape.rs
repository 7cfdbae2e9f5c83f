//! Hand shapes: class, thumb, bends and fingers to a named handshape with changes.

use super::super::dictionary::Dictionary;
use super::super::syntax::{self, Bend, BentClass, FingerList, FingerPart, Shape, ShapeClass, Thumb, ThumbSpecial};
use crate::phonology::{Between, Configuration, Digit, Digits, HandPart, HandshapeChange, Opening, ThumbPosition};

/// The configuration of a shape: a handshape of the inventory where one is exactly that, else that of the class, changed.
pub(crate) fn configuration(shape: &Shape, dictionary: &Dictionary) -> Configuration {
    let shape = &Shape { approximate: false, successive: None, ..shape.clone() };
    if let Some(id) = dictionary.handshape(shape) {
        return Configuration::named(id);
    }
    let (base, own) = class(shape.main, dictionary);
    let rest = details(shape);
    match shape.between {
        None => {
            let mut changes = lists(shape);
            changes.extend(own);
            changes.extend(rest);
            Configuration { base, between: None, changes }
        }
        Some(second) => {
            let (second, changes) = class(second, dictionary);
            let mut whole = lists(shape);
            whole.extend(rest);
            let between = Between { first: own, second, changes };
            Configuration { base, between: Some(Box::new(between)), changes: whole }
        }
    }
}

/// The name of a class with its thumb and bend, and what must be changed of it.
fn class(main: BentClass, dictionary: &Dictionary) -> (String, Vec<HandshapeChange>) {
    let exact = Shape { main, ..Shape::of(main.class) };
    if let Some(id) = dictionary.handshape(&exact) {
        return (id.to_owned(), Vec::new());
    }
    let base = dictionary.class(main.class).unwrap_or(fallback(main.class)).to_owned();
    let mut changes = Vec::new();
    changes.extend(main.thumb.map(|thumb| self::thumb(thumb, main.class)));
    changes.extend(main.bend.map(|b| bend(Digits::NONE, b)));
    (base, changes)
}

/// The ids of the built-in inventory, for one that has no handshape of that class.
fn fallback(class: ShapeClass) -> &'static str {
    match class {
        ShapeClass::Fist => "fist-a",
        ShapeClass::Flat => "flat",
        ShapeClass::Finger2 => "1",
        ShapeClass::Finger23 => "U",
        ShapeClass::Finger23Spread => "V",
        ShapeClass::Finger2345 => "5",
        ShapeClass::Pinch12 => "O-index",
        ShapeClass::PinchAll => "O",
        ShapeClass::Pinch12Open => "F",
        ShapeClass::Cee12 => "C-index",
        ShapeClass::CeeAll => "C",
        ShapeClass::Cee12Open => "open-F",
    }
}

/// Whether the thumb's modifier says how open the hand is.
pub(crate) fn opens(class: ShapeClass) -> bool {
    matches!(class, ShapeClass::Cee12 | ShapeClass::CeeAll | ShapeClass::Cee12Open)
}

fn thumb(thumb: Thumb, class: ShapeClass) -> HandshapeChange {
    match (thumb, opens(class)) {
        (Thumb::Across, true) => HandshapeChange::Opening(Opening::Tight),
        (Thumb::Open, true) => HandshapeChange::Opening(Opening::Slack),
        (Thumb::Out, _) => HandshapeChange::Thumb(ThumbPosition::Out),
        (Thumb::Across, false) => HandshapeChange::Thumb(ThumbPosition::Across),
        (Thumb::Open, false) => HandshapeChange::Thumb(ThumbPosition::Opposed),
    }
}

fn bend(digits: Digits, bend: Bend) -> HandshapeChange {
    use crate::phonology::Bend as Meant;
    let named = |meant| HandshapeChange::Bend(digits, meant);
    match bend {
        Bend::Bent => named(Meant::Bent),
        Bend::Round => named(Meant::Round),
        Bend::Hooked => named(Meant::Hooked),
        Bend::DoubleBent => named(Meant::DoubleBent),
        Bend::DoubleHooked => named(Meant::DoubleHooked),
        Bend::HalfBent => named(Meant::HalfBent),
        Bend::Quarters(quarters) => HandshapeChange::Joints(digits, quarters),
    }
}

/// What the list of fingers says.
fn lists(shape: &Shape) -> Vec<HandshapeChange> {
    let listed = Digits::of(shape.fingers.iter().map(|f| f.finger));
    let mut changes = Vec::new();
    if !listed.is_empty() {
        match shape.lists() {
            FingerList::Special => changes.push(HandshapeChange::On(listed)),
            FingerList::Exempted => changes.push(HandshapeChange::Except(listed)),
            FingerList::SpecialAndExempted => {
                changes.extend([HandshapeChange::On(listed), HandshapeChange::Except(listed)]);
            }
        }
    }
    if shape.thumb == Some(ThumbSpecial::Exempted) {
        changes.push(HandshapeChange::Except(Digits::of([Digit::Thumb])));
    }
    changes
}

/// Bends of single digits, crossings, and what the thumb does.
fn details(shape: &Shape) -> Vec<HandshapeChange> {
    let mut changes = Vec::new();
    for (digit, b) in &shape.bends {
        changes.push(bend(Digits::of([digit.unwrap_or(Digit::Index)]), *b));
    }
    for (first, part, second) in &shape.crossings {
        changes.push(HandshapeChange::Meet(*first, hand_part(*part), *second));
    }
    changes.extend(match shape.thumb {
        None | Some(ThumbSpecial::Exempted) => None,
        Some(ThumbSpecial::Between(a, b)) => Some(HandshapeChange::ThumbBetween(a, b)),
        Some(ThumbSpecial::Enclosed) => Some(HandshapeChange::Thumb(ThumbPosition::Enclosed)),
        Some(ThumbSpecial::At(part)) => Some(HandshapeChange::ThumbAt(hand_part(part))),
    });
    changes
}

/// A part of a digit as the phonology has it.
pub(crate) fn hand_part(part: FingerPart) -> HandPart {
    match part {
        FingerPart::Tip => HandPart::Tip,
        FingerPart::Nail => HandPart::Nail,
        FingerPart::Pad => HandPart::Pad,
        FingerPart::MidJoint => HandPart::Midjoint,
        FingerPart::Base => HandPart::Base,
        FingerPart::Side => HandPart::Side,
    }
}

/// The fingers that a shape shows: what a finger part without a finger belongs to.
pub(crate) fn acting_fingers(shape: Option<&Shape>) -> Digits {
    let Some(shape) = shape else { return Digits::of([Digit::Index]) };
    let listed = Digits::of(shape.fingers.iter().map(|f| f.finger));
    match shape.main.class {
        _ if !listed.is_empty() && shape.lists() != FingerList::Exempted => listed,
        ShapeClass::Finger2
        | ShapeClass::Pinch12
        | ShapeClass::Pinch12Open
        | ShapeClass::Cee12
        | ShapeClass::Cee12Open => Digits::of([Digit::Index]),
        ShapeClass::Finger23 | ShapeClass::Finger23Spread => Digits::of([Digit::Index, Digit::Middle]),
        ShapeClass::Fist | ShapeClass::Flat | ShapeClass::Finger2345 | ShapeClass::PinchAll | ShapeClass::CeeAll => {
            Digits::FINGERS
        }
    }
}

/// How the fingers of a replaced shape change.
pub(crate) fn successive(shape: &syntax::Split<Shape>) -> Option<syntax::Successive> {
    match shape {
        syntax::Split::Both(shape) => shape.successive,
        syntax::Split::Each(strong, weak) => strong.iter().chain(weak).find_map(|s| s.successive),
    }
}
