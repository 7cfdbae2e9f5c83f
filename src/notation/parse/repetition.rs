//! How often a movement is performed: `repeated 3 growing`, `to and fro once`, `repeated twice moving right small`.

use super::input::{Parsed, Tokens, expected, told};
use super::motion::{sign_of_growth, size};
use super::words::{count, is_word, must_direction};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::phonology::{Repetition, RepetitionKind, Shift};

/// How often a movement may repeat.
const MOST_TIMES: u16 = 50;

/// `repeated 3 [growing|shrinking [n]] [moving DIR [SIZE]]`, `continued 2`, `to and fro once`.
pub(crate) fn repetition<'a>(input: Tokens<'a>) -> Parsed<'a, Repetition> {
    let (rest, kind) = if is_word(input, "repeated") {
        (input.skip(), RepetitionKind::FromStart)
    } else if is_word(input, "continued") {
        (input.skip(), RepetitionKind::Continue)
    } else if is_word(input, "to") && is_word(input.skip(), "and") && is_word(input.skip_n(2), "fro") {
        (input.skip_n(3), RepetitionKind::ToAndFro)
    } else {
        return expected(input, "a repetition");
    };
    let (after, times) = match kind {
        RepetitionKind::ToAndFro => performances(rest, "to and fro", 1)?,
        RepetitionKind::FromStart | RepetitionKind::Continue => performances(rest, input.word(), 2)?,
    };
    let (after, growth) = sign_of_growth(after)?;
    let (after, shift) = shift(after)?;
    Ok((after, Repetition { kind, times, growth, shift }))
}

/// `moving DIR [SIZE]`, or nothing.
fn shift<'a>(input: Tokens<'a>) -> Parsed<'a, Option<Shift>> {
    let from = if input.is(Kind::Comma) { input.skip() } else { input };
    if !is_word(from, "moving") {
        return Ok((input, None));
    }
    let (rest, direction) = must_direction(from.skip())?;
    let (rest, size) = size(rest);
    Ok((rest, Some(Shift { direction, size })))
}

/// How often in all, from 2: `2`, `twice`, `several`.
pub(crate) fn times<'a>(rest: Tokens<'a>, what: &str) -> Parsed<'a, u8> {
    performances(rest, what, 2)
}

fn performances<'a>(rest: Tokens<'a>, what: &str, least: u16) -> Parsed<'a, u8> {
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
    if times < least {
        return told(
            Diagnostic::fault(rest.span_to(after), "a movement performed once is not repeated")
                .label("from 2")
                .hint("the number counts performances in all: `repeated 2` is once and once again"),
        );
    }
    // At most `MOST_TIMES`: checked above.
    Ok((after, times as u8))
}
