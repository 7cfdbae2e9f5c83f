//! New signs from a known one: another configuration, played backwards, moved, with the hands exchanged.
//!
//! `cargo run --example recombine` prints their descriptions.

use chereme::diagnostics::Error;
use chereme::notation::lexicon::embedded;
use chereme::notation::{Lexicon, Vocabulary, write};
use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::operator::{Operator, Tables, apply};
use chereme::phonology::{Configuration, Forced, Keys, LocationInventory, Place, Relocation, Space};

/// The snail of the lexicon and what is made from it, as `.sign` text.
pub fn descriptions() -> Result<String, Error> {
    let mut lexicon = Lexicon::default();
    lexicon.add(embedded(), &Vocabulary::builtin());
    let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
    let tables = Tables { locations: &locations, movements: &movements };
    let left = Place::Space(Space { left: 1, high: 0, far: 0 });
    let operators = [
        Operator::Configuration(None, Keys::one(Configuration::named("U"))),
        Operator::Inverted,
        Operator::At(Relocation { place: left, forced: Forced::No }),
        Operator::Swapped,
    ];
    let snail = &lexicon.find("ESCARGOT", Some("lsf"))?.sign;
    let mut text = write(snail);
    for operator in &operators {
        text += &write(&apply(operator, snail, &tables)?.sign);
    }
    Ok(text)
}

fn main() -> Result<(), Error> {
    print!("{}", descriptions()?);
    Ok(())
}
