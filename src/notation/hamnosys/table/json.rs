//! Tables in JSON: arrays of objects, objects from gloss to string or object, an object a line.
//!
//! Values are kept as they stand in the text until they are needed, so that their places are known.

use super::columns::{Role, heading, is_hamnosys, no_column, nothing, plain};
use super::{Form, Options, Row, Told, short};
use crate::diagnostics::{Diagnostic, Span};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::borrow::Cow;
use std::fmt;

/// Keys and values of an object in their order, or the values of an array.
enum Entries<'a> {
    Object(Vec<(Cow<'a, str>, &'a RawValue)>),
    Array(Vec<&'a RawValue>),
}

impl<'de: 'a, 'a> Deserialize<'de> for Entries<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Entries<'a>, D::Error> {
        struct Whole;
        impl<'de> Visitor<'de> for Whole {
            type Value = Entries<'de>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object or an array")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<'de>, A::Error> {
                let mut entries = Vec::new();
                while let Some((key, value)) = map.next_entry::<Key<'de>, _>()? {
                    entries.push((key.0, value));
                }
                Ok(Entries::Object(entries))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Entries<'de>, A::Error> {
                let mut values = Vec::new();
                while let Some(value) = seq.next_element()? {
                    values.push(value);
                }
                Ok(Entries::Array(values))
            }
        }
        deserializer.deserialize_any(Whole)
    }
}

/// A key, borrowed where it has no escapes.
#[derive(serde::Deserialize)]
struct Key<'a>(#[serde(borrow)] Cow<'a, str>);

/// Rows of a text of JSON.
pub(super) fn rows(text: &str, options: &Options, told: &mut Told) -> Vec<Row> {
    let mut reader = Json { text, options, told, rows: Vec::new(), line: 1, counted: 0 };
    let body = text.trim_start_matches('\u{feff}');
    match serde_json::from_str::<Entries>(body) {
        Ok(Entries::Array(items)) => items.into_iter().for_each(|item| reader.item(None, item)),
        Ok(Entries::Object(entries)) => reader.object(entries),
        Err(error) => match reader.lines(body) {
            Lines::Read => {}
            Lines::NotLines => {
                let at = offset(body, &error) + (text.len() - body.len());
                let message = error.to_string();
                let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(words, _)| words);
                let end = text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
                let fault = Diagnostic::fault(Span::new(at, end), format!("this is not JSON: {message}"));
                reader.told.say(fault.label("here"));
            }
        },
    }
    reader.rows
}

/// Whether a text was JSON lines.
enum Lines {
    Read,
    NotLines,
}

struct Json<'a, 'b> {
    text: &'a str,
    options: &'b Options,
    told: &'b mut Told,
    rows: Vec<Row>,
    /// The line of the byte up to which line ends were counted.
    line: usize,
    counted: usize,
}

