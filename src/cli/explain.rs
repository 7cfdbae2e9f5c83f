//! `chereme explain`

use super::signs::Finder;
use super::{Failure, Sources, gloss, terminal, world};
use crate::notation::{Tongue, explain_in};
use crate::phonology::LocationInventory;
use crate::score::gloss::{Settings, explain as explain_line};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme explain BOL\n  chereme explain BOL --language lsf\n  chereme explain bol.sign\n  chereme explain haus.sigml\n  chereme explain hamflathand,hamextfingeru,hampalmd,hamchest\n  chereme explain --lang fr BOL\n  chereme explain \"BOL@left TRAVAIL++\""
)]
pub(super) struct Explain {
    /// The name of a sign, a gloss line, a file or folder in any notation, a string of HamNoSys (symbols, or their names joined by
    /// commas), or - for standard input
    #[arg(value_name = "NAME|LINE|FILE|STRING")]
    what: String,
    /// The language of the sign, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// The language of the words: en or fr; gloss lines are explained in English only
    #[arg(long, value_name = "LANG", default_value = "en")]
    lang: Lang,
}

/// The language of the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Lang {
    /// English
    En,
    /// French
    Fr,
}

impl Lang {
    fn tongue(self, places: &LocationInventory) -> Tongue<'_> {
        match self {
            Lang::En => Tongue::English,
            Lang::Fr => Tongue::French(places),
        }
    }
}

impl Explain {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let grammar = world::grammar(sources)?;
        let words = world::words(&grammar);
        let mut finder = Finder::new(sources, &words, self.language.as_deref());
        if let Some(lexicon) = finder.named(&self.what)?.filter(|lexicon| gloss::is_line(&self.what, lexicon)) {
            let settings = Settings { language: self.language.clone(), ..Settings::default() };
            let reading = gloss::read_line(&self.what, lexicon, &grammar, &words.vocabulary, &settings);
            terminal::out(&explain_line(&reading));
            return if reading.has_faults() { Err(Failure::Faults(None)) } else { Ok(()) };
        }
        let tongue = self.lang.tongue(&grammar.locations);
        let found = finder.find(&self.what)?;
        let all: Vec<String> = found.iter().map(|f| explain_in(&f.sign, f.from.as_ref(), tongue)).collect();
        terminal::out(&all.join("\n"));
        if finder.faulty { Err(Failure::Faults(None)) } else { Ok(()) }
    }
}
