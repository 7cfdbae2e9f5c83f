//! What is done: motions, and how they combine.

use super::movement::{MOTIONS, Manner};
use super::place::PLACES;
use super::reader::{Attr, Node, Reader, attributes, elements, tag_span};
use super::words::{CHANGE, REPETITION, SIZE};
use crate::notation::hamnosys::syntax::{Action, Growth, Motion, Move, Posture, Repetition, RepetitionKind, Shift};
use crate::phonology::Size;

/// The elements that combine motions.
const COMBINED: [&str; 6] = ["tgt_motion", "par_motion", "seq_motion", "split_motion", "rpt_motion", "nonman_motion"];

impl<'a> Reader<'a> {
    /// An element that is an action; `None`, and said so, where it is none. `others` are names that may stand there too.
    pub(super) fn action(&mut self, node: Node<'a>, others: &[&'static str]) -> Option<Action> {
        match node.tag_name().name() {
            "par_motion" => self.several(node, Action::Together),
            "seq_motion" => self.several(node, Action::Sequence),
            "split_motion" => self.split_motion(node),
            "tgt_motion" => self.target(node),
            "rpt_motion" => self.repeated(node),
            "nonman_motion" => self.of_body(node),
            name if MOTIONS.contains(&name) => self.movement(node),
            _ => {
                let known: Vec<&str> = [others, &COMBINED, &MOTIONS, &PLACES].concat();
                self.unknown_element(node, &known);
                None
            }
        }
    }

    /// Actions of an element, in order.
    fn actions(&mut self, node: Node<'a>) -> Vec<Action> {
        self.no_text(node);
        elements(node).filter_map(|child| self.action(child, &[])).collect()
    }

    /// `par_motion`, `seq_motion`.
    fn several(&mut self, node: Node<'a>, plain: fn(Vec<Action>) -> Action) -> Option<Action> {
        let (mut manner, mut fused) = (Manner::default(), false);
        for attr in attributes(node) {
            match attr.name {
                "fused" => fused = self.truth(&attr),
                _ => self.manner(&mut manner, &attr, &["fused"]),
            }
        }
        let mut actions = self.actions(node);
        self.spread(&manner, &mut actions, node);
        Some(manner.alternate(if fused { Action::Fused(actions) } else { plain(actions) }))
    }

    /// `split_motion`: one for each hand.
    fn split_motion(&mut self, node: Node<'a>) -> Option<Action> {
        let mut manner = Manner::default();
        attributes(node).for_each(|attr| self.manner(&mut manner, &attr, &[]));
        let mut actions = self.actions(node);
        if actions.len() != 2 {
            let message = format!("a split motion is one motion for each hand: here are {}", actions.len());
            let told = self.warning(tag_span(node), &message);
            self.say(told.label("expected two motions").hint("a hand that does nothing has `<nomotion/>`"));
            actions.truncate(2);
        }
        self.spread(&manner, &mut actions, node);
        let mut hands = actions.into_iter().map(|action| match action {
            Action::Move(nothing) if *nothing == Move::of(Motion::Nothing) => None,
            action => Some(Box::new(action)),
        });
        let (strong, weak) = (hands.next().flatten(), hands.next().flatten());
        Some(manner.alternate(Action::Split(strong, weak)))
    }

    /// `tgt_motion`: a change of posture, a motion with a target, or a target alone.
    fn target(&mut self, node: Node<'a>) -> Option<Action> {
        self.no_text(node);
        let mut manner = Manner::default();
        attributes(node).for_each(|attr| self.manner(&mut manner, &attr, &[]));
        let (mut changes, mut posture) = (false, Posture::default());
        let (mut location, mut actions) = (None, Vec::new());
        for child in elements(node) {
            match child.tag_name().name() {
                "changeposture" => {
                    self.no_attributes(child);
                    self.no_content(child);
                    changes = true;
                }
                "handconfig" => {
                    let config = self.handconfig(child);
                    self.add(&mut posture, config, child);
                }
                "split_handconfig" => self.split_handconfig(child, &mut posture),
                name if PLACES.contains(&name) => {
                    if location.is_some() {
                        let told = self.warning(tag_span(child), "a motion has one target: this one is passed over");
                        self.say(told.label("not read"));
                    } else {
                        location = self.location(child);
                    }
                }
                _ => actions.extend(self.action(child, &["changeposture", "handconfig", "split_handconfig"])),
            }
        }
        changes |= !posture.is_empty();
        let mut moved = Move::of(if changes { Motion::Replace(posture) } else { Motion::Nothing });
        moved.span.0 = tag_span(node);
        if !changes && location.is_none() {
            let told = self.warning(tag_span(node), "`tgt_motion` has no target and changes no posture");
            self.say(told.label("read as what is in it"));
        }
        if changes || actions.is_empty() {
            manner.apply(&mut moved);
            actions.insert(0, Action::Move(Box::new(moved)));
        } else {
            self.spread(&manner, &mut actions, node);
        }
        let inner = self.one(actions, if changes { Join::Together } else { Join::Sequence }, node)?;
        Some(manner.alternate(match location {
            Some(location) => Action::Target(Box::new(inner), Box::new(location)),
            None => inner,
        }))
    }

    /// The one action of an element; several are joined, and said so.
    fn one(&mut self, mut actions: Vec<Action>, join: Join, node: Node<'a>) -> Option<Action> {
        if actions.len() == 1 {
            return actions.pop();
        }
        if actions.is_empty() {
            let told = self.warning(tag_span(node), &format!("`{}` has no motion in it", node.tag_name().name()));
            self.say(told.label("passed over"));
            return None;
        }
        let told = self.warning(tag_span(node), &format!("`{}` should have one motion in it", node.tag_name().name()));
        Some(match join {
            Join::Together => {
                self.say(told.label("read as done at the same time"));
                Action::Together(actions)
            }
            Join::Sequence => {
                self.say(told.label("read as done one after the other"));
                Action::Sequence(actions)
            }
        })
    }

    /// `nonman_motion` and `nonmanualconfig`: a part of the body does it.
    pub(super) fn of_body(&mut self, node: Node<'a>) -> Option<Action> {
        self.no_text(node);
        let mut manner = Manner::default();
        attributes(node).for_each(|attr| self.manner(&mut manner, &attr, &[]));
        let (mut part, mut actions) = (None, Vec::new());
        for child in elements(node) {
            match child.tag_name().name() {
                "handconfig" => part = self.handconfig(child).body.or(part),
                _ => actions.extend(self.action(child, &["handconfig"])),
            }
        }
        self.spread(&manner, &mut actions, node);
        let action = self.one(actions, Join::Sequence, node)?;
        let Some(part) = part else {
            let fault = self.fault(tag_span(node), "which part of the body moves is not said");
            self.say(fault.label("expected a `handconfig` with `bodypart`"));
            return None;
        };
        Some(manner.alternate(Action::OfBody(part, Box::new(action))))
    }

    /// `rpt_motion`.
    fn repeated(&mut self, node: Node<'a>) -> Option<Action> {
        let mut manner = Manner::default();
        let (mut kind, mut repetition) = (None, Repetition::of(RepetitionKind::FromStart));
        let (mut growth, mut shift, mut shift_growth) = (GrowthWords::default(), [None, None], GrowthWords::default());
        for attr in attributes(node) {
            match attr.name {
                "repetition" => kind = self.value(&attr, &REPETITION),
                "second_repetition" => repetition.second = self.value(&attr, &REPETITION),
                "approx_repetition" => repetition.approximate = self.truth(&attr),
                "repetition_incrdecr" => growth.change = Some(attr),
                "repetition_incrdecr_size" => growth.size = Some(attr),
                "repetition_baseshift" => shift[0] = Some(attr),
                "baseshift_size" => shift[1] = Some(attr),
                "baseshift_incrdecr" => shift_growth.change = Some(attr),
                "baseshift_incrdecr_size" => shift_growth.size = Some(attr),
                _ => self.manner(&mut manner, &attr, &["repetition", "second_repetition", "repetition_baseshift"]),
            }
        }
        match kind {
            Some(kind) => repetition.kind = kind,
            None if node.attribute("repetition").is_none() => {
                let told = self.warning(tag_span(node), "how the motion repeats is not said: read as `fromstart`");
                self.say(told.label("expected `repetition=\"fromstart\"`"));
            }
            None => {}
        }
        repetition.growth = self.growth(&growth);
        repetition.shift = self.shift(shift, &shift_growth);
        let mut actions = self.actions(node);
        self.spread(&manner, &mut actions, node);
        let action = self.one(actions, Join::Sequence, node)?;
        Some(manner.alternate(Action::Repeated(Box::new(action), repetition)))
    }

    /// How a repeated motion moves on.
    fn shift(&mut self, [toward, size]: [Option<Attr>; 2], growth: &GrowthWords) -> Option<Shift> {
        let Some(toward) = toward else {
            if let Some(attr) = size.or(growth.change).or(growth.size) {
                self.odd(&attr, "this says nothing without `repetition_baseshift`: passed over");
            }
            return None;
        };
        let (direction, between) = self.direction(&toward, None)?;
        if between.is_some() {
            self.odd(&toward, "a shift is not halfway between directions: the doubled letter is read alone");
        }
        let size = size.and_then(|attr| self.value(&attr, &SIZE)).unwrap_or(Size::Normal);
        Some(Shift { direction, size, growth: self.growth(growth) })
    }

    /// Larger or smaller, and how much.
    pub(super) fn growth(&mut self, words: &GrowthWords) -> Option<Growth> {
        let size = words.size.and_then(|attr| self.value(&attr, &SIZE)).unwrap_or(Size::Normal);
        match (words.change, words.size) {
            (Some(attr), _) => self.value(&attr, &CHANGE).map(|change| Growth { change, size }),
            (None, Some(attr)) => {
                self.odd(&attr, "how much, but not whether larger or smaller: passed over");
                None
            }
            (None, None) => None,
        }
    }

    /// Manners that stand on an element that combines motions are meant of each motion in it.
    fn spread(&mut self, manner: &Manner, actions: &mut [Action], node: Node<'a>) {
        if manner.is_plain() {
            return;
        }
        let told =
            self.warning(tag_span(node), "a manner belongs on a motion: read as said of each motion in this one");
        self.say(told.label("here"));
        actions.iter_mut().for_each(|action| manner.spread(action));
    }
}

