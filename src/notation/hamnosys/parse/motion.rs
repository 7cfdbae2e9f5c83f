//! Single movements: straight and bent paths, circles, the wrist, the fingers, new postures.
//!
//! ```text
//! straight = arrow [arrow] [between arrow] [size] {arc [arc] [size] | wave [size] [ellipse] | growth [size]}
//! circle   = circle [circle] [between circle] [size] {clock | clockfull [clockfull] | clock} [ellipse [size]] [wave …] [growth …]
//! move     = (straight | circle | wrist [size] | fingerplay {digit} | replace [growth] posture | nomotion)
//!            {manner | seq( brushing place ) | digit coreftag}
//! ```

use super::cursor::{Parser, Read};
use super::posture::{Stage, corner};
use crate::notation::hamnosys::kind::{Bracket, Kind, Manner};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::roll::Roll;
use crate::phonology::{Direction, Size};

impl Parser {
    /// Reads a movement, which is here.
    pub(super) fn single_move(&mut self) -> Read<Move> {
        let start = self.span();
        let motion = match self.peek() {
            Some(Kind::Arrow(direction)) => Motion::Straight(self.straight(direction)),
            Some(Kind::Circle(axis)) => Motion::Circle(self.circle(axis)),
            Some(Kind::Wrist(wrist)) => {
                self.next();
                Motion::Wrist(wrist, self.size())
            }
            Some(Kind::FingerPlay) => self.finger_play(),
            Some(Kind::Replace) => self.replacement()?,
            Some(Kind::Crossing) => {
                self.warn("is obsolete: the arms cross");
                self.next();
                Motion::Cross
            }
            Some(Kind::Nothing) => {
                self.next();
                Motion::Nothing
            }
            _other => return self.unexpected(&["a movement"]),
        };
        let mut one = Move::of(motion);
        while self.said_of_move(&mut one)? {}
        one.span = Ignored(start.to(self.span_before()));
        Ok(one)
    }

    /// Reads one thing that is said of a movement; whether there was one.
    fn said_of_move(&mut self, one: &mut Move) -> Read<bool> {
        match (self.peek(), self.ahead(1)) {
            (Some(Kind::Manner(manner)), _) => set_manner(one, manner),
            (Some(Kind::Open(Bracket::Sequence)), Some(Kind::Brushing)) => {
                let site = self.inside(|p| {
                    p.next();
                    p.site()
                })?;
                self.brushed(one, site);
                return Ok(true);
            }
            (Some(Kind::Brushing), _) => {
                self.warn("stands in `hamseqbegin` … `hamseqend` with the place brushed; it is read as if it did");
                self.next();
                if self.site_ahead() {
                    let site = self.site()?;
                    self.brushed(one, site);
                }
                return Ok(true);
            }
            (Some(Kind::Digit(digit)), Some(Kind::NamesPlace)) | (Some(Kind::NamesPlace), Some(Kind::Digit(digit))) => {
                one.names = Some((digit as u8 + 1).to_string());
                self.next();
            }
            (Some(_) | None, _) => return Ok(self.late_detail(&mut one.motion)),
        }
        self.next();
        Ok(true)
    }

    fn brushed(&mut self, one: &mut Move, site: Site) {
        if one.brushing.is_some() {
            let span = self.span_before();
            self.warn_at(span, "this movement brushes a second place", "passed over");
        } else {
            one.brushing = Some(site);
        }
    }

    /// What belongs directly to a motion, but comes after its manner.
    fn late_detail(&mut self, motion: &mut Motion) -> bool {
        match motion {
            Motion::Straight(straight) => self.straight_detail(straight),
            Motion::Circle(circle) => self.circle_detail(circle),
            Motion::Wrist(_, size) => match self.peek() {
                Some(Kind::Size(here)) if *size == Size::Normal => {
                    *size = here;
                    self.next();
                    true
                }
                _other => false,
            },
            Motion::Nothing | Motion::FingerPlay(_) | Motion::Replace(_) | Motion::Cross => false,
        }
    }

    /// A size, if one is here.
    pub(super) fn size(&mut self) -> Size {
        match self.peek() {
            Some(Kind::Size(size)) => {
                self.next();
                size
            }
            _other => Size::Normal,
        }
    }

