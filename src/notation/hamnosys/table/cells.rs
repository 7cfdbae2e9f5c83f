//! Tables as lines of cells, each with its place.
//!
//! The rules are those of RFC 4180: a cell in quotation marks may hold separators, line ends and, doubled, quotation
//! marks. TSV has no quotation marks of its own, but many programs write them: they are read where they
//! surround a whole cell. No library of ours says where in a line a cell begins, so cells are found here.

use super::{Form, Told, short};
use crate::diagnostics::{Diagnostic, Span};
use std::borrow::Cow;

/// The separator of TSV.
pub(super) const TAB: u8 = b'\t';

/// A line of cells; a cell in quotation marks may go on over several lines of the text.
pub(super) struct Record<'a> {
    pub cells: Vec<Cell<'a>>,
}

impl Record<'_> {
    /// Where the record is.
    pub fn span(&self) -> Span {
        let first = self.cells.first().map_or(Span::default(), |cell| cell.span);
        self.cells.last().map_or(first, |last| first.to(last.span))
    }
}

/// A cell.
#[derive(Clone)]
pub(super) struct Cell<'a> {
    /// What it says, without quotation marks and the spaces around it.
    pub text: Cow<'a, str>,
    /// Where that is.
    pub span: Span,
    /// The line of its first byte, from 1.
    pub line: usize,
    pub form: Form,
}

/// Comma or semicolon: whichever the first line has more of outside quotation marks.
pub(super) fn separator(text: &str) -> u8 {
    let (mut quoted, mut commas, mut semicolons) = (false, 0, 0);
    for byte in text.bytes() {
        match byte {
            b'"' => quoted = !quoted,
            b'\n' if !quoted => break,
            b',' if !quoted => commas += 1,
            b';' if !quoted => semicolons += 1,
            _ => {}
        }
    }
    if semicolons > commas { b';' } else { b',' }
}

/// The records of a text; empty lines are left out.
pub(super) fn separated<'a>(text: &'a str, separator: u8, told: &mut Told) -> Vec<Record<'a>> {
    let mut scanner = Scanner { text, at: if text.starts_with('\u{feff}') { 3 } else { 0 }, line: 1, separator };
    let mut records = Vec::new();
    while scanner.at < text.len() {
        let record = scanner.record(told);
        if !(record.cells.len() == 1 && record.cells[0].text.is_empty()) {
            records.push(record);
        }
    }
    records
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    separator: u8,
}

impl<'a> Scanner<'a> {
    fn record(&mut self, told: &mut Told) -> Record<'a> {
        let mut record = Record { cells: Vec::new() };
        loop {
            let cell = self.quoted(told).unwrap_or_else(|| self.plain(self.at));
            record.cells.push(cell);
            match self.text.as_bytes().get(self.at) {
                Some(byte) if *byte == self.separator => self.at += 1,
                Some(_) => {
                    // A line end: `plain` and `quoted` stop at nothing else.
                    self.at += 1;
                    self.line += 1;
                    return record;
                }
                None => return record,
            }
        }
    }

    /// A cell from a place up to the separator or the end of the line.
    fn plain(&mut self, start: usize) -> Cell<'a> {
        let ends = |byte: &u8| *byte == self.separator || *byte == b'\n';
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().position(|byte| ends(byte)).unwrap_or(rest.len());
        self.cell(start, self.at, Form::Verbatim)
    }

    /// What stands between two places, without spaces around it.
    fn cell(&self, start: usize, end: usize, form: Form) -> Cell<'a> {
        let whole = &self.text[start..end];
        let trimmed = whole.trim();
        let before = &whole[..whole.len() - whole.trim_start().len()];
        let (start, line) = (start + before.len(), self.line + before.matches('\n').count());
        Cell { text: Cow::Borrowed(trimmed), span: Span::new(start, start + trimmed.len()), line, form }
    }

    /// A cell in quotation marks; `None`, with nothing read, where there is none, or more than one in a cell of TSV.
    fn quoted(&mut self, told: &mut Told) -> Option<Cell<'a>> {
        let bytes = self.text.as_bytes();
        let open = self.at + bytes[self.at..].iter().position(|byte| *byte != b' ')?;
        if bytes[open] != b'"' {
            return None;
        }
        let (mut at, mut form, mut lines) = (open + 1, Form::Verbatim, 0);
        let close = loop {
            match bytes.get(at) {
                Some(b'"') if bytes.get(at + 1) == Some(&b'"') => {
                    form = Form::Escaped;
                    at += 1;
                }
                Some(b'"') => break at,
                // TSV has no line ends in cells: there the mark is a character like others.
                Some(b'\n') if self.separator == TAB => return None,
                Some(b'\n') => lines += 1,
                Some(_) => {}
                None => {
                    self.unclosed(open, told);
                    return None;
                }
            }
            at += 1;
        };
        let after = close + 1 + bytes[close + 1..].iter().take_while(|byte| matches!(byte, b' ' | b'\r')).count();
        let ends = bytes.get(after).is_none_or(|byte| *byte == self.separator || *byte == b'\n');
        if !ends && self.separator == TAB {
            return None;
        }
        let mut cell = self.cell(open + 1, close, form);
        self.line += lines;
        self.at = after;
        if form == Form::Escaped {
            cell.text = Cow::Owned(cell.text.replace("\"\"", "\""));
        }
        if !ends {
            let rest = self.plain(after);
            let message = format!("`{}` stands after a closing quotation mark: passed over", short(&rest.text));
            told.say(
                Diagnostic::warning(rest.span, message)
                    .label("expected the end of the cell")
                    .hint("a quotation mark within a cell is written twice"),
            );
        }
        Some(cell)
    }

    fn unclosed(&self, open: usize, told: &mut Told) {
        told.say(
            Diagnostic::warning(Span::new(open, open + 1), "this quotation mark is not closed: read as a character")
                .label("here")
                .hint("a cell that begins with a quotation mark ends with one"),
        );
    }
}
