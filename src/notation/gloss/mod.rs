//! Gloss lines: what is signed, in order, as linguists transcribe it.
//!
//! A line is glosses with what is done to each sign: where it is made (`BOL@left`), how often (`TRAVAIL++`), how it is
//! changed (`CLAIR[inverted]`); pointing (`IX(MAISON)`), fingerspelling (`fs(LSF)`), holds (`<HOLD 0.5s>`), and what the
//! face does meanwhile (`{brows raised: TOI NOM QUOI}`). `grammar/notation.ebnf` is the specification, section "Gloss
//! lines". Here text becomes a [`syntax::GlossLine`] and back; what the glosses mean is the affair of `score`.
//!
//! All faults of a line come back at once; an item with a fault is left out.

pub mod parse;
pub mod print;
pub mod syntax;

pub use parse::parse;
pub use print::print;
