//! `handconfig` and `split_handconfig`: consecutive ones add up to one posture.

use super::reader::{Attr, Node, Reader, attributes, elements, tag_span};
use super::shape::{ATTRIBUTES, ShapeWords};
use super::words::{ARM, BODY, FLANK, Flank, Pointed, direction, letters, roll};
use crate::notation::hamnosys::syntax::{BodyLevel, Facing, Fingers, Palm, Posture, Shape, Split};
use crate::phonology::Direction;
use crate::phonology::roll::Roll;

/// What one `handconfig` says.
#[derive(Default)]
pub(super) struct Config {
    shape: Option<Shape>,
    fingers: Option<Fingers>,
    palm: Option<Palm>,
    /// `bodypart`: what moves instead of a hand.
    pub body: Option<BodyLevel>,
    /// `handshape="nondominant"`: how the weak hand alone is sometimes written.
    pub weak: bool,
}

/// Directions and palms as written.
#[derive(Default)]
struct Orientation<'a> {
    fingers: [Option<Attr<'a>>; 2],
    palm: [Option<Attr<'a>>; 2],
    relative_fingers: bool,
    relative_palm: bool,
    approximate_palm: bool,
    absolute_palm: bool,
}

const OTHERS: &[&str] = &[
    "extfidir",
    "second_extfidir",
    "rel_extfidir",
    "palmor",
    "second_palmor",
    "rel_palmor",
    "approx_palmor",
    "abs_palmor",
    "bodypart",
    "side",
    "approx_location",
];

impl<'a> Reader<'a> {
    /// `handconfig`.
    pub(super) fn handconfig(&mut self, node: Node<'a>) -> Config {
        self.no_content(node);
        let (mut shape, mut orientation, mut config) =
            (ShapeWords::default(), Orientation::default(), Config::default());
        let (mut part, mut side, mut approximate) = (None, None, None);
        for attr in attributes(node) {
            if let Some(slot) = shape.slot(attr.name) {
                if slot.is_some() {
                    self.odd(&attr, "one thing can be said of the thumb: this is read, what stands before it is not");
                }
                *slot = Some(attr);
                continue;
            }
            match attr.name {
                "extfidir" => orientation.fingers[0] = Some(attr),
                "second_extfidir" => orientation.fingers[1] = Some(attr),
                "rel_extfidir" => orientation.relative_fingers = self.truth(&attr),
                "palmor" => orientation.palm[0] = Some(attr),
                "second_palmor" => orientation.palm[1] = Some(attr),
                "rel_palmor" => orientation.relative_palm = self.truth(&attr),
                "approx_palmor" => orientation.approximate_palm = self.truth(&attr),
                "abs_palmor" => orientation.absolute_palm = self.truth(&attr),
                "bodypart" => part = Some(attr),
                "side" => side = Some(attr),
                "approx_location" => approximate = Some(attr),
                _ if shape.bend(attr) => {}
                _ => self.unknown_attribute(&attr, &[ATTRIBUTES, OTHERS].concat()),
            }
        }
        if shape.class() == Some("nondominant") {
            shape.forget_class();
            config.weak = true;
        }
        config.body = part.and_then(|part| self.body_part(&part, side, approximate));
        config.shape = self.shape(&shape);
        config.fingers = self.fingers(&orientation);
        config.palm = self.palm(&orientation);
        config
    }

    /// `bodypart` with its side.
    fn body_part(&mut self, part: &Attr, side: Option<Attr>, approximate: Option<Attr>) -> Option<BodyLevel> {
        let Some(place) = [BODY, ARM].concat().into_iter().find(|place| *place == part.value) else {
            self.no_value(part, "a part of the body", BODY.iter().chain(ARM).copied());
            return None;
        };
        let approximate = approximate.is_some_and(|attr| self.truth(&attr));
        let mut level = BodyLevel { place: place.to_owned(), approximate, side: None, face: None };
        match side.and_then(|attr| self.value(&attr, &FLANK)) {
            Some(Flank::Side(side)) => level.side = Some(side),
            Some(Flank::Face(face)) => level.face = Some(face),
            None => {}
        }
        Some(level)
    }

    fn fingers(&mut self, words: &Orientation) -> Option<Fingers> {
        let [first, second] = words.fingers;
        let Some(first) = first else {
            second.inspect(|attr| self.odd(attr, "`second_extfidir` says nothing without `extfidir`: passed over"));
            return None;
        };
        let (direction, between) = self.direction(&first, second)?;
        Some(Fingers { direction, between, relative: words.relative_fingers })
    }

    /// A direction, and the other one where it is halfway between two.
    pub(super) fn direction(&mut self, first: &Attr, second: Option<Attr>) -> Option<(Direction, Option<Direction>)> {
        let Some(pointed) = direction(first.value) else {
            self.no_direction(first);
            return None;
        };
        let second = second.and_then(|attr| self.second_direction(&attr));
        Some(match (pointed, second) {
            (Pointed::One(one), second) => (one, second),
            (Pointed::Halfway(plain, whole), None) => (plain, Some(whole)),
            (Pointed::Halfway(plain, _), Some(second)) => {
                self.odd(first, "halfway between three directions: the doubled letter is read alone");
                (plain, Some(second))
            }
        })
    }

    /// The other end of a direction halfway between two. One that contradicts itself is passed over: the first says enough.
    fn second_direction(&mut self, attr: &Attr) -> Option<Direction> {
        match direction(attr.value) {
            Some(Pointed::One(one)) => Some(one),
            Some(Pointed::Halfway(_, whole)) => {
                self.odd(attr, "halfway to a direction that is itself halfway: read as the whole of it");
                Some(whole)
            }
            None if !attr.value.is_empty() && attr.value.bytes().all(|b| b"udlrio".contains(&b)) => {
                self.odd(attr, "opposite directions in one: passed over");
                None
            }
            None => {
                self.no_direction(attr);
                None
            }
        }
    }

    fn no_direction(&mut self, attr: &Attr) {
        let message = format!("`{}` is no direction", super::short(attr.value));
        let fault = self.fault(attr.span, &message).label("expected one to three letters, such as `uo`");
        self.say(fault.hint("u up, d down, l left, r right, o out, i in; each at most once, no two opposite ones"));
    }

    fn palm(&mut self, words: &Orientation) -> Option<Palm> {
        let [first, second] = words.palm;
        let Some(first) = first else {
            second.inspect(|attr| self.odd(attr, "`second_palmor` says nothing without `palmor`: passed over"));
            return None;
        };
        let facing = self.facing(&first, words)?;
        let between = second.and_then(|attr| self.facing(&attr, words));
        Some(Palm { facing, between, relative: words.relative_palm, approximate: words.approximate_palm })
    }

    /// A palm: one of the eight symbols, or a direction of space.
    fn facing(&mut self, attr: &Attr, words: &Orientation) -> Option<Facing> {
        if let Some(roll) = roll(attr.value).filter(|_| !words.absolute_palm) {
            return Some(Facing::Roll(roll));
        }
        match direction(attr.value) {
            // A letter that is doubled, or in another order, may be a palm symbol all the same.
            Some(Pointed::One(toward)) => match roll(&letters(toward)).filter(|_| !words.absolute_palm) {
                Some(roll) => Some(Facing::Roll(roll)),
                None => Some(Facing::Toward(toward)),
            },
            Some(Pointed::Halfway(..)) | None => {
                let known = Roll::TAGS.into_iter().chain(["directions of space such as `il`"]);
                self.no_value(attr, "a palm", known);
                None
            }
        }
    }

    /// `split_handconfig`: a posture each.
    pub(super) fn split_handconfig(&mut self, node: Node<'a>, posture: &mut Posture) {
        self.no_attributes(node);
        self.no_text(node);
        let mut hands = Vec::new();
        for child in elements(node) {
            match child.tag_name().name() {
                "handconfig" if hands.len() < 2 => hands.push(self.handconfig(child)),
                _ => self.unknown_element(child, &["handconfig"]),
            }
        }
        if hands.len() < 2 {
            let told = self.warning(tag_span(node), "a split posture should have a `handconfig` for each hand");
            self.say(told.label("what is missing stays as it is"));
        }
        let mut hands = hands.into_iter();
        let (strong, weak) = (hands.next().unwrap_or_default(), hands.next().unwrap_or_default());
        self.part(&mut posture.shape, strong.shape, weak.shape, node);
        self.part(&mut posture.fingers, strong.fingers, weak.fingers, node);
        self.part(&mut posture.palm, strong.palm, weak.palm, node);
    }

    /// A value each, where one is said.
    fn part<T: Clone>(&mut self, part: &mut Option<Split<T>>, strong: Option<T>, weak: Option<T>, node: Node<'a>) {
        if strong.is_none() && weak.is_none() {
            return;
        }
        let (before_strong, before_weak) = match part.take() {
            None => (None, None),
            Some(Split::Both(value)) => (Some(value.clone()), Some(value)),
            Some(Split::Each(strong, weak)) => (strong, weak),
        };
        if (strong.is_some() && before_strong.is_some()) || (weak.is_some() && before_weak.is_some()) {
            self.twice(node);
        }
        *part = Some(Split::Each(strong.or(before_strong), weak.or(before_weak)));
    }

    /// Adds what a `handconfig` says of both hands.
    pub(super) fn add(&mut self, posture: &mut Posture, config: Config, node: Node<'a>) {
        self.whole(&mut posture.shape, config.shape, node);
        self.whole(&mut posture.fingers, config.fingers, node);
        self.whole(&mut posture.palm, config.palm, node);
    }

    fn whole<T>(&mut self, part: &mut Option<Split<T>>, value: Option<T>, node: Node<'a>) {
        if let Some(value) = value {
            if part.is_some() {
                self.twice(node);
            }
            *part = Some(Split::Both(value));
        }
    }

    fn twice(&mut self, node: Node<'a>) {
        let told = self.warning(tag_span(node), "the posture is said twice: the later one is read");
        self.say(told.label("this one"));
    }
}
