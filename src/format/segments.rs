//! Segments as a plain table: a row an annotation, with its tier, start, end and label.
//!
//! # Conventions
//! - Tab-separated (semicolons and commas are seen too), UTF-8, a header first: `tier`, `start`, `end` or `duration`,
//!   `label`, and if wanted `source` and `recording`; or other names that people use (`begin`, `onset`, `offset`,
//!   `value`, `annotation`, `file`). Without a tier column all values are of one tier, named as the label's column.
//! - Times are seconds, or `h:mm:ss.sss`; milliseconds where the heading says so (`start_ms`, `start [ms]`).
//! - What ELAN exports as tab-delimited text is read too (ELAN 6, File, Export As): with a column for each tier
//!   (`Begin Time - ss.msec`, …), where an empty cell is no value, and without a header.
//! - Lines that begin with `#` before the header say something else (ELAN: the file's name), and are passed over.
//!
//! # What is refused
//! Cells that are no times, ends before their starts, rows that end before these cells: each with line and column.

mod columns;
mod time;

use crate::diagnostics::xml::short;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::cells::{self, Cell, Rows};
use crate::format::text;
use crate::format::told::Told;
use crate::tier::{Tier, TierValue};
use crate::time::Seconds;
use columns::{Columns, End, Times, Values};
use std::collections::HashMap;

/// What the table says of one recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// The recording's name, as a rule its file; empty where the table has no column for it.
    pub name: String,
    /// Its tiers, in the order in which they occur.
    pub tiers: Vec<Tier>,
}

/// A table that could be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The recordings, in the order in which they occur.
    pub recordings: Vec<Recording>,
    /// What is odd about it, by place.
    pub warnings: Vec<Diagnostic>,
}

/// Reads a table of segments.
///
/// # Errors
/// All faults, the first hundred of them with their places in the text that
/// [`source_of_bytes`](crate::format::text::source_of_bytes) gives.
///
/// ```
/// use chereme::format::segments;
/// let reading = segments::read(b"tier\tbegin\tend\tvalue\nRH Gloss\t0.3\t0:00:01.200\tBOL\n").unwrap();
/// let tier = &reading.recordings[0].tiers[0];
/// assert_eq!((tier.name.as_str(), tier.values()[0].end.0), ("RH Gloss", 1.2));
/// let faults = segments::read(b"tier\tbegin\tend\tvalue\nRH Gloss\t0.3\t0.2\tBOL\n").unwrap_err();
/// assert_eq!(faults[0].message, "this ends (0.2) before it begins (0.3)");
/// ```
pub fn read(bytes: &[u8]) -> Result<Reading, Vec<Diagnostic>> {
    let (text, note) = text::decode(bytes);
    let mut told = Told::default();
    note.into_iter().for_each(|note| told.say(note));
    let text = text.as_ref();
    let skipped = text.split_inclusive('\n').take_while(|line| line.starts_with('#')).map(str::len).sum::<usize>();
    let mut rows = Rows::new(text, cells::separator(&text[skipped..]));
    let mut cells = Vec::new();
    let mut table = Table::default();
    while rows.at() < skipped && rows.next(&mut cells) {}
    if rows.next(&mut cells) {
        let header = columns::is_header(&cells);
        let columns = if header { columns::named(&cells, &mut told) } else { columns::unnamed(&cells, &mut told) };
        if let Some(columns) = columns {
            if !header {
                table.row(&cells, &columns, &mut told);
            }
            while rows.next(&mut cells) {
                table.row(&cells, &columns, &mut told);
            }
        }
    } else {
        let fault = Diagnostic::fault(Span::new(0, 0), "this table is empty").label("expected a header");
        told.say(fault.hint("the first line names the columns: tier, start, end, label"));
    }
    told.judge(table.recordings()).map(|(recordings, warnings)| Reading { recordings, warnings })
}

/// The rows so far.
#[derive(Default)]
struct Table {
    names: Vec<String>,
    by_name: HashMap<String, usize>,
    tiers: Vec<(usize, String, Vec<TierValue>)>,
    by_tier: HashMap<(usize, String), usize>,
}

