//! Face and body.

use super::element::Element;
use super::unsayable;
use super::words::{FEATURE, PLAIN_FEATURE, TIER, groups};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{Cue, Feature, FeatureKind, Tier};

/// `sign_nonmanual`.
pub(super) fn tiers(tiers: &[Tier]) -> Result<Element, Error> {
    let mut element = Element::new("sign_nonmanual");
    for tier in tiers {
        let cues = tier.cues.iter().map(|cue| gestural(cue, groups(tier.kind), 0)).collect::<Result<_, _>>()?;
        element.children.push(Element::of((TIER.word)(tier.kind), cues));
    }
    Ok(element)
}

fn gestural(cue: &Cue, names: (&'static str, &'static str), depth: usize) -> Result<Element, Error> {
    super::check_depth(depth)?;
    let group = |name, cues: &[Cue]| {
        let cues = cues.iter().map(|cue| gestural(cue, names, depth + 1)).collect::<Result<_, _>>()?;
        Ok(Element::of(name, cues))
    };
    match cue {
        Cue::One(feature) => feature_element((FEATURE.word)(feature.kind), attribute(feature.kind), feature),
        Cue::Together(cues) => group(names.0, cues),
        Cue::Sequence(cues) => group(names.1, cues),
    }
}

/// The attribute that holds the value.
fn attribute(kind: FeatureKind) -> &'static str {
    match kind {
        FeatureKind::EyeGaze => "direction",
        FeatureKind::MouthPicture => "picture",
        FeatureKind::Shoulder | FeatureKind::Body | FeatureKind::Head | FeatureKind::EyeBrows => "movement",
        FeatureKind::EyeLids | FeatureKind::Nose | FeatureKind::MouthGesture | FeatureKind::Extra => "movement",
    }
}

fn feature_element(name: &'static str, attribute: &'static str, feature: &Feature) -> Result<Element, Error> {
    let mut element = Element::new(name);
    element.set(attribute, feature.value.as_str());
    match feature.amount {
        Some(amount) if amount.is_finite() && amount >= 0.0 => element.set("amount", amount.to_string()),
        Some(amount) => return unsayable(&format!("`amount` should be a number from 0 up, not {amount}")),
        None => {}
    }
    element.factor("speed", feature.speed)?;
    Ok(element)
}

/// `hamnosys_nonmanual`: what is said at the same time, and no more of it than its name.
pub(super) fn plain(tiers: &[Tier]) -> Result<Element, Error> {
    let mut element = Element::new("hamnosys_nonmanual");
    for tier in tiers {
        match tier.cues.as_slice() {
            [] => {}
            [cue] => plain_cue(cue, &mut element.children)?,
            [_, _, ..] => return in_sequence(),
        }
    }
    Ok(element)
}

fn plain_cue(cue: &Cue, elements: &mut Vec<Element>) -> Result<(), Error> {
    match cue {
        Cue::One(feature) => {
            if feature.amount.is_some() || feature.speed.is_some() {
                return unsayable(&format!("H-SiGML does not say how much or how fast `{}` is", feature.value));
            }
            let attribute = if feature.kind == FeatureKind::MouthPicture { "picture" } else { "tag" };
            elements.push(feature_element((PLAIN_FEATURE.word)(feature.kind), attribute, feature)?);
            Ok(())
        }
        Cue::Together(cues) => cues.iter().try_for_each(|cue| match cue {
            Cue::One(_) => plain_cue(cue, elements),
            Cue::Together(_) | Cue::Sequence(_) => unsayable("H-SiGML does not nest what face and body do"),
        }),
        Cue::Sequence(_) => in_sequence(),
    }
}

fn in_sequence<T>() -> Result<T, Error> {
    unsayable("H-SiGML does not say what face and body do one after the other")
}
