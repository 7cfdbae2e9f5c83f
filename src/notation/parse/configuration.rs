//! Hand configurations: `NAME`, `between A and B`, and changes after commas.

use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{choice, closed, digit, digits, is_word, keyword, name, number};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Between, Configuration};
use crate::phonology::{Bend, Digit, Digits, HandPart, HandshapeChange, Opening, ThumbPosition};

/// Words that end the name of a handshape.
pub(crate) const STOPS: [&str; 3] = ["then", "at", "and"];

/// `NAME | between MIXED and MIXED` and `, CHANGE …`.
pub(crate) fn configuration<'a>(input: Tokens<'a>) -> Parsed<'a, Configuration> {
    if !is_word(input, "between") {
        let (rest, base) = handshape(input)?;
        let (rest, changes) = changes(rest)?;
        return Ok((rest, Configuration { base, between: None, changes }));
    }
    let (rest, (base, first)) = must(mixed(input.skip()))?;
    if rest.is(Kind::Comma) {
        let fault = Diagnostic::fault(rest.span(), "which of the two handshapes does this change?").label("here");
        let name = &base.value;
        return told(
            fault.hint(format!("changes of one stand in brackets with it: `between ( {name}, thumb out ) and …`")),
        );
    }
    let (rest, ()) = must(keyword("and")(rest))?;
    let (rest, (second, own)) = must(mixed(rest))?;
    let (rest, changes) = changes(rest)?;
    let between = Some(Box::new(Between { first, second, changes: own }));
    Ok((rest, Configuration { base, between, changes }))
}

fn handshape<'a>(input: Tokens<'a>) -> Parsed<'a, Spanned<String>> {
    name(input, &STOPS, "a handshape")
}

/// `NAME | ( NAME { , CHANGE } )`
fn mixed<'a>(input: Tokens<'a>) -> Parsed<'a, (Spanned<String>, Vec<HandshapeChange>)> {
    if !input.is(Kind::Open) {
        return handshape(input).map(|(rest, name)| (rest, (name, Vec::new())));
    }
    let (rest, name) = must(handshape(input.skip()))?;
    let (rest, changes) = changes(rest)?;
    let hint = "add `)` after the handshape and its changes";
    if is_word(rest, "and") {
        return told(Diagnostic::fault(input.span(), "this bracket is not closed").label("opened here").hint(hint));
    }
    let (rest, ()) = closed(input, rest, "configuration", hint)?;
    Ok((rest, (name, changes)))
}

/// `{ , CHANGE }`
fn changes<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<HandshapeChange>> {
    let mut all = Vec::new();
    let mut rest = input;
    while rest.is(Kind::Comma) {
        let (after, more) = must(change(rest.skip()))?;
        all.push(more);
        rest = after;
    }
    Ok((rest, all))
}

/// `thumb out`, `index hooked`, `bent`, `spread`, `on ring pinky`, `index over middle`, `index touching middle nail`, …
pub(crate) fn change<'a>(input: Tokens<'a>) -> Parsed<'a, HandshapeChange> {
    let alone = [
        ("spread", HandshapeChange::Spread(true)),
        ("together", HandshapeChange::Spread(false)),
        ("tight", HandshapeChange::Opening(Opening::Tight)),
        ("slack", HandshapeChange::Opening(Opening::Slack)),
    ];
    if let Some((_, change)) = alone.iter().find(|(word, _)| is_word(input, word)) {
        return Ok((input.skip(), *change));
    }
    if is_word(input, "on") {
        return must(some_digits(input.skip())).map(|(rest, digits)| (rest, HandshapeChange::On(digits)));
    }
    if is_word(input, "except") {
        return must(some_digits(input.skip())).map(|(rest, digits)| (rest, HandshapeChange::Except(digits)));
    }
    if is_word(input, "thumb") && is_word(input.skip(), "between") {
        let (rest, a) = must(digit(input.skip_n(2)))?;
        let rest = if is_word(rest, "and") { rest.skip() } else { rest };
        let (rest, b) = must(digit(rest))?;
        return Ok((rest, HandshapeChange::ThumbBetween(a, b)));
    }
    if is_word(input, "thumb")
        && let Ok((rest, position)) = choice(input.skip(), &ThumbPosition::ALL, ThumbPosition::name, "")
    {
        return Ok((rest, HandshapeChange::Thumb(position)));
    }
    let (rest, fingers) = digits(input)?;
    if is_word(rest, "over") {
        return over(input, rest, fingers);
    }
    if is_word(rest, "touching") {
        return touching(input, rest.skip(), fingers);
    }
    if is_word(rest, "joints") {
        return joints(rest.skip(), fingers);
    }
    match choice(rest, &Bend::ALL, Bend::name, "") {
        Ok((after, bend)) => Ok((after, HandshapeChange::Bend(fingers, bend))),
        Err(_) => no_change(input, rest),
    }
}

