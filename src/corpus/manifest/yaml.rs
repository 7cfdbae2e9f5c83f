//! YAML as a tree with places. The only module that knows the YAML library.
//!
//! The tree is read first and typed afterwards ([`super::read`]), because a typed reader stops at the first fault, and
//! text that people wrote gives all of them at once. A plain value keeps the letters it was written with, so that the
//! glosses `no` and `010` are no boolean and no number.

use crate::diagnostics::{Diagnostic, Span, Spanned};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A node of the tree.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// Nothing: `~`, `null`, or no value after a `:`.
    Nothing,
    /// A plain or quoted value, as it is to be read.
    Text(String),
    /// A list.
    List(Vec<Spanned<Node>>),
    /// Keys and values, in their order; no key is there twice.
    Map(Vec<(Spanned<String>, Spanned<Node>)>),
}

impl Node {
    /// What it is, for a message.
    pub fn kind(&self) -> &'static str {
        match self {
            Node::Nothing => "nothing",
            Node::Text(_) => "a value",
            Node::List(_) => "a list",
            Node::Map(_) => "fields",
        }
    }
}

/// Reads one YAML document: a byte order mark is passed over, merge keys (`<<`) are merged, aliases followed (a million
/// events at most), braces nest 255 deep at most.
///
/// # Errors
/// Where the text is no YAML, has a key twice, or several documents.
///
/// ```
/// use chereme::corpus::manifest::yaml::{Node, parse};
/// let Node::Map(fields) = parse("gloss: no\n").unwrap().value else { panic!("fields") };
/// assert_eq!(fields[0].1.value, Node::Text("no".to_owned()));
/// assert_eq!((fields[0].1.span.start, fields[0].1.span.end), (7, 9));
/// ```
pub fn parse(text: &str) -> Result<Spanned<Node>, Diagnostic> {
    let options = serde_yaml::options! {
        strict_booleans: true,
        with_snippet: false,
        non_finite_float_policy: serde_yaml::options::NonFiniteFloatPolicy::PassThrough,
    };
    let skipped = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    let places = Places { text: &text[skipped..], skipped };
    let raw: serde_yaml::Spanned<Raw> =
        serde_yaml::from_str_with_options(places.text, options).map_err(|error| places.fault(&error))?;
    Ok(places.node(raw))
}

/// Where things are in the text behind its byte order mark.
struct Places<'t> {
    text: &'t str,
    skipped: usize,
}

impl Places<'_> {
    fn fault(&self, error: &serde_yaml::Error) -> Diagnostic {
        let told = error.render_with_formatter(&serde_yaml::UserMessageFormatter);
        // The place is told with the source line, and need not be in the message, too.
        let message = told.rsplit_once(" at line ").map_or(told.as_str(), |(what, _)| what);
        let span = error.location().map_or(Span::default(), |at| self.span(at));
        let fault = Diagnostic::fault(span, format!("this is no YAML that can be read: {message}"));
        let tab = message.contains("tab");
        if tab { fault.hint("YAML is set in with spaces, not with tabs") } else { fault }
    }

    fn span(&self, at: serde_yaml::Location) -> Span {
        let whole = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
        let (start, length) = match (at.span().byte_offset(), at.span().byte_len()) {
            (Some(start), Some(length)) => (whole(start), whole(length)),
            _ => (self.offset(whole(at.line()), whole(at.column())), 0),
        };
        let start = start.min(self.text.len());
        let mut end = start.saturating_add(length).min(self.text.len());
        // A map's or a list's place is its first line.
        if let Some(line) = self.text.get(start..end).and_then(|inside| inside.find('\n')) {
            end = start + line;
        }
        Span::new(start + self.skipped, end + self.skipped)
    }

    /// The byte of a line and a column in letters, both from 1.
    fn offset(&self, line: usize, column: usize) -> usize {
        let before: usize = self.text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
        let letters = self.text[before..].chars().take(column.saturating_sub(1));
        before + letters.map(char::len_utf8).sum::<usize>()
    }

    fn node(&self, raw: serde_yaml::Spanned<Raw>) -> Spanned<Node> {
        let span = self.span(raw.referenced);
        let node = match raw.value {
            Raw::Nothing => Node::Nothing,
            Raw::Text(text) => Node::Text(text),
            Raw::Plain => Node::Text(self.letters(raw.defined)),
            Raw::List(list) => Node::List(list.into_iter().map(|item| self.node(item)).collect()),
            Raw::Map(map) => {
                let entry = |(key, value): (serde_yaml::Spanned<String>, _)| {
                    (Spanned::new(key.value, self.span(key.referenced)), self.node(value))
                };
                Node::Map(map.into_iter().map(entry).collect())
            }
        };
        Spanned::new(node, span)
    }

    /// The letters of a plain value.
    fn letters(&self, at: serde_yaml::Location) -> String {
        let span = self.span(at);
        let inside = self.text.get(span.start - self.skipped..span.end - self.skipped);
        inside.unwrap_or_default().trim().to_owned()
    }
}

/// The tree as the library hands it on; a plain value that it takes for a number or a boolean has its place only.
enum Raw {
    Nothing,
    Plain,
    Text(String),
    List(Vec<serde_yaml::Spanned<Raw>>),
    Map(Vec<(serde_yaml::Spanned<String>, serde_yaml::Spanned<Raw>)>),
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Raw, D::Error> {
        deserializer.deserialize_any(RawVisitor)
    }
}

struct RawVisitor;

impl<'de> Visitor<'de> for RawVisitor {
    type Value = Raw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_str<E>(self, text: &str) -> Result<Raw, E> {
        Ok(Raw::Text(text.to_owned()))
    }

    fn visit_bool<E>(self, _: bool) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_i64<E>(self, _: i64) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_u64<E>(self, _: u64) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_i128<E>(self, _: i128) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_u128<E>(self, _: u128) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_f64<E>(self, _: f64) -> Result<Raw, E> {
        Ok(Raw::Plain)
    }

    fn visit_unit<E>(self) -> Result<Raw, E> {
        Ok(Raw::Nothing)
    }

    fn visit_none<E>(self) -> Result<Raw, E> {
        Ok(Raw::Nothing)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Raw, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Raw::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Raw, A::Error> {
        let mut map = Vec::new();
        while let Some(entry) = entries.next_entry()? {
            map.push(entry);
        }
        Ok(Raw::Map(map))
    }
}
