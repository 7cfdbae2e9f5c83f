//! Which column is which, by headings or by what stands in them.

use super::cells::{Cell, Record};
use super::{Form, Options, Row, Told, short};
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::hamnosys::symbol::Symbol;
use crate::notation::suggest::{fold, nearest};

/// Headings of HamNoSys, without spaces, hyphens and underscores.
const NOTATION: &[&str] = &[
    "hamnosys",
    "hamnosysstring",
    "hamnosystext",
    "hamnosysunicode",
    "ham",
    "hns",
    "notation",
    "transcription",
    "manual",
];
const GLOSS: &[&str] = &[
    "gloss",
    "glosses",
    "glossen",
    "glosse",
    "name",
    "sign",
    "signname",
    "id",
    "idgloss",
    "lemma",
    "word",
    "label",
    "key",
    "title",
    "meaning",
    "translation",
];
const MOUTHING: &[&str] =
    &["mouthing", "mouthpicture", "mouthings", "mouthpictures", "mouth", "picture", "sampa", "hamnosysmouthing"];

/// Rows that are looked at to find the column of HamNoSys.
const LOOKED_AT: usize = 100;

/// The three columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Notation,
    Gloss,
    Mouthing,
}

impl Role {
    /// Its headings, the likelier first.
    pub fn headings(self) -> &'static [&'static str] {
        match self {
            Role::Notation => NOTATION,
            Role::Gloss => GLOSS,
            Role::Mouthing => MOUTHING,
        }
    }

    /// What was asked for.
    pub fn asked(self, options: &Options) -> Option<&str> {
        match self {
            Role::Notation => options.notation.as_deref(),
            Role::Gloss => options.gloss.as_deref(),
            Role::Mouthing => options.mouthing.as_deref(),
        }
    }
}

/// A heading without case, accents, spaces, hyphens and underscores.
pub(super) fn plain(heading: &str) -> String {
    fold(heading).chars().filter(|c| c.is_alphanumeric()).collect()
}

/// The heading of a role among others, the likelier first.
pub(super) fn heading(role: Role, headings: &[String]) -> Option<usize> {
    role.headings().iter().find_map(|known| headings.iter().position(|heading| heading == known))
}

/// Whether a text looks like HamNoSys: it has a character of the font, or begins with the name of a symbol.
pub(super) fn is_hamnosys(text: &str) -> bool {
    let private = |c: char| matches!(c, '\u{e000}'..='\u{f8ff}');
    let first = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).find(|word| !word.is_empty());
    text.contains(private) || first.is_some_and(|word| word.starts_with("ham") && Symbol::of_tag(word).is_some())
}

/// Rows of records.
pub(super) fn rows(text: &str, mut records: Vec<Record>, options: &Options, told: &mut Told) -> Vec<Row> {
    let Some(columns) = Columns::of(&records, options, told) else { return Vec::new() };
    records.iter_mut().skip(columns.head).for_each(|record| join(text, record, columns.notation));
    records.into_iter().skip(columns.head).filter_map(|record| row(record, &columns, told)).collect()
}

/// Names of symbols that follow each other in cells of their own, because nobody put them in quotation marks, are one string.
fn join(text: &str, record: &mut Record, notation: usize) {
    let is_name = |cell: &&Cell| cell.text.starts_with("ham") && is_hamnosys(&cell.text);
    let more = record.cells.iter().skip(notation).take_while(is_name).count().saturating_sub(1);
    if more == 0 {
        return;
    }
    let last = record.cells[notation + more].span;
    record.cells.drain(notation + 1..=notation + more);
    let cell = &mut record.cells[notation];
    cell.span = cell.span.to(last);
    cell.form = Form::Verbatim;
    cell.text = text[cell.span.start..cell.span.end].to_owned().into();
}

fn row(record: Record, columns: &Columns, told: &mut Told) -> Option<Row> {
    let text = |column: Option<usize>| -> Option<String> {
        column.and_then(|i| record.cells.get(i)).map(|cell| cell.text.to_string()).filter(|text| !text.is_empty())
    };
    let gloss = text(columns.gloss);
    let Some(Cell { text: notation, span, line, form }) = record.cells.get(columns.notation).cloned() else {
        let gloss = gloss.map_or_else(String::new, |gloss| short(&gloss) + ": ");
        let message =
            format!("{gloss}this row ends before the column of HamNoSys, the one numbered {}", columns.notation + 1);
        told.say(Diagnostic::fault(record.span(), message).label("too short"));
        return None;
    };
    if notation.is_empty() {
        told.say(nothing(gloss.as_deref(), record.span()));
        return None;
    }
    let mouthing = text(columns.mouthing);
    Some(Row { gloss, notation: notation.into_owned(), mouthing, span, line, form })
}