/// How several actions are joined where one is expected.
enum Join {
    Together,
    Sequence,
}

/// `incrdecr` and its size.
#[derive(Default)]
pub(super) struct GrowthWords<'a> {
    pub change: Option<Attr<'a>>,
    pub size: Option<Attr<'a>>,
}

impl Manner {
    /// The action with the hands taking turns, where that is said.
    pub(super) fn alternate(&self, action: Action) -> Action {
        match (self.alternating(), action) {
            (None, action) => action,
            // Said of an action and of the element around it: it is the same turn.
            (Some(_), action @ Action::Alternating(..)) => action,
            (Some(times), action) => Action::Alternating(Box::new(action), times),
        }
    }

    /// Says a manner of every motion in an action.
    fn spread(&self, action: &mut Action) {
        match action {
            // A hand that does nothing does it in no manner.
            Action::Move(moved) if moved.motion == Motion::Nothing => {}
            Action::Move(moved) => self.apply(moved),
            Action::Together(all) | Action::Sequence(all) | Action::Fused(all) => {
                all.iter_mut().for_each(|action| self.spread(action));
            }
            Action::Split(strong, weak) => {
                [strong, weak].into_iter().flatten().for_each(|action| self.spread(action));
            }
            Action::Target(action, _) | Action::Repeated(action, _) => self.spread(action),
            Action::Alternating(action, _) | Action::OfBody(_, action) => self.spread(action),
        }
    }
}
