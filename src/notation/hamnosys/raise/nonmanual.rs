//! Non-manual values to the tiers of SiGML.

use super::super::dictionary::Dictionary;
use super::super::syntax::{Cue, Feature, FeatureKind, Tier, TierKind};
use super::note;
use crate::phonology::{Amount, Channel, Keys, NonManual, NonManualValue};
use glam::DVec3;

/// The tiers of non-manual values; what SiGML has no tag for is noted.
pub(super) fn tiers(
    nonmanual: &[(Channel, Keys<NonManual>)],
    dictionary: &Dictionary,
    errors: &mut Vec<String>,
    warnings: &mut Vec<String>,
) -> Vec<Tier> {
    let mut all: Vec<(TierKind, Vec<Cue>)> = Vec::new();
    for (channel, values) in nonmanual {
        if values.len() > 1 || values.iter().any(|(key, _)| key > 0) {
            note(
                warnings,
                "SiGML says non-manual values one after the other, over the whole sign, not at which posture",
            );
        }
        let mut cues: Vec<Cue> = values.iter().filter_map(|(_, v)| cue(*channel, v, dictionary, errors)).collect();
        let Some(cue) = (if cues.len() > 1 { Some(Cue::Sequence(cues)) } else { cues.pop() }) else { continue };
        let (tier, _) = kinds(*channel);
        match all.iter_mut().find(|(kind, _)| *kind == tier) {
            Some((_, cues)) => cues.push(cue),
            None => all.push((tier, vec![cue])),
        }
    }
    all.sort_by_key(|(kind, _)| *kind);
    all.into_iter().map(|(kind, cues)| Tier { kind, cues: at_once(cues) }).collect()
}

/// What several channels of one tier say goes on at the same time; one sequence is the tier's own.
fn at_once(mut cues: Vec<Cue>) -> Vec<Cue> {
    match (cues.len(), cues.pop()) {
        (1, Some(Cue::Sequence(all))) => all,
        (_, Some(last)) if cues.is_empty() => vec![last],
        (_, Some(last)) => {
            cues.push(last);
            vec![Cue::Together(cues)]
        }
        (_, None) => cues,
    }
}

fn kinds(channel: Channel) -> (TierKind, FeatureKind) {
    match channel {
        Channel::Head => (TierKind::Head, FeatureKind::Head),
        Channel::Torso => (TierKind::Body, FeatureKind::Body),
        Channel::Shoulders => (TierKind::Shoulder, FeatureKind::Shoulder),
        Channel::Gaze => (TierKind::EyeGaze, FeatureKind::EyeGaze),
        Channel::Brows => (TierKind::FacialExpression, FeatureKind::EyeBrows),
        Channel::Lids => (TierKind::FacialExpression, FeatureKind::EyeLids),
        Channel::Nose => (TierKind::FacialExpression, FeatureKind::Nose),
        Channel::Cheeks | Channel::Mouth => (TierKind::Mouthing, FeatureKind::MouthGesture),
    }
}

fn cue(channel: Channel, value: &NonManual, dictionary: &Dictionary, errors: &mut Vec<String>) -> Option<Cue> {
    // Brackets have no amount and no speed of their own: their parts have it.
    let mut all = |values: &[NonManual]| -> Vec<Cue> {
        let cues = values.iter().filter_map(|v| cue(channel, v, dictionary, errors));
        cues.map(|one| scaled(one, value.amount, value.pace)).collect()
    };
    let (kind, tag) = match &value.value {
        NonManualValue::Sequence(values) => return Some(Cue::Sequence(all(values))),
        NonManualValue::Together(values) => return Some(Cue::Together(all(values))),
        NonManualValue::Mouthing(sounds) => (FeatureKind::MouthPicture, Some(sounds.clone())),
        NonManualValue::Named(name) => (kinds(channel).1, dictionary.value_tag(channel, name).map(str::to_owned)),
        NonManualValue::Towards(heading) => (kinds(channel).1, toward(channel, heading.vector())),
        NonManualValue::At(_) => (kinds(channel).1, None),
    };
    let Some(tag) = tag else {
        let what = match &value.value {
            NonManualValue::Named(name) => format!("SiGML has no tag for {} `{name}`", channel.name()),
            NonManualValue::At(_) => format!("SiGML cannot say that the {} turns to a place", channel.name()),
            NonManualValue::Towards(_)
            | NonManualValue::Mouthing(_)
            | NonManualValue::Sequence(_)
            | NonManualValue::Together(_) => format!("SiGML has no tag for this value of {}", channel.name()),
        };
        note(errors, &what);
        return None;
    };
    Some(Cue::One(Feature {
        kind,
        value: tag,
        amount: (value.amount != Amount::Plain).then(|| value.amount.factor()),
        speed: (value.pace != 1.0).then_some(value.pace),
        span: Default::default(),
    }))
}

/// A cue with an amount and a speed on top of its own.
fn scaled(cue: Cue, amount: Amount, pace: f64) -> Cue {
    let all = |cues: Vec<Cue>| cues.into_iter().map(|one| scaled(one, amount, pace)).collect();
    let times = |own: Option<f64>, factor: f64| Some(own.unwrap_or(1.0) * factor).filter(|product| *product != 1.0);
    match cue {
        Cue::Sequence(cues) => Cue::Sequence(all(cues)),
        Cue::Together(cues) => Cue::Together(all(cues)),
        Cue::One(feature) => {
            let (amount, speed) = (times(feature.amount, amount.factor()), times(feature.speed, pace));
            Cue::One(Feature { amount, speed, ..feature })
        }
    }
}

/// The tag of a head or gaze that turns to a direction.
fn toward(channel: Channel, d: DVec3) -> Option<String> {
    let side = if d.x > 0.35 {
        "L"
    } else if d.x < -0.35 {
        "R"
    } else {
        ""
    };
    let height = if d.y > 0.35 {
        "U"
    } else if d.y < -0.35 {
        "D"
    } else {
        ""
    };
    let tag = match (channel, side, height) {
        (Channel::Gaze, "", "") => "AD",
        (Channel::Gaze, "", "U") => "UP",
        (Channel::Gaze, "", _) => "DN",
        (Channel::Gaze, "L", "") => "LE",
        (Channel::Gaze, "R", "") => "RI",
        (Channel::Gaze, "L", "U") => "LU",
        (Channel::Gaze, "L", _) => "LD",
        (Channel::Gaze, _, "U") => "RU",
        (Channel::Gaze, _, _) => "RD",
        (Channel::Head, "L", _) => "SL",
        (Channel::Head, "R", _) => "SR",
        (Channel::Head, _, "U") => "NB",
        (Channel::Head, _, "D") => "NF",
        (Channel::Torso, "L", _) => "RL",
        (Channel::Torso, "R", _) => "RR",
        (
            Channel::Head
            | Channel::Torso
            | Channel::Shoulders
            | Channel::Brows
            | Channel::Lids
            | Channel::Nose
            | Channel::Cheeks
            | Channel::Mouth,
            _,
            _,
        ) => return None,
    };
    Some(tag.to_owned())
}