impl Table {
    fn row(&mut self, cells: &[Cell<'_>], columns: &Columns, told: &mut Told) {
        let Some((start, end)) = times(cells, columns, told) else { return };
        let text = |at: Option<usize>| at.and_then(|at| cells.get(at)).map_or("", |cell| &cell.text);
        let recording = text(columns.recording).to_owned();
        let value =
            |label: &str| TierValue { start, end, label: label.to_owned(), source: text(columns.source).into() };
        match &columns.values {
            Values::One { tier, label } => {
                let name = match tier {
                    Some(_) => text(*tier),
                    None => &columns.only_tier,
                };
                self.push(recording, name, value(text(Some(*label))));
            }
            Values::Each(all) => {
                for (at, name) in all.iter().filter(|(at, _)| !text(Some(*at)).is_empty()) {
                    self.push(recording.clone(), name, value(text(Some(*at))));
                }
            }
        }
    }

    fn push(&mut self, recording: String, tier: &str, value: TierValue) {
        let at = *self.by_name.entry(recording).or_insert_with_key(|name| {
            self.names.push(name.clone());
            self.names.len() - 1
        });
        let at = *self.by_tier.entry((at, tier.to_owned())).or_insert_with(|| {
            self.tiers.push((at, tier.to_owned(), Vec::new()));
            self.tiers.len() - 1
        });
        self.tiers[at].2.push(value);
    }

    fn recordings(self) -> Vec<Recording> {
        let mut all: Vec<Recording> =
            self.names.into_iter().map(|name| Recording { name, tiers: Vec::new() }).collect();
        for (recording, name, mut values) in self.tiers {
            values.sort_by(|a, b| a.start.0.total_cmp(&b.start.0));
            let mut tier = Tier::new(name);
            values.into_iter().for_each(|v| tier.push(v.start, v.end, v.label, v.source));
            all[recording].tiers.push(tier);
        }
        all
    }
}

/// When a row's value is; faults are told.
fn times(cells: &[Cell<'_>], columns: &Columns, told: &mut Told) -> Option<(Seconds, Seconds)> {
    let whole = || cells.first().zip(cells.last()).map(|(a, b)| a.span.to(b.span)).unwrap_or_default();
    let mut read = |column: Times, what: &str| {
        let Some(cell) = cells.get(column.at) else {
            let message =
                format!("this row has {} cells, and its {what} would be number {}", cells.len(), column.at + 1);
            told.say(Diagnostic::fault(whole(), message).label("expected as many cells as the header has"));
            return None;
        };
        let time = time::time(&cell.text, column.unit);
        if time.is_none() {
            let fault = Diagnostic::fault(cell.span, format!("`{}` is no time", short(&cell.text)));
            let fault = fault.label(format!("expected the {what}: seconds, or h:mm:ss.sss"));
            told.say(match cell.text.contains(',') {
                true => fault.hint("decimals have a point, not a comma"),
                false => fault,
            });
        }
        time
    };
    let start = read(columns.start, "start");
    let (at, end) = match columns.end {
        End::At(column) => (column.at, read(column, "end")),
        End::After(column) => (column.at, read(column, "duration").zip(start).map(|(long, start)| start + long)),
    };
    let (start, end) = start.zip(end)?;
    if end < start {
        let span = cells.get(at).map_or(whole(), |cell| cell.span);
        let message = format!("this ends ({}) before it begins ({})", end.0, start.0);
        told.say(Diagnostic::fault(span, message).label("expected a later time").hint("are start and end exchanged?"));
        return None;
    }
    Some((start, end))
}

/// A table of segments: tab-separated, with a header; times in seconds with all their digits.
///
/// Recordings and sources have columns where one of them is not empty. A tier without values leaves no trace.
///
/// ```
/// use chereme::{format::segments, tier::Tier, time::Seconds};
/// let mut tier = Tier::new("RH Gloss");
/// tier.push(Seconds(0.3), Seconds(1.2), "BOL", "");
/// let table = segments::write(&[segments::Recording { name: String::new(), tiers: vec![tier] }]);
/// assert_eq!(table, "tier\tstart\tend\tlabel\nRH Gloss\t0.3\t1.2\tBOL\n");
/// ```
pub fn write(recordings: &[Recording]) -> String {
    let values =
        || recordings.iter().flat_map(|r| r.tiers.iter().flat_map(move |t| t.values().iter().map(move |v| (r, t, v))));
    let with_recordings = values().any(|(recording, ..)| !recording.name.is_empty());
    let with_sources = values().any(|(.., value)| !value.source.is_empty());
    let mut out = String::new();
    out.push_str(if with_recordings { "recording\t" } else { "" });
    out.push_str("tier\tstart\tend\tlabel");
    out.push_str(if with_sources { "\tsource\n" } else { "\n" });
    for (recording, tier, value) in values() {
        let (start, end) = (value.start.0.to_string(), value.end.0.to_string());
        let recording = with_recordings.then_some(recording.name.as_str());
        let source = with_sources.then_some(value.source.as_str());
        let cells = recording.into_iter().chain([tier.name.as_str(), &start, &end, &value.label]).chain(source);
        for (i, cell) in cells.enumerate() {
            out.push_str(if i > 0 { "\t" } else { "" });
            cells::push(&mut out, cell, '\t');
        }
        out.push('\n');
    }
    out
}
