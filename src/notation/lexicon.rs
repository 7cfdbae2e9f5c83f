//! The lexicon: named signs of many files.
//!
//! Sources are layered (the program's own signs, then `--lexicon` folders): an entry of a later source replaces
//! that of an earlier one with the same name and language. Within one source a name stands once.

mod link;

use super::formats::{AnyReading, Notation};
use super::read::read;
use super::vocabulary::Vocabulary;
use crate::diagnostics::{Diagnostic, Error, Source, Span};
use crate::phonology::LocationInventory;
use crate::phonology::Sign;
use crate::phonology::grammar::fold;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::operator::Tables;
use crate::phonology::recombination::Recombination;
use link::Unmade;
use std::collections::BTreeMap;

/// Language and folded name.
type Key = (String, String);

/// A sign and where it was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The sign.
    pub sign: Sign,
    /// The file.
    pub path: String,
    /// The line in it, from 1.
    pub line: usize,
    /// Whether its file holds an alphabet (`alphabet.sign`).
    pub is_letter: bool,
    /// The number of its source, from 0.
    pub layer: usize,
    /// What it is made from, where it is made from other signs.
    pub derived: Option<Recombination>,
    span: Span,
}

impl Entry {
    /// Where its name stands in its file.
    pub fn span(&self) -> Span {
        self.span
    }
}

/// A text of a source with its faults.
#[derive(Debug, Clone)]
pub struct Checked {
    /// The text.
    pub source: Source,
    /// Its faults and warnings.
    pub diagnostics: Vec<Diagnostic>,
    /// How many of its signs can be used.
    pub signs: usize,
}

/// Named signs.
#[derive(Debug, Clone, Default)]
pub struct Lexicon {
    /// By language and folded name; a name of an alphabet is kept apart from a sign of the same name.
    entries: BTreeMap<Key, Entry>,
    /// What is still to be made from other signs.
    unmade: BTreeMap<Key, Unmade>,
    layers: usize,
}

/// The language of a file by its folder: `lexicon/lsf/bol.sign` is `lsf`.
///
/// ```
/// use chereme::notation::lexicon::language_of_path;
/// assert_eq!(language_of_path("lexicon/lsf/bol.sign"), "lsf");
/// assert_eq!(language_of_path("bol.sign"), "");
/// ```
pub fn language_of_path(path: &str) -> &str {
    let mut parts = path.rsplit(['/', '\\']);
    parts.next();
    match parts.next() {
        None | Some("" | "." | "..") => "",
        Some("lexicon") => "",
        Some(folder) => folder,
    }
}

fn is_alphabet(path: &str) -> bool {
    path.rsplit(['/', '\\']).next().is_some_and(|file| file.eq_ignore_ascii_case("alphabet.sign"))
}

impl Lexicon {
    /// The signs that come with the program, those made from others among them.
    ///
    /// ```
    /// use chereme::notation::Lexicon;
    /// assert!(Lexicon::builtin().find("FONCÉ", Some("lsf")).is_ok());
    /// ```
    pub fn builtin() -> Lexicon {
        let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
        let mut lexicon = Lexicon::default();
        let mut checked = lexicon.add(embedded(), &Vocabulary::builtin());
        lexicon.link(&Tables { locations: &locations, movements: &movements }, &mut checked);
        lexicon
    }

    /// Adds the files of one source, above the sources added before. Signs without faults are taken; those that are made from
    /// others wait for [`Lexicon::link`].
    ///
    /// ```
    /// use chereme::diagnostics::Source;
    /// use chereme::notation::{Lexicon, Vocabulary};
    /// let mut lexicon = Lexicon::default();
    /// lexicon.add([Source::new("lexicon/lsf/bol.sign", "sign BOL\n  hands both\n")], &Vocabulary::open());
    /// assert_eq!(lexicon.find("bol", Some("lsf")).unwrap().sign.name, "BOL");
    /// ```
    pub fn add(&mut self, sources: impl IntoIterator<Item = Source>, vocabulary: &Vocabulary) -> Vec<Checked> {
        self.add_read(sources.into_iter().map(|source| {
            let reading = read(&source.text, vocabulary, language_of_path(&source.name)).into();
            (source, reading)
        }))
    }

    /// Adds the files of one source that are read already, whatever their notation, as [`Lexicon::add`] does.
    ///
    /// In a `.sign` text a name met before is a fault; elsewhere, where a gloss may well stand twice, the first sign counts and
    /// the others are not found by name.
    pub fn add_read(&mut self, texts: impl IntoIterator<Item = (Source, AnyReading)>) -> Vec<Checked> {
        let layer = self.layers;
        self.layers += 1;
        let mut all = Vec::new();
        let mut found = Found::default();
        for (source, reading) in texts {
            all.push(take(source, reading, layer, &mut found));
        }
        // The later source replaces, whichever way a sign is described.
        self.entries.retain(|key, _| !found.unmade.contains_key(key));
        self.unmade.retain(|key, _| !found.entries.contains_key(key));
        self.entries.append(&mut found.entries);
        self.unmade.append(&mut found.unmade);
        all
    }

