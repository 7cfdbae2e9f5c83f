//! Postures: a shape, where the fingers point, where the palm faces; for both hands or one each.
//!
//! ```text
//! posture = {shape | fingers | palm | split}
//! fingers = direction [direction] [between direction [direction]] [relative]
//! palm    = palm [between palm] [etc] [relative]
//! split   = par( {shape | fingers | palm | place} plus {shape | fingers | palm | place} )
//! ```
//! The order that HamNoSys wants is shape, fingers, palm; another is read with a warning.

use super::cursor::{Handed, Parser, Read};
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Direction;

/// What one side of a split says.
#[derive(Debug, Default)]
pub(super) struct SideOfSplit {
    shape: Option<Shape>,
    fingers: Option<Fingers>,
    palm: Option<Palm>,
    pub site: Option<Site>,
}

impl SideOfSplit {
    /// Whether it says nothing of shape, fingers and palm.
    pub fn posture_is_empty(&self) -> bool {
        self.shape.is_none() && self.fingers.is_none() && self.palm.is_none()
    }
}

/// What a posture's part comes after, for warnings of order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd)]
pub(super) enum Stage {
    Nothing,
    Shape,
    Fingers,
    Palm,
    Place,
}

impl Parser {
    /// Reads one part of a posture into it, if one is here; whether there was one. `stage` is how far the parts are.
    pub(super) fn posture_part(&mut self, posture: &mut Posture, stage: &mut Stage) -> Read<bool> {
        match self.peek() {
            Some(Kind::Class(class)) if posture.shape.is_none() => {
                self.in_order(stage, Stage::Shape);
                posture.shape = Some(Split::Both(self.shape(class)));
            }
            Some(Kind::Fingers(_)) if posture.fingers.is_none() => {
                self.in_order(stage, Stage::Fingers);
                posture.fingers = Some(Split::Both(self.fingers()));
            }
            Some(Kind::Palm(_)) if posture.palm.is_none() => {
                self.in_order(stage, Stage::Palm);
                posture.palm = Some(Split::Both(self.palm()));
            }
            Some(Kind::Thumb(_) | Kind::Bend(_)) => return Ok(self.late_modifier(posture)),
            _other => return Ok(false),
        }
        Ok(true)
    }

    /// Warns where a part stands after one that it belongs before.
    pub(super) fn in_order(&mut self, stage: &mut Stage, here: Stage) {
        if here < *stage {
            let before = match stage {
                Stage::Nothing | Stage::Shape => "the hand shape",
                Stage::Fingers => "the finger direction",
                Stage::Palm => "the palm",
                Stage::Place => "the place",
            };
            self.warn(&format!("belongs before {before}; it is read as if it stood there"));
        } else {
            *stage = here;
        }
    }

    /// A thumb or a bend that stands after the directions.
    fn late_modifier(&mut self, posture: &mut Posture) -> bool {
        let Some(shapes) = &mut posture.shape else { return false };
        let kind = self.peek();
        let set = |shape: &mut Shape| {
            let class = shape.between.as_mut().unwrap_or(&mut shape.main);
            match kind {
                Some(Kind::Thumb(thumb)) => class.thumb = class.thumb.or(Some(thumb)),
                Some(Kind::Bend(bend)) => class.bend = class.bend.or(Some(bend)),
                _other => {}
            }
        };
        match shapes {
            Split::Both(shape) => set(shape),
            Split::Each(strong, weak) => strong.iter_mut().chain(weak).for_each(set),
        }
        self.warn("belongs directly after the hand shape; it is read as if it stood there");
        self.next();
        true
    }

    /// Reads a finger direction, which is here.
    pub(super) fn fingers(&mut self) -> Fingers {
        let direction = self.finger_direction().unwrap_or(Direction::UP);
        let mut fingers = Fingers { direction, between: None, relative: false };
        loop {
            match (self.peek(), self.ahead(1)) {
                (Some(Kind::Between), Some(Kind::Fingers(_))) => {
                    self.next();
                    fingers.between = self.finger_direction();
                }
                (
                    Some(Kind::Between),
                    Some(Kind::Palm(_) | Kind::Body(_) | Kind::Arrow(_) | Kind::Contact(_)) | None,
                ) => {
                    self.skip("has no second finger direction after it");
                }
                (Some(Kind::Fingers(other)), _) if fingers.between.is_none() && near(direction, other) => {
                    self.warn("follows another finger direction: the fingers are read as halfway between the two");
                    fingers.between = self.finger_direction();
                }
                (Some(Kind::Fingers(_)), _) if !self.in_unsplit_brackets() => {
                    self.skip("is one finger direction too many")
                }
                (Some(Kind::Relative), _) => {
                    fingers.relative = true;
                    self.next();
                }
                (Some(Kind::Etc), _) => self.skip("says that the finger direction is approximate, which is not kept"),
                _other => return fingers,
            }
        }
    }

    /// One of the 26 directions: a symbol, or two for a corner.
    fn finger_direction(&mut self) -> Option<Direction> {
        let Some(Kind::Fingers(first)) = self.peek() else { return None };
        self.next();
        let Some(Kind::Fingers(second)) = self.peek() else { return Some(first) };
        let Some(corner) = corner(first, second) else { return Some(first) };
        self.next();
        Some(corner)
    }

