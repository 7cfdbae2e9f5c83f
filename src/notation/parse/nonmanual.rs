//! Non-manual values: `raised strong`, `towards up-left 60%`, `at other palm`, `mouthing "bOl"`, `( nod while tilted-left )`.

use super::input::{Parsed, Tokens, must, told};
use super::placement::placement;
use super::tier::is_key;
use super::whole::speed;
use super::words::{closed, is_percentage, is_word, must_heading, name, text};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::syntax::{NonManual, NonManualWhat};
use crate::phonology::Amount;

/// Words that end a non-manual name.
pub(crate) const STOPS: [&str; 8] = ["then", "at", "slight", "slightly", "strong", "strongly", "while", "speed"];
/// Words that a value other than a named one begins with.
pub(crate) const HEADS: [&str; 4] = ["towards", "toward", "at", "mouthing"];
/// How deep brackets may nest.
const DEEPEST: usize = 16;

/// A value, how much of it and how fast.
pub(crate) fn nonmanual<'a>(input: Tokens<'a>) -> Parsed<'a, NonManual> {
    value(input, 0)
}

fn value<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, NonManual> {
    let (mut rest, mut value) = if input.is(Kind::Open) {
        group(input, depth)?
    } else {
        what(input).map(|(rest, what)| (rest, plain(what)))?
    };
    loop {
        let before = if rest.is(Kind::Comma) { rest.skip() } else { rest };
        if let Some((after, more)) = amount(before)? {
            if value.amount != Amount::Plain {
                return twice(before, "the amount");
            }
            (rest, value.amount) = (after, more);
        } else if is_word(rest, "speed") {
            let (after, pace) = must(speed(rest.skip()))?;
            if value.pace.is_some() {
                return twice(rest, "the speed");
            }
            (rest, value.pace) = (after, Some(pace));
        } else {
            return Ok((rest, value));
        }
    }
}

fn twice<'a, T>(at: Tokens<'a>, what: &str) -> Parsed<'a, T> {
    told(Diagnostic::fault(at.span(), format!("{what} is said twice of one value")).label("the second"))
}

fn plain(what: NonManualWhat) -> NonManual {
    NonManual { what, amount: Amount::Plain, pace: None }
}

/// `( VALUE { while VALUE } { then … } )`
fn group<'a>(open: Tokens<'a>, depth: usize) -> Parsed<'a, NonManual> {
    if depth >= DEEPEST {
        return told(Diagnostic::fault(open.span(), "brackets are nested too deeply").label("here"));
    }
    let (rest, all) = joined(open.skip(), "then", |input| {
        let (rest, parts) = joined(input, "while", |input| must(value(input, depth + 1)))?;
        Ok((rest, one_or(parts, NonManualWhat::Together)))
    })?;
    let (rest, ()) = closed(open, rest, "brackets", "add `)` after the last of these values")?;
    Ok((rest, one_or(all, NonManualWhat::Sequence)))
}

fn joined<'a>(
    input: Tokens<'a>,
    by: &str,
    one: impl Fn(Tokens<'a>) -> Parsed<'a, NonManual>,
) -> Parsed<'a, Vec<NonManual>> {
    let (mut rest, first) = one(input)?;
    let mut all = vec![first];
    while is_word(rest, by) {
        let (after, next) = one(rest.skip())?;
        all.push(next);
        rest = after;
    }
    Ok((rest, all))
}

/// The value itself where there is one; brackets around it say nothing.
fn one_or(mut parts: Vec<NonManual>, join: fn(Vec<NonManual>) -> NonManualWhat) -> NonManual {
    match parts.pop() {
        Some(only) if parts.is_empty() => only,
        last => {
            parts.extend(last);
            plain(join(parts))
        }
    }
}

/// `slight`, `strong`, `60%`, where it is said.
fn amount(input: Tokens<'_>) -> Result<Option<(Tokens<'_>, Amount)>, nom::Err<super::input::Mistake>> {
    let words = [
        ("slight", Amount::Slight),
        ("slightly", Amount::Slight),
        ("strong", Amount::Strong),
        ("strongly", Amount::Strong),
    ];
    if let Some((_, amount)) = words.iter().find(|(word, _)| is_word(input, word)) {
        return Ok(Some((input.skip(), *amount)));
    }
    if !is_percentage(input.word()) {
        return Ok(None);
    }
    match input.word().trim_end_matches('%').parse::<u16>() {
        Ok(percent) if (1..=300).contains(&percent) => Ok(Some((input.skip(), Amount::of(f64::from(percent) / 100.0)))),
        _ => told(
            Diagnostic::fault(input.span(), "a percentage is a whole number from 1 to 300")
                .label("here")
                .hint("`100%` is the value as the inventory has it; `slight` is 50%, `strong` 150%"),
        )
        .map(|(_, never)| never),
    }
}

fn what<'a>(input: Tokens<'a>) -> Parsed<'a, NonManualWhat> {
    if is_word(input, "towards") || is_word(input, "toward") {
        let (rest, heading) = must_heading(input.skip())?;
        return Ok((rest, NonManualWhat::Towards(heading)));
    }
    if is_word(input, "at") && !is_key(input) {
        let (rest, place) = must(placement(input.skip()))?;
        return Ok((rest, NonManualWhat::At(Box::new(place))));
    }
    if is_word(input, "mouthing") {
        let (rest, sounds) = must(text(input.skip()))?;
        return Ok((rest, NonManualWhat::Mouthing(sounds)));
    }
    let (rest, value) = name(input, &STOPS, "a value of this tier")?;
    Ok((rest, NonManualWhat::Named(value)))
}
