//! The signer's body: anatomical angles and named places on a rig.

pub mod arm;
mod landmark_table;
pub mod hand;
pub mod landmarks;
pub mod signer;
