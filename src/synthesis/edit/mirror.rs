//! One arm for the other: mirror, swap, and the whole body reflected (Naert et al. 2021, §6, figure 12).
//!
//! The paper's *mirror* copies one arm onto the other, so that a one-handed sign becomes two-handed: twice is once.
//! Its *swap* exchanges what the two arms do. A *reflection* of the whole body is neither: trunk, gaze and face go along.
//!
//! # Conventions
//! An arm is everything from the clavicle outwards. Arms are reflected relative to the trunk: where it is turned,
//! the copy is the mirror image in the trunk's own plane. On a symmetric rig, such as the avatar's, the wrists are mirror
//! images exactly; on another they miss by the difference of its bones.

use super::{fits, remade};
use crate::body::channel::Channels;
use crate::body::reflection::Reflection;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;

/// The clip with one arm's motion copied onto the other, reflected: arm, wrist and fingers.
///
/// The arm that is copied, and everything else, stays bit for bit; so mirrored twice is mirrored once.
///
/// # Errors
/// A clip of another rig.
///
/// ```
/// # use chereme::{body::reflection::reflected, motion::{clip::{Clip, Frame}, pose::LocalPose}, time::Fps};
/// # use glam::DQuat;
/// # let signer = chereme::avatar::signer().unwrap();
/// # let mut pose = LocalPose::rest(&signer.skeleton);
/// use chereme::{phonology::Side, synthesis::edit::mirrored};
/// let [right, left] = [Side::Right, Side::Left].map(|side| signer.arm(side).upper);
/// pose.set(right, DQuat::from_rotation_z(1.0));
/// # let frames = vec![Frame { pose, weights: vec![0.0; signer.morphs.len()] }];
/// # let clip = Clip::new(signer.skeleton.clone(), Fps::DEFAULT, signer.morphs.clone(), frames).unwrap();
/// let both = mirrored(&clip, &signer, Side::Right).unwrap();
/// assert_eq!(both.frames()[0].pose.rotation(left), DQuat::from_rotation_z(-1.0));
/// ```
pub fn mirrored(clip: &Clip, signer: &Signer, from: Side) -> Result<Clip, Error> {
    exchanged(clip, signer, &[from.other()])
}

/// The clip with what the two arms do exchanged, reflected; trunk, head, face and legs stay bit for bit.
///
/// # Errors
/// A clip of another rig.
pub fn swapped(clip: &Clip, signer: &Signer) -> Result<Clip, Error> {
    exchanged(clip, signer, &[Side::Left, Side::Right])
}

/// The clip in a mirror: the root's way, every joint, the eyes, and the face's left and right morphs.
///
/// ```
/// # use chereme::{motion::{clip::{Clip, Frame}, pose::LocalPose}, time::Fps};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let mut frames = vec![Frame { pose: LocalPose::rest(&signer.skeleton), weights: vec![0.0; signer.morphs.len()] }];
/// # let morph = |name: &str| signer.morphs.iter().position(|m| m == name).unwrap();
/// frames[0].weights[morph("cheek-left-puff")] = 1.0;
/// # let clip = Clip::new(signer.skeleton.clone(), Fps::DEFAULT, signer.morphs.clone(), frames).unwrap();
/// let seen = chereme::synthesis::edit::reflected(&clip);
/// assert_eq!(seen.frames()[0].weights[morph("cheek-right-puff")], 1.0);
/// ```
pub fn reflected(clip: &Clip) -> Clip {
    let reflection = Reflection::new(clip.skeleton(), clip.morphs());
    remade(clip, clip.frames().iter().map(|frame| reflection.frame(frame)).collect())
}

/// How far a hand goes beyond the midline of the trunk at most, metres; below 0 where it never does.
///
/// Above 0 a mirrored copy of that hand meets it, or passes through it: worth a warning.
///
/// # Errors
/// A clip of another rig.
pub fn beyond_midline(clip: &Clip, signer: &Signer, side: Side) -> Result<f64, Error> {
    fits(clip, signer)?;
    let skeleton = clip.skeleton();
    let arm = signer.arm(side);
    let trunk = skeleton[arm.clavicle].parent.unwrap_or(arm.clavicle);
    let fingers = signer.hand(side).joints();
    let beyond = clip.frames().iter().flat_map(|frame| {
        let model = frame.pose.to_model(skeleton);
        let (origin, turn) = (model.position(trunk), model.rotation(trunk).conjugate());
        let joints = std::iter::once(arm.hand).chain(fingers);
        joints.map(|j| -(turn * (model.position(j) - origin)).x * side.sign()).collect::<Vec<_>>()
    });
    Ok(beyond.fold(f64::NEG_INFINITY, f64::max))
}

/// The clip with some limbs in the mirror image of the other one's rotations.
fn exchanged(clip: &Clip, signer: &Signer, to: &[Side]) -> Result<Clip, Error> {
    fits(clip, signer)?;
    let reflection = Reflection::new(clip.skeleton(), clip.morphs());
    let limbs: Vec<JointId> = to.iter().flat_map(|s| Channels::of(signer, *s).limb().collect::<Vec<_>>()).collect();
    // A reflection keeps on which side of each other neighbouring quaternions are, so no sign needs mending.
    let frames = clip.frames().iter().map(|source| {
        let mut frame = source.clone();
        for joint in &limbs {
            frame.pose.set(*joint, reflection.seen(*joint, &source.pose));
        }
        frame
    });
    Ok(remade(clip, frames.collect()))
}
