//! The rows of `grammar/locations.ron` as they are written, and the checks that make them locations.

use super::grammar::fold;
use super::grammar::read_table;
use super::hand::{Digit, HandPart};
use super::location::{Location, LocationKind};
use super::placement::Distance;
use crate::diagnostics::{Diagnostic, Source, Span};
use serde::Deserialize;
use std::collections::HashMap;

/// Reads and checks a table; every fault at once.
pub(super) fn read(source: &Source) -> Result<Vec<Location>, Vec<Diagnostic>> {
    let table: Table = read_table(source).map_err(|fault| vec![fault])?;
    let mut check = Check::new(source);
    let rows: Vec<Location> = table.locations.into_iter().filter_map(|row| check.row(row)).collect();
    if check.faults.is_empty() { Ok(rows) } else { Err(check.faults) }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    locations: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    id: String,
    #[serde(default)]
    fr: String,
    #[serde(default)]
    aliases: Vec<String>,
    hamnosys: (String, String),
    kind: KindText,
    #[serde(default)]
    paired: bool,
    unmarked: DistanceText,
    #[serde(default)]
    space: Option<f64>,
    #[serde(default)]
    half_width: f64,
    #[serde(default)]
    note: String,
    #[serde(default)]
    languages: Vec<(String, String)>,
}

#[derive(Deserialize)]
enum KindText {
    Body,
    Space,
    Limb(String),
    Digit(String),
    Part(String),
}

#[derive(Deserialize)]
enum DistanceText {
    Touch,
    Close,
    Neutral,
    Extended,
    Metres(f64),
}

/// Checks rows one after the other and keeps where each stands.
struct Check<'a> {
    source: &'a Source,
    /// Where the row before ends its id: rows are searched in order.
    from: usize,
    /// Names, tags and symbols met so far, with their places.
    seen: HashMap<String, Span>,
    faults: Vec<Diagnostic>,
}

impl<'a> Check<'a> {
    fn new(source: &'a Source) -> Check<'a> {
        Check { source, from: 0, seen: HashMap::new(), faults: Vec::new() }
    }

    /// The quoted text at or after `from`; the end of the row before where it is written with escapes.
    fn span_of(&self, quoted: &str, from: usize) -> Span {
        match self.source.text[from..].find(&format!("\"{quoted}\"")) {
            Some(at) => Span::new(from + at + 1, from + at + 1 + quoted.len()),
            None => Span::new(from, from),
        }
    }

    fn fault(&mut self, span: Span, message: String) {
        self.faults.push(Diagnostic::fault(span, message).label("here"));
    }

    /// Notes a name, tag or symbol; a fault where it was met before.
    fn unique(&mut self, what: &str, text: &str, span: Span) {
        let name = format!("{what} {}", fold(text));
        match self.seen.get(&name).copied() {
            Some(first) => self.faults.push(
                Diagnostic::fault(span, format!("the {what} \"{text}\" stands twice"))
                    .label("again here")
                    .related(first, "first here"),
            ),
            None => drop(self.seen.insert(name, span)),
        }
    }

    fn row(&mut self, row: Row) -> Option<Location> {
        let before = self.faults.len();
        let id_span = self.span_of(&row.id, self.from);
        self.from = id_span.end;
        let mut here = id_span;
        for name in std::iter::once(&row.id).chain(&row.aliases) {
            let span = if name == &row.id { id_span } else { self.span_of(name, here.end) };
            if name.trim().is_empty() || name.contains(char::is_whitespace) {
                self.fault(span, format!("\"{name}\" cannot be a name: names are one word"));
            }
            self.unique("name", name, span);
            here = span;
        }
        let (tag, code) = &row.hamnosys;
        let tag_span = self.span_of(tag, here.end);
        self.unique("HamNoSys tag", tag, tag_span);
        let code_span = self.span_of(code, tag_span.end);
        self.unique("HamNoSys symbol", code, code_span);
        let symbol = u32::from_str_radix(code, 16).ok().and_then(char::from_u32);
        if symbol.is_none() {
            self.fault(code_span, format!("\"{code}\" is not a hexadecimal code point such as E052"));
        }
        let kind = self.kind(&row.kind, code_span.end);
        if !(row.half_width.is_finite() && row.half_width >= 0.0) {
            self.fault(
                id_span,
                format!("the half-width of {} is {}, not a width in arm lengths", row.id, row.half_width),
            );
        }
        if row.space.is_some_and(|height| !(-2.0..=2.0).contains(&height)) {
            self.fault(id_span, format!("the signing space of {} is at no height of a body", row.id));
        }
        let unmarked = match row.unmarked {
            DistanceText::Touch => Distance::Touch,
            DistanceText::Close => Distance::Close,
            DistanceText::Neutral => Distance::Neutral,
            DistanceText::Extended => Distance::Extended,
            DistanceText::Metres(metres) => Distance::Metres(metres),
        };
        if self.faults.len() > before {
            return None;
        }
        Some(Location {
            id: row.id,
            french: row.fr,
            aliases: row.aliases,
            tag: row.hamnosys.0,
            symbol: symbol?,
            kind: kind?,
            paired: row.paired,
            unmarked,
            space: row.space,
            half_width_arms: row.half_width,
            note: row.note,
            languages: row.languages,
        })
    }

    fn kind(&mut self, kind: &KindText, from: usize) -> Option<LocationKind> {
        let of = |parts: &[HandPart], name: &str| parts.iter().copied().find(|p| p.name() == name);
        let (found, name, known) = match kind {
            KindText::Body => return Some(LocationKind::Body),
            KindText::Space => return Some(LocationKind::Space),
            KindText::Limb(name) => (
                of(&HandPart::OF_THE_LIMB, name).map(LocationKind::Limb),
                name,
                HandPart::OF_THE_LIMB.map(HandPart::name).join(", "),
            ),
            KindText::Digit(name) => (
                Digit::ALL.into_iter().find(|d| d.name() == name).map(LocationKind::Digit),
                name,
                Digit::ALL.map(Digit::name).join(", "),
            ),
            KindText::Part(name) => (
                of(&HandPart::OF_A_DIGIT, name).map(LocationKind::Part),
                name,
                HandPart::OF_A_DIGIT.map(HandPart::name).join(", "),
            ),
        };
        if found.is_none() {
            let span = self.span_of(name, from);
            self.faults.push(
                Diagnostic::fault(span, format!("\"{name}\" is not a part of the hand or arm"))
                    .label("unknown part")
                    .hint(format!("the parts here are {known}")),
            );
        }
        found
    }
}
