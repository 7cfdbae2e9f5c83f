//! A gloss line becomes one motion: the line is read against the lexicon, the plan that it means is signed.
//!
//! `cargo run --example gloss_line` prints when each gloss is signed.

use chereme::avatar;
use chereme::diagnostics::Error;
use chereme::notation::lexicon::embedded;
use chereme::notation::{Lexicon, Vocabulary};
use chereme::phonology::operator::Tables;
use chereme::score::gloss::{Known, Settings, read};
use chereme::synthesis::{Grammar, Options, synthesize_plan};

/// The glosses of the strong hand, one a line, with start and end in seconds.
pub fn glosses() -> Result<String, Error> {
    let (grammar, vocabulary) = (Grammar::builtin(), Vocabulary::builtin());
    let tables = Tables { locations: &grammar.locations, movements: &grammar.movements };
    let mut lexicon = Lexicon::default();
    // What `add` and `link` find wrong in the texts stays in `checked`.
    let mut checked = lexicon.add(embedded(), &vocabulary);
    lexicon.link(&tables, &mut checked);
    let known = Known { lexicon: &lexicon, vocabulary: &vocabulary, tables };
    let reading =
        read("BONJOUR, {brows raised: BOL@left} IX(BOL) CLAIR[inverted] fs(LSF)", &known, &Settings::default());
    let track = synthesize_plan(&reading.plan, &grammar, &avatar::signer()?, &Options::default())?.track;
    let tier = track.tier("RH Gloss").ok_or_else(|| Error::new("nothing is signed"))?;
    Ok(tier.values().iter().map(|v| format!("{:5.2} {:5.2}  {}\n", v.start.0, v.end.0, v.label)).collect())
}

fn main() -> Result<(), Error> {
    print!("{}", glosses()?);
    Ok(())
}
