//! SiGML: HamNoSys as XML, in its two kinds.
//!
//! H-SiGML (`hns_sign`) is the symbols of a HamNoSys string as a flat list of elements; gestural SiGML (`hamgestural_sign`)
//! is what a parser of HamNoSys comes to, as a tree. Both come to the one tree of [`syntax`](super::hamnosys::syntax).
//!
//! # Conventions
//! - Attributes of gestural SiGML that begin with `second_` are the other end of a value halfway between two.
//! - People write SiGML by hand: elements may come in any order; attributes that nobody defines, that stand on the wrong
//!   element or say what the values show anyway are warnings, not faults. A value that is none of the known ones is a fault,
//!   and so are letters of a direction that contradict each other.
//! - A sign with a fault is left out; the others are read. Messages begin with the gloss of their sign.
//!
//! Document types and entities of one's own are refused, and files that are nested deeper than [`MOST_DEEP`]: no file of
//! signs needs them, and some files that have them are made to exhaust memory.

mod read;
mod words;
mod write;

pub use read::read;
pub use write::{Kind, write};

/// How many elements may stand within each other.
pub const MOST_DEEP: usize = 64;
/// The largest file that is read, in bytes; beyond it, files are to be split.
pub const MOST_BYTES: usize = 32 << 20;
