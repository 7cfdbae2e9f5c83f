//! Gloss lines given as arguments.

use super::terminal;
use crate::diagnostics::Source;
use crate::notation::{Lexicon, Vocabulary};
use crate::phonology::operator::Tables;
use crate::score::gloss::{Known, Reading, Settings, read};
use crate::synthesis::Grammar;

/// Whether an argument is a gloss line rather than the name of one sign: it has spaces or marks, and no sign is called so.
pub(super) fn is_line(argument: &str, lexicon: &Lexicon) -> bool {
    let marks = argument.contains(|c: char| c.is_whitespace() || "@+[]{}<>&()\",".contains(c));
    (marks || argument.ends_with('.')) && lexicon.of_name(argument).next().is_none()
}

/// Reads a line and tells its faults and warnings.
pub(super) fn read_line(
    line: &str,
    lexicon: &Lexicon,
    grammar: &Grammar,
    vocabulary: &Vocabulary,
    settings: &Settings,
) -> Reading {
    let tables = Tables { locations: &grammar.locations, movements: &grammar.movements };
    let reading = read(line, &Known { lexicon, vocabulary, tables }, settings);
    terminal::tell(&reading.diagnostics, &Source::new("gloss line", line));
    reading
}
