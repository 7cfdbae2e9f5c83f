//! Movements: steps joined by `then`, simultaneous ones by `while`, groups in brackets.

use super::becoming::becoming;
use super::input::{Parsed, Tokens, expected, must, told};
use super::motion::motion;
use super::placement::placement;
use super::repetition::repetition;
use super::whole::speed;
use super::words::{closed, duration, is_word, text};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::syntax::{Action, Motion, Movement, Repeated};
use crate::phonology::Manner;

/// How deep groups may nest.
const DEEPEST: usize = 32;

/// `STEP { then STEP }`: one an interval.
pub(crate) fn movements<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<Movement>> {
    steps(input, 0)
}

fn steps<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Vec<Movement>> {
    if depth > DEEPEST {
        return told(Diagnostic::fault(input.span(), "movements are nested too deeply").label("here"));
    }
    let (mut rest, first) = must(together(input, depth))?;
    let mut all = vec![first];
    while is_word(rest, "then") {
        let (after, next) = must(together(rest.skip(), depth))?;
        all.push(next);
        rest = after;
    }
    Ok((rest, all))
}

fn together<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Movement> {
    let (mut rest, first) = primary(input, depth)?;
    if !is_word(rest, "while") {
        return Ok((rest, first));
    }
    let mut all = vec![first];
    while is_word(rest, "while") {
        let (after, next) = must(primary(rest.skip(), depth))?;
        all.push(next);
        rest = after;
    }
    Ok((rest, Movement::Together(all)))
}

fn primary<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Movement> {
    let fused = is_word(input, "fused");
    let backwards = is_word(input, "backwards");
    let open = if fused || backwards { input.skip() } else { input };
    if !open.is(Kind::Open) {
        if fused {
            return must(expected(open, "a bracket after `fused`"));
        }
        if backwards {
            return must(expected(open, "a bracket after `backwards`"));
        }
        return action(input).map(|(rest, action)| (rest, Movement::Action(Box::new(action))));
    }
    let (rest, mut parts) = steps(open.skip(), depth + 1)?;
    let (rest, ()) = closed(open, rest, "movement", "add `)` after the last movement of the group")?;
    if fused && parts.len() < 2 {
        return told(
            Diagnostic::fault(input.span_to(rest), "one movement alone cannot be fused")
                .label("here")
                .hint("fused movements are joined by `then`: `fused ( up then left )`"),
        );
    }
    let group = match parts.pop() {
        Some(only) if parts.is_empty() => only,
        Some(last) => {
            parts.push(last);
            Movement::Group { fused, parts }
        }
        None => return expected(rest, "a movement"),
    };
    let group = if backwards { Movement::Backwards(Box::new(group)) } else { group };
    again(rest, group)
}

/// How often a group is performed, where that is said.
fn again<'a>(rest: Tokens<'a>, group: Movement) -> Parsed<'a, Movement> {
    let (after, repetition) = match repetition(past_comma(rest)) {
        Ok(found) => found,
        Err(nom::Err::Error(_)) => return Ok((rest, group)),
        Err(other) => return Err(other),
    };
    let turns = past_comma(after);
    let alternating = is_word(turns, "alternating");
    let rest = if alternating { turns.skip() } else { after };
    Ok((rest, Movement::Repeated(Box::new(Repeated { movement: group, repetition, alternating }))))
}

fn past_comma(input: Tokens) -> Tokens {
    if input.is(Kind::Comma) { input.skip() } else { input }
}

/// A motion and what is said of it; commas between are free.
fn action<'a>(input: Tokens<'a>) -> Parsed<'a, Action> {
    let (rest, motion) =
        if is_word(input, "to") && !is_word(input.skip(), "and") { (input, Motion::Change) } else { motion(input)? };
    let mut action = Action::new(motion);
    let mut rest = rest;
    loop {
        match modifier(past_comma(rest), &mut action) {
            Ok((after, ())) => rest = after,
            Err(nom::Err::Error(_)) => return Ok((rest, action)),
            Err(other) => return Err(other),
        }
    }
}

fn modifier<'a>(input: Tokens<'a>, action: &mut Action) -> Parsed<'a, ()> {
    if let Some(manner) = Manner::ALL.into_iter().find(|m| is_word(input, m.name())) {
        if action.manner.contains(&manner) {
            return twice(input, input.skip());
        }
        action.manner.push(manner);
        return Ok((input.skip(), ()));
    }
    match repetition(input) {
        Ok((rest, repetition)) => return set(&mut action.repetition, repetition, input, rest),
        Err(nom::Err::Error(_)) => {}
        Err(other) => return Err(other),
    }
    let back = matches!(action.motion, Motion::Return(_));
    if is_word(input, "to") && back {
        return expected(input, "a manner; `back` says already where it goes");
    }
    if is_word(input, "to") {
        let (rest, place) = must(placement(input.skip()))?;
        return set(&mut action.target, place, input, rest);
    }
    if is_word(input, "brushing") {
        let (rest, place) = must(placement(input.skip()))?;
        return set(&mut action.brushing, place, input, rest);
    }
    if is_word(input, "duration") {
        let (rest, long) = must(duration(input.skip()))?;
        return set(&mut action.duration, long, input, rest);
    }
    if is_word(input, "speed") {
        let (rest, pace) = must(speed(input.skip()))?;
        return set(&mut action.pace, pace, input, rest);
    }
    if is_word(input, "becoming") {
        let (rest, becoming) = must(becoming(input.skip()))?;
        return set(&mut action.becoming, Box::new(becoming), input, rest);
    }
    if is_word(input, "named") {
        let (rest, name) = must(text(input.skip()))?;
        return set(&mut action.names, name, input, rest);
    }
    if is_word(input, "alternating") {
        if action.alternating {
            return twice(input, input.skip());
        }
        action.alternating = true;
        return Ok((input.skip(), ()));
    }
    expected(input, "a manner, a target or a repetition")
}

fn set<'a, T>(slot: &mut Option<T>, value: T, start: Tokens<'a>, rest: Tokens<'a>) -> Parsed<'a, ()> {
    if slot.is_some() {
        return twice(start, rest);
    }
    *slot = Some(value);
    Ok((rest, ()))
}

fn twice<'a, T>(start: Tokens<'a>, rest: Tokens<'a>) -> Parsed<'a, T> {
    let what = start.word();
    told(
        Diagnostic::fault(start.span_to(rest), format!("`{what}` is said twice of one movement"))
            .label("the second")
            .hint("movements that follow each other are joined by `then`"),
    )
}
