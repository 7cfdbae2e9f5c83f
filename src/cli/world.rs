//! The names that are known: the program's own inventories and signs, and those of the user's folders.

use super::files::{Text, read_folder};
use super::{Failure, Sources, terminal};
use crate::diagnostics::{Diagnostic, Severity, Source, Span};
use crate::notation::formats::{AnyReading, Notation, Words, read_any};
use crate::notation::lexicon::{Checked, Entry, embedded, language_of_path};
use crate::notation::{Lexicon, source_of_bytes};
use crate::phonology::expression::Expressions;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::operator::Tables;
use crate::phonology::recombination::Recombination;
use crate::phonology::{LocationInventory, Sign};
use crate::synthesis::Grammar;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The folders of an option, the one in the working folder first (so that the option's override it).
fn folders(here: &str, given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let own = Path::new(here);
    let mut all: Vec<PathBuf> = if own.is_dir() { vec![own.to_owned()] } else { Vec::new() };
    for folder in given {
        if !folder.is_dir() {
            return Err(Failure::Usage(format!("there is no folder `{}`", folder.display())));
        }
        all.push(folder.clone());
    }
    Ok(all)
}

/// A table of a folder, where it has one.
fn table(folder: &Path, name: &str) -> Result<Option<Source>, Failure> {
    let path = folder.join(name);
    match fs::read(&path) {
        Ok(bytes) => Ok(Some(source_of_bytes(&path.to_string_lossy(), &bytes).0)),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(e) => Err(Failure::Usage(format!("{}: {e}", path.display()))),
    }
}

fn told(faults: &[Diagnostic], source: &Source) -> Failure {
    terminal::tell(faults, source);
    Failure::Faults(Some(format!("{} cannot be used", source.name)))
}

/// The inventories with the folders' rows.
pub(super) fn grammar(sources: &Sources) -> Result<Grammar, Failure> {
    let mut grammar = Grammar::builtin();
    for folder in folders("grammar", &sources.grammar)? {
        if let Some(source) = table(&folder, "handshapes.ron")? {
            let own: Result<_, Vec<Diagnostic>> = grammar.handshapes.overridden(&source);
            grammar.handshapes = own.map_err(|faults| told(&faults, &source))?;
        }
        if let Some(source) = table(&folder, "locations.ron")? {
            let own = LocationInventory::from_source(&source).map_err(|faults| told(&faults, &source))?;
            let joined = grammar.locations.overridden_by(&own);
            grammar.locations =
                joined.map_err(|all| Failure::Faults(Some(format!("{}: {}", source.name, all.join("; ")))))?;
        }
        if let Some(source) = table(&folder, "nonmanuals.ron")? {
            let own = Expressions::read(&source).map_err(|fault| told(&[fault], &source))?;
            grammar.expressions = grammar.expressions.overridden_by(own);
        }
        if let Some(source) = table(&folder, "movements.ron")? {
            grammar.movements = MovementTable::read(&source).map_err(|fault| told(&[fault], &source))?;
        }
    }
    Ok(grammar)
}

/// What readers and writers look names up in.
pub(super) fn words(grammar: &Grammar) -> Words {
    Words::of(&grammar.handshapes, &grammar.locations, &grammar.expressions)
}

/// The program's signs with the folders' signs. Faults of the folders are told, and the sound signs used.
pub(super) fn lexicon(sources: &Sources, words: &Words) -> Result<Lexicon, Failure> {
    with_texts(sources, words, Vec::new()).map(|(lexicon, _)| lexicon)
}

/// The lexicon with texts above it, and what is to be said of these texts. Signs that are made from others are made.
fn with_texts(
    sources: &Sources,
    words: &Words,
    above: Vec<(Source, AnyReading)>,
) -> Result<(Lexicon, Vec<Checked>), Failure> {
    let mut lexicon = Lexicon::default();
    let mut known = lexicon.add(embedded(), &words.vocabulary);
    for folder in folders("lexicon", &sources.lexicon)? {
        let texts = read_folder(&folder, &Notation::ALL)?;
        for text in &texts {
            terminal::tell(text.fault.as_slice(), &text.source);
        }
        let readings = readings(&texts, words);
        known.extend(lexicon.add_read(texts.into_iter().map(|text| text.source).zip(readings)));
    }
    let mut checked = if above.is_empty() { Vec::new() } else { lexicon.add_read(above) };
    let grammar = grammar(sources)?;
    // Of two texts of one name, the one above is told of.
    let below = checked.len();
    checked.append(&mut known);
    lexicon.link(&Tables { locations: &grammar.locations, movements: &grammar.movements }, &mut checked);
    let known = checked.split_off(below);
    // A folder's files that are checked themselves are told of once.
    let own: BTreeSet<&str> = checked.iter().map(|above| above.source.name.as_str()).collect();
    tell_faults(known.iter().filter(|c| !own.contains(c.source.name.as_str())));
    Ok((lexicon, checked))
}

fn tell_faults<'c>(checked: impl Iterator<Item = &'c Checked>) {
    for text in checked {
        let faults: Vec<Diagnostic> =
            text.diagnostics.iter().filter(|d| d.severity == Severity::Fault).cloned().collect();
        terminal::tell(&faults, &text.source);
    }
}

