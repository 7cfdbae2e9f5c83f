//! GLB: the binary form of glTF 2.0, in which the avatar is kept and motion goes out to 3D programs.
//!
//! [`read::read`] takes the mesh and the skeleton of an avatar out of a file; what a glTF file may
//! hold besides (textures, cameras, animations) is passed over. [`write()`] gives the avatar a motion.
//!
//! # Conventions
//! Those of glTF, which are also the crate's: metres, seconds, right-handed, Y up, quaternions as
//! x, y, z, w.
//!
//! # What is refused
//! glTF 1, buffers outside the file, compressed meshes, primitives that are not triangle lists.

mod accessor;
mod container;
mod document;
pub mod read;
mod rig;
mod samples;
mod write;

pub use read::{GlbJoint, GlbModel, GlbMorph, GlbPart, morph_names};
pub use rig::Rig;
pub use write::{write, write_all};
