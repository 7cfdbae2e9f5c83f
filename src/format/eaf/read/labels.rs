//! The text of an annotation: as it stands, or that of the entry of a vocabulary that it refers to.

use super::annotations::{Annotation, RawTier};
use crate::diagnostics::Diagnostic;
use crate::diagnostics::xml::short;
use crate::format::eaf::{ControlledVocabulary, Entry, TierType};
use crate::format::told::Told;
use std::collections::HashMap;

/// The vocabularies of each type, their entries by id.
pub(super) struct Labels<'a> {
    of_type: Vec<Option<usize>>,
    all: &'a [ControlledVocabulary],
    entries: Vec<HashMap<&'a str, &'a Entry>>,
}

impl<'a> Labels<'a> {
    pub fn new(types: &[TierType], all: &'a [ControlledVocabulary]) -> Labels<'a> {
        let places: HashMap<&str, usize> = all.iter().enumerate().map(|(i, v)| (v.id.as_str(), i)).collect();
        let of_type = types.iter().map(|t| places.get(t.vocabulary.as_deref()?).copied()).collect();
        let by_id = |v: &'a ControlledVocabulary| {
            // From the back, so that the first of two with one id counts.
            v.entries.iter().rev().filter_map(|e| Some((e.id.as_deref()?, e))).collect()
        };
        Labels { of_type, all, entries: all.iter().map(by_id).collect() }
    }

    /// An annotation's label. What is written wins over the vocabulary, which may have changed since.
    pub fn label(&self, tier: &RawTier<'_>, annotation: &Annotation<'_>, told: &mut Told) -> String {
        let written = annotation.text.clone();
        let Some((id, span)) = annotation.entry else { return written };
        let Some(at) = tier.tier_type.and_then(|t| self.of_type[t]) else { return written };
        let Some(entry) = self.entries[at].get(id) else {
            if written.is_empty() || !self.all[at].entries.is_empty() {
                let message = format!("the vocabulary `{}` has no entry `{}`", short(&self.all[at].id), short(id));
                let warning = Diagnostic::warning(span, message).label("the text stands as it is written");
                told.say(match (&self.all[at].external, self.all[at].entries.is_empty()) {
                    (Some(url), true) => warning.hint(format!("it is kept in {}, which was not given", short(url))),
                    _ => warning,
                });
            }
            return written;
        };
        if written.is_empty() {
            let language = tier.node.attribute("LANG_REF");
            let own = entry.values.iter().find(|v| language.is_some() && v.language.as_deref() == language);
            return own.or(entry.values.first()).map(|v| v.text.clone()).unwrap_or_default();
        }
        if !entry.values.iter().any(|v| v.text == written) {
            let theirs = entry.values.first().map_or("", |v| &v.text);
            let message = format!("`{}` refers to the entry `{}`", short(&written), short(theirs));
            told.say(Diagnostic::warning(span, message).label("the text stands as it is written"));
        }
        written
    }
}
