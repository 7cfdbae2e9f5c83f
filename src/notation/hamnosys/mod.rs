//! HamNoSys 4 and SiGML: strings of symbols, lists of their names, XML.
//!
//! One tree ([`syntax`]) for all of them; [`lower()`] makes a [`Sign`](crate::phonology::Sign) of it, [`raise()`] goes back.
//! HamNoSys itself is read by [`symbol`], [`lex`] and [`mod@parse`], and written by [`print`](mod@print).

mod dictionary;
mod kind;
pub mod lex;
pub mod lower;
pub mod parse;
pub mod print;
pub mod raise;
pub mod symbol;
pub mod syntax;
pub mod table;

pub use dictionary::Dictionary;
pub use lower::lower;
pub use raise::{Raised, raise};
