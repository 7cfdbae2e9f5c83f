//! Words spelled with the letters of a language's manual alphabet, each letter held.

use super::line::Line;
use super::signed::told;
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::suggest::fold;
use crate::phonology::Sign;
use crate::phonology::operator::{Spelling, spelled};
use std::collections::BTreeSet;

/// The sign of a word; white space, hyphens and apostrophes are no letters. Letters with accents are spelled by those
/// without where the alphabet has only them, with a warning.
pub(super) fn word(line: &mut Line, word: &str, span: Span) -> Option<Sign> {
    let settings = line.lookup.settings;
    let language = settings.alphabet.as_deref().unwrap_or(line.lookup.language);
    let lexicon = line.lookup.lexicon;
    if lexicon.letters(language).next().is_none() {
        let known: BTreeSet<&str> =
            lexicon.entries().filter(|e| e.is_letter).map(|e| e.sign.language.as_str()).collect();
        let known: Vec<&str> = known.into_iter().collect();
        let fault = if language.is_empty() {
            Diagnostic::fault(span, format!("with which alphabet is `{word}` spelled?"))
                .label("the language of the line is not known")
        } else {
            Diagnostic::fault(span, format!("there is no alphabet of `{language}`")).label("spelled with it")
        };
        line.diagnostics.push(fault.hint(format!("say the language of the line: {}", known.join(", "))));
        return None;
    }
    let mut letters = Vec::new();
    let (mut folded, mut lacking) = (BTreeSet::new(), BTreeSet::new());
    for c in word.chars().filter(|c| !c.is_whitespace() && !"-'’‐".contains(*c)) {
        let plain = fold(&c.to_string());
        let own = lexicon.letter(&c.to_string(), language);
        match own.or_else(|| lexicon.letter(&plain, language)) {
            Some(entry) => {
                letters.push(entry.sign.clone());
                if own.is_none() {
                    folded.insert(format!("{c} as {}", entry.sign.name));
                }
            }
            None => {
                lacking.insert(c);
            }
        }
    }
    if !lacking.is_empty() {
        let all: Vec<String> = lacking.into_iter().map(|c| format!("`{c}`")).collect();
        line.diagnostics.push(
            Diagnostic::fault(span, format!("the alphabet of `{language}` has no {}", all.join(", ")))
                .label("in this word")
                .hint(format!("`chereme list --language {language}` shows its letters")),
        );
        return None;
    }
    if !folded.is_empty() {
        let all: Vec<String> = folded.into_iter().collect();
        line.diagnostics.push(
            Diagnostic::warning(span, format!("spelled without accents: {}", all.join(", "))).label("in this word"),
        );
    }
    let sign = told(line, span, spelled(&letters, Spelling::Held))?;
    Some(Sign { name: word.to_owned(), ..sign })
}
