//! Tiers and annotations as they stand in the file, their references looked up.

use super::element::{Node, attribute, named, required, text};
use super::head::twice;
use super::times::Slots;
use crate::diagnostics::xml::{short, tag_span};
use crate::diagnostics::{Diagnostic, Span};
use crate::format::eaf::{Stereotype, TierType};
use crate::format::told::Told;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

/// A tier before its annotations have times.
pub(super) struct RawTier<'a> {
    pub name: &'a str,
    pub node: Node<'a>,
    /// Its type's place among all.
    pub tier_type: Option<usize>,
    pub stereotype: Option<Stereotype>,
    /// The name of its parent, and where that is said.
    pub parent: Option<(&'a str, Span)>,
    /// Its parent's place among all tiers.
    pub parent_at: Option<usize>,
}

/// An annotation before it has a time.
pub(super) struct Annotation<'a> {
    pub id: &'a str,
    /// Of the id.
    pub span: Span,
    pub text: String,
    /// The entry of the vocabulary that it refers to.
    pub entry: Option<(&'a str, Span)>,
    pub place: Place,
}

/// What gives an annotation its time; the numbers are places among all slots and all annotations.
#[derive(Debug, Clone, Copy)]
pub(super) enum Place {
    Slots(usize, usize),
    /// The parent, and the annotation of the same parent that it follows.
    Below(usize, Option<usize>),
    /// A fault was told.
    Nowhere,
}

/// The tiers of a file, in its order.
pub(super) fn tiers<'a>(root: Node<'a>, types: &[TierType], told: &mut Told) -> Vec<RawTier<'a>> {
    let type_at: BTreeMap<&str, usize> = types.iter().enumerate().map(|(at, t)| (t.id.as_str(), at)).collect();
    let mut tiers: Vec<RawTier> = Vec::new();
    let mut taken: BTreeMap<&str, usize> = BTreeMap::new();
    for node in named(root, "TIER") {
        let Some((name, span)) = required(node, "TIER_ID", told) else { continue };
        if taken.contains_key(name) {
            told.say(twice("tier", name, span));
            continue;
        }
        taken.insert(name, tiers.len());
        let tier_type = required(node, "LINGUISTIC_TYPE_REF", told).and_then(|(id, span)| {
            let found = type_at.get(id).copied();
            if found.is_none() {
                let fault = Diagnostic::fault(span, format!("there is no type of tiers `{}`", short(id)));
                told.say(fault.label("unknown").hint("each tier names a LINGUISTIC_TYPE of the same file"));
            }
            found
        });
        let stereotype = tier_type.and_then(|at| types[at].stereotype);
        let parent = attribute(node, "PARENT_REF");
        tiers.push(RawTier { name, node, tier_type, stereotype, parent, parent_at: None });
    }
    for tier in &mut tiers {
        let Some((parent, span)) = tier.parent else { continue };
        tier.parent_at = taken.get(parent).copied();
        if tier.parent_at.is_none() && parent.is_empty() {
            tier.parent = None;
        } else if tier.parent_at.is_none() {
            told.say(Diagnostic::fault(span, format!("there is no tier `{}`", short(parent))).label("unknown parent"));
        }
    }
    tiers
}

/// All annotations of a file, tier by tier.
pub(super) struct Annotations<'a> {
    all: Vec<Annotation<'a>>,
    of_tier: Vec<Range<usize>>,
}