/// The texts as they are read, on all cores, in their order.
fn readings(texts: &[Text], words: &Words) -> Vec<AnyReading> {
    let one = |text: &Text| read_any(&text.source, text.notation, words, language_of_path(&text.source.name));
    texts.par_iter().map(one).collect()
}

/// A sign of a text, and what it is made from where it is made from others.
pub(super) struct Described {
    /// The sign.
    pub sign: Sign,
    /// What it is made from.
    pub from: Option<Recombination>,
    /// The number of its text.
    pub text: usize,
    /// Where it stands there.
    pub span: Span,
}

/// A text with what there is to say of it.
pub(super) struct Checkup {
    /// The text.
    pub text: Text,
    /// Its faults and warnings, by their place.
    pub diagnostics: Vec<Diagnostic>,
    /// How many of its signs are left out.
    pub refused: usize,
}

impl Checkup {
    /// Whether it has a fault.
    pub(super) fn has_faults(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Fault)
    }
}

/// Texts that were read: what there is to say of them, and their signs in their order.
pub(super) struct Texts {
    /// The texts.
    pub checkups: Vec<Checkup>,
    /// The signs that can be used.
    pub signs: Vec<Described>,
}

/// When names are looked up in the lexicon, and compared with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Linking {
    /// Always: a name that stands twice is a fault.
    Always,
    /// Where a sign is made from others.
    WhereNeeded,
}

/// Reads the signs of texts. Signs made from others find those of the texts first, then the lexicon's.
pub(super) fn read_texts(
    sources: &Sources,
    words: &Words,
    texts: Vec<Text>,
    linking: Linking,
) -> Result<Texts, Failure> {
    let mut readings = readings(&texts, words);
    let mut checkups: Vec<Checkup> = Vec::with_capacity(texts.len());
    let mut signs = Vec::new();
    // The .sign texts whose names are looked up, with how many signs each one begins.
    let (mut linked, mut above) = (Vec::new(), Vec::new());
    let derives = readings.iter().any(|r| !r.derived.is_empty());
    for (number, (text, reading)) in texts.into_iter().zip(readings.drain(..)).enumerate() {
        let links = reading.notation == Notation::Sign && (linking == Linking::Always || derives);
        let mut checkup = Checkup { diagnostics: text.fault.iter().cloned().collect(), refused: reading.refused, text };
        if links {
            linked.push((number, reading.refused + reading.signs.len() + reading.derived.len()));
            above.push((checkup.text.source.clone(), reading));
        } else {
            checkup.diagnostics.extend(reading.diagnostics);
            let own = reading.signs.into_iter();
            signs.extend(own.map(|l| Described { sign: l.sign, from: None, text: number, span: l.name_span }));
        }
        checkups.push(checkup);
    }
    if !above.is_empty() {
        let (lexicon, checked) = with_texts(sources, words, above)?;
        let mut own: BTreeMap<&str, Vec<&Entry>> = BTreeMap::new();
        for entry in lexicon.entries().filter(|entry| entry.layer + 1 == lexicon.layers()) {
            own.entry(entry.path.as_str()).or_default().push(entry);
        }
        for ((number, begun), checked) in linked.into_iter().zip(checked) {
            let checkup = &mut checkups[number];
            checkup.refused = begun.saturating_sub(checked.signs);
            checkup.diagnostics.extend(checked.diagnostics);
            let entries = own.remove(checked.source.name.as_str()).unwrap_or_default();
            signs.extend(entries.into_iter().map(|e| Described {
                sign: e.sign.clone(),
                from: e.derived.clone(),
                text: number,
                span: e.span(),
            }));
        }
    }
    checkups.iter_mut().for_each(|checkup| checkup.diagnostics.sort_by_key(|d| d.span.start));
    signs.sort_by_key(|described| (described.text, described.span.start));
    Ok(Texts { checkups, signs })
}

/// The signs of texts, as [`read_texts`] finds them, with faults and warnings told.
pub(super) fn described(sources: &Sources, words: &Words, texts: Vec<Text>) -> Result<Texts, Failure> {
    let read = read_texts(sources, words, texts, Linking::WhereNeeded)?;
    for checkup in &read.checkups {
        terminal::tell(&checkup.diagnostics, &checkup.text.source);
    }
    Ok(read)
}
