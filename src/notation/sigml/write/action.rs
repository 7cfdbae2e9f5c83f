//! What is done.

use super::element::Element;
use super::movement::{manner, movement};
use super::words::{CHANGE, REPETITION};
use super::{check_depth, place, posture, unsayable};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{
    Action, BodyLevel, Growth, Location, Motion, Move, Posture, Repetition, Times,
};

/// An action; `depth` is how many it stands within.
pub(super) fn action(action: &Action, depth: usize) -> Result<Element, Error> {
    check_depth(depth)?;
    let several = |name, actions: &[Action]| {
        let children = actions.iter().map(|one| self::action(one, depth + 1)).collect::<Result<_, _>>()?;
        Ok(Element::of(name, children))
    };
    match action {
        Action::Move(moved) => movement(moved),
        Action::Target(inner, location) => target(inner, location, depth),
        Action::Together(actions) => several("par_motion", actions),
        Action::Sequence(actions) => several("seq_motion", actions),
        Action::Fused(actions) => {
            let mut element = several("seq_motion", actions)?;
            element.mark("fused", true);
            Ok(element)
        }
        Action::Split(strong, weak) => {
            let hand = |hand: &Option<Box<Action>>| match hand {
                Some(one) => self::action(one, depth + 1),
                None => Ok(Element::new("nomotion")),
            };
            Ok(Element::of("split_motion", vec![hand(strong)?, hand(weak)?]))
        }
        Action::Repeated(inner, repetition) => {
            let mut element = repeated(repetition);
            element.children.push(self::action(inner, depth + 1)?);
            Ok(element)
        }
        Action::Alternating(inner, times) => alternating(inner, *times, depth),
        Action::OfBody(part, inner) => of_body("nonman_motion", part, inner, depth),
    }
}

/// The hands take turns: an attribute of the element that does.
fn alternating(inner: &Action, times: Times, depth: usize) -> Result<Element, Error> {
    if matches!(inner, Action::Alternating(..)) {
        return unsayable("gestural SiGML says once that hands take turns");
    }
    let mut element = action(inner, depth + 1)?;
    mark_alternating(&mut element, times);
    Ok(element)
}

/// Once or twice.
pub(super) fn mark_alternating(element: &mut Element, times: Times) {
    element.mark("alternating", true);
    element.mark("second_alternating", times == Times::Twice);
}

/// A motion with its target. A change of posture shares the element, a target alone needs no motion.
fn target(inner: &Action, location: &Location, depth: usize) -> Result<Element, Error> {
    let mut element = match inner {
        Action::Move(moved) if matches!(moved.motion, Motion::Replace(_)) => movement(moved)?,
        Action::Move(moved) if moved.motion == Motion::Nothing && moved.brushing.is_none() => {
            let mut element = Element::new("tgt_motion");
            manner(&mut element, moved)?;
            element
        }
        inner => Element::of("tgt_motion", vec![action(inner, depth + 1)?]),
    };
    element.children.push(place::location(location)?);
    Ok(element)
}

/// `nonman_motion` or `nonmanualconfig`.
pub(super) fn of_body(name: &'static str, part: &BodyLevel, inner: &Action, depth: usize) -> Result<Element, Error> {
    Ok(Element::of(name, vec![posture::body_part(part)?, action(inner, depth + 1)?]))
}

fn repeated(repetition: &Repetition) -> Element {
    let mut element = Element::new("rpt_motion");
    element.word("repetition", repetition.kind, &REPETITION);
    if let Some(second) = repetition.second {
        element.word("second_repetition", second, &REPETITION);
    }
    element.mark("approx_repetition", repetition.approximate);
    growth(&mut element, repetition.growth, ["repetition_incrdecr", "repetition_incrdecr_size"]);
    if let Some(shift) = repetition.shift {
        element.direction("repetition_baseshift", shift.direction);
        element.size("baseshift_size", shift.size);
        growth(&mut element, shift.growth, ["baseshift_incrdecr", "baseshift_incrdecr_size"]);
    }
    element
}

/// Larger or smaller.
pub(super) fn growth(element: &mut Element, growth: Option<Growth>, [name, size]: [&'static str; 2]) {
    if let Some(growth) = growth {
        element.word(name, growth.change, &CHANGE);
        element.size(size, growth.size);
    }
}

/// A change of posture, which needs an element around it.
pub(super) fn replacement(moved: &Move, after: &Posture) -> Result<Element, Error> {
    if moved.brushing.is_some() {
        return unsayable("in gestural SiGML a change of posture brushes no place");
    }
    let mut element = Element::of("tgt_motion", vec![Element::new("changeposture")]);
    manner(&mut element, moved)?;
    element.children.extend(posture::posture(after)?);
    Ok(element)
}
