//! Actions to movements.
//!
//! An action of the sign's own line of actions becomes one interval; a posture that it changes to is then said at the key after
//! it. Inside brackets, where no key stands, the posture is said by the action itself ([`Becoming`]).

use super::super::syntax::{
    self, Action, Change, Circle, Ellipse, Location, Move, Posture, RepetitionKind, Straight, Times, WaveStyle, Waves,
};
use super::location::contact_kind;
use super::nonmanual::pace;
use super::orientation::heading;
use super::phase::{Phases, replaced_in, splits_action};
use super::shape::successive;
use crate::diagnostics::Diagnostic;
use crate::phonology::{
    self, Becoming, Clock, Contact, Digits, Direction, Extent, Hand, Heading, Manner, Motion, Movement, Overlay,
    Placement, Repeated, Repetition, Shift, Size,
};

/// Where a movement stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    /// It reaches the key after its interval: what it changes is said there.
    Key,
    /// Within a bracket.
    Inside,
}

impl Phases<'_> {
    /// The movement of one hand in an action; `None` where the hand does nothing of it.
    pub(super) fn movement(&mut self, action: &Action, hand: Hand, depth: Depth) -> Option<Movement> {
        let shared = hand == Hand::Weak && !self.alone && !splits_action(action);
        if shared && self.is_beside() {
            // Beside a strong hand that acts alone, the weak one does what is split.
            return None;
        }
        if shared && let Some(mirror) = self.reflection() {
            // A part that both hands share: the weak one does it in the mirror.
            let movement = self.movement(action, Hand::Strong, depth).map(|m| mirror.movement(&m));
            if depth == Depth::Key && replaced_in(action).is_some() {
                self.followed_values(action);
            }
            return movement;
        }
        match action {
            Action::Move(one) => Some(self.single(one, hand, depth)),
            Action::Target(inner, location) => {
                let movement = self.movement(inner, hand, depth).unwrap_or_else(|| leaf(Motion::Change));
                Some(self.targeted(movement, location, hand, depth))
            }
            Action::Together(parts) => self.several(parts, hand, depth).map(|all| bracket(all, Movement::Together)),
            Action::Sequence(parts) => {
                self.several(parts, hand, Depth::Inside).map(|all| bracket(all, Movement::Sequence))
            }
            Action::Fused(parts) => self.several(parts, hand, Depth::Inside).map(|all| bracket(all, Movement::Fused)),
            Action::Split(strong, weak) => {
                let own = match hand {
                    Hand::Strong => strong,
                    Hand::Weak => weak,
                };
                let before = std::mem::replace(&mut self.alone, true);
                let movement = own.as_ref().and_then(|a| self.movement(a, hand, depth));
                self.alone = before;
                movement
            }
            Action::Repeated(inner, repetition) => {
                let repetition = self::repetition(repetition);
                // There and back ends where it began, so no key after it has the posture.
                let depth = if repetition.kind == phonology::RepetitionKind::ToAndFro { Depth::Inside } else { depth };
                let inner = self.movement(inner, hand, depth)?;
                Some(repeated(inner, repetition))
            }
            Action::Alternating(inner, times) => {
                if *times == Times::Twice {
                    self.warn("alternating twice is read as once");
                }
                self.movement(inner, hand, depth).map(alternating)
            }
            Action::OfBody(level, inner) => {
                self.of_body(level, inner);
                None
            }
        }
    }

    fn several(&mut self, parts: &[Action], hand: Hand, depth: Depth) -> Option<Vec<Movement>> {
        let all: Vec<Movement> = parts.iter().filter_map(|p| self.movement(p, hand, depth)).collect();
        (!all.is_empty()).then_some(all)
    }

    fn single(&mut self, one: &Move, hand: Hand, depth: Depth) -> Movement {
        let mut action = phonology::Action::new(match &one.motion {
            syntax::Motion::Nothing => Motion::Hold,
            syntax::Motion::Straight(straight) => self.straight(straight),
            syntax::Motion::Circle(circle) => self.circle(circle),
            syntax::Motion::Wrist(motion, size) => Motion::Wrist(*motion, *size),
            syntax::Motion::FingerPlay(digits) => Motion::Wiggle(Digits::of(digits.iter().copied())),
            syntax::Motion::Replace(_) => Motion::Change,
            syntax::Motion::Cross => {
                self.warn("the obsolete crossing movement is read as a movement to the other side");
                Motion::Straight {
                    direction: match hand {
                        Hand::Strong => Direction::LEFT.into(),
                        Hand::Weak => Direction::RIGHT.into(),
                    },
                    extent: Extent::Size(Size::Normal),
                    overlay: None,
                }
            }
        });
        action.manner = manner(one);
        action.pace = pace(one.speed);
        action.names.clone_from(&one.names);
        if let Some(site) = &one.brushing {
            action.brushing = self.placement(site, hand);
        }
        if let syntax::Motion::Replace(posture) = &one.motion {
            action.manner.extend(posture.shape.as_ref().and_then(successive).map(|s| match s {
                syntax::Successive::TowardPinky => Manner::TowardPinky,
                syntax::Successive::TowardThumb => Manner::TowardThumb,
            }));
            action.becoming = self.replaced(posture, hand, depth);
        }
        Movement::Action(Box::new(action))
    }

    /// Takes note of a changed posture; inside a bracket the action says it.
    fn replaced(&mut self, posture: &Posture, hand: Hand, depth: Depth) -> Option<Box<Becoming>> {
        match depth {
            Depth::Key => {
                self.take_posture(posture, hand);
                None
            }
            Depth::Inside => {
                let (configuration, orientation) = self.passing_posture(posture, hand);
                let becoming = Becoming { configuration, orientation, contact: None };
                (!becoming.is_empty()).then(|| Box::new(becoming))
            }
        }
    }

    fn straight(&mut self, s: &Straight) -> Motion {
        let direction = heading(s.direction, s.between);
        let extent = Extent::Size(s.size);
        let growth = growth(s.growth);
        let overlay = s.waves.map(|w| Overlay { growth, ..overlay(w, direction) });
        if growth != 0 && overlay.is_none() {
            self.warn("increasing or decreasing says nothing of a straight movement without waves");
        }
        match s.arc {
            None => Motion::Straight { direction, extent, overlay },
            Some((side, depth)) => Motion::Arc { direction, extent, bulge: side.heading(direction), depth, overlay },
        }
    }

    fn circle(&mut self, c: &Circle) -> Motion {
        let axis = heading(c.axis, c.between);
        Motion::Circle {
            axis,
            extent: Extent::Size(c.size),
            start: c.start.unwrap_or_default(),
            turns: turns(c),
            ellipse: c.ellipse.map(|(long, size)| (flatness(size), drawn(long, axis))),
            growth: growth(c.growth),
            overlay: c.waves.map(|w| overlay(w, axis)),
        }
    }

    /// A movement that leads to a place or to the other hand.
    fn targeted(&mut self, mut movement: Movement, location: &Location, hand: Hand, depth: Depth) -> Movement {
        match location {
            Location::One(site) => {
                let place = if self.alone { self.placement(site, hand) } else { self.shared_placement(site, hand) };
                lead(&mut movement, place);
            }
            Location::Split(strong, weak) => {
                let own = match hand {
                    Hand::Strong => strong,
                    Hand::Weak => weak,
                };
                let place = own.as_ref().and_then(|site| self.placement(site, hand));
                lead(&mut movement, place);
            }
            Location::Constellation(c) if !self.has_both_hands() => {
                // With one hand acting, a contact alone is with the place where the hand is.
                let place = match (&c.at, &c.points) {
                    (None, None) => self.touched(c.contact),
                    (Some(site), _) => self.placement(site, hand),
                    (None, Some((other, own))) => {
                        let site =
                            syntax::Site::Hand { level: other.clone(), contact: c.contact, with: Some(own.clone()) };
                        self.placement(&site, hand)
                    }
                };
                lead(&mut movement, place);
            }
            Location::Constellation(c) => {
                let (strong, weak) = c.points.as_ref().map(|points| self.points(points)).unzip();
                let contact = Contact { strong, weak, kind: contact_kind(c.contact) };
                match depth {
                    Depth::Key => self.take_contact(contact),
                    Depth::Inside => become_meeting(&mut movement, contact),
                }
                if let Some(site) = &c.at {
                    let place = self.shared_placement(site, hand);
                    match depth {
                        Depth::Key => self.take_placement(place, hand),
                        Depth::Inside => lead(&mut movement, place),
                    }
                }
            }
        }
        movement
    }

    pub(super) fn warn(&mut self, message: impl Into<String>) {
        let warning = Diagnostic::warning(self.span, message.into()).label("here");
        if !self.diagnostics.contains(&warning) {
            self.diagnostics.push(warning);
        }
    }
}

