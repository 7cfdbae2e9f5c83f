//! What head, trunk and face do meanwhile: `{brows raised, head tilted-left: TOI NOM}`.

use super::{DEEPEST, Reading, items};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::notation::gloss::syntax::{Face, Item, What};
use crate::notation::lex::{Kind, Token};
use crate::notation::parse::input::{Parsed, Tokens, must, told};
use crate::notation::parse::nonmanual::nonmanual;
use crate::notation::parse::{diagnostic, synonym};
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Ignored, NonManual};
use crate::phonology::Channel;

/// A span in braces, added to `all`; its faults are told and what can be read of it is kept.
pub(super) fn face<'a>(open: Tokens<'a>, depth: usize, all: &mut Vec<Item>, reading: &mut Reading) -> Tokens<'a> {
    if depth >= DEEPEST {
        reading.stop(
            open.span(),
            format!("braces more than {DEEPEST} deep"),
            "say what the face does in one pair of braces, with commas",
        );
        return open;
    }
    let before = reading.faults.len();
    let (from, values) = head(open, reading);
    let mut inside = Vec::new();
    let rest = items(from, depth + 1, &mut inside, reading);
    if reading.stopped {
        return rest;
    }
    let sound = reading.faults.len() == before;
    let rest = if rest.is_mark('}') {
        rest.skip()
    } else {
        reading.told(
            Diagnostic::fault(open.span(), "this brace is never closed")
                .label("opened here")
                .hint("close it with `}` where the face goes back"),
        );
        rest
    };
    if inside.is_empty() && sound {
        reading.told(
            Diagnostic::fault(open.span_to(rest), "nothing is signed in these braces")
                .label("here")
                .hint("the signs stand after the colon: `{brows raised: TOI NOM QUOI}`"),
        );
    } else {
        all.push(Item { what: What::Face(Face { values, items: inside }), span: Ignored(open.span_to(rest)) });
    }
    rest
}

/// The values up to the colon, each with its faults told, and where the items begin.
fn head<'a>(open: Tokens<'a>, reading: &mut Reading) -> (Tokens<'a>, Vec<(Spanned<Channel>, NonManual)>) {
    let from = open.skip();
    let here = |t: &Token| matches!(t.kind, Kind::Mark(':' | '{' | '}'));
    let length = from.all().iter().position(here).unwrap_or(from.all().len());
    let colon = from.skip_n(length);
    if !colon.is_mark(':') {
        reading.told(
            Diagnostic::fault(open.span(), "a colon is missing in these braces")
                .label("opened here")
                .hint("what the face does stands before it, the signs after it: `{brows raised: TOI NOM QUOI}`"),
        );
        return (colon, Vec::new());
    }
    let mut rest = Tokens::new(&from.all()[..length]);
    let mut values: Vec<(Spanned<Channel>, NonManual)> = Vec::new();
    if rest.is_empty() {
        reading.told(
            Diagnostic::fault(open.span().to(colon.span()), "what does the face do?")
                .label("nothing is said")
                .hint("write for example `{brows raised: …}`, `{head shake: …}`, `{mouth smile, cheeks puffed: …}`"),
        );
    }
    while !rest.is_empty() && !reading.stopped {
        match one(rest, &values) {
            Ok((after, value)) => {
                values.push(value);
                rest = after;
            }
            Err(error) => {
                let fault = diagnostic(error, rest);
                let past = fault.span;
                reading.told(fault);
                rest = next(rest, past);
            }
        }
    }
    (colon.skip(), values)
}

/// The value after the next comma that a fault does not cover.
fn next<'a>(from: Tokens<'a>, fault: Span) -> Tokens<'a> {
    let comma = from.all().iter().position(|t| t.kind == Kind::Comma && t.span.start >= fault.end);
    from.skip_n(comma.map_or(from.all().len(), |at| at + 1))
}

/// `brows raised` and the comma after it.
fn one<'a>(input: Tokens<'a>, before: &[(Spanned<Channel>, NonManual)]) -> Parsed<'a, (Spanned<Channel>, NonManual)> {
    let word = input.word();
    let Some(channel) = Channel::ALL.into_iter().find(|c| c.name().eq_ignore_ascii_case(word)) else {
        return no_channel(input);
    };
    let channel = Spanned::new(channel, input.span());
    if let Some((first, _)) = before.iter().find(|(c, _)| *c == channel) {
        let fault = Diagnostic::fault(channel.span, format!("`{}` is said twice", channel.value.name()));
        return told(fault.label("the second").related(first.span, "the first"));
    }
    let (rest, value) = must(nonmanual(input.skip()))?;
    match rest.first() {
        None => Ok((rest, (channel, value))),
        Some(t) if t.kind == Kind::Comma && !rest.skip().is_empty() => Ok((rest.skip(), (channel, value))),
        Some(t) if t.kind == Kind::Comma => {
            told(Diagnostic::fault(t.span, "a comma with nothing after it").label("leave it out"))
        }
        Some(t) => told(
            Diagnostic::fault(t.span, format!("`{}` is not expected here", t.text))
                .label("the value ended before this")
                .hint("values are separated by commas: `{brows raised, head tilted-left: …}`"),
        ),
    }
}

fn no_channel<'a, T>(input: Tokens<'a>) -> Parsed<'a, T> {
    let word = input.first().map_or("", |t| t.text);
    let fault = Diagnostic::fault(input.span(), format!("`{word}` is no part of head, trunk or face")).label("here");
    let names = Channel::ALL.map(Channel::name);
    let plural = format!("{word}s");
    let synonym = synonym(word).or_else(|| synonym(&plural)).filter(|w| names.contains(w));
    told(match synonym.or_else(|| nearest(word, names)) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint(format!("they are {}", names.join(", "))),
    })
}
