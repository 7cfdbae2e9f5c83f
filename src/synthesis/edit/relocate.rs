//! Spatialization: a sign put elsewhere in the signing space (Naert et al. 2021, §4.1).
//!
//! # Departs from the paper
//! It states the translation frame by frame, as targeted minus actual position of the wrist, which would freeze the
//! sign at its target. Here one constant vector moves all acting wrists, so that the movement within the sign and the
//! places of the hands to each other stay (papers-decisions.md, 1).

use super::wrists::{HandKept, Moved, Sides, moved, paths};
use super::{Extent, fits};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use glam::DVec3;

/// Which arms are put elsewhere, when, and what their hands keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relocation {
    /// The hands that act.
    pub sides: Sides,
    /// Where in time they are elsewhere; the way there and back is eased outside it.
    pub extent: Extent,
    /// What the hands keep.
    pub kept: HandKept,
}

/// The clip with its acting wrists moved by one vector (model space, metres).
///
/// Upper arm, forearm and wrist of the acting arms change; everything else stays bit for bit. A target out of reach
/// stretches the arm straight toward it, and the distance left is the result's residual.
///
/// # Errors
/// A clip of another rig, a vector that is not finite.
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # use glam::DVec3;
/// # let signer = chereme::avatar::signer().unwrap();
/// # let sign = chereme::notation::read("sign X\n configuration flat\n", &chereme::notation::Vocabulary::builtin(), "lsf");
/// # let clip = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap().track.clip;
/// use edit::{Extent, HandKept, Relocation, Sides};
/// let how = Relocation { sides: Sides::Right, extent: Extent::whole(&clip), kept: HandKept::Global };
/// let moved = edit::relocated(&clip, &signer, DVec3::new(0.1, 0.05, 0.0), &how).unwrap();
/// let places = [&clip, &moved.clip].map(|c| edit::mean_place(c, &signer, Sides::Right, &how.extent).unwrap());
/// assert!((places[1] - places[0] - DVec3::new(0.1, 0.05, 0.0)).length() < 1e-4);
/// ```
pub fn relocated(clip: &Clip, signer: &Signer, by: DVec3, how: &Relocation) -> Result<Moved, Error> {
    if !by.is_finite() {
        return Err(Error::new("the place to sign at is not a place"));
    }
    moved(clip, signer, (how.sides, how.kept), &how.extent, |_, wrist| wrist + by)
}

/// The clip with its acting wrists moved so that their mean place ([`mean_place`]) is the target (model space, metres).
///
/// # Errors
/// As [`relocated`].
pub fn relocated_to(clip: &Clip, signer: &Signer, target: DVec3, how: &Relocation) -> Result<Moved, Error> {
    let place = mean_place(clip, signer, how.sides, &how.extent)?;
    relocated(clip, signer, target - place, how)
}

/// Where a sign is made: the mean place of its wrist, or of the point midway between both, over the frames in which the
/// extent holds fully (all frames, where it holds in none); model space, metres.
///
/// # Errors
/// A clip of another rig.
pub fn mean_place(clip: &Clip, signer: &Signer, sides: Sides, extent: &Extent) -> Result<DVec3, Error> {
    fits(clip, signer)?;
    let paths = paths(clip, signer, sides.each());
    let weights = extent.weights(clip);
    let none = weights.iter().all(|w| *w < 1.0);
    let held: Vec<usize> = (0..weights.len()).filter(|&i| none || weights[i] >= 1.0).collect();
    let sum: DVec3 = paths.iter().flat_map(|path| held.iter().map(|&i| path[i])).sum();
    Ok(sum / (held.len() * paths.len()) as f64)
}