/// A motion with nothing more said.
pub(super) fn leaf(motion: Motion) -> Movement {
    Movement::Action(Box::new(phonology::Action::new(motion)))
}

/// Several movements in a bracket; one needs none.
fn bracket(mut all: Vec<Movement>, of: fn(Vec<Movement>) -> Movement) -> Movement {
    match (all.len(), all.pop()) {
        (1, Some(one)) => one,
        (_, Some(last)) => {
            all.push(last);
            of(all)
        }
        (_, None) => of(all),
    }
}

/// A movement repeated: a single action says it itself, unless it repeats already.
fn repeated(mut movement: Movement, repetition: Repetition) -> Movement {
    if let Movement::Action(action) = &mut movement
        && action.repetition.is_none()
    {
        action.repetition = Some(repetition);
        return movement;
    }
    Movement::Repeated(Box::new(Repeated { movement, repetition, alternating: false }))
}

/// A movement in which the hands take turns.
fn alternating(movement: Movement) -> Movement {
    match movement {
        Movement::Repeated(r) => Movement::Repeated(Box::new(Repeated { alternating: true, ..*r })),
        other => other.map_actions(&|a| phonology::Action { alternating: true, ..a.clone() }),
    }
}

/// Lets a movement lead to a place: the path of what goes on at the same time, the last of what follows each other.
fn lead(movement: &mut Movement, place: Option<Placement>) {
    let Some(place) = place else { return };
    if let Some(action) = leading(movement) {
        action.target = Some(place);
    }
}

