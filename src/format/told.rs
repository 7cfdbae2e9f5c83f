//! What a reader has to say of a file, kept in proportion.

use crate::diagnostics::{Diagnostic, Severity, Span};

/// Faults, and warnings, beyond this many are counted, not shown.
const MOST: usize = 100;

/// Faults and warnings as they are found.
#[derive(Debug, Default)]
pub(super) struct Told {
    faults: Vec<Diagnostic>,
    warnings: Vec<Diagnostic>,
    more: usize,
}

impl Told {
    /// Keeps a fault or a warning.
    pub fn say(&mut self, told: Diagnostic) {
        let kept = match told.severity {
            Severity::Fault => &mut self.faults,
            Severity::Warning => &mut self.warnings,
        };
        if kept.len() < MOST {
            kept.push(told);
        } else {
            self.more += 1;
        }
    }

    /// Whether the file cannot be used.
    pub fn has_fault(&self) -> bool {
        !self.faults.is_empty()
    }

    /// All of it, in the order of the text.
    pub fn finish(self) -> Vec<Diagnostic> {
        let mut all = self.faults;
        all.extend(self.warnings);
        all.sort_by_key(|told| told.span.start);
        if self.more > 0 {
            let message = format!("{} more faults and warnings of this file are not shown", self.more);
            all.push(Diagnostic::warning(Span::default(), message).label("in this file"));
        }
        all
    }

    /// What was read, with the warnings; or everything that is told, where there is a fault.
    pub fn judge<T>(self, read: T) -> Result<(T, Vec<Diagnostic>), Vec<Diagnostic>> {
        if self.has_fault() { Err(self.finish()) } else { Ok((read, self.finish())) }
    }
}
