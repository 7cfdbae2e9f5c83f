//! Phases: hands, posture, place, actions.
//!
//! ```text
//! phases = phase {plus phase}
//! phase  = [nomotion] [weak | symmetry] {seq( body level action )} {posture} [location] {action}
//! symmetry = (symmpar | symmlr) {bend | large | alternating | nonipsi}
//! ```

use super::action::Within;
use super::cursor::{Handed, Parser, Read};
use super::posture::Stage;
use super::site::points;
use crate::diagnostics::Diagnostic;
use crate::notation::hamnosys::kind::{Kind, Reflection};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Size;

impl Parser {
    /// Reads all phases; faults are among the diagnostics.
    pub(super) fn phases(&mut self) -> Vec<Phase> {
        let mut phases = Vec::new();
        let whole = self.limit;
        while self.at < self.limit {
            if self.peek() == Some(Kind::Plus) {
                let parts = !phases.is_empty();
                if !parts || self.ahead(1).is_none() {
                    self.warn("has nothing to join on one side; it is passed over");
                }
                self.next();
                continue;
            }
            let start = self.at;
            match self.phase(phases.is_empty()) {
                Ok(phase) if says_nothing(&phase) => {}
                Ok(phase) => phases.push(phase),
                Err(_stop) => {
                    self.limit = whole;
                    self.at = self.plus_ahead(start, whole).unwrap_or(whole);
                    // The fault is told; a phase that cannot be read still counts as one.
                    phases.push(nothing());
                }
            }
        }
        if phases.is_empty() && self.diagnostics.iter().all(|d| d.severity != crate::diagnostics::Severity::Fault) {
            self.diagnostics.push(
                Diagnostic::fault(self.span(), "nothing is written")
                    .label("expected a hand shape")
                    .hint("a sign begins with its symmetry or its hand shape, such as `hamflathand`"),
            );
        }
        phases
    }

    fn phase(&mut self, first: bool) -> Read<Phase> {
        let (start, begin) = (self.span(), self.at);
        let mut phase = nothing();
        self.handed = Handed::One;
        if self.peek() == Some(Kind::Nothing) && self.ahead(1).is_some_and(|next| next != Kind::Plus) {
            phase.holds_over = true;
            self.next();
        }
        self.hands(&mut phase)?;
        while self.body_action_ahead() {
            let action = self.action()?;
            phase.body.push(action);
        }
        self.posture_and_place(&mut phase)?;
        if first {
            self.missing(&phase, begin);
        }
        loop {
            let actions = self.actions(Within::Phase)?;
            phase.actions.extend(actions);
            match self.peek() {
                Some(Kind::Symmetry(_)) if phase.hands == Hands::Strong && !self.shape_after_symmetry() => {
                    self.warn("belongs at the beginning; it is read as if it stood there");
                    self.hands(&mut phase)?;
                }
                Some(Kind::Symmetry(_) | Kind::Class(_) | Kind::Weak | Kind::Open(_)) if self.at > begin => {
                    self.warn("begins another posture; `hamplus` is read before it");
                    break;
                }
                _other => break,
            }
        }
        if self.at == begin {
            return self.unexpected(&["a symmetry", "a hand shape"]);
        }
        phase.span = Ignored(start.to(self.span_before()));
        Ok(phase)
    }

    /// Which hands act: a symmetry with its marks, or the weak hand.
    fn hands(&mut self, phase: &mut Phase) -> Read<()> {
        loop {
            match self.peek() {
                Some(Kind::Weak) if phase.hands == Hands::Strong => {
                    phase.hands = Hands::Weak;
                    self.next();
                }
                Some(Kind::Symmetry(reflection)) => match phase.hands {
                    Hands::Strong | Hands::Weak => {
                        self.next();
                        phase.hands = Hands::Both(self.symmetry(reflection));
                        self.handed = Handed::Two;
                    }
                    Hands::Both(_) => self.skip("is a second symmetry"),
                },
                Some(Kind::NonIpsi) => self.skip("belongs after a symmetry"),
                Some(
                    Kind::Alternating
                    | Kind::Size(_)
                    | Kind::Bend(_)
                    | Kind::Thumb(_)
                    | Kind::Etc
                    | Kind::Relative
                    | Kind::Growth(_),
                ) if phase.posture.is_empty() && self.posture_follows() => {
                    self.skip("stands before the hand shape, where it says nothing");
                }
                _other => return Ok(()),
            }
        }
    }

    /// The marks after a symmetry, in any order.
    fn symmetry(&mut self, reflection: Reflection) -> Symmetry {
        let mut symmetry = Symmetry { left_right: reflection == Reflection::LeftRight, ..Symmetry::default() };
        loop {
            match self.peek() {
                Some(Kind::Bend(Bend::Bent)) => symmetry.out_in = true,
                Some(Kind::Bend(_)) => {
                    self.warn("is read as `hamfingerstraightmod`, which says that in and out are mirrored");
                    symmetry.out_in = true;
                }
                Some(Kind::Size(Size::Large)) => symmetry.up_down = true,
                Some(Kind::Alternating) => symmetry.alternating = true,
                Some(Kind::NonIpsi) => symmetry.non_ipsi = true,
                _other => return symmetry,
            }
            self.next();
        }
    }

