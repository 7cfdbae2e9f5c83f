//! Non-manual tiers: tags to named values, mouth pictures to mouthing, sequences and simultaneous values.

use super::super::dictionary::Dictionary;
use super::super::syntax::{Cue, Feature, FeatureKind, Tier};
use crate::diagnostics::Diagnostic;
use crate::notation::suggest::nearest;
use crate::phonology::{Amount, Channel, Keys, NonManual, NonManualValue};

/// The non-manual tiers of a sign. A tag that has no meaning for us is left out with a warning.
pub(crate) fn nonmanuals(
    tiers: &[Tier],
    dictionary: &Dictionary,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<(Channel, Keys<NonManual>)> {
    for tier in tiers {
        tier.cues.iter().for_each(|cue| tell_unknown(cue, dictionary, diagnostics));
    }
    let mut all = Vec::new();
    for channel in Channel::ALL {
        // What is said of one channel in several places goes on at the same time.
        let said = tiers.iter().filter_map(|tier| sequence(&tier.cues, channel, dictionary));
        if let Some(value) = joined(said.collect(), NonManualValue::Together) {
            all.push((channel, Keys::one(value)));
        }
    }
    all
}

fn sequence(cues: &[Cue], channel: Channel, dictionary: &Dictionary) -> Option<NonManual> {
    joined(cues.iter().filter_map(|c| value(c, channel, dictionary)).collect(), NonManualValue::Sequence)
}

/// One value as it is, several in brackets.
fn joined(mut values: Vec<NonManual>, bracket: fn(Vec<NonManual>) -> NonManualValue) -> Option<NonManual> {
    match values.len() {
        0 => None,
        1 => values.pop(),
        _ => Some(NonManual::plain(bracket(values))),
    }
}

/// What a cue says of a channel.
fn value(cue: &Cue, channel: Channel, dictionary: &Dictionary) -> Option<NonManual> {
    match cue {
        Cue::One(feature) => {
            let (of, what) = meaning(feature, dictionary)?;
            let amount = feature.amount.map_or(Amount::Plain, Amount::of);
            (of == channel).then_some(NonManual { value: what, amount, pace: pace(feature.speed) })
        }
        Cue::Together(all) => {
            joined(all.iter().filter_map(|c| value(c, channel, dictionary)).collect(), NonManualValue::Together)
        }
        Cue::Sequence(all) => sequence(all, channel, dictionary),
    }
}

/// A speed within the model's bounds.
pub(crate) fn pace(speed: Option<f64>) -> f64 {
    speed.filter(|s| s.is_finite() && *s > 0.0).map_or(1.0, |s| s.clamp(0.05, 20.0))
}

/// The channels that a kind of feature may speak of: its own first.
fn channels(kind: FeatureKind) -> &'static [Channel] {
    match kind {
        FeatureKind::Shoulder => &[Channel::Shoulders],
        FeatureKind::Body => &[Channel::Torso],
        FeatureKind::Head => &[Channel::Head],
        FeatureKind::EyeGaze => &[Channel::Gaze],
        FeatureKind::EyeBrows => &[Channel::Brows],
        FeatureKind::EyeLids => &[Channel::Lids],
        FeatureKind::Nose => &[Channel::Nose],
        FeatureKind::MouthGesture => &[Channel::Mouth, Channel::Cheeks],
        FeatureKind::MouthPicture => &[Channel::Mouth],
        FeatureKind::Extra => &[],
    }
}

/// Channel and value of a feature.
fn meaning(feature: &Feature, dictionary: &Dictionary) -> Option<(Channel, NonManualValue)> {
    if feature.kind == FeatureKind::MouthPicture {
        let sounds = feature.value.trim();
        return (!sounds.is_empty()).then(|| (Channel::Mouth, NonManualValue::Mouthing(sounds.to_owned())));
    }
    let written = feature.value.trim();
    // Tags are capitals but for a few words.
    let (tag, word) = (written.to_uppercase(), written.to_lowercase());
    let found = |channel: &Channel| {
        let value = dictionary.value(*channel, &tag).or_else(|| dictionary.value(*channel, &word));
        value.map(|name| (*channel, NonManualValue::Named(name.to_owned())))
    };
    channels(feature.kind).iter().find_map(found)
}

fn tell_unknown(cue: &Cue, dictionary: &Dictionary, diagnostics: &mut Vec<Diagnostic>) {
    match cue {
        Cue::Together(all) | Cue::Sequence(all) => {
            all.iter().for_each(|c| tell_unknown(c, dictionary, diagnostics));
        }
        Cue::One(feature) => {
            let empty = feature.value.trim().is_empty();
            if empty || meaning(feature, dictionary).is_some() {
                return;
            }
            let warning = |message: String| Diagnostic::warning(feature.span.0, message).label("left out");
            diagnostics.push(match channels(feature.kind) {
                [] => warning(format!("`{}` is a movement of one avatar only", feature.value)),
                known => {
                    let tags: Vec<&str> = known.iter().flat_map(|c| dictionary.tags(*c)).collect();
                    let what = format!("there is no {} `{}`", name(feature.kind), feature.value);
                    match nearest(&feature.value, tags.iter().copied()) {
                        Some(near) => warning(what).hint(format!("did you mean `{near}`?")),
                        None => warning(what).hint(format!("there are {}", tags.join(", "))),
                    }
                }
            });
        }
    }
}

/// What a kind of feature is called.
fn name(kind: FeatureKind) -> &'static str {
    match kind {
        FeatureKind::Shoulder => "movement of the shoulders",
        FeatureKind::Body => "movement of the body",
        FeatureKind::Head => "movement of the head",
        FeatureKind::EyeGaze => "eye gaze",
        FeatureKind::EyeBrows => "movement of the eyebrows",
        FeatureKind::EyeLids => "movement of the eyelids",
        FeatureKind::Nose => "movement of the nose",
        FeatureKind::MouthGesture => "mouth gesture",
        FeatureKind::MouthPicture => "mouth picture",
        FeatureKind::Extra => "extra movement",
    }
}
