//! The text of a file's bytes: UTF-8, or UTF-16 that begins with a byte order mark.

use crate::diagnostics::{Diagnostic, Source, Span};
use std::borrow::Cow;

/// The text that the readers of annotation files see, without a byte order mark, and a warning where bytes had to be
/// replaced by U+FFFD.
///
/// ```
/// use chereme::format::text::decode;
/// assert_eq!(decode(b"\xff\xfea\0\xe9\0").0, "aé");
/// assert_eq!(decode("\u{feff}aé".as_bytes()), ("aé".into(), None));
/// assert_eq!(decode(b"a\xe9").1.unwrap().message, "a byte is not UTF-8");
/// ```
pub fn decode(bytes: &[u8]) -> (Cow<'_, str>, Option<Diagnostic>) {
    if let Some(rest) = bytes.strip_prefix(&[0xff, 0xfe]) {
        return utf_16(rest, u16::from_le_bytes);
    }
    if let Some(rest) = bytes.strip_prefix(&[0xfe, 0xff]) {
        return utf_16(rest, u16::from_be_bytes);
    }
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return (text.into(), None),
        Err(error) => error,
    };
    let warning = replaced(error.valid_up_to(), "a byte is not UTF-8");
    let hint = "this file may be in another encoding (Latin-1, MacRoman); save it as UTF-8";
    (String::from_utf8_lossy(bytes), Some(warning.hint(hint)))
}

/// The text that spans of the readers of annotation files point into.
pub fn source_of_bytes(name: &str, bytes: &[u8]) -> Source {
    Source::new(name, decode(bytes).0)
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> (Cow<'_, str>, Option<Diagnostic>) {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let mut text = String::with_capacity(pairs.len());
    let mut wrong = None;
    for read in char::decode_utf16(pairs.iter().map(|pair| unit(*pair))) {
        if read.is_err() {
            wrong.get_or_insert(text.len());
        }
        text.push(read.unwrap_or(char::REPLACEMENT_CHARACTER));
    }
    if !rest.is_empty() {
        wrong.get_or_insert(text.len());
        text.push(char::REPLACEMENT_CHARACTER);
    }
    (text.into(), wrong.map(|at| replaced(at, "a unit is not UTF-16").hint("was the file cut off?")))
}

fn replaced(at: usize, message: &str) -> Diagnostic {
    let span = Span::new(at, at + char::REPLACEMENT_CHARACTER.len_utf8());
    Diagnostic::warning(span, message).label("read as \u{fffd}")
}