/// At least one finger.
fn some_digits<'a>(input: Tokens<'a>) -> Parsed<'a, Digits> {
    let (rest, all) = digits(input)?;
    if all.is_empty() { expected(input, "a finger: index, middle, ring, pinky or thumb") } else { Ok((rest, all)) }
}

/// The one finger of a set.
fn only(fingers: Digits) -> Option<Digit> {
    let mut all = fingers.iter();
    all.next().filter(|_| all.next().is_none())
}

fn over<'a>(start: Tokens<'a>, at: Tokens<'a>, fingers: Digits) -> Parsed<'a, HandshapeChange> {
    let (after, under) = must(digit(at.skip()))?;
    match only(fingers).filter(|one| *one != under) {
        Some(one) => Ok((after, HandshapeChange::Cross(one, under))),
        None => told(
            Diagnostic::fault(start.span_to(after), "one finger crosses over one other")
                .label("here")
                .hint("write for example `index over middle`"),
        ),
    }
}

/// `DIGIT PART`, of the thumb also `PART` alone.
fn touching<'a>(start: Tokens<'a>, input: Tokens<'a>, fingers: Digits) -> Parsed<'a, HandshapeChange> {
    let part = |at| {
        choice(at, &HandPart::OF_A_DIGIT, HandPart::name, "a part of a finger: tip, nail, pad, midjoint, base or side")
    };
    if only(fingers) == Some(Digit::Thumb)
        && let Ok((rest, part)) = part(input)
    {
        return Ok((rest, HandshapeChange::ThumbAt(part)));
    }
    let (rest, touched) = must(digit(input))?;
    let (after, part) = must(part(rest))?;
    match only(fingers).filter(|one| *one != touched) {
        Some(one) => Ok((after, HandshapeChange::Meet(one, part, touched))),
        None => told(
            Diagnostic::fault(start.span_to(after), "one finger touches one other")
                .label("here")
                .hint("write for example `index touching middle nail`"),
        ),
    }
}

/// `QUARTERS QUARTERS QUARTERS`: knuckle, middle and last joint.
fn joints<'a>(input: Tokens<'a>, fingers: Digits) -> Parsed<'a, HandshapeChange> {
    let mut bends = [0; 3];
    let mut rest = input;
    for bend in &mut bends {
        match number(rest) {
            Ok((after, n)) if n.fract() == 0.0 && (0.0..=4.0).contains(&n) => {
                // A whole number up to 4: checked above.
                *bend = n as u8;
                rest = after;
            }
            _ => {
                return told(
                    Diagnostic::fault(rest.span(), "the bends of a finger's joints are three numbers from 0 to 4")
                        .label("here")
                        .hint("write for example `index joints 4 1 0`: knuckle, middle and last joint, in quarters of their range"),
                );
            }
        }
    }
    Ok((rest, HandshapeChange::Joints(fingers, bends)))
}

fn no_change<'a, T>(start: Tokens<'a>, at: Tokens<'a>) -> Parsed<'a, T> {
    let word = at.word();
    if word.is_empty() {
        return expected(at, "a change such as `thumb out`, `index hooked` or `spread`");
    }
    let thumb = is_word(start, "thumb");
    let known = Bend::ALL
        .map(Bend::name)
        .into_iter()
        .chain(ThumbPosition::ALL.map(ThumbPosition::name))
        .chain(Digit::ALL.map(Digit::name))
        .chain(["spread", "together", "tight", "slack", "on", "except", "over", "touching", "joints", "between"]);
    let fault = Diagnostic::fault(at.span(), format!("`{word}` is not a change of a handshape")).label("here");
    if is_word(at, "orientation") || is_word(at, "contact") {
        return told(fault.hint(format!("the parts of a posture are joined by `and`: `… and {word} …`")));
    }
    told(match nearest(word, known) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None if thumb => fault.hint("the thumb is along, out, across, opposed, enclosed, bent like a finger, `between index middle` or `touching index pad`"),
        None => fault.hint(format!(
            "changes are {}, spread, together, tight, slack, `thumb out`, `on ring pinky`, `except index`, `index over middle`, `index touching middle nail`, `joints 4 1 0`; fingers may stand before a bend: `index hooked`",
            Bend::ALL.map(Bend::name).join(", ")
        )),
    })
}
