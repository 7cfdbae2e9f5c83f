//! The posture that a hand takes on during a movement: `becoming ( configuration 5 and orientation palm up )`.

use super::configuration::configuration;
use super::input::{Parsed, Tokens, expected, must, told};
use super::orientation::{contact, orientation};
use super::synonym;
use super::words::{closed, is_word};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::Becoming;

/// What stands in the brackets, for hints.
const EXAMPLE: &str = "write for example `becoming ( configuration 5 and orientation palm up )`";

/// `( FACET { and FACET } )`, after the word `becoming`.
pub(crate) fn becoming<'a>(open: Tokens<'a>) -> Parsed<'a, Becoming> {
    if !open.is(Kind::Open) {
        return told(
            Diagnostic::fault(open.span(), "what does the hand become?")
                .label("a posture in brackets stands here")
                .hint(EXAMPLE),
        );
    }
    let mut made = Becoming::default();
    let mut rest = open.skip();
    loop {
        let (after, ()) = facet(rest, &mut made)?;
        rest = after;
        if !is_word(rest, "and") {
            break;
        }
        rest = rest.skip();
    }
    let (rest, ()) = closed(open, rest, "becoming", "add `)` after the posture")?;
    Ok((rest, made))
}

fn facet<'a>(input: Tokens<'a>, made: &mut Becoming) -> Parsed<'a, ()> {
    let from = input.skip();
    if is_word(input, "configuration") {
        let (rest, value) = must(configuration(from))?;
        return set(&mut made.configuration, value, input, rest);
    }
    if is_word(input, "orientation") {
        let (rest, value) = must(orientation(from))?;
        return set(&mut made.orientation, value, input, rest);
    }
    if is_word(input, "contact") {
        let (rest, value) = must(contact(from))?;
        return set(&mut made.contact, value, input, rest);
    }
    let word = input.word();
    if word.is_empty() {
        return must(expected(input, "`configuration`, `orientation` or `contact`"));
    }
    let known = ["configuration", "orientation", "contact"];
    let fault = Diagnostic::fault(input.span(), format!("`{word}` is no part of a posture")).label("here");
    let ours = synonym(word).filter(|ours| known.contains(ours)).or_else(|| nearest(word, known));
    told(match ours {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None if is_word(input, "placement") => fault.hint("a movement leads to a place by `to`: `to chest, touch`"),
        None => fault.hint(EXAMPLE),
    })
}

fn set<'a, T>(slot: &mut Option<T>, value: T, start: Tokens<'a>, rest: Tokens<'a>) -> Parsed<'a, ()> {
    if slot.is_some() {
        let fault = Diagnostic::fault(start.span(), format!("`{}` is said twice of one posture", start.word()));
        return told(
            fault.label("the second").hint("a hand that changes twice does so in two movements, joined by `then`"),
        );
    }
    *slot = Some(value);
    Ok((rest, ()))
}
