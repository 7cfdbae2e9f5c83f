//! ELAN's annotation files (EAF): tiers, to be looked at, searched and corrected where linguists work. [`read()`] takes
//! versions 2.3 to 3.0, with all that they say about tiers; [`write()`] makes 3.0.
//!
//! Source: the schema EAFv3.0.xsd (Max Planck Institute for Psycholinguistics, December 2016), and how ELAN reads it.
//!
//! # Conventions of what is written
//! - Whole milliseconds, rounded once; each annotation has time slots of its own. One value at a time: where two
//!   overlap, the earlier ends as the later begins; an instant lasts 1 ms.
//! - Tiers of a hand whose values lie within its glosses are children of `RH Gloss` or `LH Gloss` ("Included In").
//!   Phase is not one of them: preparation and retraction lie outside the gloss.
//! - Where a value came from stands in a tier of its own under the tier ("Symbolic Association"), after all others;
//!   ELAN searches, sorts and hides such tiers by their type, `Source`.
//! - No media file is named, because ELAN stops at one that it does not find. Link one with Edit, Linked Files.
//! - The date is always the same: the library reads no clock, and equal tracks give equal files. ELAN sets it on saving.
//!
//! Control characters, which XML cannot hold, become U+FFFD.
//!
//! # What is refused
//! Document types, names that nobody defines or that two define, references in a circle, annotations that end before they
//! begin: each with line and column. Memory is in proportion to the text; depth of references costs no stack.

mod data;
pub mod ecv;
mod layout;
mod read;

use crate::diagnostics::Error;
use crate::tier::Tier;
use layout::{Layout, Row, clean, layout};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use std::io;

pub use data::{AnnotatedTier, ControlledVocabulary, Eaf, Entry, EntryValue, Language, Media, Stereotype, TierType};
pub use read::{Reading, read, read_with};

/// What a file says besides its tiers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Who signs; may be empty.
    pub participant: String,
    /// The sign language, as its folder is named; may be empty.
    pub language: String,
    /// The values that ELAN offers for some kinds of tiers; the values that occur are added to them.
    pub vocabularies: Vec<Vocabulary>,
}

/// The values of a kind of tier.
#[derive(Debug, Clone, PartialEq)]
pub struct Vocabulary {
    /// The tier's name without the hand: `Configuration`.
    pub kind: String,
    /// In the order in which they are offered.
    pub values: Vec<String>,
}

const AUTHOR: &str = concat!("chereme ", env!("CARGO_PKG_VERSION"));
const DATE: &str = "1970-01-01T00:00:00Z";
const SCHEMA: &str = "http://www.mpi.nl/tools/elan/EAFv3.0.xsd";
/// The language of vocabularies. Names of EAF share one space; those of slots are ts1, ts2, of annotations a1, a2.
const ENGLISH: [(&str, &str); 3] =
    [("LANG_ID", "eng"), ("LANG_DEF", "http://cdb.iso.org/lg/CDB-00138502-001"), ("LANG_LABEL", "English (eng)")];
const INCLUDED: &str = "Included_In";
const ASSOCIATED: &str = "Symbolic_Association";

type Xml = Writer<Vec<u8>>;

/// An EAF file of tiers, UTF-8.
///
/// # Errors
/// None that a track can cause: those of writing to memory.
///
/// ```
/// use chereme::{format::eaf, tier::Tier, time::Seconds};
/// let mut tier = Tier::new("RH Gloss");
/// tier.push(Seconds(0.3), Seconds(1.2), "BOL", "description");
/// let file = eaf::write(&[tier], &eaf::Document::default()).unwrap();
/// assert!(file.contains("TIME_VALUE=\"1200\"") && file.contains("<ANNOTATION_VALUE>BOL</ANNOTATION_VALUE>"));
/// ```
pub fn write(tiers: &[Tier], document: &Document) -> Result<String, Error> {
    let layout = layout(tiers, &document.vocabularies);
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    let bytes = whole(&mut xml, &layout, document).map(|()| xml.into_inner());
    let bytes = bytes.map_err(|e| Error::new(e.to_string()).context("writing EAF"))?;
    String::from_utf8(bytes).map(|text| text + "\n").map_err(|e| Error::new(e.to_string()).context("writing EAF"))
}

