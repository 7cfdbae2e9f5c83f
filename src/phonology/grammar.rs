//! Reading the inventories of `grammar/` (RON), with faults that name line and column.

use crate::diagnostics::{Diagnostic, Source, Span};
use serde::de::DeserializeOwned;
use unicode_normalization::UnicodeNormalization;

/// Reads a RON table.
///
/// # Errors
/// One diagnostic at the place the text stops being such a table; it names the row as far as it was read.
pub fn read_table<T: DeserializeOwned>(source: &Source) -> Result<T, Diagnostic> {
    let text = source.text.strip_prefix('\u{feff}').unwrap_or(&source.text);
    let cut = source.text.len() - text.len();
    ron::from_str(text).map_err(|error| {
        let offset = |position: ron::error::Position| cut + offset_of(text, position.line, position.col);
        let span = Span::new(offset(error.span.start), offset(error.span.end));
        Diagnostic::fault(span, format!("this is not a table of the expected form: {}", error.code)).label("here")
    })
}

/// The form in which names are compared: NFC, lower case.
///
/// ```
/// use chereme::phonology::grammar::fold;
/// assert_eq!(fold("E\u{301}TE\u{301}"), fold("été"));
/// ```
pub fn fold(name: &str) -> String {
    if name.is_ascii() {
        return name.to_ascii_lowercase();
    }
    name.nfc().flat_map(char::to_lowercase).nfc().collect()
}

/// The byte offset of a line and a column (both from 1, in characters).
fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let start: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let rest = &text[start..];
    start + rest.char_indices().nth(column.saturating_sub(1)).map_or(rest.len(), |(i, _)| i)
}
