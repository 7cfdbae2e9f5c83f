//! Orientations, contacts and hands.

use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{hand_point, is_word, keyword, length, must_heading};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Contact, ContactKind, Orientation};
use crate::phonology::{HandPoint, Hands, Relation, Symmetry};

/// `fingers HEADING, palm HEADING, along path`, in any order, each at most once.
pub(crate) fn orientation<'a>(input: Tokens<'a>) -> Parsed<'a, Orientation> {
    let mut value = Orientation::default();
    let mut rest = input;
    loop {
        let part = rest;
        if is_word(rest, "along") {
            let (after, ()) = must(keyword("path")(rest.skip()))?;
            value.along_path = true;
            rest = after;
        } else {
            let slot = if is_word(rest, "fingers") {
                &mut value.fingers
            } else if is_word(rest, "palm") {
                &mut value.palm
            } else {
                return no_part(rest);
            };
            let which = rest.word();
            let (after, heading) = must_heading(rest.skip())?;
            let span = rest.skip().span_to(after);
            if let Some(first) = slot {
                return told(
                    Diagnostic::fault(part.span_to(after), format!("`{which}` is given twice"))
                        .label("the second")
                        .related(first.span, "the first"),
                );
            }
            *slot = Some(Spanned::new(heading, span));
            rest = after;
        }
        if rest.is(Kind::Comma) {
            rest = rest.skip();
        } else if ["fingers", "palm", "along"].iter().any(|w| is_word(rest, w)) {
            return told(
                Diagnostic::fault(rest.span(), format!("a comma is missing before `{}`", rest.word()))
                    .label("here")
                    .hint("write `fingers …, palm …`"),
            );
        } else {
            return Ok((rest, value));
        }
    }
}

fn no_part<'a, T>(at: Tokens<'a>) -> Parsed<'a, T> {
    let word = at.word();
    if word.is_empty() {
        return expected(at, "`fingers` or `palm` and a direction");
    }
    let fault = Diagnostic::fault(at.span(), format!("`{word}` is not part of an orientation")).label("here");
    told(match nearest(word, ["fingers", "palm", "along"]) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint("write `fingers up, palm left`: where the fingers point and where the palm faces"),
    })
}

/// `strong POINT|hand touches|close to|crosses|interlocks|3cm from weak POINT|hand`
pub(crate) fn contact<'a>(input: Tokens<'a>) -> Parsed<'a, Contact> {
    if let Ok((after, _)) = contact_kind(input) {
        let words = input.all().iter().map(|t| t.text).take(input.all().len() - after.all().len());
        let meets = words.collect::<Vec<_>>().join(" ");
        return told(
            Diagnostic::fault(input.span(), "which parts of the hands meet?")
                .label("the strong hand stands before it")
                .hint(format!("write `strong hand {meets} weak hand` where no part is to be named")),
        );
    }
    let (rest, ()) =
        keyword("strong")(input).or_else(|_: nom::Err<_>| expected(input, "`strong` and a point of the hand"))?;
    let (rest, strong) = must(meeting(rest))?;
    let (rest, kind) = must(contact_kind(rest))?;
    let (rest, ()) = must(keyword("weak")(rest))?;
    let (rest, weak) = must(meeting(rest))?;
    Ok((rest, Contact { strong, kind, weak }))
}

/// A point of the hand; `hand` names none.
fn meeting<'a>(input: Tokens<'a>) -> Parsed<'a, Option<HandPoint>> {
    if is_word(input, "hand") {
        return Ok((input.skip(), None));
    }
    hand_point(input).map(|(rest, point)| (rest, Some(point)))
}

fn contact_kind<'a>(input: Tokens<'a>) -> Parsed<'a, ContactKind> {
    let pairs = [
        ("touches", "", ContactKind::Touches),
        ("close", "to", ContactKind::CloseTo),
        ("crosses", "", ContactKind::Crosses),
        ("interlocks", "", ContactKind::Interlocks),
    ];
    for (word, next, kind) in pairs {
        if is_word(input, word) {
            let rest = input.skip();
            return if next.is_empty() { Ok((rest, kind)) } else { must(keyword("to")(rest)).map(|(r, ())| (r, kind)) };
        }
    }
    if input.word().starts_with(|c: char| c.is_ascii_digit()) {
        let (rest, far) = must(length(input))?;
        let (rest, ()) = must(keyword("from")(rest))?;
        return Ok((rest, ContactKind::LengthFrom(far)));
    }
    expected(input, "`touches`, `close to`, `crosses`, `interlocks` or `3cm from`")
}

/// `one`, `weak`, `both [mirrored|parallel] [up-down] [out-in] [alternating] [crossed]`
pub(crate) fn hands<'a>(input: Tokens<'a>) -> Parsed<'a, Hands> {
    if is_word(input, "one") || is_word(input, "strong") {
        return Ok((input.skip(), Hands::Strong));
    }
    if is_word(input, "weak") {
        return Ok((input.skip(), Hands::Weak));
    }
    if !is_word(input, "both") {
        let word = input.word();
        if is_word(input, "two") || word == "2" {
            return told(
                Diagnostic::fault(input.span(), "two hands are `both`").label("here").hint("write `hands both`"),
            );
        }
        if is_word(input, "mirrored") || is_word(input, "parallel") {
            return told(
                Diagnostic::fault(input.span(), format!("`{word}` is said of both hands"))
                    .label("here")
                    .hint(format!("write `hands both {word}`")),
            );
        }
        return expected(input, "`one`, `weak` or `both`");
    }
    let mut rest = input.skip();
    let relation = if is_word(rest, "mirrored") {
        Relation::Mirrored
    } else if is_word(rest, "parallel") {
        Relation::Parallel
    } else {
        return Ok((rest, Hands::Both(None)));
    };
    rest = rest.skip();
    let mut symmetry = Symmetry { relation, up_down: false, out_in: false, alternating: false, crossed: false };
    loop {
        let flag = match rest.word().to_ascii_lowercase().as_str() {
            "up-down" => &mut symmetry.up_down,
            "out-in" => &mut symmetry.out_in,
            "alternating" => &mut symmetry.alternating,
            "crossed" => &mut symmetry.crossed,
            _ => return Ok((rest, Hands::Both(Some(symmetry)))),
        };
        if *flag {
            return told(
                Diagnostic::fault(rest.span(), format!("`{}` is given twice", rest.word())).label("the second"),
            );
        }
        *flag = true;
        rest = rest.skip();
    }
}
