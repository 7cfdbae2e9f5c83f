//! Faults of the XML itself, in plain words.

use crate::diagnostics::{Diagnostic, Span};
use roxmltree::{Error, TextPos};

/// What the parser of XML says, with its place.
pub(super) fn fault(error: &Error, text: &str, name: &str) -> Diagnostic {
    let at = match error {
        Error::UnclosedRootNode | Error::NoRootNode | Error::UnexpectedEndOfStream => text.trim_end().len(),
        error => offset(text, error.pos()),
    };
    let end = text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
    let told = |message: &str| Diagnostic::fault(Span::new(at, end), message.to_owned());
    match error {
        Error::NoRootNode => told(&format!("there is no {name} in this file")).label("the end of the file"),
        Error::UnclosedRootNode => {
            told("the file ends before its first element is closed").label("the end of the file")
        }
        Error::UnexpectedEndOfStream => told("the file ends in the middle of an element").label("the end of the file"),
        Error::UnexpectedCloseTag(open, closed, _) => {
            told(&format!("`</{}>` closes `<{}>`", super::short(closed), super::short(open)))
                .label(format!("expected `</{}>`", super::short(open)))
        }
        Error::DuplicatedAttribute(name, _) => {
            told(&format!("`{}` is written twice on one element", super::short(name))).label("the second one")
        }
        Error::UnknownEntityReference(name, _) => told(&format!("`&{};` is no entity of XML", super::short(name)))
            .label("unknown")
            .hint("a character may be written by number: `&#233;`; an `&` itself is written `&amp;`"),
        Error::MalformedEntityReference(_) => {
            told("an `&` begins an entity that does not end").label("here").hint("an `&` itself is written `&amp;`")
        }
        Error::UnknownNamespace(prefix, _) => told(&format!("the prefix `{}:` was not declared", super::short(prefix)))
            .label("here")
            .hint(format!("elements of {name} need no prefix")),
        Error::InvalidAttributeValue(_) => told("a value has a `<`")
            .label("here")
            .hint("is its closing quotation mark missing? a `<` is written `&lt;`"),
        Error::NonXmlChar(c, _) => {
            told(&format!("U+{:04X} may not stand in XML", u32::from(*c))).label("this character")
        }
        Error::InvalidChar(..) | Error::InvalidChar2(..) => {
            told(&format!("this is not well-formed XML: {}", without_place(&error.to_string())))
                .label("here")
                .hint("is a quotation mark, a `/` or a `>` missing before?")
        }
        other => told(&format!("this is not well-formed XML: {}", without_place(&other.to_string()))).label("here"),
    }
}

/// The parser's message without the place at its end, which is shown.
fn without_place(message: &str) -> &str {
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b':');
    message.rsplit_once(" at ").filter(|(_, place)| digits(place)).map_or(message, |(words, _)| words)
}

/// The byte of a line and column, both from 1.
fn offset(text: &str, at: TextPos) -> usize {
    let before: usize = text.split_inclusive('\n').take(at.row.saturating_sub(1) as usize).map(str::len).sum();
    let line = &text[before..];
    let column = line.char_indices().nth(at.col.saturating_sub(1) as usize).map_or(line.len(), |(i, _)| i);
    before + column
}
