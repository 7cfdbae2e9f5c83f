//! Controlled vocabularies: as up to 2.7 (a text an entry), as from 2.8 on (a text a language), and kept elsewhere.

use super::element::{Node, attribute, named, optional, owned, required, text};
use super::head::twice;
use crate::diagnostics::xml::{short, tag_span};
use crate::diagnostics::{Diagnostic, Span};
use crate::format::eaf::{ControlledVocabulary, Entry, EntryValue};
use crate::format::told::Told;
use std::collections::{BTreeMap, BTreeSet};

/// The vocabularies of a file; `external` is where references lead.
pub(super) fn vocabularies(
    root: Node<'_>,
    external: &BTreeMap<&str, &str>,
    told: &mut Told,
) -> Vec<ControlledVocabulary> {
    let mut all = Vec::new();
    let mut taken = BTreeSet::new();
    for node in named(root, "CONTROLLED_VOCABULARY") {
        let Some((id, span)) = required(node, "CV_ID", told) else { continue };
        if !taken.insert(id) {
            told.say(twice("vocabulary", id, span));
            continue;
        }
        let url = attribute(node, "EXT_REF").and_then(|(name, span)| {
            let found = external.get(name);
            if found.is_none() {
                let message = format!("there is no EXTERNAL_REF `{}`", short(name));
                told.say(Diagnostic::warning(span, message).label("so the vocabulary stays empty"));
            }
            found.map(|url| (*url).to_owned())
        });
        all.push(ControlledVocabulary {
            id: id.to_owned(),
            description: description(node),
            entries: entries(node, told),
            external: url,
        });
    }
    all
}

fn description(node: Node<'_>) -> String {
    let nested = || named(node, "DESCRIPTION").map(text).find(|said| !said.trim().is_empty());
    optional(node, "DESCRIPTION").or_else(nested).unwrap_or_default()
}

fn entries(vocabulary: Node<'_>, told: &mut Told) -> Vec<Entry> {
    let mut taken = BTreeSet::new();
    let mut entries = Vec::new();
    for node in vocabulary.children().filter(Node::is_element) {
        let values: Vec<EntryValue> = match node.tag_name().name() {
            "CV_ENTRY" => vec![value(node)],
            "CV_ENTRY_ML" => named(node, "CVE_VALUE").map(value).collect(),
            _ => continue,
        };
        if values.is_empty() {
            told.say(Diagnostic::warning(tag_span(node), "an entry without a CVE_VALUE").label("left out"));
            continue;
        }
        if let Some((id, span)) = attribute(node, "CVE_ID").filter(|(id, _)| !taken.insert(*id)) {
            let message = format!("two entries of this vocabulary have the id `{}`", short(id));
            told.say(Diagnostic::warning(span, message).label("the first one counts"));
        }
        entries.push(Entry { id: optional(node, "CVE_ID"), values });
    }
    entries
}

fn value(node: Node<'_>) -> EntryValue {
    EntryValue { language: optional(node, "LANG_REF"), text: text(node), description: owned(node, "DESCRIPTION") }
}

/// Fills the vocabularies that are kept elsewhere, as far as `find` has them.
pub(super) fn resolve(
    root: Node<'_>,
    all: &mut [ControlledVocabulary],
    mut find: impl FnMut(&str) -> Option<Vec<ControlledVocabulary>>,
    told: &mut Told,
) {
    let here: BTreeMap<&str, Span> =
        named(root, "CONTROLLED_VOCABULARY").filter_map(|node| attribute(node, "CV_ID")).collect();
    let mut found: BTreeMap<String, Option<BTreeMap<String, ControlledVocabulary>>> = BTreeMap::new();
    for vocabulary in all {
        let Some(url) = &vocabulary.external else { continue };
        let by_id = |all: Vec<ControlledVocabulary>| all.into_iter().map(|v| (v.id.clone(), v)).collect();
        let Some(theirs) = found.entry(url.clone()).or_insert_with(|| find(url).map(by_id)) else { continue };
        if let Some(same) = theirs.get(&vocabulary.id) {
            vocabulary.entries.clone_from(&same.entries);
            if vocabulary.description.is_empty() {
                vocabulary.description.clone_from(&same.description);
            }
            continue;
        }
        let span = here.get(vocabulary.id.as_str()).copied().unwrap_or(tag_span(root));
        let message = format!("{} has no vocabulary `{}`", short(url), short(&vocabulary.id));
        let warning = Diagnostic::warning(span, message).label("so it stays empty");
        let theirs: Vec<String> = theirs.keys().take(5).map(|id| format!("`{}`", short(id))).collect();
        told.say(match theirs.is_empty() {
            true => warning,
            false => warning.hint(format!("it has {}", theirs.join(", "))),
        });
    }
}
