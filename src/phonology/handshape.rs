//! Handshapes: the inventory (`grammar/handshapes.ron`), and the joint angles a description comes to.
//!
//! A handshape is features: how each finger is bent, spread and crossed, and where the thumb stands or what
//! it touches. Names (inventory rows, letters, HamNoSys classes) stand for such values. The angles in the
//! table were made on a generic hand; each shape was then solved on the avatar's mesh, and the solved angles
//! are what [`HandshapeInventory::angles`] gives.
//!
//! # Conventions
//! Radians. Flexion is positive toward the palm; abduction is positive away from the middle finger (for the
//! middle finger itself: toward the thumb) and is meant as it stands, that is after a bent finger has lost
//! the share 1 − cos(MCP) of its spread. The thumb's metacarpal points to
//! d = (sin ρ cos π, cos ρ cos π, sin π) in the hand's axes (toward the thumb's side, toward the fingers, out
//! of the palm), ρ radial and π palmar abduction; pronation turns the thumb's flexion axis about d.
//! The angles hold for both hands: the left is the right one's mirror image.

pub mod angles;
pub mod change;
mod fingers;
pub mod inventory;
pub mod limits;
mod row;
pub mod shape;
mod thumb;
mod written;

pub use angles::{FingerAngles, HandAngles, ThumbAngles};
pub use inventory::{HandshapeInventory, NotFound};
pub use limits::{FingerLimits, HandLimits, Limits};
pub use shape::{Handshape, Solved, ThumbGoal, ThumbPart, ThumbStance, ThumbTarget};
