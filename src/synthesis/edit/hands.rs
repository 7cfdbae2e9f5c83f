//! Two signs at once, one on each hand (Naert et al. 2021, §6: "the parallel production of two signs").

use super::wrists::paths;
use super::{continue_signs, fits, may_last, remade, swapped};
use crate::body::channel::Channels;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::profile::length;
use crate::phonology::Side;
use crate::time::FrameIndex;

/// One clip on the right arm, another on the left; trunk, head, face and legs are the first one's.
///
/// The second clip is swapped first where it acts with the right hand ([`acts_with`]), and sampled at the first one's
/// rate. The shorter of the two goes on in its last frame until the longer one ends.
///
/// # Errors
/// A clip of another rig; a result that is too long.
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # use chereme::phonology::Side;
/// # let signer = chereme::avatar::signer().unwrap();
/// # let text = "sign X\n configuration flat\n movement up 10cm\n\nsign Y\n configuration fist-s\n";
/// # let read = chereme::notation::read(text, &chereme::notation::Vocabulary::builtin(), "lsf");
/// # let clips: Vec<_> = read.signs.iter().map(|s| synthesize(&s.sign, &Grammar::builtin(), &signer, &Options::default()).unwrap().track.clip).collect();
/// let both = edit::on_each_hand(&clips[0], &clips[1], &signer).unwrap();
/// let swapped = edit::swapped(&clips[1], &signer).unwrap();
/// let left = signer.arm(Side::Left).upper;
/// assert_eq!(both.frames()[40].pose.rotation(left), swapped.frames()[40].pose.rotation(left));
/// ```
pub fn on_each_hand(strong: &Clip, weak: &Clip, signer: &Signer) -> Result<Clip, Error> {
    let exchanged = match acts_with(weak, signer)? {
        Side::Right => Some(swapped(weak, signer)?),
        Side::Left => None,
    };
    joined(strong, exchanged.as_ref().unwrap_or(weak), signer)
}

/// The left arm of one clip in another.
pub(super) fn joined(strong: &Clip, weak: &Clip, signer: &Signer) -> Result<Clip, Error> {
    fits(strong, signer)?;
    fits(weak, signer)?;
    let fps = strong.fps();
    may_last(strong.duration().0.max(weak.duration().0) * fps.get())?;
    let count = strong.frames().len().max(fps.frame_count(weak.duration()));
    let left: Vec<_> = Channels::of(signer, Side::Left).limb().collect();
    let mut frames = Vec::with_capacity(count);
    for i in 0..count {
        let mut frame = strong.frames()[i.min(strong.frames().len() - 1)].clone();
        let other = weak.sample(fps.time_of(FrameIndex(i)));
        for joint in &left {
            frame.pose.set(*joint, other.pose.rotation(*joint));
        }
        frames.push(frame);
    }
    continue_signs(&mut frames, 1);
    Ok(remade(strong, frames))
}

/// The hand that acts in a clip: the one whose wrist goes the longer way, the right one where both go the same.
///
/// # Errors
/// A clip of another rig.
pub fn acts_with(clip: &Clip, signer: &Signer) -> Result<Side, Error> {
    fits(clip, signer)?;
    let ways = paths(clip, signer, &[Side::Right, Side::Left]);
    Ok(if length(&ways[1]) > length(&ways[0]) { Side::Left } else { Side::Right })
}
