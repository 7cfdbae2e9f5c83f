//! The tables of a questionnaire: what people answered, and the key that says what they saw.
//!
//! # Conventions
//! CSV with a row of names, columns in any order, case ignored; commas, or semicolons or tabs where the first row has those (spreadsheets
//! of some countries write them). Answers have `participant`, `stimulus`, and of these what was asked: `level`, `age`, `hearing`, `answer`,
//! `realism`. The key has `stimulus`, `group`, `item`, `version`, `correct`; these columns may stand in the answers instead. Other columns
//! are passed over. An empty cell is an answer that was not given.

use super::Level;
use crate::diagnostics::{Diagnostic, Source, Span};
use std::collections::BTreeMap;

/// The most rows of a table.
const MOST_ROWS: usize = 1_000_000;

/// One answer, as it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Given {
    /// Who.
    pub participant: String,
    /// How well they sign.
    pub level: Option<Level>,
    /// The opaque name of what was shown.
    pub stimulus: String,
    /// What they recognised.
    pub answer: Option<String>,
    /// From 1 to 5.
    pub realism: Option<u8>,
    /// What was shown, where the table itself says it.
    pub shown: Option<Stimulus>,
    /// Where the row stands.
    pub span: Span,
}

/// What a stimulus is.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Stimulus {
    /// The question that it belongs to: stimuli are compared within a group.
    pub group: String,
    /// What is signed.
    pub item: String,
    /// How it was made: what is compared.
    pub version: String,
    /// The right answer, where something is to be recognised.
    pub correct: Option<String>,
}

/// Reads the answers of a questionnaire.
///
/// # Errors
/// All faults: a column that is missing, a rating that is not 1 to 5, a level that is not known, a row without a participant.
///
/// ```
/// use chereme::{diagnostics::Source, evaluation::ratings::read_answers};
/// let table = Source::new("a.csv", "participant,stimulus,level,answer,realism\nP1,7f3a,native,left,4\n");
/// assert_eq!(read_answers(&table).unwrap()[0].realism, Some(4));
/// let wrong = Source::new("a.csv", "participant,stimulus,realism\nP1,7f3a,6\n");
/// assert!(read_answers(&wrong).unwrap_err()[0].message.contains("1 to 5"));
/// ```
pub fn read_answers(source: &Source) -> Result<Vec<Given>, Vec<Diagnostic>> {
    let mut table = Table::of(source, &["participant", "stimulus"])?;
    let rows = std::mem::take(&mut table.rows);
    let mut answers = Vec::with_capacity(rows.len());
    for row in &rows {
        answers.extend(given(&mut table, row));
    }
    table.done(answers)
}

fn given(table: &mut Table, row: &Row) -> Option<Given> {
    let participant = table.needed(row, "participant")?;
    let stimulus = table.needed(row, "stimulus")?;
    let level = match table.cell(row, "level") {
        Some(text) => match text.parse::<Level>() {
            Ok(level) => Some(level),
            Err(error) => return table.fault(row, "level", error.to_string()),
        },
        None => None,
    };
    let realism = match table.cell(row, "realism") {
        Some(text) => match text.parse::<u8>() {
            Ok(rating @ 1..=5) => Some(rating),
            _ => return table.fault(row, "realism", format!("`{text}` is no rating; expected a number from 1 to 5")),
        },
        None => None,
    };
    let shown = match table.has("group") && table.has("version") {
        true => Some(stimulus_of(table, row)?),
        false => None,
    };
    let answer = table.cell(row, "answer").map(str::to_owned);
    Some(Given { participant, level, stimulus, answer, realism, shown, span: row.span })
}

fn stimulus_of(table: &mut Table, row: &Row) -> Option<Stimulus> {
    let (group, version) = (table.needed(row, "group")?, table.needed(row, "version")?);
    let item = table.cell(row, "item").unwrap_or("").to_owned();
    Some(Stimulus { group, item, version, correct: table.cell(row, "correct").map(str::to_owned) })
}

/// Reads the key of a questionnaire: what each opaque name stands for.
///
/// # Errors
/// All faults: a column that is missing, a stimulus that stands twice, an empty cell.
///
/// ```
/// use chereme::{diagnostics::Source, evaluation::ratings::read_key};
/// let key = Source::new("key.csv", "stimulus,group,item,version,correct\n7f3a,spatialization,BOL,synthesized,left\n");
/// assert_eq!(read_key(&key).unwrap()["7f3a"].version, "synthesized");
/// ```
pub fn read_key(source: &Source) -> Result<BTreeMap<String, Stimulus>, Vec<Diagnostic>> {
    let mut table = Table::of(source, &["stimulus", "group", "version"])?;
    let rows = std::mem::take(&mut table.rows);
    let mut key = BTreeMap::new();
    for row in &rows {
        let Some(name) = table.needed(row, "stimulus") else { continue };
        let Some(stimulus) = stimulus_of(&mut table, row) else { continue };
        if key.insert(name.clone(), stimulus).is_some() {
            let _: Option<()> = table.fault(row, "stimulus", format!("`{name}` stands twice in the key"));
        }
    }
    table.done(key)
}

