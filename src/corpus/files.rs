//! The files of a corpus as whoever opens it gives them: from a disk, or from memory.

use crate::diagnostics::{Diagnostic, Error, Source, Span};
use std::path::Path;
use std::sync::Arc;

/// What a file's folder says about it without its content.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stamp {
    /// Bytes.
    pub size: u64,
    /// When it was changed last, nanoseconds since 1970; 0 where that is not known.
    pub modified_ns: u64,
}

/// Files that can be read. `corpus` opens none itself, but those of its cache.
pub trait Files: Sync {
    /// All bytes of a file.
    ///
    /// # Errors
    /// It is not there, or cannot be read; the message names it.
    fn read(&self, path: &Path) -> Result<Vec<u8>, Error>;

    /// Its size and time; `None` where it is not there.
    fn stamp(&self, path: &Path) -> Option<Stamp>;
}

/// A place in a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The text.
    pub source: Arc<Source>,
    /// Where.
    pub span: Span,
}

impl Place {
    /// A fault here.
    pub fn fault(&self, message: impl Into<String>) -> Finding {
        Finding { source: self.source.clone(), diagnostic: Diagnostic::fault(self.span, message) }
    }

    /// A warning here.
    pub fn warning(&self, message: impl Into<String>) -> Finding {
        Finding { source: self.source.clone(), diagnostic: Diagnostic::warning(self.span, message) }
    }
}

/// Something missing or odd about a corpus, and the text that it stands in.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The manifest, a table, an annotation or a motion.
    pub source: Arc<Source>,
    /// What it is.
    pub diagnostic: Diagnostic,
}

impl Finding {
    /// With a text at the caret.
    pub fn label(mut self, label: impl Into<String>) -> Finding {
        self.diagnostic.label = label.into();
        self
    }

    /// With one more hint.
    pub fn hint(mut self, hint: impl Into<String>) -> Finding {
        self.diagnostic.hints.push(hint.into());
        self
    }
}