    /// Posture and place, which belong in this order, but are read in any.
    fn posture_and_place(&mut self, phase: &mut Phase) -> Read<()> {
        let mut stage = Stage::Nothing;
        loop {
            if self.splits_postures() {
                // A second shape begins a phase; brackets that split nothing, after the place, hold a movement.
                let over = stage == Stage::Place && !self.plus_inside();
                if over || phase.posture.shape.is_some() && self.splits_shapes() {
                    return Ok(());
                }
            }
            if self.splits_postures() {
                if stage == Stage::Place && !phase.posture.is_empty() {
                    self.warn("begins a posture after the place; it belongs before");
                }
                if let Some((strong, weak)) = self.split_posture(&mut phase.posture)? {
                    self.places_of_split(phase, strong, weak)?;
                }
            } else if self.posture_part(&mut phase.posture, &mut stage)? {
            } else if phase.location.is_none() && self.location_ahead() && !self.empty_brackets() {
                if stage == Stage::Nothing && phase.posture.is_empty() && self.posture_follows() {
                    self.warn("begins a place before the posture; it belongs after");
                }
                phase.location = Some(self.location()?);
                stage = Stage::Place;
            } else if matches!(self.peek(), Some(Kind::Symmetry(_))) && phase.hands == Hands::Strong {
                self.warn("belongs at the beginning; it is read as if it stood there");
                self.hands(phase)?;
            } else if phase.location.is_some() && matches!(self.peek(), Some(Kind::Contact(_))) {
                self.skip("is a second contact at the same place");
            } else if self.splits_places() && matches!(phase.location, Some(Location::One(Site::Body { .. }))) {
                self.hands_after_place(phase)?;
            } else if self.stray_in_posture() {
                self.skip("has nothing before it that it could be said of");
            } else {
                return Ok(());
            }
        }
    }

    /// Hands at each other that stand after the place where they are.
    fn hands_after_place(&mut self, phase: &mut Phase) -> Read<()> {
        self.warn("begins where the hands are at each other; it belongs before the place where both are");
        match (self.location()?, phase.location.take()) {
            (Location::Constellation(mut hands), Some(Location::One(site))) => {
                hands.at = hands.at.or(Some(site));
                phase.location = Some(Location::Constellation(hands));
            }
            (second, first) => {
                phase.location = first;
                let target =
                    Action::Target(Box::new(Action::Move(Box::new(Move::of(Motion::Nothing)))), Box::new(second));
                phase.actions.push(target);
            }
        }
        Ok(())
    }

    /// Whether a symbol is here that says nothing, and the posture goes on after it.
    fn stray_in_posture(&self) -> bool {
        let stray = matches!(
            self.peek(),
            Some(
                Kind::Size(_)
                    | Kind::Manner(_)
                    | Kind::Growth(_)
                    | Kind::Etc
                    | Kind::Relative
                    | Kind::NonIpsi
                    | Kind::Thumb(_)
                    | Kind::Bend(_)
                    | Kind::Between
                    | Kind::Alternating
            )
        );
        stray && self.kind(self.at + 1).is_some_and(|next| matches!(next, Kind::Fingers(_) | Kind::Palm(_)))
    }

    /// The places that stood in the brackets of a split posture.
    fn places_of_split(&mut self, phase: &mut Phase, strong: Option<Site>, weak: Option<Site>) -> Read<()> {
        let location = match points(strong, weak) {
            Ok(both) => self.constellation(Some(both))?,
            Err(location) => *location,
        };
        if phase.location.is_none() {
            phase.location = Some(location);
        } else {
            let span = self.span_before();
            self.warn_at(span, "the hands have a second place before any movement", "passed over");
        }
        Ok(())
    }

    /// Whether a part of a posture comes before any movement.
    fn posture_follows(&self) -> bool {
        let mut at = self.at;
        while let Some(kind) = self.kind(at) {
            match kind {
                Kind::Class(_) | Kind::Fingers(_) | Kind::Palm(_) => return true,
                Kind::Plus | Kind::Replace => return false,
                kind if super::group::is_motion(kind) => return false,
                _other => at += 1,
            }
        }
        false
    }

    /// Whether a symmetry here is followed by a posture, and so begins a phase.
    fn shape_after_symmetry(&self) -> bool {
        let mut at = self.at + 1;
        while matches!(
            self.kind(at),
            Some(Kind::Bend(_) | Kind::Size(_) | Kind::Alternating | Kind::NonIpsi | Kind::Open(_) | Kind::Symmetry(_))
        ) {
            at += 1;
        }
        matches!(self.kind(at), Some(Kind::Class(_)))
    }

    /// Says what the posture of the first phase lacks.
    fn missing(&mut self, phase: &Phase, begin: usize) {
        let posture = &phase.posture;
        let (message, label) = match (&posture.shape, &posture.fingers, &posture.palm) {
            (None, _, _) if phase.body.is_empty() => {
                ("the sign has no hand shape", "the hand is read as keeping its shape")
            }
            (Some(_), Some(_), None) => ("the palm is not said", "the hand is read as keeping its palm"),
            (Some(_), None, Some(_)) => {
                ("the finger direction is not said", "the hand is read as keeping its direction")
            }
            (None, _, _) | (Some(_), None, None) | (Some(_), Some(_), Some(_)) => return,
        };
        let at = std::mem::replace(&mut self.at, begin);
        let span = self.span();
        self.at = at;
        self.warn_at(span, message, label);
    }
}

/// Whether a phase says no more than which hands act.
fn says_nothing(phase: &Phase) -> bool {
    phase.body.is_empty() && phase.posture.is_empty() && phase.location.is_none() && phase.actions.is_empty()
}

/// A phase of which nothing is said.
fn nothing() -> Phase {
    Phase {
        hands: Hands::Strong,
        holds_over: false,
        body: Vec::new(),
        posture: Posture::default(),
        location: None,
        actions: Vec::new(),
        span: Ignored::default(),
    }
}
