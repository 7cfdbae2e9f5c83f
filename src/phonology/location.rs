//! The places of the body, of space, and of the hands and arms, by name (`grammar/locations.ron`).
//!
//! One row a location of HamNoSys 4 (U+E040–U+E07A, 44 of them), with readable aliases, what a placement
//! means that says no distance, and how wide the region is.
//!
//! # Conventions
//! Names are NFC and case-insensitive; ids and aliases share one space of names. Widths are in arm lengths
//! (shoulder to elbow to wrist). Where a place lies on a body is not known here: no joints, no metres.
//!
//! A table is refused with all its faults at once where a name, tag or symbol stands twice, a symbol is not a
//! hexadecimal code point, a kind names an unknown part, or a width is negative or not a number.

use super::grammar::read_table;
use super::hand::{Digit, HandPart};
use super::placement::Distance;
use crate::diagnostics::{Diagnostic, Source, Span};
use serde::Deserialize;
use std::collections::HashMap;
use unicode_normalization::UnicodeNormalization;

/// What sort of place a location is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LocationKind {
    /// A place on head or trunk.
    Body,
    /// A point in space before the signer.
    Space,
    /// A part of the (other) hand or arm as a whole.
    Limb(HandPart),
    /// A digit; which part of it is said apart.
    Digit(Digit),
    /// A part of a digit; which digit is said apart.
    Part(HandPart),
}

/// One row of the inventory.
#[derive(Debug, Clone, PartialEq)]
pub struct Location {
    /// The name, unique whatever the case.
    pub id: String,
    /// Other names, just as unique.
    pub aliases: Vec<String>,
    /// The HamNoSys tag, such as `hamchest`.
    pub tag: String,
    /// The HamNoSys symbol, in the private use area.
    pub symbol: char,
    /// What sort of place it is.
    pub kind: LocationKind,
    /// The body has a left and a right one: a side chooses which, and is not a shift.
    pub paired: bool,
    /// The distance that a placement without one means; never [`Distance::Unmarked`].
    pub unmarked: Distance,
    /// Half the width of the region, arm lengths; 0 for places of hand and arm.
    pub half_width_arms: f64,
    /// A remark for the reader of a listing; may be empty.
    pub note: String,
    /// Remarks on single sign languages: (language, remark).
    pub languages: Vec<(String, String)>,
}

impl Location {
    /// How far to the side `left` and `right` of this place are: half of the half-width, arm lengths.
    pub fn at_arms(&self) -> f64 {
        0.5 * self.half_width_arms
    }

    /// How far to the side `left beside` and `right beside` this place are: one and a half half-widths, arm lengths.
    pub fn beside_arms(&self) -> f64 {
        1.5 * self.half_width_arms
    }
}

/// A checked table of locations.
///
/// ```
/// use chereme::phonology::location::{LocationInventory, LocationKind};
/// let inventory = LocationInventory::builtin();
/// let chest = inventory.get("Breast").unwrap();
/// assert_eq!((chest.id.as_str(), chest.tag.as_str(), chest.kind), ("chest", "hamchest", LocationKind::Body));
/// ```
#[derive(Debug, Clone)]
pub struct LocationInventory {
    rows: Vec<Location>,
    by_name: HashMap<String, usize>,
}

impl LocationInventory {
    /// The inventory that comes with the program.
    pub fn builtin() -> LocationInventory {
        LocationInventory::from_source(&LocationInventory::builtin_source())
            .unwrap_or_else(|faults| unreachable!("the embedded table is tested to be sound: {faults:?}"))
    }

    /// The text of the inventory that comes with the program.
    pub fn builtin_source() -> Source {
        Source::new("grammar/locations.ron", include_str!("../../grammar/locations.ron"))
    }

    /// Reads and checks a table.
    ///
    /// # Errors
    /// Every fault of the table, with its place in the text.
    pub fn from_source(source: &Source) -> Result<LocationInventory, Vec<Diagnostic>> {
        let table: Table = read_table(source).map_err(|fault| vec![fault])?;
        let mut check = Check::new(source);
        let rows: Vec<Location> = table.locations.into_iter().filter_map(|row| check.row(row)).collect();
        if check.faults.is_empty() { Ok(LocationInventory::of(rows)) } else { Err(check.faults) }
    }

    /// This inventory with the rows of another put in place of those with the same id, or added.
    ///
    /// # Errors
    /// One message a name, tag or symbol that two different rows would then have.
    pub fn overridden_by(&self, other: &LocationInventory) -> Result<LocationInventory, Vec<String>> {
        let mut rows = self.rows.clone();
        for row in &other.rows {
            match rows.iter_mut().find(|r| key(&r.id) == key(&row.id)) {
                Some(old) => *old = row.clone(),
                None => rows.push(row.clone()),
            }
        }
        let mut clashes = Vec::new();
        for (i, a) in rows.iter().enumerate() {
            for b in &rows[..i] {
                for name in a.names().filter(|n| b.names().any(|m| key(m) == key(n))) {
                    clashes.push(format!("\"{name}\" names both the place {} and the place {}", b.id, a.id));
                }
                if a.tag == b.tag || a.symbol == b.symbol {
                    clashes.push(format!("the places {} and {} have one HamNoSys symbol", b.id, a.id));
                }
            }
        }
        if clashes.is_empty() { Ok(LocationInventory::of(rows)) } else { Err(clashes) }
    }

    fn of(rows: Vec<Location>) -> LocationInventory {
        let by_name =
            rows.iter().enumerate().flat_map(|(i, row)| row.names().map(move |name| (key(name), i))).collect();
        LocationInventory { rows, by_name }
    }

    /// The place of that id or alias, in any case.
    pub fn get(&self, name: &str) -> Option<&Location> {
        self.by_name.get(&key(name)).map(|&i| &self.rows[i])
    }

    /// The place of that HamNoSys tag (`hamchest`).
    pub fn by_tag(&self, tag: &str) -> Option<&Location> {
        self.rows.iter().find(|row| row.tag == tag)
    }

    /// The place of that HamNoSys symbol.
    pub fn by_symbol(&self, symbol: char) -> Option<&Location> {
        self.rows.iter().find(|row| row.symbol == symbol)
    }

    /// All rows, in the order of the table.
    pub fn rows(&self) -> &[Location] {
        &self.rows
    }

    /// All ids and aliases, as written: what a "did you mean" chooses from.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.rows.iter().flat_map(Location::names)
    }
}

impl Location {
    /// The id, then the aliases.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.id.as_str()).chain(self.aliases.iter().map(String::as_str))
    }
}

/// The form in which names are compared.
fn key(name: &str) -> String {
    name.nfc().flat_map(char::to_lowercase).nfc().collect()
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
    aliases: Vec<String>,
    hamnosys: (String, String),
    kind: KindText,
    #[serde(default)]
    paired: bool,
    unmarked: DistanceText,
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
        let name = format!("{what} {}", key(text));
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
            aliases: row.aliases,
            tag: row.hamnosys.0,
            symbol: symbol?,
            kind: kind?,
            paired: row.paired,
            unmarked,
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
