//! Hand configurations: `NAME`, `between A and B`, and changes after commas.

use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{choice, digit, digits, is_word, keyword, name};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::Configuration;
use crate::phonology::{Bend, Digit, HandshapeChange, ThumbPosition};

/// Words that end the name of a handshape.
pub(crate) const STOPS: [&str; 3] = ["then", "at", "and"];

/// `NAME | between NAME and NAME` and `, CHANGE …`.
pub(crate) fn configuration<'a>(input: Tokens<'a>) -> Parsed<'a, Configuration> {
    let handshape = |i| name(i, &STOPS, "a handshape");
    let (rest, base, between) = if is_word(input, "between") {
        let (rest, a) = must(handshape(input.skip()))?;
        let (rest, ()) = must(keyword("and")(rest))?;
        let (rest, b) = must(handshape(rest))?;
        (rest, a, Some(b))
    } else {
        let (rest, base) = handshape(input)?;
        (rest, base, None)
    };
    let mut changes = Vec::new();
    let mut rest = rest;
    while rest.is(Kind::Comma) {
        let (after, more) = must(change(rest.skip()))?;
        changes.push(more);
        rest = after;
    }
    Ok((rest, Configuration { base, between, changes }))
}

/// `thumb out`, `index hooked`, `bent`, `spread`, `together`, `index over middle`, `thumb between index middle`.
pub(crate) fn change<'a>(input: Tokens<'a>) -> Parsed<'a, HandshapeChange> {
    if is_word(input, "spread") {
        return Ok((input.skip(), HandshapeChange::Spread(true)));
    }
    if is_word(input, "together") {
        return Ok((input.skip(), HandshapeChange::Spread(false)));
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
        let mut over = fingers.iter();
        let (after, under) = must(digit(rest.skip()))?;
        return match (over.next(), over.next()) {
            (Some(one), None) if one != under => Ok((after, HandshapeChange::Cross(one, under))),
            _ => told(
                Diagnostic::fault(input.span_to(after), "one finger crosses over one other")
                    .label("here")
                    .hint("write for example `index over middle`"),
            ),
        };
    }
    match choice(rest, &Bend::ALL, Bend::name, "") {
        Ok((after, bend)) => Ok((after, HandshapeChange::Bend(fingers, bend))),
        Err(_) => no_change(input, rest),
    }
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
        .chain(["spread", "together"]);
    let fault = Diagnostic::fault(at.span(), format!("`{word}` is not a change of a handshape")).label("here");
    told(match nearest(word, known) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None if thumb => fault.hint("the thumb is along, out, across, opposed, bent like a finger, or `between index middle`"),
        None => fault.hint(format!(
            "changes are {}, spread, together, `thumb out`, `index over middle`; fingers may stand before a bend: `index hooked`",
            Bend::ALL.map(Bend::name).join(", ")
        )),
    })
}
