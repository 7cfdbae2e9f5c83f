//! Non-manual values: `raised strong`, `towards up-left`, `at other palm`, `mouthing "bOl"`.

use super::input::{Parsed, Tokens, must};
use super::placement::placement;
use super::tier::is_key;
use super::words::{is_word, must_heading, name, text};
use crate::notation::lex::Kind;
use crate::notation::syntax::{NonManual, NonManualWhat};
use crate::phonology::Amount;

/// Words that end a non-manual name.
pub(crate) const STOPS: [&str; 6] = ["then", "at", "slight", "slightly", "strong", "strongly"];
/// Words that a value other than a named one begins with.
pub(crate) const HEADS: [&str; 4] = ["towards", "toward", "at", "mouthing"];

/// A value and how much of it.
pub(crate) fn nonmanual<'a>(input: Tokens<'a>) -> Parsed<'a, NonManual> {
    let (rest, what) = what(input)?;
    let before = if rest.is(Kind::Comma) { rest.skip() } else { rest };
    if is_word(before, "slight") || is_word(before, "slightly") {
        return Ok((before.skip(), NonManual { what, amount: Amount::Slight }));
    }
    if is_word(before, "strong") || is_word(before, "strongly") {
        return Ok((before.skip(), NonManual { what, amount: Amount::Strong }));
    }
    Ok((rest, NonManual { what, amount: Amount::Plain }))
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