    /// The sign of a name, in one language or in all.
    ///
    /// # Errors
    /// No sign of that name (with the nearest), or several languages that have one (listing them).
    pub fn find(&self, name: &str, language: Option<&str>) -> Result<&Entry, Error> {
        let wanted = |entry: &&Entry| language.is_none_or(|l| entry.sign.language.eq_ignore_ascii_case(l));
        let hits: Vec<&Entry> = self.of_name(name).filter(wanted).collect();
        match hits.as_slice() {
            [one] => Ok(one),
            [] => {
                let of = language.map(|l| format!(" in `{l}`")).unwrap_or_default();
                let names = self.entries.values().filter(wanted).map(|e| e.sign.name.as_str());
                let near = super::suggest::nearest(name, names);
                let near = near.map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
                Err(Error::new(format!("there is no sign `{name}`{of}{near}")))
            }
            several => {
                let all: Vec<String> =
                    several.iter().map(|e| format!("{} ({}:{})", e.sign.language, e.path, e.line)).collect();
                Err(Error::new(format!("`{name}` is a sign of several languages, say which: {}", all.join(", "))))
            }
        }
    }

    /// The signs of a name, one a language at most.
    pub fn of_name(&self, name: &str) -> impl Iterator<Item = &Entry> {
        let folded = fold(name);
        self.entries.iter().filter(move |((_, n), _)| *n == folded).map(|(_, e)| e)
    }

    /// A letter of a language's alphabet.
    pub fn letter(&self, letter: &str, language: &str) -> Option<&Entry> {
        let entry = self.entries.get(&(language.to_lowercase(), fold(letter)))?;
        entry.is_letter.then_some(entry)
    }

    /// The letters of a language's alphabet, by name.
    pub fn letters<'l>(&'l self, language: &'l str) -> impl Iterator<Item = &'l Entry> {
        self.entries().filter(move |e| e.is_letter && e.sign.language.eq_ignore_ascii_case(language))
    }

    /// All entries, by language and name.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.entries.values()
    }

    /// How many sources were added; an entry of the last one has [`Entry::layer`] one less.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// How many signs there are.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}

/// What one source describes.
#[derive(Default)]
struct Found {
    entries: BTreeMap<Key, Entry>,
    unmade: BTreeMap<Key, Unmade>,
}

impl Found {
    /// Where a sign of that name stands already.
    fn first(&self, key: &Key) -> Option<(&str, usize, Span)> {
        let entry = self.entries.get(key).map(|e| (e.path.as_str(), e.line, e.span));
        entry.or_else(|| self.unmade.get(key).map(|u| (u.path.as_str(), u.line, u.derived.name_span)))
    }
}

/// Takes the signs of a file, with a fault for a name met before in the same source.
fn take(source: Source, reading: AnyReading, layer: usize, found: &mut Found) -> Checked {
    let mut diagnostics = reading.diagnostics;
    let mut signs = 0;
    let is_letter = is_alphabet(&source.name);
    let described = reading.signs.into_iter().map(|l| (l.name_span, Ok(l.sign)));
    let derived = reading.derived.into_iter().map(|d| (d.name_span, Err(d)));
    let mut all: Vec<_> = described.chain(derived).collect();
    all.sort_by_key(|(span, _)| span.start);
    // Line numbers by one walk through the text, not one for each sign.
    let (mut walked, mut line) = (0, 1);
    for (span, described) in all {
        let upto = span.start.min(source.text.len());
        line += source.text.as_bytes()[walked..upto].iter().filter(|b| **b == b'\n').count();
        walked = upto;
        let own: &Sign = match &described {
            Ok(sign) => sign,
            Err(derived) => &derived.own,
        };
        let key = (own.language.to_lowercase(), fold(&own.name));
        if let Some((path, first, there)) = found.first(&key) {
            match reading.notation {
                Notation::Sign => {}
                Notation::HamNoSys | Notation::SiGml | Notation::Table => {
                    signs += 1;
                    continue;
                }
            }
            let fault = Diagnostic::fault(span, format!("`{}` is described twice", own.name));
            let fault = fault.label("the second").hint(format!("the first is {path}:{first}"));
            diagnostics.push(if path == source.name { fault.related(there, "the first") } else { fault });
            continue;
        }
        let path = source.name.clone();
        match described {
            Ok(sign) => {
                signs += 1;
                found.entries.insert(key, Entry { sign, path, line, is_letter, layer, derived: None, span });
            }
            Err(derived) => {
                found.unmade.insert(key, Unmade { derived, path, line, is_letter, layer });
            }
        }
    }
    diagnostics.sort_by_key(|d| d.span.start);
    Checked { source, diagnostics, signs }
}

/// The texts of the lexicon that comes with the program.
pub fn embedded() -> impl Iterator<Item = Source> {
    const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/lexicon.rs"));
    FILES.iter().map(|(path, text)| Source::new(*path, *text))
}
