//! Face and body: `sign_nonmanual` and its tiers, and the plain list of H-SiGML.

use super::reader::{Node, Reader, attributes, elements, tag_span};
use super::words::{FEATURE, PLAIN_FEATURE, TIER, groups, tier_of};
use crate::notation::hamnosys::syntax::{Cue, Feature, FeatureKind, Ignored, Tier, TierKind};

impl<'a> Reader<'a> {
    /// `sign_nonmanual`.
    pub(super) fn nonmanual(&mut self, node: Node<'a>, tiers: &mut Vec<Tier>) {
        self.no_attributes(node);
        self.no_text(node);
        for child in elements(node) {
            let name = child.tag_name().name();
            if let Some(kind) = TIER.find(name) {
                self.no_attributes(child);
                let cues = self.cues(child, kind);
                tiers.push(Tier { kind, cues });
            } else if let Some(kind) = FEATURE.find(name) {
                let told = self.warning(tag_span(child), &format!("`{name}` stands outside a tier"));
                let tier = tier_of(kind);
                self.say(told.label(format!("read as if within `{}`", (TIER.word)(tier))));
                let cues = self.feature(child, kind).map(Cue::One).into_iter().collect();
                tiers.push(Tier { kind: tier, cues });
            } else {
                self.unknown_element(child, &TIER.list().collect::<Vec<_>>());
            }
        }
    }

    /// What a tier, or a group within it, says.
    fn cues(&mut self, node: Node<'a>, tier: TierKind) -> Vec<Cue> {
        self.no_text(node);
        elements(node).filter_map(|child| self.cue(child, tier)).collect()
    }

    fn cue(&mut self, node: Node<'a>, tier: TierKind) -> Option<Cue> {
        let name = node.tag_name().name();
        if let Some(kind) = FEATURE.find(name) {
            return self.feature(node, kind).map(Cue::One);
        }
        if name.ends_with("_par") || name.ends_with("_seq") {
            self.no_attributes(node);
            let cues = self.cues(node, tier);
            return Some(if name.ends_with("_par") { Cue::Together(cues) } else { Cue::Sequence(cues) });
        }
        let (together, sequence) = groups(tier);
        let known: Vec<&str> = FEATURE.list().chain([together, sequence]).collect();
        self.unknown_element(node, &known);
        None
    }

    /// One value.
    fn feature(&mut self, node: Node<'a>, kind: FeatureKind) -> Option<Feature> {
        self.no_content(node);
        let (mut value, mut amount, mut speed) = (None, None, None);
        for attr in attributes(node) {
            match attr.name {
                "movement" | "direction" | "picture" | "tag" => value = Some(attr),
                "amount" => amount = self.amount(&attr),
                "speed" => speed = self.factor(&attr),
                _ => self.unknown_attribute(&attr, &["movement", "direction", "picture", "tag", "amount", "speed"]),
            }
        }
        let Some(attr) = value else {
            let told = self.warning(tag_span(node), &format!("`{}` does not say what it does", node.tag_name().name()));
            self.say(told.label("passed over"));
            return None;
        };
        Some(Feature { kind, value: attr.raw.to_owned(), amount, speed, span: Ignored(attr.span) })
    }

    /// `hamnosys_nonmanual`: values of one tier are at the same time, wherever they stand.
    pub(super) fn plain_nonmanual(&mut self, node: Node<'a>, tiers: &mut Vec<Tier>) {
        self.no_attributes(node);
        self.no_text(node);
        for child in elements(node) {
            let name = child.tag_name().name();
            let Some(kind) = PLAIN_FEATURE.find(name).or_else(|| FEATURE.find(name)) else {
                self.unknown_element(child, &PLAIN_FEATURE.list().collect::<Vec<_>>());
                continue;
            };
            let Some(feature) = self.feature(child, kind) else { continue };
            let tier = tier_of(kind);
            match tiers.iter_mut().find(|t| t.kind == tier) {
                None => tiers.push(Tier { kind: tier, cues: vec![Cue::One(feature)] }),
                Some(tier) => add(&mut tier.cues, feature),
            }
        }
    }
}

/// One more value at the same time.
fn add(cues: &mut Vec<Cue>, feature: Feature) {
    match cues.pop() {
        None => cues.push(Cue::One(feature)),
        Some(Cue::Together(mut together)) => {
            together.push(Cue::One(feature));
            cues.push(Cue::Together(together));
        }
        Some(other @ (Cue::One(_) | Cue::Sequence(_))) => cues.push(Cue::Together(vec![other, Cue::One(feature)])),
    }
}
