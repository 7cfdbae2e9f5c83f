//! One arm for the other, with the tiers of the hands.

use super::{about, marked, remapped, side_of};
use crate::body::reflection::exchange_words;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::phonology::Side;
use crate::synthesis::edit;
use crate::tier::{Tier, TierValue};
use crate::track::Track;

/// The track with what the two arms do exchanged; the tiers of the hands change sides with them.
///
/// # Errors
/// As [`edit::swapped`].
pub fn swapped(track: &Track, signer: &Signer) -> Result<Track, Error> {
    let tiers = track.tiers.iter().map(|tier| match side_of(tier) {
        Some(side) => seen(tier, side.other(), "swapped"),
        None => tier.clone(),
    });
    Ok(Track { clip: edit::swapped(&track.clip, signer)?, tiers: in_order(tiers.collect()) })
}

/// The track in a mirror: hands, trunk, gaze and face, with the sides named in every tier exchanged.
pub fn reflected(track: &Track) -> Track {
    let tiers = track.tiers.iter().map(|tier| match side_of(tier) {
        Some(side) => seen(tier, side.other(), "reflected"),
        None => {
            let values = tier.values().iter().map(|v| TierValue { label: in_mirror(&v.label), ..v.clone() });
            remapped(tier, String::new(), values)
        }
    });
    Track { clip: edit::reflected(&track.clip), tiers: in_order(tiers.collect()) }
}

/// The track with one arm copied onto the other, and the tiers of its hand with it.
///
/// # Errors
/// As [`edit::mirrored`].
pub fn mirrored(track: &Track, signer: &Signer, from: Side) -> Result<Track, Error> {
    let clip = edit::mirrored(&track.clip, signer, from)?;
    let mut tiers: Vec<Tier> = track.tiers.iter().filter(|t| side_of(t) != Some(from.other())).cloned().collect();
    let copies = track.tiers.iter().filter(|t| side_of(t) == Some(from));
    tiers.extend(copies.map(|tier| seen(tier, from.other(), "mirrored")));
    Ok(Track { clip, tiers: in_order(tiers) })
}

/// One sign on the right hand, another on the left; non-manuals are the first one's.
///
/// The second track is swapped first where its tiers are of the right hand alone.
///
/// # Errors
/// As [`edit::on_each_hand`].
pub fn on_each_hand(strong: &Track, weak: &Track, signer: &Signer) -> Result<Track, Error> {
    let with_left = weak.tiers.iter().any(|t| side_of(t) == Some(Side::Left));
    let exchanged = if with_left { None } else { Some(swapped(weak, signer)?) };
    let weak = exchanged.as_ref().unwrap_or(weak);
    let clip = edit::hands::joined(&strong.clip, &weak.clip, signer)?;
    let mut tiers: Vec<Tier> = strong.tiers.iter().filter(|t| side_of(t) != Some(Side::Left)).cloned().collect();
    tiers.extend(weak.tiers.iter().filter(|t| side_of(t) == Some(Side::Left)).cloned());
    Ok(Track { clip, tiers: in_order(tiers) })
}

/// A hand's tier as the other hand's in the mirror. Glosses and phases have no sides in their labels.
fn seen(tier: &Tier, side: Side, done: &str) -> Tier {
    let whole = matches!(about(tier), "Gloss" | "Phase" | "Configuration");
    let values = tier.values().iter().map(|v| {
        let label = if whole { v.label.clone() } else { in_mirror(&v.label) };
        TierValue { label, ..marked(v, done) }
    });
    remapped(tier, format!("{} {}", side.hand(), about(tier)), values)
}

/// A label with its left and right exchanged, and the X of a place in metres.
fn in_mirror(label: &str) -> String {
    let exchanged = exchange_words(label);
    let place = exchanged.strip_prefix('(').and_then(|rest| rest.split_once(','));
    match place.and_then(|(x, rest)| Some((x.trim().parse::<f64>().ok()?, rest))) {
        Some((x, rest)) => format!("({:.2},{rest}", -x),
        None => exchanged,
    }
}

/// The right hand's tiers, the left hand's, the others, each in their order.
pub(in crate::synthesis) fn in_order(mut tiers: Vec<Tier>) -> Vec<Tier> {
    tiers.sort_by_key(|tier| match side_of(tier) {
        Some(Side::Right) => 0,
        Some(Side::Left) => 1,
        None => 2,
    });
    tiers
}