impl<'a> Json<'a, '_> {
    /// One object: a row by itself, or from gloss to row.
    fn object(&mut self, entries: Vec<(Cow<'a, str>, &'a RawValue)>) {
        let text = |value: &RawValue| serde_json::from_str::<String>(value.get()).ok();
        let keys: Vec<String> = entries.iter().map(|(key, _)| plain(key)).collect();
        let named = self
            .options
            .notation
            .as_deref()
            .map_or_else(|| heading(Role::Notation, &keys), |asked| keys.iter().position(|key| *key == plain(asked)));
        // A gloss may be called NOTATION; its value is then no HamNoSys, or an object.
        let is_row =
            named.is_some_and(|i| text(entries[i].1).is_some_and(|text| entries.len() > 1 || is_hamnosys(&text)));
        if is_row && heading(Role::Gloss, &keys).or(heading(Role::Mouthing, &keys)).is_some() {
            return self.fields(None, entries, Span::new(0, self.text.len()));
        }
        entries.into_iter().for_each(|(key, value)| self.item(Some(key.into_owned()), value));
    }

    /// An object a line.
    fn lines(&mut self, body: &'a str) -> Lines {
        let lines = || body.lines().filter(|line| !line.trim().is_empty());
        let is_object = |line: &str| matches!(serde_json::from_str(line), Ok(Entries::Object(_)));
        // One line at least is an object, and not the first line of one that is larger.
        if lines().nth(1).is_none() || !lines().take(2).any(is_object) {
            return Lines::NotLines;
        }
        for line in lines() {
            match serde_json::from_str::<&RawValue>(line) {
                Ok(value) => self.item(None, value),
                Err(error) => {
                    let start = self.start(line);
                    let span = Span::new(start, start + line.len());
                    let message = error.to_string();
                    let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(words, _)| words);
                    self.told.say(Diagnostic::fault(span, format!("this line is not JSON: {message}")).label("here"));
                }
            }
        }
        Lines::Read
    }

    /// A row: an object, or a string under its gloss.
    fn item(&mut self, gloss: Option<String>, value: &'a RawValue) {
        let span = self.span(value);
        match value.get().as_bytes().first() {
            Some(b'{') => {
                if let Ok(Entries::Object(entries)) = serde_json::from_str(value.get()) {
                    self.fields(gloss, entries, span);
                }
            }
            Some(b'"') => self.row(gloss, value, None),
            _ => {
                let name = gloss.map_or_else(String::new, |gloss| short(&gloss) + ": ");
                let fault =
                    Diagnostic::fault(span, format!("{name}this is no row")).label("expected an object or a string");
                self.told.say(fault);
            }
        }
    }

    /// A row from its keys and values.
    fn fields(&mut self, gloss: Option<String>, entries: Vec<(Cow<'a, str>, &'a RawValue)>, span: Span) {
        let keys: Vec<String> = entries.iter().map(|(key, _)| plain(key)).collect();
        let text = |i: usize| scalar(entries[i].1);
        let find = |role: Role| match role.asked(self.options) {
            Some(asked) => keys.iter().position(|key| *key == plain(asked)),
            None => heading(role, &keys),
        };
        let gloss = gloss.or_else(|| find(Role::Gloss).and_then(text)).filter(|gloss| !gloss.is_empty());
        let mouthing = find(Role::Mouthing).and_then(text).filter(|text| !text.is_empty());
        let by_symbols = || (0..entries.len()).find(|i| text(*i).is_some_and(|text| is_hamnosys(&text)));
        let notation = match &self.options.notation {
            Some(asked) => match find(Role::Notation) {
                Some(i) => Some(i),
                None => {
                    let there = entries.iter().map(|(key, _)| key.as_ref());
                    return self.told.say(no_column(asked, span, there));
                }
            },
            None => find(Role::Notation).or_else(by_symbols),
        };
        let Some(i) = notation.filter(|i| text(*i).is_some_and(|text| !text.trim().is_empty())) else {
            return self.told.say(nothing(gloss.as_deref(), span));
        };
        self.row(gloss, entries[i].1, mouthing);
    }

    /// A row of a string.
    fn row(&mut self, gloss: Option<String>, value: &RawValue, mouthing: Option<String>) {
        let whole = self.span(value);
        let Some(notation) = serde_json::from_str::<String>(value.get()).ok().filter(|text| !text.trim().is_empty())
        else {
            return self.told.say(nothing(gloss.as_deref(), whole));
        };
        let span = Span::new(whole.start + 1, whole.end.saturating_sub(1));
        let form = if self.text[span.start..span.end] == notation { Form::Verbatim } else { Form::Escaped };
        let line = self.line_of(span.start);
        self.rows.push(Row { gloss, notation, mouthing, span, line, form });
    }

    /// Where a part of the text begins in it.
    fn start(&self, part: &str) -> usize {
        (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize).min(self.text.len())
    }

    fn span(&self, value: &RawValue) -> Span {
        let start = self.start(value.get());
        Span::new(start, start + value.get().len())
    }

    /// The line of a byte; rows come in the order of the text, so each line end is counted once.
    fn line_of(&mut self, at: usize) -> usize {
        if at > self.counted {
            self.line += self.text.as_bytes()[self.counted..at].iter().filter(|byte| **byte == b'\n').count();
            self.counted = at;
        }
        self.line
    }
}

/// A string or a number as text.
fn scalar(value: &RawValue) -> Option<String> {
    match value.get().as_bytes().first()? {
        b'"' => serde_json::from_str(value.get()).ok(),
        b'0'..=b'9' | b'-' => Some(value.get().to_owned()),
        _ => None,
    }
}

/// The byte of a fault of JSON; its columns count bytes.
fn offset(text: &str, error: &serde_json::Error) -> usize {
    let before: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let mut at = (before + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
