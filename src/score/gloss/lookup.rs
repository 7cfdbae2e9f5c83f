//! Names of a line looked up: signs in the line's language first.

use super::Settings;
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::gloss::syntax::{GlossLine, Head, Item, What};
use crate::notation::lexicon::Entry;
use crate::notation::suggest::nearest;
use crate::notation::{Lexicon, gloss};
use std::collections::{BTreeMap, BTreeSet};

/// Where names are looked up.
pub(super) struct Lookup<'l> {
    pub lexicon: &'l Lexicon,
    /// The line's language; empty where none could be told.
    pub language: &'l str,
    pub settings: &'l Settings,
}

impl<'l> Lookup<'l> {
    /// The sign of a gloss; `None` where there is none.
    ///
    /// # Errors
    /// Several languages have one, and the line is in none of them.
    pub(super) fn sign(&self, name: &str, span: Span) -> Result<Option<&'l Entry>, Diagnostic> {
        let hits: Vec<&Entry> = self.lexicon.of_name(name).collect();
        let own = hits.iter().find(|e| e.sign.language.eq_ignore_ascii_case(self.language));
        match (own, hits.as_slice()) {
            (Some(own), _) => Ok(Some(own)),
            (None, []) => Ok(None),
            (None, [one]) => Ok(Some(one)),
            (None, several) => {
                let all: Vec<&str> = several.iter().map(|e| e.sign.language.as_str()).collect();
                Err(Diagnostic::fault(span, format!("`{name}` is a sign of several languages"))
                    .label("of which one?")
                    .hint(format!("say the language of the line: {}", all.join(", "))))
            }
        }
    }

    /// The fault of a gloss that no language knows.
    pub(super) fn unknown(&self, name: &str, span: Span) -> Diagnostic {
        let fault = Diagnostic::fault(span, format!("there is no sign `{name}`")).label("unknown gloss");
        let bare = name.trim_end_matches(['?', '!', ';', '…']);
        if bare != name && self.lexicon.of_name(bare).next().is_some() {
            return fault.hint(format!("write `{bare}`; what a question or an exclamation looks like is in the face: `{{brows raised: {bare}}}`"));
        }
        let names = |own: bool| {
            let entries = self.lexicon.entries();
            let own = entries.filter(move |e| !own || e.sign.language.eq_ignore_ascii_case(self.language));
            own.map(|e| e.sign.name.as_str())
        };
        match nearest(name, names(true)).or_else(|| nearest(name, names(false))) {
            Some(near) => fault.hint(format!("did you mean `{near}`?")),
            None => fault.hint(format!("`chereme list` shows the signs; `fs({})` spells it", gloss::print::word(name))),
        }
    }
}

/// The language that knows most of a line's glosses; `None` where none does, or two know as many.
pub(super) fn language(line: &GlossLine, lexicon: &Lexicon) -> Option<String> {
    let mut names = BTreeSet::new();
    glosses(&line.items, &mut names);
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for entry in names.into_iter().flat_map(|name| lexicon.of_name(name)) {
        *counts.entry(entry.sign.language.to_lowercase()).or_default() += 1;
    }
    let most = counts.values().copied().max()?;
    let mut best = counts.into_iter().filter(|(_, n)| *n == most).map(|(language, _)| language);
    best.next().filter(|_| best.next().is_none())
}

fn glosses<'g>(items: &'g [Item], names: &mut BTreeSet<&'g str>) {
    for item in items {
        let signs = match &item.what {
            What::Signed(one) => vec![one],
            What::Together(strong, weak) => vec![strong, weak],
            What::Face(face) => {
                // Braces nest only as deep as the parser lets them.
                glosses(&face.items, names);
                continue;
            }
            What::Pause(_) | What::Hold(..) | What::Rest(_) => continue,
        };
        for signed in signs {
            if let Head::Gloss(name) = &signed.head.value {
                names.insert(name);
            }
        }
    }
}
