//! HamNoSys 4 and SiGML: strings of symbols, lists of their names, XML.
//!
//! One tree ([`syntax`]) for all of them; `lower` makes a [`Sign`](crate::phonology::Sign) of it, `raise` goes back.
//! HamNoSys itself is read by [`symbol`], [`lex`] and [`parse`], and written by [`print`](mod@print).

mod kind;
pub mod lex;
pub mod parse;
pub mod symbol;
pub mod syntax;
mod dictionary;
pub mod lower;
pub mod raise;

pub use dictionary::Dictionary;
pub use lower::lower;
pub use raise::{Raised, raise};
