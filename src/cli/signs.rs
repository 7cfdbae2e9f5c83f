//! The signs that a command line names: of files, of folders, of standard input, of the lexicon, or written out as an argument.

use super::files::{self, Text};
use super::template::Origin;
use super::world::{self, Texts};
use super::{Failure, Sources};
use crate::diagnostics::Source;
use crate::notation::Lexicon;
use crate::notation::formats::{Notation, Words, is_string};
use crate::phonology::Sign;
use crate::phonology::recombination::Recombination;
use std::path::{Path, PathBuf};

/// Finds signs; the lexicon is read when the first name asks for it.
pub(super) struct Finder<'a> {
    /// Where names come from.
    sources: &'a Sources,
    /// The words that descriptions may use.
    words: &'a Words,
    /// The language of signs given by name, where several have one of that name.
    language: Option<&'a str>,
    /// The notation of files and of standard input, whatever they are called; folders have several.
    pub notation: Option<Notation>,
    /// Some text had a fault, which is told already.
    pub faulty: bool,
    /// How many signs had a fault and are left out.
    pub refused: usize,
    lexicon: Option<Lexicon>,
}

/// A sign with where it came from.
pub(super) struct Found {
    /// The sign.
    pub sign: Sign,
    /// What it is made from, where it is made from others.
    pub from: Option<Recombination>,
    /// For the names of its files.
    pub origin: Origin,
}

impl<'a> Finder<'a> {
    pub(super) fn new(sources: &'a Sources, words: &'a Words, language: Option<&'a str>) -> Finder<'a> {
        Finder { sources, words, language, notation: None, faulty: false, refused: 0, lexicon: None }
    }

    /// The lexicon, if this names a sign of it or is a gloss line; `None` for a file, a folder, standard input (`-`) or a string of
    /// HamNoSys.
    pub(super) fn named(&mut self, what: &str) -> Result<Option<&Lexicon>, Failure> {
        let is_file = what == "-" || Notation::of_extension(what).is_some() || Path::new(what).exists();
        if is_file || is_string(what) {
            return Ok(None);
        }
        let lexicon = match self.lexicon.take() {
            Some(lexicon) => lexicon,
            None => world::lexicon(self.sources, self.words)?,
        };
        Ok(Some(self.lexicon.insert(lexicon)))
    }

    /// The signs of a file, a folder, standard input or a string of HamNoSys, or the one sign of a name.
    pub(super) fn find(&mut self, what: &str) -> Result<Vec<Found>, Failure> {
        let language = self.language;
        if let Some(lexicon) = self.named(what)? {
            let found = lexicon.find(what, language);
            let entry = found.map_err(|e| Failure::Faults(Some(e.to_string())))?;
            return Ok(vec![Found {
                sign: entry.sign.clone(),
                from: entry.derived.clone(),
                origin: Origin::of_name(&entry.sign),
            }]);
        }
        let mut texts = match !Path::new(what).exists() && is_string(what) {
            true => vec![written_out(what)],
            false => files::read_all(&[PathBuf::from(what)])?,
        };
        if let Some(notation) = self.notation.filter(|_| !Path::new(what).is_dir()) {
            texts.iter_mut().for_each(|text| text.notation = notation);
        }
        let read = world::described(self.sources, self.words, texts)?;
        self.faulty |= read.checkups.iter().any(|checkup| checkup.has_faults());
        self.refused += read.checkups.iter().map(|checkup| checkup.refused).sum::<usize>();
        Ok(found(read))
    }
}

/// A string of HamNoSys as a text.
fn written_out(string: &str) -> Text {
    let source = Source::new("argument", string);
    Text { source, notation: Notation::HamNoSys, path: None, folder: PathBuf::new(), fault: None }
}

/// The signs of texts with where they came from.
pub(super) fn found(read: Texts) -> Vec<Found> {
    let mut counts = vec![0; read.checkups.len()];
    read.signs.iter().for_each(|described| counts[described.text] += 1);
    let mut numbers = vec![0; read.checkups.len()];
    let with_origin = |described: world::Described| {
        let text = &read.checkups[described.text].text;
        numbers[described.text] += 1;
        let (number, of) = (numbers[described.text], counts[described.text]);
        let origin = Origin::of_text(&described.sign, text, number, of);
        Found { sign: described.sign, from: described.from, origin }
    };
    read.signs.into_iter().map(with_origin).collect()
}
