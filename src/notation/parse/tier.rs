//! Values joined by `then`, and the keys they stand at.

use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{count, is_word, keyword};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::syntax::{Ignored, Key, Placed, Values};
use crate::phonology::Sign;

/// The most keys that `at key` counts to.
pub(crate) const MOST_KEYS: u16 = Sign::MOST_INTERVALS as u16 + 1;

/// `VALUE [at KEY] { then VALUE [at KEY] }`
pub(crate) fn values<'a, T>(input: Tokens<'a>, value: impl Fn(Tokens<'a>) -> Parsed<'a, T>) -> Parsed<'a, Values<T>> {
    let mut all = Vec::new();
    let mut rest = input;
    loop {
        let (after, v) = must(value(rest))?;
        let span = rest.span_to(after);
        let (after, at) = key(after)?;
        all.push(Placed { value: v, at, span: Ignored(span) });
        if !is_word(after, "then") {
            return Ok((after, all));
        }
        rest = after.skip();
    }
}

/// Whether a key is named here: `at start`, `at middle`, `at end`, `at key 2`.
pub(crate) fn is_key(input: Tokens) -> bool {
    is_word(input, "at") && ["start", "middle", "end", "key"].iter().any(|w| is_word(input.skip(), w))
}

fn key<'a>(input: Tokens<'a>) -> Parsed<'a, Option<Spanned<Key>>> {
    if !is_word(input, "at") {
        return Ok((input, None));
    }
    let (rest, at) = must(named(input.skip()))?;
    if let Some(number) = rest.word().parse::<u8>().ok().filter(|_| matches!(at, Key::Start | Key::End)) {
        return told(
            Diagnostic::fault(rest.span(), "a number after `start` or `end`")
                .label("not expected here")
                .hint(format!("a key by its number is `at key {number}`")),
        );
    }
    Ok((rest, Some(Spanned::new(at, input.span_to(rest)))))
}

fn named<'a>(input: Tokens<'a>) -> Parsed<'a, Key> {
    for (word, key) in [("start", Key::Start), ("middle", Key::Middle), ("end", Key::End)] {
        if is_word(input, word) {
            return Ok((input.skip(), key));
        }
    }
    match keyword("key")(input) {
        Ok((rest, ())) => must(count(rest, MOST_KEYS)).map(|(rest, n)| (rest, Key::Number(n.into()))),
        Err(_) => expected(input, "`start`, `middle`, `end` or `key` and its number"),
    }
}
