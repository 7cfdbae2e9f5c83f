//! From the bytes of an EAF file to what it says, or to all that is wrong with it.

mod annotations;
mod element;
mod head;
mod labels;
mod times;
mod vocabularies;

use super::data::{AnnotatedTier, ControlledVocabulary, Eaf};
use crate::diagnostics::Diagnostic;
use crate::diagnostics::xml::{Xml, short, tag_span};
use crate::format::text;
use crate::format::told::Told;
use crate::tier::Tier;
use annotations::{Annotations, RawTier};
use element::{Node, named, optional, owned};
use labels::Labels;
use std::collections::BTreeMap;

/// The elements of an EAF file nest six deep; a day of annotation takes some 25 MB.
const EAF: Xml = Xml { name: "EAF", most_bytes: 256 << 20, most_deep: 64 };

/// An annotation file that could be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// What it says.
    pub eaf: Eaf,
    /// What is odd about it, by place: annotations without a length, texts that their vocabulary does not have.
    pub warnings: Vec<Diagnostic>,
}

/// Reads an EAF file without the vocabularies that it keeps elsewhere; see [`read_with`].
///
/// # Errors
/// All faults with their places in the text that [`source_of_bytes`](crate::format::text::source_of_bytes) gives.
///
/// ```
/// use chereme::format::eaf;
/// let file = r#"<ANNOTATION_DOCUMENT AUTHOR="" DATE="" VERSION="3.0">
///   <HEADER TIME_UNITS="milliseconds"/>
///   <TIME_ORDER><TIME_SLOT TIME_SLOT_ID="ts1" TIME_VALUE="300"/><TIME_SLOT TIME_SLOT_ID="ts2" TIME_VALUE="1200"/></TIME_ORDER>
///   <TIER TIER_ID="Gloss" LINGUISTIC_TYPE_REF="gloss"><ANNOTATION>
///     <ALIGNABLE_ANNOTATION ANNOTATION_ID="a1" TIME_SLOT_REF1="ts1" TIME_SLOT_REF2="ts2"><ANNOTATION_VALUE>BOL</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION>
///   </ANNOTATION></TIER>
///   <LINGUISTIC_TYPE LINGUISTIC_TYPE_ID="gloss" TIME_ALIGNABLE="true"/>
/// </ANNOTATION_DOCUMENT>"#;
/// let reading = eaf::read(file.as_bytes()).unwrap();
/// let value = &reading.eaf.tiers[0].tier.values()[0];
/// assert_eq!((value.label.as_str(), value.source.as_str(), value.end.0), ("BOL", "a1", 1.2));
/// let faults = eaf::read(file.replace("REF2=\"ts2\"", "REF2=\"ts3\"").as_bytes()).unwrap_err();
/// assert_eq!(faults[0].message, "there is no time slot `ts3`");
/// ```
pub fn read(bytes: &[u8]) -> Result<Reading, Vec<Diagnostic>> {
    read_with(bytes, |_| None)
}

/// Reads an EAF file, of any version from 2.3 to 3.0 and any stereotypes; `resolve` gives the vocabularies of an
/// external file (an `.ecv`, see [`ecv::read`](super::ecv::read)) by its URL as written, and is asked once a URL.
///
/// Annotations that refer to others take their times from these: associations the same, symbolic subdivisions an even
/// share in the order of their `PREVIOUS_ANNOTATION`. Time slots without a value lie evenly between their neighbours on
/// the tier, as ELAN proposes them (whole milliseconds, the step rounded down).
///
/// # Errors
/// All faults, the first hundred of them with their places: what is no well-formed XML or no EAF, names that nobody
/// defines or two define, references in a circle, annotations that end before they begin.
///
/// ```
/// use chereme::format::eaf;
/// let file = eaf::write(&[chereme::tier::Tier::new("Brows")], &eaf::Document::default()).unwrap();
/// let reading = eaf::read_with(file.as_bytes(), |url| panic!("no vocabulary is kept at {url}")).unwrap();
/// assert_eq!(reading.eaf.tiers[0].tier.name, "Brows");
/// ```
pub fn read_with(
    bytes: &[u8],
    resolve: impl FnMut(&str) -> Option<Vec<ControlledVocabulary>>,
) -> Result<Reading, Vec<Diagnostic>> {
    let (text, note) = text::decode(bytes);
    let mut told = Told::default();
    note.into_iter().for_each(|note| told.say(note));
    let document = match EAF.parse(&text) {
        Ok(document) => document,
        Err(fault) => {
            told.say(fault);
            return Err(told.finish());
        }
    };
    let eaf = file(document.root_element(), resolve, &mut told);
    told.judge(eaf).map(|(eaf, warnings)| Reading { eaf, warnings })
}

