//! From a whole text, or any bytes, to signs.

use super::lower::{Derived, Lowered, lower};
use super::parse::parse;
use super::parse::recombination::operators_of;
use super::syntax::File;
use super::vocabulary::Vocabulary;
use crate::diagnostics::{Diagnostic, Severity, Source, Span};
use crate::phonology::operator::Operator;

/// What a text holds.
#[derive(Debug, Clone, Default)]
pub struct Reading {
    /// What was written.
    pub file: File,
    /// The signs without faults, in the order they were written.
    pub signs: Vec<Lowered>,
    /// The signs without faults that are made from others; a [`Lexicon`](super::Lexicon) looks those up.
    pub derived: Vec<Derived>,
    /// All faults and warnings, by their place in the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl Reading {
    /// Whether something cannot be used as it is written.
    pub fn has_faults(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Fault)
    }
}

/// Reads a text of signs; `language` is that of signs in a file without a `language` line (the folder's name).
///
/// ```
/// use chereme::notation::{Vocabulary, read};
/// let text = "sign BOL\n  hands both mirrored\n  movement arc up-right 15cm\n";
/// let reading = read(text, &Vocabulary::open(), "lsf");
/// assert_eq!(reading.diagnostics, []);
/// assert_eq!(reading.signs[0].sign.name, "BOL");
/// ```
pub fn read(text: &str, vocabulary: &Vocabulary, language: &str) -> Reading {
    let (file, mut diagnostics) = parse(text);
    let lowering = lower(&file, vocabulary, language, &mut diagnostics);
    diagnostics.sort_by_key(|d| d.span.start);
    Reading { file, signs: lowering.signs, derived: lowering.derived, diagnostics }
}

/// Reads a list of operators that stands alone, such as the one between the brackets of a gloss. `offset` is where it begins in its
/// source; `language` is that of the handshapes it names.
///
/// # Errors
/// Every fault, with its place in the source.
///
/// ```
/// use chereme::notation::{Vocabulary, operators};
/// use chereme::phonology::operator::Operator;
/// let all = operators("inverted, with configuration U, big", 0, &Vocabulary::builtin(), "lsf").unwrap();
/// assert_eq!((all.len(), &all[0], &all[2]), (3, &Operator::Inverted, &Operator::Size(1.4)));
/// ```
pub fn operators(
    text: &str,
    offset: usize,
    vocabulary: &Vocabulary,
    language: &str,
) -> Result<Vec<Operator>, Vec<Diagnostic>> {
    let written = operators_of(text, offset).map_err(|fault| vec![*fault])?;
    let mut faults = Vec::new();
    let all = super::lower::operators(&written, vocabulary, language, &mut faults);
    if faults.is_empty() { Ok(all) } else { Err(faults) }
}

/// A source of any bytes: what is not UTF-8 is replaced, with a fault at the first such byte.
///
/// ```
/// use chereme::notation::source_of_bytes;
/// let (source, fault) = source_of_bytes("a.sign", b"sign \xff");
/// assert_eq!(source.text, "sign \u{fffd}");
/// assert_eq!(fault.unwrap().span.start, 5);
/// ```
pub fn source_of_bytes(name: &str, bytes: &[u8]) -> (Source, Option<Diagnostic>) {
    match std::str::from_utf8(bytes) {
        Ok(text) => (Source::new(name, text), None),
        Err(error) => {
            let at = error.valid_up_to();
            let byte = bytes.get(at).copied().unwrap_or_default();
            let fault = Diagnostic::fault(Span::new(at, at + 3), format!("the byte 0x{byte:02X} is not UTF-8"))
                .label("here")
                .hint(if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
                    "this file is UTF-16; save it as UTF-8"
                } else {
                    "save the file as UTF-8; it may be Latin-1 or Windows-1252 now"
                });
            (Source::new(name, String::from_utf8_lossy(bytes)), Some(fault))
        }
    }
}