/// Lets the hands meet at the end of a movement inside a bracket.
fn become_meeting(movement: &mut Movement, contact: Contact) {
    if let Some(action) = leading(movement) {
        action.becoming.get_or_insert_default().contact = Some(contact);
    }
}

/// The action that leads somewhere.
fn leading(movement: &mut Movement) -> Option<&mut phonology::Action> {
    match movement {
        Movement::Action(action) => Some(action),
        Movement::Together(parts) => {
            let moves = |m: &Movement| m.any_action(&|a| has_path(&a.motion));
            let at = parts.iter().position(moves).unwrap_or(0);
            parts.get_mut(at).and_then(leading)
        }
        Movement::Sequence(parts) | Movement::Fused(parts) => parts.last_mut().and_then(leading),
        Movement::Repeated(r) => leading(&mut r.movement),
        Movement::Backwards(inner) => leading(inner),
    }
}

/// Whether a motion leads anywhere by itself.
pub(crate) fn has_path(motion: &Motion) -> bool {
    match motion {
        Motion::Straight { .. } | Motion::Arc { .. } | Motion::Circle { .. } | Motion::Return { .. } => true,
        Motion::Hold | Motion::Change | Motion::Wrist(..) | Motion::Wiggle(_) => false,
    }
}

fn manner(one: &Move) -> Vec<Manner> {
    let said = [
        (one.fast, Manner::Fast),
        (one.slow, Manner::Slow),
        (one.tense, Manner::Tense),
        (one.rest, Manner::Rest),
        (one.halt, Manner::Halt),
        (one.bouncing, Manner::Bouncing),
    ];
    said.into_iter().filter(|(said, _)| *said).map(|(_, manner)| manner).collect()
}

/// A repetition, its symbols added up.
fn repetition(r: &syntax::Repetition) -> Repetition {
    let times = [Some(r.kind), r.second].into_iter().flatten().map(again).sum::<u8>();
    let (kind, times) = match r.kind {
        RepetitionKind::FromStart | RepetitionKind::FromStartSeveral => {
            (phonology::RepetitionKind::FromStart, 1 + times)
        }
        RepetitionKind::Continue | RepetitionKind::ContinueSeveral => (phonology::RepetitionKind::Continue, 1 + times),
        RepetitionKind::Reverse | RepetitionKind::ToFroTo => (phonology::RepetitionKind::ToAndFro, times),
    };
    let shift = r.shift.map(|s| Shift { direction: s.direction, size: s.size });
    Repetition { kind, times, growth: growth(r.growth), shift }
}

/// How many further performances a symbol asks for.
fn again(kind: RepetitionKind) -> u8 {
    match kind {
        RepetitionKind::FromStart | RepetitionKind::Continue | RepetitionKind::Reverse => 1,
        RepetitionKind::FromStartSeveral | RepetitionKind::ContinueSeveral | RepetitionKind::ToFroTo => 2,
    }
}

fn growth(growth: Option<syntax::Growth>) -> i8 {
    match growth.map(|g| g.change) {
        None => 0,
        Some(Change::Increasing) => 1,
        Some(Change::Decreasing) => -1,
    }
}

/// The turns of a circle: a full one where neither full turns nor an end are said.
fn turns(c: &Circle) -> f64 {
    let full = match c.full {
        None => 0.0,
        Some(Times::Once) => 1.0,
        Some(Times::Twice) => 2.0,
    };
    let start = c.start.map_or(0, Clock::eighths);
    let part = c.end.map_or(0, |end| (end.eighths() + 8 - start) % 8);
    match (c.full, part) {
        // Full turns are said on top of the first one.
        (None, 0) => 1.0,
        (Some(_), 0) => 1.0 + full,
        (_, part) => full + f64::from(part) / 8.0,
    }
}

fn overlay(waves: Waves, along: Heading) -> Overlay {
    let zigzag = match waves.style {
        WaveStyle::Zigzag => true,
        WaveStyle::Wavy => false,
    };
    Overlay { zigzag, size: waves.size, across: waves.plane.map(|p| drawn(p, along)), growth: 0 }
}

/// How flat an ellipse is: its short axis as a part of the long one.
pub(crate) fn flatness(size: Size) -> f64 {
    match size {
        Size::Small => 0.7,
        Size::Normal => 0.5,
        Size::Large => 0.3,
    }
}

/// A long axis drawn on the plane across a heading: as a palm's roll is drawn.
pub(crate) fn drawn(ellipse: Ellipse, across: Heading) -> Direction {
    let sixteenths = match ellipse {
        Ellipse::Vertical => 0,
        Ellipse::UpRight => 2,
        Ellipse::Horizontal => 4,
        Ellipse::UpLeft => 14,
    };
    let v = super::orientation::rolled(across.vector(), sixteenths);
    Direction::nearest(v).unwrap_or(Direction::UP)
}
