//! The names that are known: the program's own inventories and signs, and those of the user's folders.

use super::files::{Text, collect};
use super::{Failure, Sources, terminal};
use crate::diagnostics::{Diagnostic, Severity, Source};
use crate::notation::lexicon::{Checked, embedded, language_of_path};
use crate::notation::{Lexicon, Reading, Vocabulary, read, source_of_bytes};
use crate::phonology::expression::Expressions;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::operator::Tables;
use crate::phonology::recombination::Recombination;
use crate::phonology::{LocationInventory, Sign};
use crate::synthesis::Grammar;
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

/// The names of the inventories.
pub(super) fn vocabulary(sources: &Sources) -> Result<Vocabulary, Failure> {
    let grammar = grammar(sources)?;
    Ok(Vocabulary::of(&grammar.handshapes, &grammar.locations, &grammar.expressions))
}

/// The program's signs with the folders' signs. Faults of the folders are told, and the sound signs used.
pub(super) fn lexicon(sources: &Sources, vocabulary: &Vocabulary) -> Result<Lexicon, Failure> {
    with_texts(sources, vocabulary, Vec::new()).map(|(lexicon, _)| lexicon)
}

/// The lexicon with texts above it, and what is to be said of these texts. Signs that are made from others are made.
pub(super) fn with_texts(
    sources: &Sources,
    vocabulary: &Vocabulary,
    above: Vec<Source>,
) -> Result<(Lexicon, Vec<Checked>), Failure> {
    let mut lexicon = Lexicon::default();
    let mut known = lexicon.add(embedded(), vocabulary);
    for folder in folders("lexicon", &sources.lexicon)? {
        let mut files = Vec::new();
        collect(&folder, 0, &mut files)?;
        let mut texts = Vec::new();
        for file in files {
            let bytes = fs::read(&file).map_err(|e| Failure::Usage(format!("{}: {e}", file.display())))?;
            let (source, fault) = source_of_bytes(&file.to_string_lossy(), &bytes);
            terminal::tell(fault.as_slice(), &source);
            texts.push(source);
        }
        known.extend(lexicon.add(texts, vocabulary));
    }
    let mut checked = if above.is_empty() { Vec::new() } else { lexicon.add(above, vocabulary) };
    let grammar = grammar(sources)?;
    // Of two texts of one name, the one above is told of.
    let below = checked.len();
    checked.append(&mut known);
    lexicon.link(&Tables { locations: &grammar.locations, movements: &grammar.movements }, &mut checked);
    let known = checked.split_off(below);
    // A folder's files that are checked themselves are told of once.
    let again = |c: &&Checked| checked.iter().any(|above| above.source.name == c.source.name);
    tell_faults(known.iter().filter(|c| !again(c)));
    Ok((lexicon, checked))
}

fn tell_faults<'c>(checked: impl Iterator<Item = &'c Checked>) {
    for text in checked {
        let faults: Vec<Diagnostic> =
            text.diagnostics.iter().filter(|d| d.severity == Severity::Fault).cloned().collect();
        terminal::tell(&faults, &text.source);
    }
}

/// A sign of a text, and what it is made from where it is made from others.
pub(super) struct Described {
    pub sign: Sign,
    pub from: Option<Recombination>,
}

/// The signs of texts, in their order, and whether a text has a fault. Faults and warnings are told. Signs made from others find
/// those of the texts first, then the lexicon's.
pub(super) fn described(
    sources: &Sources,
    vocabulary: &Vocabulary,
    texts: Vec<Text>,
) -> Result<(Vec<Described>, bool), Failure> {
    let readings: Vec<Reading> =
        texts.iter().map(|t| read(&t.source.text, vocabulary, language_of_path(&t.source.name))).collect();
    let derives = readings.iter().any(|r| !r.derived.is_empty());
    let (mut all, mut faulty) = (Vec::new(), false);
    let mut tell = |mut diagnostics: Vec<Diagnostic>, text: &Text| {
        diagnostics.extend(text.fault.clone());
        terminal::tell(&diagnostics, &text.source);
        faulty |= diagnostics.iter().any(|d| d.severity == Severity::Fault);
    };
    if !derives {
        for (reading, text) in readings.into_iter().zip(&texts) {
            tell(reading.diagnostics, text);
            all.extend(reading.signs.into_iter().map(|s| Described { sign: s.sign, from: None }));
        }
        return Ok((all, faulty));
    }
    let above = texts.iter().map(|t| t.source.clone()).collect();
    let (lexicon, checked) = with_texts(sources, vocabulary, above)?;
    for (checked, text) in checked.into_iter().zip(&texts) {
        tell(checked.diagnostics, text);
        let mut own: Vec<_> = lexicon.entries().filter(|e| e.path == text.source.name).collect();
        own.sort_by_key(|e| e.line);
        all.extend(own.into_iter().map(|e| Described { sign: e.sign.clone(), from: e.derived.clone() }));
    }
    Ok((all, faulty))
}