/// The vocabularies of an `.ecv` file and the warnings about them.
pub(super) fn external(bytes: &[u8]) -> Result<(Vec<ControlledVocabulary>, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (text, note) = text::decode(bytes);
    let mut told = Told::default();
    note.into_iter().for_each(|note| told.say(note));
    let document = match (Xml { name: "ECV", ..EAF }).parse(&text) {
        Ok(document) => document,
        Err(fault) => {
            told.say(fault);
            return Err(told.finish());
        }
    };
    let root = document.root_element();
    is_root(root, "CV_RESOURCE", "an ECV file", &mut told);
    let read = vocabularies::vocabularies(root, &BTreeMap::new(), &mut told);
    told.judge(read)
}

fn is_root(root: Node<'_>, expected: &str, what: &str, told: &mut Told) -> bool {
    let name = root.tag_name().name();
    if name != expected {
        let fault = Diagnostic::fault(tag_span(root), format!("`{}` is not the beginning of {what}", short(name)));
        told.say(fault.label(format!("expected `{expected}`")).hint(match name {
            "CV_RESOURCE" => "this is an external vocabulary (.ecv), not annotations",
            "ANNOTATION_DOCUMENT" => "these are annotations (.eaf), not a vocabulary",
            _ => "save the file from ELAN as .eaf, or export the vocabulary as .ecv",
        }));
    }
    name == expected
}

fn file(root: Node<'_>, resolve: impl FnMut(&str) -> Option<Vec<ControlledVocabulary>>, told: &mut Told) -> Eaf {
    if !is_root(root, "ANNOTATION_DOCUMENT", "an EAF file", told) {
        return Eaf::default();
    }
    let version = optional(root, "FORMAT").or(optional(root, "VERSION")).unwrap_or_default();
    head::check_version(root, &version, told);
    let unit = head::unit(root, told);
    let external = head::external_references(root);
    let types = head::types(root, told);
    let mut vocabularies = vocabularies::vocabularies(root, &external, told);
    vocabularies::resolve(root, &mut vocabularies, resolve, told);

    let mut slots = times::Slots::read(root, told);
    let tiers = annotations::tiers(root, &types, told);
    let annotations = Annotations::read(&tiers, &slots, told);
    let times = times::times(&tiers, &annotations, &mut slots, told);
    let labels = Labels::new(&types, &vocabularies);
    let read = tiers.iter().enumerate().map(|(at, raw)| {
        let mut values: Vec<_> = annotations.of(at).filter_map(|i| Some((times[i]?, i))).collect();
        values.sort_by_key(|&((begin, _), _)| begin);
        let mut tier = Tier::new(raw.name);
        for ((begin, end), i) in values {
            let annotation = annotations.get(i);
            tier.push(unit.seconds(begin), unit.seconds(end), labels.label(raw, annotation, told), annotation.id);
        }
        described(raw, tier, &types)
    });
    Eaf {
        tiers: read.collect(),
        version,
        author: owned(root, "AUTHOR"),
        date: owned(root, "DATE"),
        media: head::media(root, told),
        properties: head::properties(root),
        languages: head::languages(root),
        types,
        vocabularies,
    }
}

fn described(raw: &RawTier<'_>, tier: Tier, types: &[super::TierType]) -> AnnotatedTier {
    let of_type = raw.tier_type.and_then(|at| types.get(at));
    AnnotatedTier {
        tier,
        parent: raw.parent.map(|(name, _)| name.to_owned()),
        tier_type: owned(raw.node, "LINGUISTIC_TYPE_REF"),
        stereotype: of_type.and_then(|t| t.stereotype),
        participant: owned(raw.node, "PARTICIPANT"),
        annotator: owned(raw.node, "ANNOTATOR"),
        language: optional(raw.node, "LANG_REF"),
    }
}

/// All elements of a name below the header.
fn in_header<'a>(root: Node<'a>, name: &'static str) -> impl Iterator<Item = Node<'a>> {
    named(root, "HEADER").flat_map(move |header| named(header, name))
}