/// A row without HamNoSys: dictionaries are often only partly transcribed.
pub(super) fn nothing(gloss: Option<&str>, span: Span) -> Diagnostic {
    let gloss = gloss.map_or_else(String::new, |gloss| short(gloss) + ": ");
    Diagnostic::warning(span, format!("{gloss}this row has no HamNoSys")).label("passed over")
}

/// Which column is which.
struct Columns {
    notation: usize,
    gloss: Option<usize>,
    mouthing: Option<usize>,
    /// Records at the top that are no rows.
    head: usize,
}

impl Columns {
    fn of(records: &[Record], options: &Options, told: &mut Told) -> Option<Columns> {
        let first = records.first()?;
        let headings: Vec<String> = first.cells.iter().map(|cell| plain(&cell.text)).collect();
        let find = |role: Role, told: &mut Told| match role.asked(options) {
            Some(asked) => asked_for(asked, first, &headings, told).map(Some),
            None => Some(heading(role, &headings)),
        };
        // A row of symbols is no heading, whatever else it says.
        let headed = !first.cells.iter().any(|cell| is_hamnosys(&cell.text));
        let by_symbols = most_symbols(records);
        let notation = match find(Role::Notation, told)?.filter(|_| headed || options.notation.is_some()) {
            Some(column) => column,
            None => match by_symbols {
                Some(column) => column,
                None => {
                    no_notation(first, &headings, told);
                    return None;
                }
            },
        };
        let other = |column: &usize| *column != notation;
        let named = |column: Option<usize>, asked: &Option<String>| column.filter(|_| headed || asked.is_some());
        let gloss = named(find(Role::Gloss, told)?, &options.gloss).filter(other);
        let mouthing = named(find(Role::Mouthing, told)?, &options.mouthing).filter(other);
        let known =
            [Role::Notation, Role::Gloss, Role::Mouthing].iter().any(|role| heading(*role, &headings).is_some());
        let asked = [&options.notation, &options.gloss, &options.mouthing].into_iter().flatten();
        let names_asked = asked.into_iter().any(|asked| headings.contains(&plain(asked)));
        let head = usize::from(headed && (known || names_asked || by_symbols.is_some() && records.len() > 1));
        let free = |column: &usize| *column != notation && Some(*column) != mouthing;
        let gloss = gloss.or_else(|| (0..first.cells.len()).find(free));
        Some(Columns { notation, gloss, mouthing, head })
    }
}

/// The column that was asked for by heading or number.
fn asked_for(asked: &str, first: &Record, headings: &[String], told: &mut Told) -> Option<usize> {
    let by_heading = headings.iter().position(|heading| *heading == plain(asked));
    let number = || asked.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).filter(|i| *i < headings.len());
    let found = by_heading.or_else(number);
    if found.is_none() {
        told.say(no_column(asked, first.span(), first.cells.iter().map(|cell| cell.text.as_ref())));
    }
    found
}

/// A column that was asked for and is not there.
pub(super) fn no_column<'a>(asked: &str, span: Span, there: impl Iterator<Item = &'a str> + Clone) -> Diagnostic {
    let mut fault = Diagnostic::fault(span, format!("the table has no column `{}`", short(asked))).label("its columns");
    if let Some(near) = nearest(asked, there.clone()) {
        fault = fault.hint(format!("did you mean `{near}`?"));
    }
    let there: Vec<String> = there.take(20).map(short).collect();
    fault.hint(format!("its columns are: {}", there.join(", ")))
}

/// The column in which most of the first rows look like HamNoSys.
fn most_symbols(records: &[Record]) -> Option<usize> {
    let mut counts: Vec<usize> = Vec::new();
    for record in records.iter().take(LOOKED_AT) {
        for (i, _) in record.cells.iter().enumerate().filter(|(_, cell)| is_hamnosys(&cell.text)) {
            if counts.len() <= i {
                counts.resize(i + 1, 0);
            }
            counts[i] += 1;
        }
    }
    let most = *counts.iter().max()?;
    counts.iter().position(|count| *count == most)
}

fn no_notation(first: &Record, headings: &[String], told: &mut Told) {
    let mut fault = Diagnostic::fault(first.span(), "no column of this table holds HamNoSys").label("its first line");
    let near = first.cells.iter().zip(headings).find_map(|(cell, heading)| {
        nearest(heading, NOTATION.iter().copied()).map(|known| (cell.text.as_ref(), known))
    });
    if let Some((there, known)) = near.filter(|(_, known)| known.len() > 3) {
        fault = fault.hint(format!("is `{}` meant as `{known}`?", short(there)));
    }
    told.say(
        fault
            .hint("name the column `hamnosys`, or say which it is")
            .hint("HamNoSys is characters of its font (U+E000 to U+E0F1), or names of symbols such as `hamflathand`"),
    );
}
