//! Postures as symbols.

use super::Writer;
use crate::notation::hamnosys::kind::Kind;
use crate::notation::hamnosys::parse::Handed;
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Digit;

impl Posture {
    /// Whether the hands have different values.
    pub(super) fn splits(&self) -> bool {
        matches!(self.shape, Some(Split::Each(..)))
            || matches!(self.fingers, Some(Split::Each(..)))
            || matches!(self.palm, Some(Split::Each(..)))
    }

    /// Whether symbols of this class, written after the posture, would be read as a part of its shape.
    pub(super) fn takes(&self, after: Option<Kind>) -> bool {
        let (Some(Split::Both(shape)), None, None) = (&self.shape, &self.fingers, &self.palm) else { return false };
        let in_digits = !shape.fingers.is_empty() || !shape.bends.is_empty() || !shape.crossings.is_empty() || shape.thumb.is_some();
        match after {
            Some(Kind::Digit(_) | Kind::Part(_)) => true,
            Some(Kind::Hand(_) | Kind::Contact(_) | Kind::At | Kind::Beside) => in_digits,
            Some(_) | None => false,
        }
    }
}

/// The tag of a bend; some are of gestural SiGML alone.
fn bend_tag(bend: Bend) -> Option<&'static str> {
    match bend {
        Bend::Bent => Some("hamfingerstraightmod"),
        Bend::Round => Some("hamfingerbendmod"),
        Bend::Hooked => Some("hamfingerhookmod"),
        Bend::DoubleBent => Some("hamdoublebent"),
        Bend::DoubleHooked => Some("hamdoublehooked"),
        Bend::HalfBent | Bend::Quarters(_) => None,
    }
}

/// The tag of a digit.
pub(super) fn digit_tag(digit: Digit) -> &'static str {
    match digit {
        Digit::Thumb => "hamthumb",
        Digit::Index => "hamindexfinger",
        Digit::Middle => "hammiddlefinger",
        Digit::Ring => "hamringfinger",
        Digit::Pinky => "hampinky",
    }
}

/// The tag of a part of a digit.
pub(super) fn part_tag(part: FingerPart) -> &'static str {
    match part {
        FingerPart::Tip => "hamfingertip",
        FingerPart::Nail => "hamfingernail",
        FingerPart::Pad => "hamfingerpad",
        FingerPart::MidJoint => "hamfingermidjoint",
        FingerPart::Base => "hamfingerbase",
        FingerPart::Side => "hamfingerside",
    }
}

fn class_tag(class: ShapeClass) -> &'static str {
    match class {
        ShapeClass::Fist => "hamfist",
        ShapeClass::Flat => "hamflathand",
        ShapeClass::Finger2 => "hamfinger2",
        ShapeClass::Finger23 => "hamfinger23",
        ShapeClass::Finger23Spread => "hamfinger23spread",
        ShapeClass::Finger2345 => "hamfinger2345",
        ShapeClass::Pinch12 => "hampinch12",
        ShapeClass::PinchAll => "hampinchall",
        ShapeClass::Pinch12Open => "hampinch12open",
        ShapeClass::Cee12 => "hamcee12",
        ShapeClass::CeeAll => "hamceeall",
        ShapeClass::Cee12Open => "hamceeopen",
    }
}

impl Writer {
    /// Writes a posture; `after` is the class of the symbol that follows it as a place.
    pub(super) fn posture(&mut self, posture: &Posture, after: Option<Kind>) {
        if successive(posture).is_some() {
            self.cannot("HamNoSys lets fingers change one after the other in `hamreplace` alone");
        }
        // Brackets around the shape keep it from taking the digits of the place.
        let bracketed = posture.takes(after);
        if bracketed {
            self.put("hamparbegin");
        }
        self.posture_parts(posture);
        if bracketed {
            self.put("hamparend");
        }
    }

    /// Writes the parts of a posture.
    pub(super) fn posture_parts(&mut self, posture: &Posture) {
        self.split(&posture.shape, Writer::shape);
        self.split(&posture.fingers, Writer::fingers);
        self.split(&posture.palm, Writer::palm);
    }

