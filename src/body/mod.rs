//! The signer's body: anatomical angles and named places on a rig.

pub mod arm;
pub mod channel;
pub mod hand;
pub mod hand_skin;
mod landmark_table;
pub mod landmarks;
pub mod measure;
pub mod reflection;
pub mod retarget;
pub mod signer;
pub mod signing_space;
pub mod skin;
pub mod solid;
