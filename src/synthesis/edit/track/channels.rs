//! Another configuration and another place for the sign of a track, with the tier that names it.

use super::{Phases, about, marked, remapped, side_of};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::easing::Easing;
use crate::phonology::Side;
use crate::phonology::handshape::HandAngles;
use crate::synthesis::edit::{self, Extent, HandKept, Moved, Relocation, Sides};
use crate::tier::{Tier, TierValue};
use crate::time::Seconds;
use crate::track::Track;
use glam::DVec3;

/// The sign with another configuration, by its name and its angles, from the stroke's start to the sign's end.
///
/// It is formed in the preparation and loosened in the retraction.
///
/// # Errors
/// As [`edit::with_configuration`], and a track without phases or with several signs.
pub fn with_configuration(
    track: &Track,
    signer: &Signer,
    sides: Sides,
    (name, angles): (&str, &HandAngles),
    easing: Easing,
) -> Result<Track, Error> {
    let phases = Phases::of(track)?;
    let extent = phases.extent(easing);
    let mut made = track.clone();
    for &side in sides.each() {
        made.clip = edit::with_configuration(&made.clip, signer, side, angles, &extent)?;
        let mut tier = Tier::new(format!("{} Configuration", side.hand()));
        tier.push(phases.stroke, phases.sign_end, name, "configuration replaced");
        replace(&mut made.tiers, tier, side);
    }
    Ok(made)
}

/// Puts a hand's tier in the place of the one of its name, or after the hand's others.
fn replace(tiers: &mut Vec<Tier>, tier: Tier, side: Side) {
    match tiers.iter().position(|t| t.name == tier.name) {
        Some(at) => tiers[at] = tier,
        None => {
            let after = tiers.iter().rposition(|t| side_of(t) == Some(side)).map_or(tiers.len(), |at| at + 1);
            tiers.insert(after, tier);
        }
    }
}

/// A track whose sign is made elsewhere, and how near the wrists came.
#[derive(Debug, Clone)]
pub struct Relocated {
    /// The new track.
    pub track: Track,
    /// The greatest distance of a wrist from where it should be, metres.
    pub residual_m: f64,
    /// When that is.
    pub at: Seconds,
}

/// The sign with its acting wrists moved by one vector (model space, metres); the ways there and back follow the
/// preparation and the retraction.
///
/// # Errors
/// As [`edit::relocated`], and a track without phases or with several signs.
pub fn relocated_by(track: &Track, signer: &Signer, by: DVec3, kept: HandKept) -> Result<Relocated, Error> {
    let how = relocation(track, kept)?;
    Ok(with_place(track, edit::relocated(&track.clip, signer, by, &how)?))
}

/// The sign with the mean place of its acting wrists in the stroke at a target (model space, metres).
///
/// The hold does not count, as it does not for a described sign: it may be of any length. A sign without a stroke is
/// where it is held.
///
/// # Errors
/// As [`relocated_by`].
pub fn relocated_to(track: &Track, signer: &Signer, target: DVec3, kept: HandKept) -> Result<Relocated, Error> {
    let phases = Phases::of(track)?;
    // From one frame's time on, a frame stands in the stroke.
    let moves = (phases.stroke_end - phases.stroke).0 * track.clip.fps().get() >= 1.0;
    let end = if moves { phases.stroke_end } else { phases.sign_end };
    let place = edit::mean_place(&track.clip, signer, phases.sides, &Extent::between(phases.stroke, end))?;
    relocated_by(track, signer, target - place, kept)
}

fn relocation(track: &Track, kept: HandKept) -> Result<Relocation, Error> {
    let phases = Phases::of(track)?;
    Ok(Relocation { sides: phases.sides, extent: phases.extent(Easing::default()), kept })
}

fn with_place(track: &Track, moved: Moved) -> Relocated {
    let tiers = track.tiers.iter().map(|tier| {
        if side_of(tier).is_none() || about(tier) != "Placement" {
            return tier.clone();
        }
        let values = tier.values().iter();
        let values = values.map(|v| TierValue { label: format!("{}, elsewhere", v.label), ..marked(v, "relocated") });
        remapped(tier, String::new(), values)
    });
    let tiers = tiers.collect();
    Relocated { track: Track { clip: moved.clip, tiers }, residual_m: moved.residual_m, at: moved.at }
}
