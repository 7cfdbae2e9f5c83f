//! Tables of HamNoSys strings, as dictionaries and corpora give them away: TSV, CSV, JSON.
//!
//! A table has a row for each sign: its gloss, its HamNoSys, perhaps a mouthing in SAMPA. JSON may be an array of objects, an
//! object from gloss to string or object, or an object a line. Columns are found by their names; a table without names
//! has its HamNoSys where the symbols are, and its gloss in the first other column.
//!
//! Rows come as text with their places: what a string says is the affair of [`parse`](super::parse). A row that cannot be
//! read never stops the rest.

mod cells;
mod columns;
mod json;

use crate::diagnostics::{Diagnostic, Source, Span};

/// Faults and warnings that are kept; the rest is counted.
const MOST_TOLD: usize = 1000;

/// A row.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The gloss, where the table has one.
    pub gloss: Option<String>,
    /// The HamNoSys string.
    pub notation: String,
    /// A mouth picture in SAMPA, where the table has one.
    pub mouthing: Option<String>,
    /// Where the string stands in the table, without quotation marks.
    pub span: Span,
    /// The line on which it begins, from 1.
    pub line: usize,
    /// Whether the string stands in the table as it is.
    form: Form,
}

/// How a cell stands in the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// As it is.
    Verbatim,
    /// With doubled quotation marks or escapes.
    Escaped,
}

impl Row {
    /// The place in the table of a place in the string; the whole string where it is written with escapes.
    pub fn place(&self, inside: Span) -> Span {
        match self.form {
            Form::Verbatim => {
                let at = |offset: usize| self.span.start.saturating_add(offset).min(self.span.end);
                Span::new(at(inside.start), at(inside.end))
            }
            Form::Escaped => self.span,
        }
    }
}

/// The formats of tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Cells apart by tabs.
    Tsv,
    /// Cells apart by commas, or by semicolons where those are more, and perhaps in quotation marks.
    Csv,
    /// JSON, or JSON lines.
    Json,
}

/// What the reader need not find out by itself. Columns are named by their heading (or key), or by their number from 1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// The format; else the ending of the name says it, or the text.
    pub format: Option<Format>,
    /// The column of HamNoSys.
    pub notation: Option<String>,
    /// The column of glosses.
    pub gloss: Option<String>,
    /// The column of mouthings.
    pub mouthing: Option<String>,
}

/// Reads the rows of a table, and says what is wrong with it.
///
/// ```
/// use chereme::{diagnostics::Source, notation::hamnosys::table};
/// let source = Source::new("signs.csv", "name,hamnosys\nYES,\"hamfist,hamextfingero\"\nNO,\n");
/// let (rows, told) = table::rows(&source, &table::Options::default());
/// assert_eq!((rows[0].gloss.as_deref(), rows[0].line), (Some("YES"), 2));
/// assert_eq!(&source.text[rows[0].span.start..rows[0].span.end], "hamfist,hamextfingero");
/// assert_eq!((rows.len(), told[0].message.as_str()), (1, "NO: this row has no HamNoSys"));
/// ```
pub fn rows(source: &Source, options: &Options) -> (Vec<Row>, Vec<Diagnostic>) {
    let mut told = Told::default();
    let rows = match options.format.unwrap_or_else(|| format_of(source)) {
        Format::Tsv => separated(&source.text, cells::TAB, options, &mut told),
        Format::Csv => separated(&source.text, cells::separator(&source.text), options, &mut told),
        Format::Json => json::rows(&source.text, options, &mut told),
    };
    (rows, told.all())
}

fn separated(text: &str, separator: u8, options: &Options, told: &mut Told) -> Vec<Row> {
    columns::rows(text, cells::separated(text, separator, told), options, told)
}

/// The format by the ending of the name, else by how the text begins.
fn format_of(source: &Source) -> Format {
    let ending = source.name.rsplit_once('.').map_or("", |(_, ending)| ending).to_ascii_lowercase();
    match ending.as_str() {
        "tsv" | "tab" => Format::Tsv,
        "csv" => Format::Csv,
        "json" | "jsonl" | "ndjson" => Format::Json,
        _ => {
            let text = source.text.trim_start_matches(['\u{feff}', ' ', '\n', '\r']);
            let first = text.lines().next().unwrap_or_default();
            match (text.starts_with(['{', '[']), first.contains('\t')) {
                (true, _) => Format::Json,
                (false, true) => Format::Tsv,
                (false, false) => Format::Csv,
            }
        }
    }
}

/// What is said of a table.
#[derive(Default)]
struct Told {
    told: Vec<Diagnostic>,
    untold: usize,
}

impl Told {
    fn say(&mut self, told: Diagnostic) {
        if self.told.len() < MOST_TOLD {
            self.told.push(told);
        } else {
            self.untold += 1;
        }
    }

    fn all(mut self) -> Vec<Diagnostic> {
        self.told.sort_by_key(|told| told.span.start);
        if self.untold > 0 {
            let message = format!("{} more faults and warnings of this table are not shown", self.untold);
            self.told.push(Diagnostic::warning(Span::default(), message).label("in this file"));
        }
        self.told
    }
}

/// A text for a message: cut where it is long.
fn short(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