    /// Growth with its size, if it is here.
    pub(super) fn growth(&mut self) -> Option<Growth> {
        let Some(Kind::Growth(change)) = self.peek() else { return None };
        self.next();
        Some(Growth { change, size: self.size() })
    }

    fn straight(&mut self, first: Direction) -> Straight {
        let direction = self.corner_of(first, arrow);
        let mut straight =
            Straight { direction, size: self.size(), between: None, arc: None, waves: None, growth: None };
        while self.straight_detail(&mut straight) {}
        straight
    }

    /// The direction of one symbol, or of two that make a corner: both then say two axes, and go with each other.
    fn corner_of(&mut self, first: Direction, of: fn(Option<Kind>) -> Option<Direction>) -> Direction {
        self.next();
        let axes = |d: Direction| d.signs().iter().filter(|s| **s != 0).count();
        let second = of(self.peek()).filter(|second| axes(first) == 2 && axes(*second) == 2);
        match second.and_then(|second| corner(first, second)) {
            Some(corner) => {
                self.next();
                corner
            }
            None => first,
        }
    }

    fn straight_detail(&mut self, straight: &mut Straight) -> bool {
        match (self.peek(), self.ahead(1)) {
            (Some(Kind::Between), Some(Kind::Arrow(second))) if straight.between.is_none() => {
                self.next();
                straight.between = Some(self.corner_of(second, arrow));
                self.second_size(&mut straight.size);
            }
            (Some(Kind::Arc(roll)), _) if straight.arc.is_none() => {
                self.next();
                let roll = match self.peek() {
                    Some(Kind::Arc(second)) if diagonal(roll, second).is_some() => {
                        self.next();
                        diagonal(roll, second).unwrap_or(roll)
                    }
                    _other => roll,
                };
                straight.arc = Some((roll, self.size()));
            }
            (Some(Kind::Arc(_)), _) => self.skip("is a second arc of the same path"),
            (Some(Kind::Size(_)), _) => self.second_size(&mut straight.size),
            (Some(Kind::Etc), _) => self.skip("says that the movement is approximate, which is not kept"),
            _other => return self.waves_or_growth(&mut straight.waves, &mut straight.growth),
        }
        true
    }

    /// A size after the direction between, or too many of them.
    fn second_size(&mut self, size: &mut Size) {
        match self.peek() {
            Some(Kind::Size(here)) if *size == Size::Normal => {
                *size = here;
                self.next();
            }
            Some(Kind::Size(_)) => self.skip("is a second size of the same movement"),
            _other => {}
        }
    }

    fn waves_or_growth(&mut self, waves: &mut Option<Waves>, growth: &mut Option<Growth>) -> bool {
        match (self.peek(), waves) {
            (Some(Kind::Wave(style)), waves @ None) => {
                self.next();
                *waves = Some(Waves { style, size: self.size(), plane: None });
            }
            (Some(Kind::Wave(_)), Some(_)) => self.skip("is a second kind of waves"),
            (Some(Kind::Ellipse(plane)), Some(waves)) if waves.plane.is_none() => {
                self.next();
                waves.plane = Some(plane);
            }
            (Some(Kind::Ellipse(_)), _) => self.skip("belongs to waves or to a circle"),
            (Some(Kind::Growth(_)), _) if growth.is_none() => *growth = self.growth(),
            _other => return false,
        }
        true
    }

    fn circle(&mut self, first: Direction) -> Circle {
        let axis = self.corner_of(first, circle);
        let mut round = Circle {
            axis,
            size: self.size(),
            between: None,
            start: None,
            full: None,
            end: None,
            ellipse: None,
            waves: None,
            growth: None,
        };
        while self.circle_detail(&mut round) {}
        round
    }