    /// Reads a palm, which is here.
    pub(super) fn palm(&mut self) -> Palm {
        let facing = self.facing().unwrap_or(Facing::Toward(Direction::DOWN));
        let mut palm = Palm { facing, between: None, relative: false, approximate: false };
        loop {
            match (self.peek(), self.ahead(1)) {
                (Some(Kind::Between), Some(Kind::Palm(_))) => {
                    self.next();
                    palm.between = self.facing();
                }
                (
                    Some(Kind::Between),
                    Some(Kind::Fingers(_) | Kind::Body(_) | Kind::Arrow(_) | Kind::Contact(_)) | None,
                ) => {
                    self.skip("has no second palm after it");
                }
                (Some(Kind::Palm(_)), _) if palm.between.is_none() && !self.in_unsplit_brackets() => {
                    self.warn("follows another palm: the palm is read as halfway between the two");
                    palm.between = self.facing();
                }
                (Some(Kind::Palm(_)), _) if !self.in_unsplit_brackets() => self.skip("is one palm too many"),
                (Some(Kind::Relative), _) => {
                    palm.relative = true;
                    self.next();
                }
                (Some(Kind::Etc), _) => {
                    palm.approximate = true;
                    self.next();
                }
                _other => return palm,
            }
        }
    }

    fn facing(&mut self) -> Option<Facing> {
        let Some(Kind::Palm(roll)) = self.peek() else { return None };
        self.next();
        Some(Facing::Roll(roll))
    }

    /// Reads a split posture, whose bracket is here, into a posture; the places of its sides come back.
    pub(super) fn split_posture(&mut self, posture: &mut Posture) -> Read<Option<(Option<Site>, Option<Site>)>> {
        let (strong, weak) = self.sides()?;
        let Some(weak) = weak else {
            put(&mut posture.shape, strong.shape.map(Split::Both));
            put(&mut posture.fingers, strong.fingers.map(Split::Both));
            put(&mut posture.palm, strong.palm.map(Split::Both));
            return Ok(strong.site.map(|site| (Some(site), None)));
        };
        self.handed = Handed::Two;
        put(&mut posture.shape, each(strong.shape, weak.shape));
        put(&mut posture.fingers, each(strong.fingers, weak.fingers));
        put(&mut posture.palm, each(strong.palm, weak.palm));
        Ok((strong.site.is_some() || weak.site.is_some()).then_some((strong.site, weak.site)))
    }

    /// Reads the two sides of a bracket that splits; one where nothing splits it.
    pub(super) fn sides(&mut self) -> Read<(SideOfSplit, Option<SideOfSplit>)> {
        let open = self.at;
        self.inside(|p| {
            let strong = p.side()?;
            if p.at < p.limit && !p.take(Kind::Plus) {
                if p.plus_ahead(p.at, p.limit).is_some() {
                    p.unexpected::<()>(&["`hamplus`"])?;
                }
                p.warn("begins what the weak hand does, and `hamplus` is missing before it");
            } else if p.at == p.limit && p.kind(p.at.saturating_sub(1)) != Some(Kind::Plus) {
                let (at, here) = (p.at, p.limit);
                p.at = open;
                p.warn("has no `hamplus` inside: brackets around one posture or place say nothing");
                (p.at, p.limit) = (at, here);
                return Ok((strong, None));
            }
            let weak = p.side()?;
            if p.peek() == Some(Kind::Plus) {
                p.fault::<()>(
                    "stands here for the second time",
                    "a split has two parts: the strong hand and the weak",
                )?;
            }
            Ok((strong, Some(weak)))
        })
    }

    /// Reads one side of a split.
    fn side(&mut self) -> Read<SideOfSplit> {
        let mut side = SideOfSplit::default();
        loop {
            match self.peek() {
                Some(Kind::Class(class)) if side.shape.is_none() => side.shape = Some(self.shape(class)),
                Some(Kind::Fingers(_)) if side.fingers.is_none() => side.fingers = Some(self.fingers()),
                Some(Kind::Palm(_)) if side.palm.is_none() => side.palm = Some(self.palm()),
                Some(Kind::Nothing) => self.next(),
                Some(Kind::Thumb(thumb)) if side.shape.is_some() => {
                    self.warn("belongs directly after the hand shape; it is read as if it stood there");
                    if let Some(shape) = &mut side.shape {
                        shape.main.thumb = shape.main.thumb.or(Some(thumb));
                    }
                    self.next();
                }
                Some(Kind::Open(Bracket::Together)) => {
                    self.warn("is one bracket too many; what it holds is read as if it were not there");
                    let inner = self.inside(Parser::side)?;
                    put(&mut side.shape, inner.shape);
                    put(&mut side.fingers, inner.fingers);
                    put(&mut side.palm, inner.palm);
                    put(&mut side.site, inner.site);
                }
                Some(_) if side.site.is_none() && self.site_ahead() => side.site = Some(self.site()?),
                _other => return Ok(side),
            }
        }
    }
}

/// The corner that two directions make together.
pub(super) fn corner(a: Direction, b: Direction) -> Option<Direction> {
    let mut joined = [0; 3];
    for ((j, a), b) in joined.iter_mut().zip(a.signs()).zip(b.signs()) {
        if a * b < 0 {
            return None;
        }
        *j = if a == 0 { b } else { a };
    }
    if joined.contains(&0) {
        return None;
    }
    Direction::new(joined[0], joined[1], joined[2])
}

/// Whether two directions are less than a right angle apart, or at one.
fn near(a: Direction, b: Direction) -> bool {
    a != b && a.vector().dot(b.vector()) > -1e-9
}

fn each<T>(strong: Option<T>, weak: Option<T>) -> Option<Split<T>> {
    (strong.is_some() || weak.is_some()).then_some(Split::Each(strong, weak))
}

/// Puts a value where there is none.
fn put<T>(place: &mut Option<T>, value: Option<T>) {
    if place.is_none() {
        *place = value;
    }
}
