//! Movements: steps joined by `then`, simultaneous ones by `while`, groups in brackets.

use super::input::{Parsed, Tokens, expected, must, told};
use super::motion::{motion, sign_of_growth};
use super::placement::placement;
use super::words::{count, duration, is_word, mark};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::syntax::{Action, Motion, Movement};
use crate::phonology::{Manner, Repetition, RepetitionKind};

/// How deep groups may nest.
const DEEPEST: usize = 32;
/// How often a movement may repeat.
const MOST_TIMES: u16 = 50;

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
    let (rest, ()) = match mark(Kind::Close, "a closing bracket")(rest) {
        Ok(closed) => closed,
        Err(_) if rest.is_empty() => {
            return told(
                Diagnostic::fault(open.span(), "this bracket is not closed")
                    .label("opened here")
                    .hint("add `)` after the last movement of the group"),
            );
        }
        Err(_) => return super::leftover(rest, "movement"),
    };
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
    match repetition(if rest.is(Kind::Comma) { rest.skip() } else { rest }) {
        Ok((after, repetition)) => Ok((after, Movement::Repeated(Box::new(group), repetition))),
        Err(nom::Err::Error(_)) => Ok((rest, group)),
        Err(other) => Err(other),
    }
}

/// A motion and what is said of it; commas between are free.
fn action<'a>(input: Tokens<'a>) -> Parsed<'a, Action> {
    let (rest, motion) =
        if is_word(input, "to") && !is_word(input.skip(), "and") { (input, Motion::Change) } else { motion(input)? };
    let mut action = Action {
        motion,
        target: None,
        brushing: None,
        manner: Vec::new(),
        repetition: None,
        duration: None,
        alternating: false,
    };
    let mut rest = rest;
    loop {
        let from = if rest.is(Kind::Comma) { rest.skip() } else { rest };
        match modifier(from, &mut action) {
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

/// `repeated 3 [growing|shrinking [n]]`, `continued 2`, `to and fro 2`.
fn repetition<'a>(input: Tokens<'a>) -> Parsed<'a, Repetition> {
    let (rest, kind) = if is_word(input, "repeated") {
        (input.skip(), RepetitionKind::FromStart)
    } else if is_word(input, "continued") {
        (input.skip(), RepetitionKind::Continue)
    } else if is_word(input, "to") && is_word(input.skip(), "and") && is_word(input.skip_n(2), "fro") {
        (input.skip_n(3), RepetitionKind::ToAndFro)
    } else {
        return expected(input, "a repetition");
    };
    let (after, times) = times(rest, if kind == RepetitionKind::ToAndFro { "to and fro" } else { input.word() })?;
    let (after, growth) = sign_of_growth(after)?;
    Ok((after, Repetition { kind, times, growth, shift: None }))
}

/// How often in all: `2`, `twice`, `several`.
pub(crate) fn times<'a>(rest: Tokens<'a>, what: &str) -> Parsed<'a, u8> {
    let words = [("twice", 2), ("several", 3), ("thrice", 3), ("once", 1)];
    let (after, times) = match words.iter().find(|(w, _)| is_word(rest, w)) {
        Some((_, n)) => (rest.skip(), *n),
        None => match count(rest, MOST_TIMES) {
            Err(nom::Err::Error(_)) => {
                return told(
                    Diagnostic::fault(rest.span(), format!("`{what}` how often?"))
                        .label("a number is missing")
                        .hint(format!("`{what} 2` is two performances in all")),
                );
            }
            other => other?,
        },
    };
    if times < 2 {
        return told(
            Diagnostic::fault(rest.span_to(after), "a movement performed once is not repeated")
                .label("from 2")
                .hint("the number counts performances in all: `repeated 2` is once and once again"),
        );
    }
    // At most `MOST_TIMES`: checked above.
    Ok((after, times as u8))
}