    fn circle_detail(&mut self, round: &mut Circle) -> bool {
        match (self.peek(), self.ahead(1)) {
            (Some(Kind::Between), Some(Kind::Circle(second))) if round.between.is_none() => {
                self.next();
                round.between = Some(self.corner_of(second, circle));
                self.second_size(&mut round.size);
            }
            (Some(Kind::Clock(clock)), _) => {
                match (round.start, round.full, round.end) {
                    (None, None, None) => round.start = Some(clock),
                    (_, _, None) => round.end = Some(clock),
                    (_, _, Some(_)) => self.warn("is one place on the clock too many; it is passed over"),
                }
                self.next();
            }
            (Some(Kind::FullTurn), _) => {
                match round.full {
                    None => round.full = Some(Times::Once),
                    Some(Times::Once) => round.full = Some(Times::Twice),
                    Some(Times::Twice) => self.warn("is one full turn too many; it is passed over"),
                }
                self.next();
            }
            (Some(Kind::Ellipse(ellipse)), _) if round.ellipse.is_none() && round.waves.is_none() => {
                self.next();
                round.ellipse = Some((ellipse, self.size()));
            }
            (Some(Kind::Size(_)), _) => self.second_size(&mut round.size),
            (Some(Kind::Etc), _) => self.skip("says that the movement is approximate, which is not kept"),
            _other => return self.waves_or_growth(&mut round.waves, &mut round.growth),
        }
        true
    }

    fn finger_play(&mut self) -> Motion {
        self.next();
        let mut digits = Vec::new();
        while let (Some(Kind::Digit(digit)), next) = (self.peek(), self.ahead(1)) {
            // Digits with more than themselves are the place where the fingers play.
            if matches!(next, Some(Kind::Contact(_) | Kind::Part(_) | Kind::NamesPlace | Kind::NamedPlace)) {
                break;
            }
            digits.push(digit);
            self.next();
        }
        Motion::FingerPlay(digits)
    }

    fn replacement(&mut self) -> Read<Motion> {
        self.next();
        let mut successive = self.successive();
        let (mut posture, mut stage) = (Posture::default(), Stage::Nothing);
        loop {
            if self.splits_postures() {
                let (open, before) = (self.span(), posture.is_empty());
                if let Some(_sites) = self.split_posture(&mut posture)? {
                    self.warn_at(open, "places stand in the brackets of a new posture", "they are passed over");
                }
                if before && posture.is_empty() {
                    break;
                }
            } else if !self.posture_part(&mut posture, &mut stage)? {
                break;
            }
        }
        if successive.is_none() && matches!(self.peek(), Some(Kind::Growth(_))) {
            self.warn("belongs directly after `hamreplace`");
            successive = self.successive();
        }
        match (&mut posture.shape, successive) {
            (Some(Split::Both(shape)), Some(_)) => shape.successive = successive,
            (Some(Split::Each(strong, weak)), Some(_)) => {
                strong.iter_mut().chain(weak).for_each(|shape| shape.successive = successive);
            }
            (None, Some(_)) => {
                let span = self.span_before();
                self.warn_at(span, "fingers that change one after the other need a new hand shape", "passed over");
            }
            (Some(_) | None, None) => {}
        }
        if posture.is_empty() && !self.location_ahead() {
            let span = self.span_before();
            self.warn_at(span, "`hamreplace` says no new posture", "nothing changes");
        }
        Ok(Motion::Replace(posture))
    }

    fn successive(&mut self) -> Option<Successive> {
        let growth = self.growth()?;
        Some(match growth.change {
            Change::Increasing => Successive::TowardPinky,
            Change::Decreasing => Successive::TowardThumb,
        })
    }
}

/// Sets how a movement is made.
pub(super) fn set_manner(one: &mut Move, manner: Manner) {
    match manner {
        Manner::Fast => one.fast = true,
        Manner::Slow => one.slow = true,
        Manner::Tense => one.tense = true,
        Manner::Rest => one.rest = true,
        Manner::Halt => one.halt = true,
    }
}

fn arrow(kind: Option<Kind>) -> Option<Direction> {
    match kind {
        Some(Kind::Arrow(direction)) => Some(direction),
        _other => None,
    }
}

fn circle(kind: Option<Kind>) -> Option<Direction> {
    match kind {
        Some(Kind::Circle(axis)) => Some(axis),
        _other => None,
    }
}

/// The diagonal between two arcs.
fn diagonal(a: Roll, b: Roll) -> Option<Roll> {
    let tag = |x: &str, y: &str| Roll::from_tag(&format!("{x}{y}"));
    tag(a.tag(), b.tag()).or_else(|| tag(b.tag(), a.tag()))
}
