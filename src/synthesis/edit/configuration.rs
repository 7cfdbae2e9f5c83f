//! Another configuration on the same motion: derived signs and shape specifiers (Naert et al. 2021, §5.1).

use super::{Extent, fits, rewritten};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use crate::phonology::handshape::HandAngles;

/// The clip with a hand's fingers in a configuration over a stretch of time.
///
/// The fifteen finger joints are the configuration's exactly within the extent, and ease joint by joint between it
/// and the source's fingers outside. Every other joint, and so the wrist, stays as it was bit for bit.
///
/// # Errors
/// A clip of another rig.
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # use chereme::phonology::{Side, handshape::HandAngles};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let sign = chereme::notation::read("sign X\n configuration fist-s\n", &chereme::notation::Vocabulary::builtin(), "lsf");
/// # let clip = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap().track.clip;
/// let flat = HandAngles::default();
/// let edited = edit::with_configuration(&clip, &signer, Side::Right, &flat, &edit::Extent::whole(&clip)).unwrap();
/// assert!(signer.hand(Side::Right).angles_of(&edited.frames()[30].pose).max_difference(&flat) < 1e-9);
/// ```
pub fn with_configuration(
    clip: &Clip,
    signer: &Signer,
    side: Side,
    configuration: &HandAngles,
    extent: &Extent,
) -> Result<Clip, Error> {
    fits(clip, signer)?;
    let hand = signer.hand(side);
    let joints = hand.joints();
    let mut shape = clip.frames()[0].pose.clone();
    hand.apply(configuration, &mut shape);
    let weights = extent.weights(clip);
    Ok(rewritten(clip, &joints, |i, pose| {
        let weight = weights[i];
        if weight <= 0.0 {
            return;
        }
        for joint in joints {
            let own = pose.rotation(joint);
            let shaped = shape.rotation(joint);
            let eased = if weight >= 1.0 { shaped } else { ShortArc::new(own, shaped).eased(extent.easing, weight) };
            pose.set(joint, eased);
        }
    }))
}