/// A row: its cells and where it stands.
struct Row {
    cells: Vec<String>,
    span: Span,
}

/// A table in the reading.
struct Table<'a> {
    source: &'a Source,
    separator: u8,
    columns: BTreeMap<String, usize>,
    rows: Vec<Row>,
    faults: Vec<Diagnostic>,
}

impl<'a> Table<'a> {
    /// The rows of a table that has certain columns.
    fn of(source: &'a Source, needed: &[&str]) -> Result<Table<'a>, Vec<Diagnostic>> {
        let text = source.text.as_str();
        let first = text.lines().next().unwrap_or("");
        let separator = [b',', b';', b'\t'].into_iter().find(|s| first.as_bytes().contains(s)).unwrap_or(b',');
        let mut table = Table { source, separator, columns: BTreeMap::new(), rows: Vec::new(), faults: Vec::new() };
        let mut reader = csv::ReaderBuilder::new();
        let mut reader = reader.delimiter(separator).flexible(true).has_headers(false).from_reader(text.as_bytes());
        for record in reader.records() {
            let record = match record {
                Ok(record) => record,
                Err(error) => return Err(vec![Diagnostic::fault(Span::default(), error.to_string())]),
            };
            let start = record.position().map_or(0, |p| p.byte() as usize).min(text.len());
            table.row(&record, start)?;
        }
        let missing = |name: &&&str| !table.columns.contains_key(**name);
        if let Some(name) = needed.iter().find(missing) {
            let here: Vec<&str> = table.columns.keys().map(String::as_str).collect();
            let what = format!("there is no column `{name}`");
            let fault = Diagnostic::fault(Span::new(0, first.len()), what);
            return Err(vec![fault.hint(format!("the first row names these columns: {}", here.join(", ")))]);
        }
        Ok(table)
    }

    /// Takes a record: the first one names the columns.
    fn row(&mut self, record: &csv::StringRecord, start: usize) -> Result<(), Vec<Diagnostic>> {
        let end = self.source.text[start..].find('\n').map_or(self.source.text.len(), |n| start + n);
        let span = Span::new(start, end);
        if self.columns.is_empty() {
            for (at, name) in record.iter().enumerate() {
                let name = name.trim().trim_start_matches('\u{feff}').to_lowercase();
                if !name.is_empty() && self.columns.insert(name.clone(), at).is_some() {
                    return Err(vec![Diagnostic::fault(span, format!("the column `{name}` stands twice"))]);
                }
            }
        } else if self.rows.len() >= MOST_ROWS {
            return Err(vec![Diagnostic::fault(span, format!("more than {MOST_ROWS} rows are not read"))]);
        } else if record.iter().any(|cell| !cell.trim().is_empty()) {
            self.rows.push(Row { cells: record.iter().map(str::to_owned).collect(), span });
        }
        Ok(())
    }

    fn has(&self, column: &str) -> bool {
        self.columns.contains_key(column)
    }

    /// What stands in a column; `None` where it is empty or not there.
    fn cell<'r>(&self, row: &'r Row, column: &str) -> Option<&'r str> {
        let cell = row.cells.get(*self.columns.get(column)?)?.trim();
        (!cell.is_empty()).then_some(cell)
    }

    /// What stands in a column that may not be empty.
    fn needed(&mut self, row: &Row, column: &str) -> Option<String> {
        match self.cell(row, column) {
            Some(cell) => Some(cell.to_owned()),
            None => self.fault(row, column, format!("the row has no {column}")),
        }
    }

    /// Notes a fault at a cell.
    fn fault<T>(&mut self, row: &Row, column: &str, message: String) -> Option<T> {
        let span = self.columns.get(column).map_or(row.span, |at| self.span_of(row, *at));
        self.faults.push(Diagnostic::fault(span, message));
        None
    }

    /// Where a cell stands, quotes included.
    fn span_of(&self, row: &Row, column: usize) -> Span {
        let (mut at, mut start, mut quoted) = (0, row.span.start, false);
        for (i, byte) in self.source.text.bytes().enumerate().skip(row.span.start) {
            match byte {
                b'"' => quoted = !quoted,
                b'\n' | b'\r' if !quoted && i > row.span.start => {
                    return if at == column { Span::new(start, i) } else { row.span };
                }
                separator if separator == self.separator && !quoted => {
                    if at == column {
                        return Span::new(start, i);
                    }
                    (at, start) = (at + 1, i + 1);
                }
                _ => {}
            }
        }
        if at == column { Span::new(start, self.source.text.len()) } else { row.span }
    }

    fn done<T>(self, result: T) -> Result<T, Vec<Diagnostic>> {
        if self.faults.is_empty() { Ok(result) } else { Err(self.faults) }
    }
}
