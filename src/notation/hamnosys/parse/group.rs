//! What a bracket is for: a look at what it holds says it.

use super::cursor::Parser;
use crate::notation::hamnosys::kind::{Bracket, Kind};

/// What parallel brackets hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Holds {
    /// Shapes, finger directions, palms: a split posture, perhaps with places.
    Postures,
    /// Places: a split location or the points of two hands.
    Places,
    /// Movements.
    Actions,
    /// Nothing that tells.
    Nothing,
}

impl Parser {
    /// What the bracket here holds.
    pub(super) fn holds(&self) -> Holds {
        let Some(Kind::Open(_)) = self.peek() else { return Holds::Nothing };
        let close = self.closing(self.at);
        let mut first = Holds::Nothing;
        for at in self.at + 1..close {
            let here = match self.kind(at) {
                Some(kind) if is_motion(kind) => return Holds::Actions,
                // No motion is a side that does nothing, or a movement of which more is said.
                Some(Kind::Nothing) if !matches!(self.kind(at + 1), Some(Kind::Plus | Kind::Close(_)) | None) => {
                    return Holds::Actions;
                }
                Some(Kind::Open(_)) if self.body_action_at(at) => return Holds::Actions,
                Some(Kind::Class(_) | Kind::Fingers(_) | Kind::Palm(_)) => Holds::Postures,
                Some(
                    Kind::Body(_)
                    | Kind::Arm(_)
                    | Kind::Hand(_)
                    | Kind::Digit(_)
                    | Kind::Part(_)
                    | Kind::Neutral
                    | Kind::NamedPlace
                    | Kind::Contact(_),
                ) => Holds::Places,
                _other => Holds::Nothing,
            };
            if first == Holds::Nothing {
                first = here;
            }
        }
        if first == Holds::Nothing && (self.at + 1..close).any(|at| self.kind(at) == Some(Kind::Nothing)) {
            return Holds::Actions;
        }
        first
    }

    /// Whether parallel brackets open here that split postures.
    pub(super) fn splits_postures(&self) -> bool {
        self.opens(Bracket::Together) && self.holds() == Holds::Postures
    }

    /// Whether parallel brackets open here that hold places.
    pub(super) fn splits_places(&self) -> bool {
        self.opens(Bracket::Together) && self.holds() == Holds::Places
    }

    /// Whether `seq( bodypart action )` opens here.
    pub(super) fn body_action_ahead(&self) -> bool {
        self.body_action_at(self.at)
    }

    fn body_action_at(&self, open: usize) -> bool {
        let mut at = match self.kind(open + 1) {
            Some(Kind::At | Kind::Beside) => open + 2,
            _other => open + 1,
        };
        if !matches!(self.kind(open), Some(Kind::Open(_))) || !matches!(self.kind(at), Some(Kind::Body(_) | Kind::Arm(_))) {
            return false;
        }
        at += 1;
        while matches!(self.kind(at), Some(Kind::At | Kind::Beside | Kind::Etc | Kind::Hand(_))) {
            at += 1;
        }
        match self.kind(at) {
            Some(Kind::Open(_) | Kind::Nothing) => true,
            Some(kind) => is_motion(kind),
            None => false,
        }
    }
}

/// Whether a symbol begins a movement.
pub(super) fn is_motion(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Arrow(_)
            | Kind::Circle(_)
            | Kind::Wrist(_)
            | Kind::FingerPlay
            | Kind::Replace
            | Kind::Crossing
            | Kind::Brushing
    )
}
