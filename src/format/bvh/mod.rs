//! BVH (Biovision hierarchy): the text file of joints and angles that motion capture is exchanged in.
//!
//! Nobody owns the format and every program writes its own: other orders of channels, positions on
//! inner joints, leaves without an `End Site`, a row count that is not what `Frames:` says. [`read()`]
//! takes all of these as they are into a [`Bvh`], which keeps the file's units and numbers;
//! [`to_clip`] makes a [`Clip`](crate::motion::clip::Clip) of it. [`from_clip`] and [`print()`] go the
//! other way, and [`write()`] is both.
//!
//! # Conventions
//! - A joint's rotation is the product of its rotation channels in the order in which they are listed:
//!   `Zrotation Xrotation Yrotation` is `Rz · Rx · Ry`. Angles are degrees.
//! - A joint's position channels stand in place of its `OFFSET` (so does Blender; three.js adds both). What we
//!   write means the same in both, because its root has the offset 0 0 0.
//! - The format has no unit of length. What we write is in centimetres, Y up, facing +Z, at rest in a T-pose with
//!   identity rotations.
//!
//! # What is refused
//! Numbers that are not finite, rows of another length than the joints have channels, braces that do not match,
//! channels unknown or listed twice, a frame time that is not above 0. Each with line and column; nothing is guessed.
//! Memory is in proportion to the text, whatever its counts say, and depth of nesting costs no stack.

#[cfg(feature = "bvh_anim")]
mod bvh_anim;
mod clip;
mod data;
mod decimal;
mod euler;
mod hierarchy;
mod motion;
mod number;
mod onto;
mod print;
mod read;
mod unit;
mod words;
mod write;

pub use clip::{ClipOptions, Converted, Roots, to_clip};
pub use data::{Axis, Bvh, Channel, Joint};
pub use onto::onto;
pub use print::print;
pub use read::{Reading, read, source_of_bytes};
pub use unit::{UnitProposal, propose_unit};
pub use write::{Options, TwistLeaves, from_clip, write};
