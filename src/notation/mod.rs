//! The `.sign` language: text ↔ [`phonology::Sign`](crate::phonology::Sign).
//!
//! A description is written one tier a line, readable aloud; `grammar/notation.ebnf` is the specification.
//! Two stages: [`parse()`] makes a [`syntax::File`] (what was written, with spans and comments), [`lower()`] makes
//! signs of it (what it means); [`raise()`] and [`print()`] go the other way. `parse ∘ print` is the identity.
//!
//! All faults of a text come back at once; a sign with a fault is left out, the rest loads.
//!
//! # Conventions
//! Lengths are written in mm, cm or m, durations in s or ms; keys are counted from 1 in text and from 0 inside.
//! Names of signs are NFC; names are compared without regard to case. This module touches no files.

pub mod explain;
pub mod formats;
pub mod gloss;
pub mod hamnosys;
mod lex;
pub mod lexicon;
pub mod lower;
pub mod parse;
pub mod print;
pub mod raise;
pub mod read;
pub mod sigml;
pub use crate::diagnostics::suggest;
pub mod syntax;
pub mod vocabulary;

pub use explain::{Tongue, explain, explain_derived, explain_in};
pub use lexicon::{Entry, Lexicon};
pub use lower::{Derived, Lowered, Lowering, lower};
pub use parse::parse;
pub use print::print;
pub use raise::{raise, write, write_derived};
pub use read::{Reading, operators, read, source_of_bytes};
pub use vocabulary::{Names, Vocabulary};