    /// Writes a value for both hands or one each.
    fn split<T>(&mut self, value: &Option<Split<T>>, write: fn(&mut Writer, &T)) {
        match value {
            None => {}
            Some(Split::Both(value)) => write(self, value),
            Some(Split::Each(None, None)) => self.cannot("HamNoSys cannot split a value that neither hand has"),
            Some(Split::Each(strong, weak)) => {
                self.handed = Handed::Two;
                self.put("hamparbegin");
                self.or_nothing(strong.as_ref(), write);
                self.put("hamplus");
                self.or_nothing(weak.as_ref(), write);
                self.put("hamparend");
            }
        }
    }

    /// Writes a value, or `hamnomotion`.
    pub(super) fn or_nothing<T: ?Sized>(&mut self, value: Option<&T>, write: fn(&mut Writer, &T)) {
        match value {
            Some(value) => write(self, value),
            None => self.put("hamnomotion"),
        }
    }

    fn shape(&mut self, shape: &Shape) {
        self.class(&shape.main);
        if shape.approximate {
            self.put("hametc");
        }
        if let Some(between) = &shape.between {
            self.put("hambetween");
            self.class(between);
        }
        for (_, bend) in shape.bends.iter().filter(|(digit, _)| digit.is_none()) {
            if shape.between.as_ref().unwrap_or(&shape.main).bend.is_none() {
                self.cannot("HamNoSys reads a bend without a finger as that of all fingers, where these have none");
            }
            self.bend(*bend);
        }
        for listed in &shape.fingers {
            self.put(digit_tag(listed.finger));
            if listed.opposed {
                self.cannot("we know no way to write which finger the thumb is opposed to");
            }
        }
        for (digit, bend) in &shape.bends {
            if let Some(digit) = digit {
                self.put(digit_tag(*digit));
                self.bend(*bend);
            }
        }
        if shape.crossings.len() > 2 {
            self.cannot("HamNoSys has two pairs of digits that touch at most");
        }
        for (first, part, second) in &shape.crossings {
            self.put(digit_tag(*first));
            self.put(part_tag(*part));
            self.put(digit_tag(*second));
        }
        self.thumb(shape.thumb);
    }

    fn thumb(&mut self, thumb: Option<ThumbSpecial>) {
        match thumb {
            None => {}
            Some(ThumbSpecial::Between(a, b)) => {
                self.put("hambetween");
                self.put(digit_tag(a));
                self.put(digit_tag(b));
            }
            Some(ThumbSpecial::Enclosed) => self.put("hambetween"),
            Some(ThumbSpecial::Exempted) => self.put("hamthumb"),
            Some(ThumbSpecial::At(part)) => self.put(part_tag(part)),
        }
    }

    fn class(&mut self, class: &BentClass) {
        self.put(class_tag(class.class));
        match class.thumb {
            None => {}
            Some(Thumb::Out) => self.put("hamthumboutmod"),
            Some(Thumb::Across) => self.put("hamthumbacrossmod"),
            Some(Thumb::Open) => self.put("hamthumbopenmod"),
        }
        if let Some(bend) = class.bend {
            self.bend(bend);
        }
    }

    fn bend(&mut self, bend: Bend) {
        match bend_tag(bend) {
            Some(tag) => self.put(tag),
            None => self.cannot("HamNoSys has no symbols for fingers bent in quarters or by half"),
        }
    }

    fn fingers(&mut self, fingers: &Fingers) {
        self.direction("hamextfinger", fingers.direction);
        if let Some(between) = fingers.between {
            self.put("hambetween");
            self.direction("hamextfinger", between);
        }
        if fingers.relative {
            self.put("hamorirelative");
        }
    }

    fn palm(&mut self, palm: &Palm) {
        self.facing(palm.facing);
        if let Some(between) = palm.between {
            self.put("hambetween");
            self.facing(between);
        }
        if palm.approximate {
            self.put("hametc");
        }
        if palm.relative {
            self.put("hamorirelative");
        }
    }

    fn facing(&mut self, facing: Facing) {
        match facing {
            Facing::Roll(roll) => self.put_tag(&format!("hampalm{}", roll.tag())),
            Facing::Toward(_) => self.cannot("HamNoSys has no symbols for palms that face a direction of space"),
        }
    }
}

/// How the fingers of a posture change, if one after the other.
pub(super) fn successive(posture: &Posture) -> Option<Successive> {
    match &posture.shape {
        Some(Split::Both(shape)) => shape.successive,
        Some(Split::Each(strong, weak)) => strong.iter().chain(weak).find_map(|shape| shape.successive),
        None => None,
    }
}
