//! The names that are known: the program's own inventories and signs, and those of the user's folders.

use super::files::collect;
use super::{Failure, Sources, terminal};
use crate::diagnostics::{Diagnostic, Severity, Source};
use crate::notation::lexicon::{Checked, embedded};
use crate::notation::{Lexicon, Vocabulary, source_of_bytes};
use crate::phonology::LocationInventory;
use crate::phonology::expression::Expressions;
use crate::phonology::movement_table::MovementTable;
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
    let mut lexicon = Lexicon::default();
    tell_faults(&lexicon.add(embedded(), vocabulary));
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
        tell_faults(&lexicon.add(texts, vocabulary));
    }
    Ok(lexicon)
}

fn tell_faults(checked: &[Checked]) {
    for text in checked {
        let faults: Vec<Diagnostic> =
            text.diagnostics.iter().filter(|d| d.severity == Severity::Fault).cloned().collect();
        terminal::tell(&faults, &text.source);
    }
}
