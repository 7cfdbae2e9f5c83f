//! Tables that list motion files.

use super::{Seen, field_of_heading, of};
use crate::corpus::manifest::{Field, Rows};
use crate::diagnostics::{Error, Span, Spanned};
use std::collections::{BTreeMap, BTreeSet};

/// A table with headings.
pub struct HeadedTable {
    /// Its path from the folder, with `/`.
    pub path: String,
    rows: Rows,
}

/// What a table lists.
pub(super) struct Listed {
    /// Recordings' fields and the headings of their columns.
    pub(super) columns: Vec<(Spanned<Field>, Spanned<String>)>,
    /// The numbers of the motions.
    pub(super) rows: Vec<usize>,
}

impl Listed {
    /// `motion: file, gloss: gloss`.
    pub(super) fn columns_told(&self) -> String {
        let told: Vec<String> =
            self.columns.iter().map(|(field, heading)| format!("{}: {}", field.value.word(), heading.value)).collect();
        told.join(", ")
    }
}

impl HeadedTable {
    /// A table of its text.
    ///
    /// # Errors
    /// It is empty, or no CSV.
    pub fn of(path: &str, text: &str) -> Result<HeadedTable, Error> {
        Ok(HeadedTable { path: path.to_owned(), rows: Rows::of(text)? })
    }

    /// What it lists, where one of its columns names motions, most of which could be read; the first such column.
    pub(super) fn takes(&self, motions: &[Seen]) -> Option<Listed> {
        let folder = self.path.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"));
        let numbers: BTreeMap<&str, usize> =
            motions.iter().enumerate().filter_map(|(at, seen)| Some((seen.path.strip_prefix(&folder)?, at))).collect();
        let rows = &self.rows.rows;
        let listed = |column: usize| {
            let number = |(cells, _): &(Vec<String>, Span)| numbers.get(cells.get(column)?.as_str()).copied();
            let found: Vec<usize> = rows.iter().filter_map(number).collect();
            (!found.is_empty() && found.len() * 2 >= rows.len()).then_some(found)
        };
        let (column, found) = (0..self.rows.headings.len()).find_map(|column| Some((column, listed(column)?)))?;
        if found.iter().collect::<BTreeSet<_>>().len() < found.len() {
            // A file of several rows is cut into pieces by columns that cannot be guessed.
            return None;
        }
        let named = |field: Field, at: usize| (Spanned::new(field, Span::default()), of(&self.rows.headings[at]));
        let mut columns = vec![named(Field::Motion, column)];
        for (at, heading) in self.rows.headings.iter().enumerate().filter(|(at, _)| *at != column) {
            let field =
                field_of_heading(heading).filter(|field| columns.iter().all(|(known, _)| known.value != *field));
            let fits = field.is_some_and(|field| self.fits(field, at));
            columns.extend(field.filter(|_| fits).map(|field| named(field, at)));
        }
        Some(Listed { columns, rows: found })
    }

    /// Whether a column's cells can be a field: hands are hands, names differ.
    fn fits(&self, field: Field, column: usize) -> bool {
        let cells = || self.rows.rows.iter().map(|(cells, _)| cells.get(column).map_or("", String::as_str));
        let is_side = |cell: &str| ["", "right", "left"].contains(&cell.to_lowercase().as_str());
        match field {
            Field::Hand => cells().all(|cell| is_side(cell) || cell.eq_ignore_ascii_case("both")),
            Field::Dominant => cells().all(is_side),
            Field::Name => {
                let all: BTreeSet<&str> = cells().collect();
                all.len() == self.rows.rows.len() && !all.contains("")
            }
            _ => true,
        }
    }
}
