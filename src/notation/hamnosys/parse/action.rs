//! Actions: movements with targets and repetitions, and the brackets that combine them.
//!
//! ```text
//! action = (move | par( {action} [plus {action}] ) | seq( {action} ) | fusion( {action} ) | seq( body level {action} ))
//!          {location | repetition | alternating [alternating]}
//! ```

use super::cursor::{Parser, Read};
use super::group::is_motion;
use super::motion::set_manner;
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Size;

/// Where actions are read, for what may end them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Within {
    /// A phase: a new hand shape begins another.
    Phase,
    /// Brackets: a new hand shape can only replace the old.
    Brackets,
}

impl Parser {
    /// Reads actions up to the limit, a plus, or what begins another phase.
    pub(super) fn actions(&mut self, within: Within) -> Read<Vec<Action>> {
        let mut actions = Vec::new();
        let mut early = Vec::new();
        while let Some(kind) = self.peek() {
            match kind {
                Kind::Plus => break,
                Kind::Class(_) | Kind::Symmetry(_) | Kind::Weak if within == Within::Phase => break,
                Kind::Open(_) if within == Within::Phase && self.splits_shapes() => break,
                Kind::Manner(_) | Kind::Size(_) | Kind::Arc(_) | Kind::Wave(_) if self.action_follows() => {
                    self.warn("belongs after the movement; it is read as if it stood there");
                    early.push(kind);
                    self.next();
                }
                Kind::Class(_) | Kind::Fingers(_) | Kind::Palm(_) => actions.push(self.bare_posture()?),
                Kind::Open(_) if self.splits_postures() && self.plus_inside() => actions.push(self.bare_posture()?),
                Kind::Open(_) if self.empty_brackets() => {}
                _kind if self.action_ahead() => {
                    let mut action = self.action()?;
                    early.drain(..).for_each(|kind| modify(&mut action, kind));
                    actions.push(action);
                }
                _kind if self.location_ahead() => actions.push(self.bare_target()?),
                _kind => self.stray(&actions)?,
            }
        }
        Ok(actions)
    }

    /// Whether an action begins here.
    pub(super) fn action_ahead(&self) -> bool {
        match self.peek() {
            Some(Kind::Nothing) => true,
            Some(Kind::Open(_)) => {
                !(self.location_ahead() || self.repetition_ahead() || self.splits_postures() && self.plus_inside())
            }
            Some(kind) => is_motion(kind) && kind != Kind::Brushing,
            None => false,
        }
    }

    /// Passes over brackets that hold nothing; whether there were some.
    pub(super) fn empty_brackets(&mut self) -> bool {
        let empty = matches!(self.peek(), Some(Kind::Open(_))) && self.closing(self.at) == self.at + 1;
        if empty {
            self.warn("begins brackets that hold nothing; they are passed over");
            self.at += 2;
        }
        empty
    }

    /// Reads an action, which is here, with what follows it.
    pub(super) fn action(&mut self) -> Read<Action> {
        let action = match self.peek() {
            Some(Kind::Open(bracket)) => self.group(bracket)?,
            _other => Action::Move(Box::new(self.single_move()?)),
        };
        self.followed(action)
    }

    /// Reads what follows an action: places, repetitions, alternation, modifiers that come late.
    fn followed(&mut self, mut action: Action) -> Read<Action> {
        let mut at_place = false;
        loop {
            match self.peek() {
                Some(Kind::Alternating) => {
                    self.next();
                    let times = if self.take(Kind::Alternating) { Times::Twice } else { Times::Once };
                    action = Action::Alternating(Box::new(action), times);
                    at_place = false;
                }
                Some(kind @ (Kind::Manner(_) | Kind::Size(_) | Kind::Arc(_) | Kind::Wave(_)))
                    if !self.action_follows() && takes(&mut action, kind) =>
                {
                    self.warn("belongs directly after the movement; it is read as if it stood there");
                    modify(&mut action, kind);
                    self.next();
                }
                Some(Kind::Contact(_)) if at_place => self.skip("is a second contact at the same place"),
                _other if self.repetition_ahead() => {
                    action = Action::Repeated(Box::new(action), self.repetition()?);
                    at_place = false;
                }
                _other if !at_place && self.location_ahead() => {
                    action = Action::Target(Box::new(action), Box::new(self.location()?));
                    at_place = true;
                }
                _other => return Ok(action),
            }
        }
    }