fn whole(xml: &mut Xml, layout: &Layout, document: &Document) -> io::Result<()> {
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let root = xml.create_element("ANNOTATION_DOCUMENT").with_attributes([
        ("AUTHOR", AUTHOR),
        ("DATE", DATE),
        ("FORMAT", "3.0"),
        ("VERSION", "3.0"),
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xsi:noNamespaceSchemaLocation", SCHEMA),
    ]);
    root.write_inner_content(|xml| {
        head(xml, layout)?;
        tiers(xml, layout, document)?;
        types(xml, layout)?;
        languages(xml, document)?;
        for stereotype in [
            (INCLUDED, "Time alignable annotations within the parent annotation's time interval, gaps are allowed"),
            (ASSOCIATED, "1-1 association with a parent annotation"),
        ] {
            let attributes = [("STEREOTYPE", stereotype.0), ("DESCRIPTION", stereotype.1)];
            xml.create_element("CONSTRAINT").with_attributes(attributes).write_empty()?;
        }
        vocabularies(xml, layout)
    })?;
    Ok(())
}

fn head(xml: &mut Xml, layout: &Layout) -> io::Result<()> {
    // ELAN gives its next annotation the number after this one.
    let written = layout.rows.iter().map(|r| r.annotations.len() * if r.sources.is_some() { 2 } else { 1 });
    let last = written.sum::<usize>().to_string();
    xml.create_element("HEADER").with_attribute(("TIME_UNITS", "milliseconds")).write_inner_content(|xml| {
        let property = xml.create_element("PROPERTY").with_attribute(("NAME", "lastUsedAnnotationId"));
        property.write_text_content(BytesText::new(&last)).map(|_| ())
    })?;
    xml.create_element("TIME_ORDER").write_inner_content(|xml| {
        for (i, time) in layout.slots.iter().enumerate() {
            let (id, time) = (slot(i), time.to_string());
            let attributes = [("TIME_SLOT_ID", id.as_str()), ("TIME_VALUE", &time)];
            xml.create_element("TIME_SLOT").with_attributes(attributes).write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn slot(i: usize) -> String {
    format!("ts{}", i + 1)
}

/// The tiers, then the tiers of their sources.
fn tiers(xml: &mut Xml, layout: &Layout, document: &Document) -> io::Result<()> {
    let participant = clean(&document.participant);
    let language = language(document);
    let tier = |name, kind, parent: Option<&str>| {
        let all = [
            ("ANNOTATOR", Some(AUTHOR)),
            ("LANG_REF", language.as_deref().filter(|_| kind == layout::GLOSS)),
            ("LINGUISTIC_TYPE_REF", Some(kind)),
            ("PARENT_REF", parent),
            ("PARTICIPANT", Some(&*participant).filter(|p| !p.is_empty())),
            ("TIER_ID", Some(name)),
        ];
        all.into_iter().filter_map(|(key, value)| Some((key, value?.to_owned()))).collect::<Vec<_>>()
    };
    let mut annotations = (1..).map(|n| format!("a{n}"));
    let mut with_sources: Vec<(&Row, &str, Vec<String>)> = Vec::new();
    for row in &layout.rows {
        let kind = &layout.kinds[row.kind];
        let attributes = tier(&row.name, &kind.name, row.parent.as_deref());
        let ids: Vec<String> = annotations.by_ref().take(row.annotations.len()).collect();
        element(xml, "TIER", &attributes).write_inner_content(|xml| {
            for (annotation, id) in row.annotations.iter().zip(&ids) {
                let number = kind.vocabulary.as_ref().and_then(|v| v.number(&annotation.label));
                let mut attributes = vec![
                    ("ANNOTATION_ID", id.clone()),
                    ("TIME_SLOT_REF1", slot(annotation.begin)),
                    ("TIME_SLOT_REF2", slot(annotation.end)),
                ];
                attributes.extend(number.map(|n| ("CVE_REF", entry(n))));
                value(xml, "ALIGNABLE_ANNOTATION", &attributes, &annotation.label)?;
            }
            Ok(())
        })?;
        with_sources.extend(row.sources.as_deref().map(|name| (row, name, ids)));
    }
    for (row, name, parents) in with_sources {
        let attributes = tier(name, &layout.source_kind, Some(&row.name));
        element(xml, "TIER", &attributes).write_inner_content(|xml| {
            for ((annotation, parent), id) in row.annotations.iter().zip(parents).zip(annotations.by_ref()) {
                let attributes = [("ANNOTATION_ID", id), ("ANNOTATION_REF", parent)];
                value(xml, "REF_ANNOTATION", &attributes, &annotation.source)?;
            }
            Ok(())
        })?;
    }
    Ok(())
}

fn element<'a>(
    xml: &'a mut Xml,
    name: &'a str,
    attributes: &[(&str, String)],
) -> quick_xml::writer::ElementWriter<'a, Vec<u8>> {
    xml.create_element(name).with_attributes(attributes.iter().map(|(key, value)| (*key, value.as_str())))
}

fn value(xml: &mut Xml, name: &str, attributes: &[(&str, String)], text: &str) -> io::Result<()> {
    xml.create_element("ANNOTATION").write_inner_content(|xml| {
        element(xml, name, attributes).write_inner_content(|xml| {
            xml.create_element("ANNOTATION_VALUE").write_text_content(BytesText::new(text)).map(|_| ())
        })?;
        Ok(())
    })?;
    Ok(())
}

fn types(xml: &mut Xml, layout: &Layout) -> io::Result<()> {
    for kind in &layout.kinds {
        let constraint = kind.included.then_some(("CONSTRAINTS", INCLUDED));
        let vocabulary = kind.vocabulary.as_ref().map(|_| ("CONTROLLED_VOCABULARY_REF", kind.name.as_str()));
        let fixed = [("LINGUISTIC_TYPE_ID", kind.name.as_str()), ("TIME_ALIGNABLE", "true")];
        let attributes = fixed.into_iter().chain(constraint).chain(vocabulary);
        xml.create_element("LINGUISTIC_TYPE").with_attributes(attributes).write_empty()?;
    }
    let source =
        [("LINGUISTIC_TYPE_ID", layout.source_kind.as_str()), ("TIME_ALIGNABLE", "false"), ("CONSTRAINTS", ASSOCIATED)];
    xml.create_element("LINGUISTIC_TYPE").with_attributes(source).write_empty()?;
    Ok(())
}

/// The name of the sign language among the file's names; the prefix keeps it from being one of the others.
fn language(document: &Document) -> Option<String> {
    let plain: String = document.language.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
    (!plain.is_empty()).then(|| format!("sgn-{plain}"))
}

fn languages(xml: &mut Xml, document: &Document) -> io::Result<()> {
    xml.create_element("LANGUAGE").with_attributes(ENGLISH).write_empty()?;
    if let Some(id) = language(document) {
        let label = clean(&document.language);
        let attributes = [("LANG_ID", id.as_str()), ("LANG_LABEL", &label)];
        xml.create_element("LANGUAGE").with_attributes(attributes).write_empty()?;
    }
    Ok(())
}

fn vocabularies(xml: &mut Xml, layout: &Layout) -> io::Result<()> {
    let english = ("LANG_REF", ENGLISH[0].1);
    for kind in &layout.kinds {
        let Some(entries) = &kind.vocabulary else { continue };
        let vocabulary = xml.create_element("CONTROLLED_VOCABULARY").with_attribute(("CV_ID", kind.name.as_str()));
        vocabulary.write_inner_content(|xml| {
            for (number, text) in entries.values.iter().enumerate() {
                let id = entry(number);
                xml.create_element("CV_ENTRY_ML").with_attribute(("CVE_ID", id.as_str())).write_inner_content(
                    |xml| {
                        let value = xml.create_element("CVE_VALUE").with_attribute(english);
                        value.write_text_content(BytesText::new(text)).map(|_| ())
                    },
                )?;
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// The name of a vocabulary's entry, unique within its vocabulary.
fn entry(number: usize) -> String {
    format!("cve{}", number + 1)
}
