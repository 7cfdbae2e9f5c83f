//! What is said of a sign as a whole: its speed, the configurations attested on it, where it is moved to.

use super::configuration::configuration;
use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{is_one_of, is_word, number};
use super::{leftover, meaning, placement};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::syntax::{Attested, Place, Relocation};
use crate::phonology::{Forced, Sign};

/// A factor of time: 2 is twice as fast.
pub(crate) fn speed<'a>(input: Tokens<'a>) -> Parsed<'a, f64> {
    let (rest, value) = number(input)?;
    if Sign::SPEEDS.contains(&value) {
        return Ok((rest, value));
    }
    told(
        Diagnostic::fault(input.span(), "a speed lies between 0.05 and 20")
            .label("here")
            .hint("2 is twice as fast, 0.5 half as fast"),
    )
}

/// `CONFIGURATION [MEANINGS] { then CONFIGURATION [MEANINGS] }`
pub(crate) fn base<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<Attested>> {
    let mut all = Vec::new();
    let mut rest = input;
    loop {
        let (after, one) = attested(rest)?;
        all.push(one);
        if !is_word(after, "then") {
            return Ok((after, all));
        }
        rest = after.skip();
    }
}

/// A configuration ends where a language and a text begin: `Y, thumb out en "snail"`.
fn attested<'a>(input: Tokens<'a>) -> Parsed<'a, Attested> {
    let tokens = input.all();
    let end = tokens.iter().position(|t| t.kind == Kind::Word && t.text.eq_ignore_ascii_case("then"));
    let end = end.unwrap_or(tokens.len());
    let tag = |i: &usize| {
        tokens[*i].kind == Kind::Word
            && tokens.get(i + 1).is_some_and(|t| t.kind == Kind::Text)
            && !is_one_of(tokens[*i].text, &["and", "between"])
    };
    let cut = (0..end).find(tag).unwrap_or(end);
    let (rest, configuration) = must(configuration(input.first_n(cut)))?;
    if !rest.is_empty() {
        return leftover(rest, "configuration");
    }
    let (rest, meaning) = if cut < end { meaning(input.skip_n(cut))? } else { (input.skip_n(cut), Vec::new()) };
    Ok((rest, Attested { configuration, meaning }))
}

/// `PLACE [, forced]`; the words of signing space stand without `space` too: `left high`.
pub(crate) fn relocation<'a>(input: Tokens<'a>) -> Parsed<'a, Relocation> {
    let axes = ["left", "centre", "center", "right", "high", "mid-height", "low", "near", "far"];
    let (rest, place) = if is_one_of(input.word(), &axes) {
        placement::space(input)?
    } else if input.is_empty() {
        return expected(input, "a place such as `left`, `space left high` or `point 0.5 1.2 0.4`");
    } else {
        must(placement::place(input, 0))?
    };
    if matches!(place, Place::Towards(_)) {
        return told(
            Diagnostic::fault(input.span_to(rest), "a sign is moved to a place, not to where one points at it")
                .label("here")
                .hint("leave out `pointing at`"),
        );
    }
    let forced = if rest.is(Kind::Comma) { rest.skip() } else { rest };
    if is_word(forced, "forced") {
        return Ok((forced.skip(), Relocation { place, forced: Forced::Yes }));
    }
    Ok((rest, Relocation { place, forced: Forced::No }))
}