    /// Reads a bracket of actions, which opens here.
    fn group(&mut self, bracket: Bracket) -> Read<Action> {
        if self.body_action_ahead() {
            return self.body_action(bracket);
        }
        self.inside(|p| {
            let first = p.actions(Within::Brackets)?;
            if p.peek() != Some(Kind::Plus) {
                return Ok(together(first, bracket));
            }
            if bracket != Bracket::Together {
                p.warn("splits what the two hands do; the brackets are read as `hamparbegin` … `hamparend`");
            }
            p.next();
            let second = p.actions(Within::Brackets)?;
            if p.peek() == Some(Kind::Plus) {
                return p
                    .fault("stands here for the second time", "a split has two parts: the strong hand and the weak");
            }
            Ok(Action::Split(side(first), side(second)))
        })
    }

    /// Reads `seq( bodypart action )`.
    fn body_action(&mut self, bracket: Bracket) -> Read<Action> {
        if bracket != Bracket::Sequence {
            self.warn("holds what a part of the body does, which stands in `hamseqbegin` … `hamseqend`");
        }
        self.inside(|p| {
            let level = p.body_level()?;
            let actions = p.actions(Within::Brackets)?;
            if p.peek() == Some(Kind::Plus) {
                return p.fault("cannot stand in what a part of the body does", "only hands are split");
            }
            Ok(Action::OfBody(level, Box::new(together(actions, Bracket::Sequence))))
        })
    }

    /// A new posture that no `hamreplace` announces.
    fn bare_posture(&mut self) -> Read<Action> {
        self.warn("begins a new posture after a movement; `hamreplace` is read before it");
        let start = self.span();
        let mut posture = Posture::default();
        let mut stage = super::posture::Stage::Nothing;
        loop {
            let more = if self.splits_postures() {
                self.split_posture(&mut posture)?;
                true
            } else {
                self.posture_part(&mut posture, &mut stage)?
            };
            if !more {
                break;
            }
        }
        let mut one = Move::of(Motion::Replace(posture));
        one.span = Ignored(start.to(self.span_before()));
        self.followed(Action::Move(Box::new(one)))
    }

    /// A place without a movement.
    fn bare_target(&mut self) -> Read<Action> {
        self.warn("begins a place that no movement goes to; the hand is read as going there");
        let mut one = Move::of(Motion::Nothing);
        one.span = Ignored(self.span());
        self.followed(Action::Move(Box::new(one)))
    }

    /// Whether an action begins directly after the manners and sizes here.
    fn action_follows(&self) -> bool {
        let mut at = self.at;
        let mut path = false;
        while let Some(Kind::Manner(_) | Kind::Size(_) | Kind::Arc(_) | Kind::Wave(_)) = self.kind(at) {
            path |= matches!(self.kind(at), Some(Kind::Arc(_) | Kind::Wave(_)));
            at += 1;
        }
        match self.kind(at) {
            Some(Kind::Arrow(_)) => true,
            Some(kind) => !path && is_motion(kind),
            None => false,
        }
    }

