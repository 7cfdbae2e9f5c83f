//! Actions as symbols.

use super::Writer;
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::syntax::*;

/// Whether brackets are put around an action.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Brackets {
    No,
    Yes,
}

impl Writer {
    /// Writes what parts of the body do at the start.
    pub(super) fn body_actions(&mut self, actions: &[Action]) {
        for action in actions {
            if !matches!(action, Action::OfBody(..)) {
                self.cannot("HamNoSys has only actions of body parts before the posture");
            }
            self.action(action);
        }
    }

    /// Writes the actions of a phase that begins at an index.
    pub(super) fn actions_of_phase(&mut self, actions: &[Action], begin: usize) {
        let [first, rest @ ..] = actions else { return };
        // At the very beginning, no motion would say that a hand holds over, and a body part that it acts before.
        let at_beginning = self.out.len() == begin || matches!(self.last(), Some(Kind::Symmetry(_) | Kind::Weak | Kind::NonIpsi));
        let bare = self.out[begin..].iter().all(|s| !matches!(s.kind(), Kind::Class(_) | Kind::Fingers(_) | Kind::Palm(_)));
        let symbols = self.apart(|w| w.action(first));
        let starts = symbols.first().map(|symbol| symbol.kind());
        let confused = match starts {
            Some(Kind::Nothing) => at_beginning,
            Some(Kind::Open(_)) => bare && matches!(first, Action::OfBody(..)),
            Some(_) | None => false,
        };
        let confused = confused || matches!((first, starts), (Action::Target(inner, _) | Action::Repeated(inner, _) | Action::Alternating(inner, _), Some(Kind::Open(_))) if bare && begins_with_body(inner));
        self.append(symbols, if confused { Brackets::Yes } else { Brackets::No });
        self.more_actions(rest);
    }

    /// Writes actions after one another.
    fn more_actions(&mut self, actions: &[Action]) {
        for action in actions {
            let symbols = self.apart(|w| w.action(action));
            // Two arrows or circles in a row may be one corner.
            let corner = match (self.last(), symbols.first().map(|symbol| symbol.kind())) {
                (Some(Kind::Arrow(_)), Some(Kind::Arrow(_))) | (Some(Kind::Circle(_)), Some(Kind::Circle(_))) => {
                    self.out.last().zip(symbols.first()).is_some_and(|(a, b)| a.tag().len() == b.tag().len() && a != b)
                }
                _other => false,
            };
            self.append(symbols, if corner && self.is_diagonal() { Brackets::Yes } else { Brackets::No });
        }
    }

    /// Whether the last symbol is an arrow or a circle of two letters.
    fn is_diagonal(&self) -> bool {
        match self.last() {
            Some(Kind::Arrow(d) | Kind::Circle(d)) => d.signs().iter().filter(|sign| **sign != 0).count() == 2,
            _other => false,
        }
    }

    fn append(&mut self, symbols: Vec<crate::notation::hamnosys::symbol::Symbol>, brackets: Brackets) {
        if brackets == Brackets::Yes {
            self.put("hamseqbegin");
        }
        self.out.extend(symbols);
        if brackets == Brackets::Yes {
            self.put("hamseqend");
        }
    }

    fn action(&mut self, action: &Action) {
        match action {
            Action::Move(one) => self.one_move(one),
            Action::Target(inner, location) => {
                let handed = self.handed;
                let inside = self.apart(|w| w.action(inner));
                let place = self.apart(|w| w.location(location));
                let _ = handed;
                let confused = ends_at_place(inner) || takes(inner, place.first().map(|symbol| symbol.kind()));
                self.append(inside, if confused { Brackets::Yes } else { Brackets::No });
                self.out.extend(place);
            }
            Action::Together(actions) => self.group(Bracket::Together, actions),
            Action::Sequence(actions) => self.group(Bracket::Sequence, actions),
            Action::Fused(actions) => self.group(Bracket::Fusion, actions),
            Action::Split(strong, weak) => {
                self.put("hamparbegin");
                self.or_nothing(strong.as_deref(), Writer::side);
                self.put("hamplus");
                self.or_nothing(weak.as_deref(), Writer::side);
                self.put("hamparend");
            }
            Action::Repeated(inner, repetition) => {
                let symbols = self.apart(|w| w.action(inner));
                let again = matches!(**inner, Action::Repeated(..));
                self.append(symbols, if again { Brackets::Yes } else { Brackets::No });
                self.repetition(repetition);
            }
            Action::Alternating(inner, times) => {
                let symbols = self.apart(|w| w.action(inner));
                let again = matches!(**inner, Action::Alternating(..));
                self.append(symbols, if again { Brackets::Yes } else { Brackets::No });
                self.put("hamalternatingmotion");
                if *times == Times::Twice {
                    self.put("hamalternatingmotion");
                }
            }
            Action::OfBody(level, inner) => {
                self.put("hamseqbegin");
                self.body_level(level);
                self.action(inner);
                self.put("hamseqend");
            }
        }
    }

