//! Hand shapes: a class with thumb and bend, then fingers.
//!
//! ```text
//! shape = class {thumb | bend | etc} [between class {thumb | bend}] {finger} {digit bend} {digit part digit} [special]
//! special = between finger finger | between | thumb | part
//! ```

use super::cursor::Parser;
use crate::notation::hamnosys::kind::Kind;
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Digit;

impl Parser {
    /// Reads a shape; its class is here.
    pub(super) fn shape(&mut self, class: ShapeClass) -> Shape {
        let mut shape = Shape::of(class);
        self.next();
        self.class_modifiers(&mut shape, Halfway::No);
        if let (Some(Kind::Between), Some(Kind::Class(class))) = (self.peek(), self.ahead(1)) {
            self.at += 2;
            shape.between = Some(BentClass { class, thumb: None, bend: None });
            self.class_modifiers(&mut shape, Halfway::Yes);
        }
        while self.digits(&mut shape) {}
        shape
    }

    /// Thumb, bend and `hametc` after a class.
    fn class_modifiers(&mut self, shape: &mut Shape, halfway: Halfway) {
        loop {
            let class = match (&mut shape.between, halfway) {
                (Some(between), Halfway::Yes) => between,
                (Some(_) | None, Halfway::No) | (None, Halfway::Yes) => &mut shape.main,
            };
            match self.peek() {
                Some(Kind::Thumb(thumb)) if class.thumb.is_none() => class.thumb = Some(thumb),
                Some(Kind::Bend(bend)) if class.bend.is_none() => class.bend = Some(bend),
                Some(Kind::Etc) if !shape.approximate => shape.approximate = true,
                Some(Kind::Thumb(_)) => {
                    self.skip("is a second position of the thumb");
                    continue;
                }
                _other => return,
            }
            self.next();
        }
    }

    /// Reads one thing that is said of digits, or a modifier that comes late; whether there was one.
    fn digits(&mut self, shape: &mut Shape) -> bool {
        match self.peek() {
            Some(Kind::Bend(bend)) => self.bend(shape, None, bend, 1),
            Some(Kind::Digit(digit)) => return self.digit(shape, digit),
            Some(Kind::Part(part)) if shape.thumb.is_none() && !self.place_ahead() => {
                shape.thumb = Some(ThumbSpecial::At(part));
                self.next();
            }
            Some(Kind::Between) if shape.thumb.is_none() => match (self.ahead(1), self.ahead(2)) {
                (Some(Kind::Digit(a)), Some(Kind::Digit(b))) => {
                    shape.thumb = Some(ThumbSpecial::Between(a, b));
                    self.at += 3;
                }
                (Some(Kind::Digit(a)), _) => {
                    self.warn("needs two fingers: the thumb is read as between this finger and the next");
                    let next = Digit::ALL[(a as usize + 1).min(4)];
                    shape.thumb = Some(ThumbSpecial::Between(a, next));
                    self.at += 2;
                }
                _other => {
                    shape.thumb = Some(ThumbSpecial::Enclosed);
                    self.next();
                }
            },
            Some(Kind::Etc) => {
                self.warn("belongs before the fingers");
                shape.approximate = true;
                self.next();
            }
            Some(Kind::Thumb(thumb)) => {
                self.warn("belongs before the fingers");
                self.late_thumb(shape, thumb);
                self.next();
            }
            _other => return false,
        }
        true
    }

    /// What begins with a digit: a bend of its own, a crossing, a finger of the list, or a thumb that is exempted.
    fn digit(&mut self, shape: &mut Shape, digit: Digit) -> bool {
        match (self.ahead(1), self.ahead(2)) {
            (Some(Kind::Bend(bend)), _) => self.bend(shape, Some(digit), bend, 2),
            (Some(Kind::Part(part)), Some(Kind::Digit(other))) if other != digit && !self.place_after_crossing() => {
                if shape.crossings.len() == 2 {
                    self.warn("is the third pair of digits that touch, and a shape has two; it is passed over");
                } else {
                    shape.crossings.push((digit, part, other));
                }
                self.at += 3;
            }
            _other if self.place_ahead() => return false,
            _other if digit == Digit::Thumb && shape.thumb.is_none() => {
                shape.thumb = Some(ThumbSpecial::Exempted);
                self.next();
            }
            _other if digit == Digit::Thumb || shape.fingers.iter().any(|f| f.finger == digit) => {
                self.skip("is said already");
            }
            _other => {
                shape.fingers.push(ListedFinger { finger: digit, opposed: false });
                self.next();
            }
        }
        true
    }

    fn bend(&mut self, shape: &mut Shape, digit: Option<Digit>, bend: Bend, symbols: usize) {
        let known = shape.bends.iter().any(|(d, _)| *d == digit);
        if known {
            self.warn("is a second bend of the same digit; it is passed over");
        } else {
            shape.bends.push((digit, bend));
        }
        self.at += symbols;
    }

    /// A thumb that comes late.
    pub(super) fn late_thumb(&mut self, shape: &mut Shape, thumb: Thumb) {
        let class = shape.between.as_mut().unwrap_or(&mut shape.main);
        class.thumb = class.thumb.or(Some(thumb));
    }

    /// Whether the digits and parts here are a place, because a contact, a side or a face follows them, or a name of a place.
    fn place_ahead(&self) -> bool {
        let mut at = self.at;
        while matches!(self.kind(at), Some(Kind::Digit(_) | Kind::Part(_))) {
            at += 1;
        }
        match self.kind(at) {
            Some(Kind::Contact(_) | Kind::NamesPlace | Kind::NamedPlace | Kind::Hand(_) | Kind::Behind) => true,
            // A side may also belong to the place that follows.
            Some(Kind::At | Kind::Beside) => !matches!(self.kind(at + 1), Some(Kind::Body(_) | Kind::Arm(_))),
            _other => false,
        }
    }

    /// Whether `digit part digit` is no crossing but a place, because a contact follows.
    fn place_after_crossing(&self) -> bool {
        matches!(self.kind(self.at + 3), Some(Kind::Contact(_) | Kind::NamesPlace | Kind::NamedPlace))
    }
}

/// Whether what is read belongs to the class after `hambetween`.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Halfway {
    No,
    Yes,
}
