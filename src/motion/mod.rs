//! Skeletons, poses and clips, and the mathematics of moving between them.
//!
//! Nothing here knows what a sign is.
//!
//! # Conventions
//! Right-handed, Y up, the signer faces +Z and the signer's left is +X. Metres, seconds, radians.
//! *Local* rotations are relative to the parent joint; *model* positions and rotations are relative
//! to the floor between the feet. The two are different types ([`pose::LocalPose`], [`pose::ModelPose`]).

pub mod arm;
pub mod carry;
pub mod clip;
pub mod curve;
pub mod difference;
pub mod easing;
pub mod fabrik;
pub mod point;
pub mod pose;
pub mod profile;
pub mod reach;
pub mod rotation;
pub mod short_arc;
pub mod skeleton;
pub mod two_bone;