    /// A symbol that nothing here takes: passed over if little is lost, a fault if not.
    fn stray(&mut self, before: &[Action]) -> Read<()> {
        let after_action = !before.is_empty();
        match self.peek() {
            Some(Kind::Repeat(_) | Kind::Alternating) => self.skip("has no movement before it to repeat"),
            Some(Kind::Size(_) | Kind::Manner(_) | Kind::Growth(_) | Kind::Etc) => {
                self.skip("has no movement before it")
            }
            Some(Kind::Thumb(_) | Kind::Bend(_)) => self.skip("has no hand shape before it"),
            Some(Kind::Contact(_) | Kind::Behind | Kind::At | Kind::Beside) => self.skip("has no place beside it"),
            Some(Kind::Relative) => self.skip("has no direction or palm before it"),
            Some(Kind::NonIpsi) => self.skip("belongs after a symmetry"),
            Some(Kind::Brushing) => self.skip("has no movement before it"),
            Some(Kind::Arc(_)) => {
                return self.fault(
                    "bends a straight movement, and none is before it",
                    "write the arrow of the movement first",
                );
            }
            Some(Kind::Clock(_) | Kind::FullTurn) => {
                return self
                    .fault("says where a circle begins or ends, and no circle is before it", "write the circle first");
            }
            Some(Kind::Wave(_) | Kind::Ellipse(_)) => {
                return self
                    .fault("says how a movement waves, and no movement is before it", "write the movement first");
            }
            Some(Kind::Between) => self.skip("joins two values of one kind, and has not one on each side"),
            Some(Kind::NamesPlace | Kind::NamedPlace) => {
                return self.fault(
                    "names a place by a number, and no finger says the number",
                    "write the finger's symbol before it",
                );
            }
            _other if after_action => return self.unexpected(&["a movement", "a place", "a repetition", "`hamplus`"]),
            _other => return self.unexpected(&["a hand shape", "a place", "a movement"]),
        }
        Ok(())
    }
}

/// The actions of brackets: one stands for itself, none is no motion.
fn together(mut actions: Vec<Action>, bracket: Bracket) -> Action {
    match (actions.len(), bracket) {
        (0, _) => Action::Move(Box::new(Move::of(Motion::Nothing))),
        (1, _) => actions.remove(0),
        (_, Bracket::Together) => Action::Together(actions),
        (_, Bracket::Sequence) => Action::Sequence(actions),
        (_, Bracket::Fusion) => Action::Fused(actions),
    }
}

/// One side of a split: `None` where nothing moves.
fn side(actions: Vec<Action>) -> Option<Box<Action>> {
    if actions.is_empty() {
        return None;
    }
    match together(actions, Bracket::Together) {
        Action::Move(one) if *one == Move::of(Motion::Nothing) => None,
        action => Some(Box::new(action)),
    }
}

/// Does something to each movement of an action.
fn each_move(action: &mut Action, change: &mut impl FnMut(&mut Move)) {
    match action {
        Action::Move(one) => change(one),
        Action::Target(inner, _)
        | Action::Repeated(inner, _)
        | Action::Alternating(inner, _)
        | Action::OfBody(_, inner) => {
            each_move(inner, change);
        }
        Action::Together(actions) | Action::Sequence(actions) | Action::Fused(actions) => {
            actions.iter_mut().for_each(|action| each_move(action, change));
        }
        Action::Split(strong, weak) => {
            strong.iter_mut().chain(weak).for_each(|action| each_move(action, change));
        }
    }
}

/// Says a manner or a size of each movement of an action.
fn modify(action: &mut Action, modifier: Kind) {
    each_move(action, &mut |one| match (modifier, &mut one.motion) {
        (Kind::Manner(manner), _) => set_manner(one, manner),
        (Kind::Size(size), _) => late_size(one, size),
        (Kind::Arc(roll), Motion::Straight(straight)) => straight.arc = straight.arc.or(Some((roll, Size::Normal))),
        (Kind::Wave(style), Motion::Straight(Straight { waves, .. }) | Motion::Circle(Circle { waves, .. })) => {
            *waves = waves.or(Some(Waves { style, size: Size::Normal, plane: None }));
        }
        _other => {}
    });
}

/// Whether a modifier can be said of some movement of an action.
fn takes(action: &mut Action, modifier: Kind) -> bool {
    let mut taken = false;
    each_move(action, &mut |one| {
        taken |= match (modifier, &one.motion) {
            (Kind::Arc(_), Motion::Straight(_)) => true,
            (Kind::Wave(_), Motion::Straight(_) | Motion::Circle(_)) => true,
            (Kind::Arc(_) | Kind::Wave(_), _) => false,
            _other => true,
        };
    });
    taken
}

fn late_size(one: &mut Move, size: Size) {
    match &mut one.motion {
        Motion::Straight(straight) => straight.size = size,
        Motion::Circle(circle) => circle.size = size,
        Motion::Wrist(_, of_wrist) => *of_wrist = size,
        Motion::Nothing | Motion::FingerPlay(_) | Motion::Replace(_) | Motion::Cross => {}
    }
}