    /// Writes one side of a split; what is at the same time needs no brackets of its own.
    fn side(&mut self, action: &Action) {
        match action {
            Action::Together(actions) if actions.len() > 1 => self.more_actions(actions),
            other => self.action(other),
        }
    }

    fn group(&mut self, bracket: Bracket, actions: &[Action]) {
        match actions {
            [] => return self.cannot("HamNoSys has no brackets that hold nothing"),
            [one] => return self.action(one),
            [_, _, ..] => {}
        }
        self.put(match bracket {
            Bracket::Together => "hamparbegin",
            Bracket::Sequence => "hamseqbegin",
            Bracket::Fusion => "hamfusionbegin",
        });
        self.more_actions(actions);
        self.put(match bracket {
            Bracket::Together => "hamparend",
            Bracket::Sequence => "hamseqend",
            Bracket::Fusion => "hamfusionend",
        });
    }

    fn repetition(&mut self, repetition: &Repetition) {
        let shift = repetition.shift;
        if shift.is_some() {
            self.put("hamseqbegin");
        }
        self.repeat(repetition.kind);
        if let Some(second) = repetition.second {
            self.repeat(second);
        }
        if repetition.approximate {
            self.put("hametc");
        }
        self.growth(repetition.growth);
        if let Some(shift) = shift {
            self.direction("hammove", shift.direction);
            self.size(shift.size);
            self.growth(shift.growth);
            self.put("hamseqend");
        }
    }

    fn repeat(&mut self, kind: RepetitionKind) {
        match kind {
            RepetitionKind::FromStart => self.put("hamrepeatfromstart"),
            RepetitionKind::FromStartSeveral => self.put("hamrepeatfromstartseveral"),
            RepetitionKind::Continue => self.put("hamrepeatcontinue"),
            RepetitionKind::ContinueSeveral => self.put("hamrepeatcontinueseveral"),
            RepetitionKind::Reverse => self.put("hamrepeatreverse"),
            RepetitionKind::ToFroTo => self.cannot("HamNoSys has no symbol for repeating to, fro and to"),
        }
    }
}

/// Whether an action has its target already.
fn ends_at_place(action: &Action) -> bool {
    match action {
        Action::Target(..) => true,
        Action::Move(_)
        | Action::Together(_)
        | Action::Sequence(_)
        | Action::Fused(_)
        | Action::Split(..)
        | Action::Repeated(..)
        | Action::Alternating(..)
        | Action::OfBody(..) => false,
    }
}

/// Whether an action would take a symbol of this class that follows it as a part of itself.
fn takes(action: &Action, after: Option<Kind>) -> bool {
    let Action::Move(one) = action else { return false };
    match &one.motion {
        Motion::Replace(posture) => posture.takes(after),
        Motion::FingerPlay(_) => matches!(after, Some(Kind::Digit(_) | Kind::Part(_) | Kind::Contact(_))),
        Motion::Nothing | Motion::Straight(_) | Motion::Circle(_) | Motion::Wrist(..) | Motion::Cross => false,
    }
}

/// Whether an action begins with that of a body part, whatever follows it.
fn begins_with_body(action: &Action) -> bool {
    match action {
        Action::OfBody(..) => true,
        Action::Target(inner, _) | Action::Repeated(inner, _) | Action::Alternating(inner, _) => begins_with_body(inner),
        Action::Move(_) | Action::Together(_) | Action::Sequence(_) | Action::Fused(_) | Action::Split(..) => false,
    }
}
