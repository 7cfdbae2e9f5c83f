//! Played backwards: CLAIR becomes FONCÉ, AIMER becomes NE PAS AIMER (Naert et al. 2021, §6, figure 11).

use super::wrists::{Sides, turn_hand};
use super::{fits, remade, rewritten};
use crate::body::channel::Channels;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::rotation::unit;

/// The clip backwards: all channels, face included.
///
/// Twice is the clip itself, bit for bit.
///
/// ```
/// # let signer = chereme::avatar::signer().unwrap();
/// # use chereme::{motion::{clip::{Clip, Frame}, pose::LocalPose}, time::Fps};
/// # let mut frames = vec![Frame { pose: LocalPose::rest(&signer.skeleton), weights: vec![0.0; signer.morphs.len()] }; 2];
/// # frames[1].pose.root_model.y = 2.0;
/// # let clip = Clip::new(signer.skeleton.clone(), Fps::DEFAULT, signer.morphs.clone(), frames).unwrap();
/// use chereme::synthesis::edit::inverted;
/// assert_eq!(inverted(&clip).frames()[0], clip.frames()[1]);
/// assert_eq!(inverted(&inverted(&clip)).frames(), clip.frames());
/// ```
pub fn inverted(clip: &Clip) -> Clip {
    remade(clip, clip.frames().iter().rev().cloned().collect())
}

/// The clip with the movement alone backwards: the arms go their way in reverse, while the fingers form as they
/// formed and the hands face in model space where they faced.
///
/// The placement channel of each frame (clavicle, upper arm, forearm) is that of the frame as far from the other end,
/// relative to the trunk as it is now; the wrist makes up for it. Fingers, trunk, head and face stay bit for bit.
///
/// # Errors
/// A clip of another rig.
pub fn inverted_movement(clip: &Clip, signer: &Signer, sides: Sides) -> Result<Clip, Error> {
    fits(clip, signer)?;
    let channels: Vec<Channels> = sides.each().iter().map(|side| Channels::of(signer, *side)).collect();
    let joints: Vec<_> = channels.iter().flat_map(|c| c.placement.iter().chain(&c.orientation)).copied().collect();
    let last = clip.frames().len() - 1;
    let mut turned = [0.0; 2];
    Ok(rewritten(clip, &joints, |i, pose| {
        let faced = pose.to_model(clip.skeleton());
        let other = &clip.frames()[last - i].pose;
        for joint in channels.iter().flat_map(|c| c.placement) {
            pose.set(joint, other.rotation(joint));
        }
        let carried = pose.to_model(clip.skeleton());
        for &side in sides.each() {
            let arm = signer.arm(side);
            let hand = unit(carried.rotation(arm.fore).conjugate() * faced.rotation(arm.hand));
            turn_hand(arm, hand, &mut turned[side as usize], pose);
        }
    }))
}
