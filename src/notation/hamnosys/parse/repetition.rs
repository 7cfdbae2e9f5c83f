//! Repetition: how often and how an action comes back.
//!
//! ```text
//! repetition = kind [kind] [etc] [growth [size]] | seq( kind [kind] [etc] [growth] arrow [size] [growth [size]] )
//! ```

use super::cursor::{Parser, Read};
use super::posture::corner;
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::syntax::*;

impl Parser {
    /// Whether a repetition begins here.
    pub(super) fn repetition_ahead(&self) -> bool {
        match self.peek() {
            Some(Kind::Repeat(_)) => true,
            Some(Kind::Open(Bracket::Sequence)) => matches!(self.ahead(1), Some(Kind::Repeat(_))),
            _other => false,
        }
    }

    /// Reads a repetition, which is here.
    pub(super) fn repetition(&mut self) -> Read<Repetition> {
        if self.opens(Bracket::Sequence) {
            return self.inside(|p| {
                let mut repetition = p.repetition()?;
                repetition.shift = p.shift();
                Ok(repetition)
            });
        }
        let Some(Kind::Repeat(kind)) = self.peek() else { return self.unexpected(&["a repetition"]) };
        self.next();
        let mut repetition = Repetition::of(kind);
        if let Some(Kind::Repeat(second)) = self.peek() {
            repetition.second = Some(second);
            self.next();
        }
        if self.take(Kind::Etc) {
            repetition.approximate = true;
            while let Some(Kind::Ellipse(_)) = self.peek() {
                self.skip("says where the repetitions lie, which is not kept");
            }
        }
        repetition.growth = self.growth();
        Ok(repetition)
    }

    /// The arrow along which repetitions move on.
    fn shift(&mut self) -> Option<Shift> {
        let Some(Kind::Arrow(mut direction)) = self.peek() else { return None };
        self.next();
        if let Some(Kind::Arrow(second)) = self.peek()
            && let Some(both) = corner(direction, second)
        {
            direction = both;
            self.next();
        }
        let size = self.size();
        Some(Shift { direction, size, growth: self.growth() })
    }
}
