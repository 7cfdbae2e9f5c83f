//! Captured motion as the analyses see it: what fingers, hands and arms do, and where one movement ends and the next begins.
//!
//! [`Movement`] is one thing that moves in one take: the fingertips seen from the wrist, the wrist seen from the chest, the hand on
//! its way. [`cut::transitions`] finds the movements from rest to rest in its speed. Joints are found by Mixamo's names, whatever
//! their prefix; nothing is retargeted.
//!
//! # Conventions
//! Metres, seconds; frames of points, all points of a frame together. Amplitude and speed of several points are the root of the mean
//! square over the points, so one number means the same for a wrist and for five fingertips.

pub mod cut;
mod hand;
mod movement;
mod smooth;

pub use hand::{Hand, hands};
pub use movement::{Kind, Movement, Way};
pub use smooth::{distance, smoothed, speed};
