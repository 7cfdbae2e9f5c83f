//! Operators on motion: new clips made from old ones (Naert et al. 2021, §4.1, 5.1 and 6).
//!
//! A captured sign has no description to be changed, so its motion is: reversed, mirrored, exchanged, repeated, given
//! another configuration or another place. Each operator changes the channels that it names ([`crate::body::channel`])
//! and leaves every other joint as it was, bit for bit. A described sign is recombined as a description instead
//! (`phonology`), and both ways should come to one motion.
//!
//! # Conventions
//! An operator on a [`Clip`] takes the whole clip as the sign; those in [`track`] know from the phase tiers what is
//! stroke and what is transition, and carry the tiers along. Model space, metres, seconds from the clip's start.
//! Neighbouring frames of every result have quaternions on one side (dot ≥ 0).
//!
//! # What they refuse
//! A clip of another rig than the signer's, and results longer than [`MOST_FRAMES`].

mod configuration;
mod extent;
mod hands;
mod invert;
mod mirror;
mod relocate;
mod repeat;
mod size;
mod speed;
pub mod track;
mod way;
mod wrists;

pub use configuration::with_configuration;
pub use extent::Extent;
pub use hands::{acts_with, on_each_hand};
pub use invert::{inverted, inverted_movement};
pub use mirror::{beyond_midline, mirrored, reflected, swapped};
pub use relocate::{Relocation, mean_place, relocated, relocated_to};
pub use repeat::{Repetition, repeated};
pub use size::{About, Scaling, sized};
pub use speed::at_speed;
pub(super) use way::Way;
pub(super) use wrists::turn_hand;
pub use wrists::{HandKept, Moved, Sides};

use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::rotation::continuous;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;
use glam::DVec3;
use std::sync::Arc;

/// The longest clip that an operator makes: some 27 minutes at 60 frames a second.
pub const MOST_FRAMES: usize = 100_000;

/// A clip of the same rig, rate and morphs with other frames.
fn remade(clip: &Clip, frames: Vec<Frame>) -> Clip {
    Clip::new(clip.skeleton().clone(), clip.fps(), clip.morphs().clone(), frames)
        .expect("frames made of a clip's frames fit its rig, and there is at least one")
}

/// A clip with the rotations of some joints made anew in each frame; nothing else changes.
///
/// The rotation nearer in sign to the frame before is written, so a joint that keeps its rotation keeps its bits.
pub(super) fn rewritten(clip: &Clip, joints: &[JointId], mut each: impl FnMut(usize, &mut LocalPose)) -> Clip {
    let mut frames: Vec<Frame> = Vec::with_capacity(clip.frames().len());
    for (i, source) in clip.frames().iter().enumerate() {
        let mut frame = source.clone();
        each(i, &mut frame.pose);
        let before = frames.last().map_or(&source.pose, |f| &f.pose);
        for joint in joints {
            frame.pose.set(*joint, continuous(before.rotation(*joint), frame.pose.rotation(*joint)));
        }
        frames.push(frame);
    }
    remade(clip, frames)
}

/// Turns signs of quaternions from a frame on so that each is nearest to the one before.
pub(super) fn continue_signs(frames: &mut [Frame], from: usize) {
    for i in from.max(1)..frames.len() {
        let (before, after) = frames.split_at_mut(i);
        for (q, p) in after[0].pose.rotations.iter_mut().zip(&before[i - 1].pose.rotations) {
            *q = continuous(*p, *q);
        }
    }
}

/// Where a wrist is in every frame, model space, metres.
pub(super) fn wrist_path(clip: &Clip, signer: &Signer, side: Side) -> Vec<DVec3> {
    wrists::paths(clip, signer, &[side]).remove(0)
}

/// Whether a clip's joints are the signer's.
fn fits(clip: &Clip, signer: &Signer) -> Result<(), Error> {
    let (a, b) = (clip.skeleton(), &signer.skeleton);
    if Arc::ptr_eq(a, b) || a.joints() == b.joints() {
        return Ok(());
    }
    Err(Error::new("the clip moves another rig than the signer's: retarget it first"))
}

/// Whether a result of so many frames may be made.
pub(super) fn may_last(frames: f64) -> Result<usize, Error> {
    if frames <= MOST_FRAMES as f64 {
        return Ok(frames as usize);
    }
    Err(Error::new(format!("the result would have {frames:.0} frames, more than {MOST_FRAMES}")))
}
