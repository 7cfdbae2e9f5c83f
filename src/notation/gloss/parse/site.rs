//! Where a sign is made or what is pointed at: `left-high`, `(0.6,1.4,0.5)`, the name of a sign made before.

use crate::diagnostics::Diagnostic;
use crate::notation::gloss::syntax::Site;
use crate::notation::lex::{Kind, unquote};
use crate::notation::parse::input::{Parsed, Tokens, expected, told};
use crate::notation::parse::placement::{FURTHEST_M, step, take_step};
use crate::phonology::Space;
use unicode_normalization::UnicodeNormalization;

/// A site after `@`: a bracket with a point, or a word.
pub(super) fn site<'a>(input: Tokens<'a>) -> Parsed<'a, Site> {
    if input.is(Kind::Open) { point(input) } else { named(input) }
}

/// A site in brackets: `(0.6,1.4,0.5)`, `(MAISON)`, `(left-high)`.
pub(super) fn in_brackets<'a>(input: Tokens<'a>) -> Parsed<'a, Site> {
    let inside = input.skip();
    // Names may begin with a digit, but then no comma follows them.
    if is_number(inside.word()) || inside.skip().is(Kind::Comma) {
        return point(input);
    }
    let (rest, site) = named(inside)?;
    if !rest.is(Kind::Close) {
        return unclosed(input, rest, "one place stands in the brackets: `IX(0.6,1.4,0.5)`, `IX(left)`, `IX(MAISON)`");
    }
    Ok((rest.skip(), site))
}

/// The fault of a bracket without its partner.
pub(super) fn unclosed<'a, T>(open: Tokens<'a>, at: Tokens<'a>, hint: &str) -> Parsed<'a, T> {
    told(
        Diagnostic::fault(at.span(), "the closing bracket is missing")
            .label("expected `)`")
            .hint(hint)
            .related(open.span(), "opened here"),
    )
}

/// `left-high`, or else the name of a sign.
fn named<'a>(input: Tokens<'a>) -> Parsed<'a, Site> {
    let Some(token) = input.first() else { return expected(input, PLACE) };
    match token.kind {
        Kind::Text => Ok((input.skip(), Site::Referent(unquote(token.text).trim().nfc().collect()))),
        Kind::Word => match cell(token.text) {
            Some(Ok(cell)) => Ok((input.skip(), Site::Space(cell))),
            Some(Err(())) => told(
                Diagnostic::fault(token.span, "an axis of the space is said twice")
                    .label("here")
                    .hint("one of left, centre, right; one of high, mid-height, low; one of near, far"),
            ),
            None if is_number(token.text) => told(
                Diagnostic::fault(token.span, "a point stands in brackets")
                    .label("here")
                    .hint("write `@(0.3,1.2,0.4)`"),
            ),
            None => Ok((input.skip(), Site::Referent(token.text.nfc().collect()))),
        },
        Kind::Open | Kind::Close | Kind::Comma | Kind::Equals | Kind::Mark(_) => expected(input, PLACE),
    }
}

const PLACE: &str = "a place such as `left`, `left-high`, `(0.3,1.2,0.4)` or the name of a sign made before";

/// The cell that hyphenated words name; an error where an axis is said twice; `None` where they are other words.
fn cell(words: &str) -> Option<Result<Space, ()>> {
    let mut cell = Space::default();
    let mut said = [false; 3];
    let mut twice = false;
    // `mid-height` has a hyphen of its own.
    let lower = words.to_ascii_lowercase().replace("mid-height", "mid_height");
    for word in lower.split('-') {
        let (axis, value) = step(if word == "mid_height" { "mid-height" } else { word })?;
        twice |= std::mem::replace(&mut said[axis], true);
        take_step(&mut cell, axis, value);
    }
    Some(if twice { Err(()) } else { Ok(cell) })
}

/// Whether a name means something else as a place, so that as the name of a sign it stands in quotes.
pub(crate) fn is_place(name: &str) -> bool {
    is_number(name) || cell(name).is_some()
}

fn is_number(word: &str) -> bool {
    let digits = word.trim_start_matches(['+', '-']).trim_start_matches('.');
    digits.starts_with(|c: char| c.is_ascii_digit()) && word.parse::<f64>().is_ok()
}

/// `(0.6,1.4,0.5)`
fn point<'a>(input: Tokens<'a>) -> Parsed<'a, Site> {
    let mut at = [0.0; 3];
    let mut rest = input.skip();
    for (i, coordinate) in at.iter_mut().enumerate() {
        if i > 0 {
            if !rest.is(Kind::Comma) {
                return three_numbers(input, rest);
            }
            rest = rest.skip();
        }
        if !is_number(rest.word()) {
            return three_numbers(input, rest);
        }
        *coordinate = rest.word().parse().unwrap_or(f64::NAN);
        if coordinate.is_nan() || coordinate.abs() > FURTHEST_M {
            return told(
                Diagnostic::fault(rest.span(), "this point is out of reach")
                    .label("coordinates are metres, from -10 to 10"),
            );
        }
        rest = rest.skip();
    }
    if rest.is(Kind::Close) {
        return Ok((rest.skip(), Site::Point(at)));
    }
    if rest.is(Kind::Comma) { three_numbers(input, rest) } else { unclosed(input, rest, POINT) }
}

const POINT: &str = "a point is `(0.6,1.4,0.5)`: to the left, up from the floor, out; in metres, with decimal points";

fn three_numbers<'a, T>(open: Tokens<'a>, at: Tokens<'a>) -> Parsed<'a, T> {
    let word = at.word();
    let number = word.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let fault = Diagnostic::fault(at.span(), "a point is three numbers, separated by commas")
        .related(open.span(), "of this point");
    told(if number != word && is_number(number) {
        fault.label("without a unit").hint("the numbers are metres: `(0.6,1.4,0.5)`")
    } else {
        fault.label("here").hint(POINT)
    })
}
