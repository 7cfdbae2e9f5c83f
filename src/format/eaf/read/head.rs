//! What stands about the tiers: version, unit of time, media, types, languages.

use super::element::{Node, attribute, named, optional, owned, required, text};
use super::in_header;
use crate::diagnostics::xml::{short, tag_span};
use crate::diagnostics::{Diagnostic, Span};
use crate::format::eaf::{Language, Media, Stereotype, TierType};
use crate::format::told::Told;
use crate::time::Seconds;
use std::collections::{BTreeMap, BTreeSet};

/// Warns of a version that nobody has seen yet.
pub(super) fn check_version(root: Node<'_>, version: &str, told: &mut Told) {
    let major = version.split('.').next().and_then(|n| n.parse::<u32>().ok());
    if !matches!(major, Some(1..=3)) {
        let span = attribute(root, "FORMAT").or(attribute(root, "VERSION")).map_or(tag_span(root), |a| a.1);
        let message = match version {
            "" => "this file does not say which version of EAF it is".to_owned(),
            _ => format!("version {} of EAF is not known here", short(version)),
        };
        told.say(Diagnostic::warning(span, message).label("read as 3.0"));
    }
}

/// What a whole number of time is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Unit {
    Milliseconds,
    /// Frames, this many a second.
    Frames(f64),
}

impl Unit {
    pub fn seconds(self, count: u64) -> Seconds {
        match self {
            Unit::Milliseconds => Seconds(count as f64 / 1000.0),
            Unit::Frames(rate) => Seconds(count as f64 / rate),
        }
    }
}

/// `TIME_UNITS`: the schema knows three.
pub(super) fn unit(root: Node<'_>, told: &mut Told) -> Unit {
    let Some(header) = named(root, "HEADER").next() else {
        told.say(Diagnostic::fault(tag_span(root), "there is no HEADER").label("expected a HEADER within this"));
        return Unit::Milliseconds;
    };
    match attribute(header, "TIME_UNITS") {
        None | Some(("milliseconds", _)) => Unit::Milliseconds,
        Some(("PAL-frames", _)) => Unit::Frames(25.0),
        Some(("NTSC-frames", _)) => Unit::Frames(30_000.0 / 1001.0),
        Some((other, span)) => {
            let fault = Diagnostic::fault(span, format!("`{}` is no unit of time of EAF", short(other)));
            told.say(fault.label("expected milliseconds, PAL-frames or NTSC-frames"));
            Unit::Milliseconds
        }
    }
}

pub(super) fn media(root: Node<'_>, told: &mut Told) -> Vec<Media> {
    let one = |node| {
        let origin = match attribute(node, "TIME_ORIGIN") {
            None => 0,
            Some((value, span)) => value.trim().parse::<i64>().unwrap_or_else(|_| {
                let fault = Diagnostic::fault(span, format!("`{}` is no time", short(value)));
                told.say(fault.label("expected whole milliseconds"));
                0
            }),
        };
        Media {
            url: owned(node, "MEDIA_URL"),
            relative_url: optional(node, "RELATIVE_MEDIA_URL"),
            mime: owned(node, "MIME_TYPE"),
            origin: Seconds(origin as f64 / 1000.0),
            extracted_from: optional(node, "EXTRACTED_FROM"),
        }
    };
    in_header(root, "MEDIA_DESCRIPTOR").map(one).collect()
}

pub(super) fn properties(root: Node<'_>) -> Vec<(String, String)> {
    in_header(root, "PROPERTY").map(|node| (owned(node, "NAME"), text(node))).collect()
}

pub(super) fn languages(root: Node<'_>) -> Vec<Language> {
    let one = |node| Language {
        id: owned(node, "LANG_ID"),
        definition: owned(node, "LANG_DEF"),
        label: owned(node, "LANG_LABEL"),
    };
    named(root, "LANGUAGE").map(one).collect()
}

/// Where vocabularies outside the file are, by the name of the reference.
pub(super) fn external_references<'a>(root: Node<'a>) -> BTreeMap<&'a str, &'a str> {
    let one = |node: Node<'a>| Some((node.attribute("EXT_REF_ID")?, node.attribute("VALUE")?));
    named(root, "EXTERNAL_REF").filter_map(one).collect()
}

pub(super) fn types(root: Node<'_>, told: &mut Told) -> Vec<TierType> {
    let mut types = Vec::new();
    let mut taken = BTreeSet::new();
    for node in named(root, "LINGUISTIC_TYPE") {
        let Some((id, span)) = required(node, "LINGUISTIC_TYPE_ID", told) else { continue };
        if !taken.insert(id) {
            told.say(twice("type of tiers", id, span));
            continue;
        }
        types.push(TierType {
            id: id.to_owned(),
            time_alignable: node.attribute("TIME_ALIGNABLE") != Some("false"),
            stereotype: stereotype(node, told),
            vocabulary: optional(node, "CONTROLLED_VOCABULARY_REF"),
        });
    }
    types
}

fn stereotype(node: Node<'_>, told: &mut Told) -> Option<Stereotype> {
    let (written, span) = attribute(node, "CONSTRAINTS").filter(|(value, _)| !value.is_empty())?;
    // Old files have blanks for the underscore.
    let known = Stereotype::ALL.into_iter().find(|s| s.word() == written.replace(' ', "_"));
    if known.is_none() {
        let all = Stereotype::ALL.map(Stereotype::word).join(", ");
        let fault = Diagnostic::fault(span, format!("`{}` is no stereotype of tiers", short(written)));
        told.say(fault.label(format!("expected one of {all}")));
    }
    known
}

/// A name that two things have.
pub(super) fn twice(what: &str, id: &str, span: Span) -> Diagnostic {
    Diagnostic::fault(span, format!("there are two of the {what} `{}`", short(id)))
        .label("the second one")
        .hint("were two files put together? each name may be given once")
}