impl<'a> Annotations<'a> {
    pub fn read(tiers: &[RawTier<'a>], slots: &Slots<'a>, told: &mut Told) -> Annotations<'a> {
        let mut read = Annotations { all: Vec::new(), of_tier: Vec::new() };
        let mut nodes = Vec::new();
        let mut places: HashMap<&str, usize> = HashMap::new();
        for tier in tiers {
            let begin = read.all.len();
            let within = named(tier.node, "ANNOTATION").flat_map(|n| n.children().filter(Node::is_element));
            for node in within {
                let Some((id, span)) = required(node, "ANNOTATION_ID", told) else { continue };
                if places.insert(id, read.all.len()).is_some() {
                    told.say(twice("annotation", id, span));
                }
                let text = named(node, "ANNOTATION_VALUE").map(text).next().unwrap_or_default();
                let entry = attribute(node, "CVE_REF").filter(|(id, _)| !id.is_empty());
                read.all.push(Annotation { id, span, text, entry, place: Place::Nowhere });
                nodes.push(node);
            }
            read.of_tier.push(begin..read.all.len());
        }
        for (at, tier) in tiers.iter().enumerate() {
            // An id of this range is on the parent tier.
            let parent = tier.parent_at.map(|parent| read.of_tier[parent].clone());
            for i in read.of_tier[at].clone() {
                let find = |name: &'static str| reference(nodes[i], name, &places);
                read.all[i].place = match nodes[i].tag_name().name() {
                    "ALIGNABLE_ANNOTATION" => slots.of(nodes[i], told),
                    // That its tier's parent is unknown was told.
                    "REF_ANNOTATION" if tier.parent.is_some() && tier.parent_at.is_none() => Place::Nowhere,
                    "REF_ANNOTATION" => below(nodes[i], find, parent.clone(), &read.of_tier[at], told),
                    other => {
                        let message = format!("`{}` is no annotation", short(other));
                        let fault = Diagnostic::fault(tag_span(nodes[i]), message);
                        told.say(fault.label("expected ALIGNABLE_ANNOTATION or REF_ANNOTATION"));
                        Place::Nowhere
                    }
                };
            }
        }
        read
    }

    /// The places of a tier's annotations.
    pub fn of(&self, tier: usize) -> Range<usize> {
        self.of_tier[tier].clone()
    }

    pub fn get(&self, at: usize) -> &Annotation<'a> {
        &self.all[at]
    }

    pub fn len(&self) -> usize {
        self.all.len()
    }
}

/// An attribute that names an annotation: what it says, where, and the annotation's place among all.
type Reference<'a> = (&'a str, Span, Option<usize>);

fn reference<'a>(node: Node<'a>, name: &str, places: &HashMap<&str, usize>) -> Option<Reference<'a>> {
    attribute(node, name).filter(|(id, _)| !id.is_empty()).map(|(id, span)| (id, span, places.get(id).copied()))
}

/// The place of an annotation that refers to another; `parents` and `own` are the annotations of both tiers.
fn below<'a>(
    node: Node<'a>,
    find: impl Fn(&'static str) -> Option<Reference<'a>>,
    parents: Option<Range<usize>>,
    own: &Range<usize>,
    told: &mut Told,
) -> Place {
    let Some((id, span, parent)) = find("ANNOTATION_REF") else {
        let fault = Diagnostic::fault(tag_span(node), "this annotation refers to none");
        told.say(fault.label("expected ANNOTATION_REF=\"…\""));
        return Place::Nowhere;
    };
    let Some(parent) = parent else {
        told.say(unknown(id, span));
        return Place::Nowhere;
    };
    if !parents.is_some_and(|parents| parents.contains(&parent)) {
        let fault = Diagnostic::fault(span, format!("the annotation `{}` is not on the parent tier", short(id)));
        told.say(fault.label("refers to another tier").hint("is the tier's PARENT_REF missing or another?"));
        return Place::Nowhere;
    }
    match find("PREVIOUS_ANNOTATION") {
        None => Place::Below(parent, None),
        Some((_, _, Some(previous))) if own.contains(&previous) => Place::Below(parent, Some(previous)),
        Some((id, span, Some(_))) => {
            let fault = Diagnostic::fault(span, format!("the annotation `{}` is not on this tier", short(id)));
            told.say(fault.label("expected one of the same tier"));
            Place::Nowhere
        }
        Some((id, span, None)) => {
            told.say(unknown(id, span));
            Place::Nowhere
        }
    }
}

fn unknown(id: &str, span: Span) -> Diagnostic {
    Diagnostic::fault(span, format!("there is no annotation `{}`", short(id)))
        .label("unknown")
        .hint("was the annotation that this one hangs on taken out?")
}
