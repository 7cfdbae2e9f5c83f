//! Retargeting: a motion of somebody's skeleton on our rig, and ours on theirs.
//!
//! Mode [`Mode::Directions`] keeps the directions of bones: what looks up looks up, whatever the bones' lengths. Mode
//! [`Mode::Contacts`] keeps where fingertips are: wrists are put where they are from the shoulders, in arm lengths, and
//! the fingers are solved again so that the tips lie as they do about the wrist, in lengths of the hand. Hands without a body (from a sensor) are placed before the
//! signer, and the arm follows by inverse kinematics.
//!
//! # Conventions
//! A stranger's clip is in metres in the file's own axes ([`Axes`]); ours is Y up, facing +Z. What a recording does not
//! cover stays as in the pose that is given for it. The skeleton's hips keep the line of the hips; their own bones have no direction of
//! their own, because three begin there.

pub mod axes;
mod contacts;
mod finger;
mod humanoid;
mod inward;
pub mod names;
mod outward;
mod report;
mod root;
mod t_pose;

pub use axes::{Axes, SignedAxis, propose_axes};
pub use humanoid::Humanoid;
pub use inward::retarget;
pub use outward::to_theirs;
pub use report::{Part, PartError, Report};
pub use t_pose::{begins_with_t_pose, stands};

use crate::motion::clip::Clip;
use crate::motion::pose::LocalPose;

/// What of a body a recording has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    /// Hips, trunk and head.
    pub body: bool,
    /// Left and right arm, from the shoulder to the wrist.
    pub arms: [bool; 2],
    /// Left and right hand, with at least four digits.
    pub hands: [bool; 2],
}

/// What is kept of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// The directions of bones.
    #[default]
    Directions,
    /// The places of wrists and fingertips.
    Contacts,
}

/// Knobs of retargeting.
#[derive(Debug, Clone)]
pub struct Options {
    /// What is kept.
    pub mode: Mode,
    /// How many frames at the start are left out, such as an inserted T-pose.
    pub skip_frames: usize,
    /// How our body stands where the recording has nothing of it.
    pub rest: LocalPose,
}

/// A motion on our rig.
#[derive(Debug, Clone)]
pub struct Retargeted {
    /// The motion, without morphs.
    pub clip: Clip,
    /// What of it comes from the recording.
    pub covers: Coverage,
    /// How near it is.
    pub report: Report,
}
