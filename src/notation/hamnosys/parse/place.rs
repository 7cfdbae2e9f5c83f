//! Places of body, arm and hand.
//!
//! ```text
//! body level = [side] place [etc] [face] [side] [between …]
//! hand level = (hand | digits [part] | part [digits]) [etc] [face] [side] [between …]
//! ```
//! A side before the place is the left one, after it the right one.

use super::cursor::{Parser, Read};
use crate::notation::hamnosys::kind::Kind;
use crate::notation::hamnosys::syntax::*;

impl Parser {
    /// A side before a place, if one is here and a place follows.
    pub(super) fn side_before(&mut self) -> Option<Side> {
        let side = match self.peek() {
            Some(Kind::At) => Side::LeftAt,
            Some(Kind::Beside) => Side::LeftBeside,
            _other => return None,
        };
        self.next();
        Some(side)
    }

    /// Reads places of body or arm, the first of which is here (after its side).
    pub(super) fn body_levels(&mut self) -> Read<BodyLevels> {
        let first = self.body_level()?;
        let between = match self.between_ahead() {
            Some(Kind::Body(_) | Kind::Arm(_)) => {
                self.next();
                Some(self.body_level()?)
            }
            _other => None,
        };
        Ok(BodyLevels { first, between })
    }

    /// The kind of the place after `hambetween` here, sides passed over.
    fn between_ahead(&self) -> Option<Kind> {
        match (self.peek(), self.ahead(1)) {
            (Some(Kind::Between), Some(Kind::At | Kind::Beside)) => self.ahead(2),
            (Some(Kind::Between), kind) => kind,
            _other => None,
        }
    }

    /// Reads a place of body or arm.
    pub(super) fn body_level(&mut self) -> Read<BodyLevel> {
        let side = self.side_before();
        let (Some(Kind::Body(place)) | Some(Kind::Arm(place))) = self.peek() else {
            return self.unexpected(&["a place of the body"]);
        };
        let arm = matches!(self.peek(), Some(Kind::Arm(_)));
        self.next();
        let mut level = BodyLevel { place: place.to_owned(), approximate: false, side, face: None };
        loop {
            match self.peek() {
                Some(Kind::Etc) => {
                    level.approximate = true;
                    self.next();
                }
                Some(Kind::Hand(tag)) if arm && level.face.is_none() => match face(tag) {
                    Some(face) => {
                        level.face = Some(face);
                        self.next();
                    }
                    None => return Ok(level),
                },
                Some(Kind::At | Kind::Beside) => self.side_after(&mut level.side),
                _other => return Ok(level),
            }
        }
    }

    /// A side after a place.
    fn side_after(&mut self, side: &mut Option<Side>) {
        if side.is_some() {
            return self.skip("is a second side of the same place");
        }
        *side = Some(match self.peek() {
            Some(Kind::At) => Side::RightAt,
            _beside => Side::RightBeside,
        });
        self.next();
    }

    /// Reads parts of a hand, the first of which is here (after its side).
    pub(super) fn hand_levels(&mut self) -> Read<HandLevels> {
        let first = self.hand_level()?;
        let between = match self.between_ahead() {
            Some(Kind::Hand(_) | Kind::Digit(_) | Kind::Part(_) | Kind::Arm(_)) => {
                self.next();
                Some(self.hand_level()?)
            }
            _other => None,
        };
        Ok(HandLevels { first, between })
    }

    /// Reads a part of a hand.
    pub(super) fn hand_level(&mut self) -> Read<HandLevel> {
        let side = self.side_before();
        let part = match self.peek() {
            Some(Kind::Hand(tag) | Kind::Arm(tag)) => {
                self.next();
                HandPlace::Hand(tag.to_owned())
            }
            Some(Kind::Digit(_) | Kind::Part(_)) => self.digits_and_part(),
            _other => return self.unexpected(&["a part of the hand"]),
        };
        let mut level = HandLevel { part, approximate: false, side, face: None };
        loop {
            match self.peek() {
                Some(Kind::Etc) => {
                    level.approximate = true;
                    self.next();
                }
                Some(Kind::Hand(tag)) if level.face.is_none() => match face(tag) {
                    Some(face) => {
                        level.face = Some(face);
                        self.next();
                    }
                    None => return Ok(level),
                },
                Some(Kind::At | Kind::Beside) => self.side_after(&mut level.side),
                _other => return Ok(level),
            }
        }
    }

    /// Digits and a part of them, in either order.
    fn digits_and_part(&mut self) -> HandPlace {
        let (mut digits, mut part) = (Vec::new(), None);
        loop {
            match (self.peek(), self.ahead(1)) {
                (Some(Kind::Digit(_)), Some(Kind::NamesPlace | Kind::NamedPlace)) => break,
                (Some(Kind::Digit(digit)), _) if digits.contains(&digit) => self.skip("is said already"),
                (Some(Kind::Digit(digit)), _) => {
                    digits.push(digit);
                    self.next();
                }
                (Some(Kind::Part(here)), _) if part.is_none() => {
                    part = Some(here);
                    self.next();
                }
                (Some(Kind::Part(_)), _) => self.skip("is a second part of the same finger"),
                _other => break,
            }
        }
        HandPlace::Digits(digits, part)
    }
}

/// The face of hand or arm that a symbol says after a place.
fn face(tag: &str) -> Option<Face> {
    match tag {
        "palm" => Some(Face::Palmar),
        "handback" => Some(Face::Dorsal),
        _other => None,
    }
}
