//! Rows of cells with a separator, each cell with its place; for tables of annotations and of marker positions.
//!
//! A cell in quotation marks may hold separators, line ends and, doubled, quotation marks (RFC 4180); spreadsheets and
//! ELAN write such cells into tab-separated files too.

use crate::diagnostics::Span;
use std::borrow::Cow;

/// A cell: its text, without quotation marks or, where there are none, without the blanks around it; and its place.
#[derive(Debug, Clone)]
pub(super) struct Cell<'a> {
    pub text: Cow<'a, str>,
    pub span: Span,
}

/// Where reading stands in a table.
pub(super) struct Rows<'a> {
    text: &'a str,
    at: usize,
    separator: u8,
}

impl<'a> Rows<'a> {
    pub fn new(text: &'a str, separator: u8) -> Rows<'a> {
        Rows { text, at: 0, separator }
    }

    /// The place that is read next.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Puts the cells of the next line that is not empty into `cells`; false at the end of the text.
    pub fn next(&mut self, cells: &mut Vec<Cell<'a>>) -> bool {
        let bytes = self.text.as_bytes();
        while self.at < bytes.len() {
            cells.clear();
            loop {
                cells.push(self.cell());
                match bytes.get(self.at) {
                    Some(byte) if *byte == self.separator => self.at += 1,
                    _ => break,
                }
            }
            self.at += if bytes[self.at..].starts_with(b"\r\n") { 2 } else { 1 };
            if cells.len() > 1 || !cells[0].text.is_empty() {
                return true;
            }
        }
        cells.clear();
        false
    }

    /// Reads a cell up to its separator or the end of its line.
    fn cell(&mut self) -> Cell<'a> {
        let bytes = self.text.as_bytes();
        let start = self.at;
        let separator = self.separator;
        let ends = |byte: &u8| *byte == separator || matches!(byte, b'\n' | b'\r');
        if let Some(cell) = self.quoted(start) {
            return cell;
        }
        let length = bytes[start..].iter().position(ends).unwrap_or(bytes.len() - start);
        self.at = start + length;
        let whole = &self.text[start..self.at];
        let text = whole.trim();
        let start = start + (whole.len() - whole.trim_start().len());
        Cell { text: text.into(), span: Span::new(start, start + text.len()) }
    }

    /// A cell in quotation marks that end right before a separator or the end of the line; of others they are part.
    fn quoted(&mut self, start: usize) -> Option<Cell<'a>> {
        let bytes = self.text.as_bytes();
        if bytes.get(start) != Some(&b'"') {
            return None;
        }
        let mut at = start + 1;
        let mut doubled = false;
        loop {
            at += bytes[at..].iter().position(|b| *b == b'"')?;
            if bytes.get(at + 1) != Some(&b'"') {
                break;
            }
            doubled = true;
            at += 2;
        }
        if bytes.get(at + 1).is_some_and(|b| *b != self.separator && !matches!(b, b'\n' | b'\r')) {
            return None;
        }
        let inner = &self.text[start + 1..at];
        self.at = at + 1;
        let text = if doubled { inner.replace("\"\"", "\"").into() } else { inner.into() };
        Some(Cell { text, span: Span::new(start, at + 1) })
    }
}

/// A cell as it is written: in quotation marks where it would be read as something else without.
pub(super) fn push(out: &mut String, text: &str, separator: char) {
    if text.contains([separator, '"', '\n', '\r']) || text.trim() != text {
        out.push('"');
        out.push_str(&text.replace('"', "\"\""));
        out.push('"');
    } else {
        out.push_str(text);
    }
}

/// Tab, semicolon or comma: what the first line has most of, tabs before the others.
pub(super) fn separator(text: &str) -> u8 {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let count = |separator: char| first.matches(separator).count();
    match (count('\t'), count(';'), count(',')) {
        (0, 0, 0) => b'\t',
        (0, semicolons, commas) if semicolons >= commas => b';',
        (0, ..) => b',',
        _ => b'\t',
    }
}
