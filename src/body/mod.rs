//! The signer's body: where named places and the hand's contact points lie on the avatar's skin.
//!
//! # Conventions
//! Model space: right-handed, Y up, the signer faces +Z, the signer's left is +X, metres.

pub mod landmarks;
