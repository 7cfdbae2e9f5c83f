//! The signs that a command line names: of files, of folders, of standard input, or of the lexicon.

use super::{Failure, Sources, files, world};
use crate::notation::{Lexicon, Vocabulary};
use crate::phonology::Sign;
use std::path::Path;

/// Finds signs; the lexicon is read when the first name asks for it.
pub(super) struct Finder<'a> {
    /// Where names come from.
    sources: &'a Sources,
    /// The words that descriptions may use.
    vocabulary: &'a Vocabulary,
    /// The language of signs given by name, where several have one of that name.
    language: Option<&'a str>,
    /// Some text had a fault, which is told already.
    pub faulty: bool,
    lexicon: Option<Lexicon>,
}

impl<'a> Finder<'a> {
    pub(super) fn new(sources: &'a Sources, vocabulary: &'a Vocabulary, language: Option<&'a str>) -> Finder<'a> {
        Finder { sources, vocabulary, language, faulty: false, lexicon: None }
    }

    /// The lexicon, if this names a sign of it or is a gloss line; `None` for a file, a folder or standard input (`-`).
    pub(super) fn named(&mut self, what: &str) -> Result<Option<&Lexicon>, Failure> {
        if what == "-" || what.ends_with(".sign") || Path::new(what).exists() {
            return Ok(None);
        }
        let lexicon = match self.lexicon.take() {
            Some(lexicon) => lexicon,
            None => world::lexicon(self.sources, self.vocabulary)?,
        };
        Ok(Some(self.lexicon.insert(lexicon)))
    }

    /// The signs of a file, a folder or standard input, or the one sign of a name.
    pub(super) fn find(&mut self, what: &str) -> Result<Vec<Sign>, Failure> {
        let language = self.language;
        if let Some(lexicon) = self.named(what)? {
            let found = lexicon.find(what, language);
            return Ok(vec![found.map_err(|e| Failure::Faults(Some(e.to_string())))?.sign.clone()]);
        }
        let texts = files::read_all(&[Path::new(what).to_owned()])?;
        let (described, faulty) = world::described(self.sources, self.vocabulary, texts)?;
        self.faulty |= faulty;
        Ok(described.into_iter().map(|d| d.sign).collect())
    }
}
