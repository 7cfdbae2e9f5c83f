//! The signs that a command line names: of files, of folders, of standard input, or of the lexicon.

use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::Severity;
use crate::notation::lexicon::language_of_path;
use crate::notation::{Lexicon, Vocabulary, read};
use crate::phonology::Sign;
use std::path::Path;

/// Finds signs; the lexicon is read when the first name asks for it.
pub(super) struct Finder<'a> {
    /// Where names come from.
    pub sources: &'a Sources,
    /// The words that descriptions may use.
    pub vocabulary: &'a Vocabulary,
    /// The language of signs given by name, where several have one of that name.
    pub language: Option<&'a str>,
    /// Some text had a fault, which is told already.
    pub faulty: bool,
    lexicon: Option<Lexicon>,
}

impl<'a> Finder<'a> {
    pub(super) fn new(sources: &'a Sources, vocabulary: &'a Vocabulary, language: Option<&'a str>) -> Finder<'a> {
        Finder { sources, vocabulary, language, faulty: false, lexicon: None }
    }

    /// The signs of a file, a folder or standard input (`-`), or the one sign of a name.
    pub(super) fn find(&mut self, what: &str) -> Result<Vec<Sign>, Failure> {
        let path = Path::new(what);
        if what != "-" && !what.ends_with(".sign") && !path.exists() {
            let lexicon = match &self.lexicon {
                Some(lexicon) => lexicon,
                None => self.lexicon.insert(world::lexicon(self.sources, self.vocabulary)?),
            };
            let found = lexicon.find(what, self.language);
            return Ok(vec![found.map_err(|e| Failure::Faults(Some(e.to_string())))?.sign.clone()]);
        }
        let mut signs = Vec::new();
        for text in files::read_all(&[path.to_owned()])? {
            let mut reading = read(&text.source.text, self.vocabulary, language_of_path(&text.source.name));
            reading.diagnostics.extend(text.fault);
            terminal::tell(&reading.diagnostics, &text.source);
            self.faulty |= reading.diagnostics.iter().any(|d| d.severity == Severity::Fault);
            signs.extend(reading.signs.into_iter().map(|s| s.sign));
        }
        Ok(signs)
    }
}
