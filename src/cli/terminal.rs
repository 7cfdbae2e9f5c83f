//! Printing: a closed pipe is no error, colours are for terminals.

use crate::diagnostics::render::render;
use crate::diagnostics::{Diagnostic, Source};
use std::io::{IsTerminal, Write};

/// How many faults of one text are shown.
const MOST_TOLD: usize = 100;

/// Prints to standard output; where nobody listens any more, nothing is to be done.
pub(super) fn out(text: &str) {
    let _ = std::io::stdout().lock().write_all(text.as_bytes());
}

/// Writes bytes to standard output.
pub(super) fn out_bytes(bytes: &[u8]) {
    let _ = std::io::stdout().lock().write_all(bytes);
}

/// Prints to standard error.
pub(super) fn err(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Prints a text's faults to standard error, in colour on a terminal unless NO_COLOR is set; the first hundred.
pub(super) fn tell(diagnostics: &[Diagnostic], source: &Source) {
    tell_all(&diagnostics[..diagnostics.len().min(MOST_TOLD)], source);
    if let Some(more) = diagnostics.len().checked_sub(MOST_TOLD).filter(|n| *n > 0) {
        err(&format!("{}: {} not shown\n\n", source.name, count(more, "further fault")));
    }
}

/// Prints faults to standard error, all of them.
pub(super) fn tell_all(diagnostics: &[Diagnostic], source: &Source) {
    let plain = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    let colour = std::io::stderr().is_terminal() && !plain;
    for diagnostic in diagnostics {
        err(&format!("{}\n\n", render(diagnostic, source, colour)));
    }
}

/// `1 sign`, `2 signs`.
pub(super) fn count(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}
