//! `chereme explain`

use super::{Failure, Sources, files, gloss, terminal, world};
use crate::notation::{Tongue, Vocabulary, explain_in};
use crate::phonology::LocationInventory;
use crate::score::gloss::{Settings, explain as explain_line};
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme explain BOL\n  chereme explain BOL --language lsf\n  chereme explain bol.sign\n  chereme explain --lang fr BOL\n  chereme explain \"BOL@left TRAVAIL++\""
)]
pub(super) struct Explain {
    /// The name of a sign, a gloss line, a file, or - for standard input
    #[arg(value_name = "NAME|LINE|FILE")]
    what: String,
    /// The language of the sign, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// The language of the words: en or fr; gloss lines are explained in English only
    #[arg(long, value_name = "LANG", default_value = "en")]
    lang: Words,
}

/// The language of the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Words {
    /// English
    En,
    /// French
    Fr,
}

impl Words {
    fn tongue(self, places: &LocationInventory) -> Tongue<'_> {
        match self {
            Words::En => Tongue::English,
            Words::Fr => Tongue::French(places),
        }
    }
}

impl Explain {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let grammar = world::grammar(sources)?;
        let vocabulary = Vocabulary::of(&grammar.handshapes, &grammar.locations, &grammar.expressions);
        let tongue = self.lang.tongue(&grammar.locations);
        let file = self.what == "-" || self.what.ends_with(".sign") || Path::new(&self.what).is_file();
        if !file {
            let lexicon = world::lexicon(sources, &vocabulary)?;
            if gloss::is_line(&self.what, &lexicon) {
                let settings = Settings { language: self.language.clone(), ..Settings::default() };
                let reading = gloss::read_line(&self.what, &lexicon, &grammar, &vocabulary, &settings);
                terminal::out(&explain_line(&reading));
                return if reading.has_faults() { Err(Failure::Faults(None)) } else { Ok(()) };
            }
            let found = lexicon.find(&self.what, self.language.as_deref());
            let entry = found.map_err(|e| Failure::Faults(Some(e.to_string())))?;
            terminal::out(&explain_in(&entry.sign, entry.derived.as_ref(), tongue));
            return Ok(());
        }
        let texts = files::read_all(&[PathBuf::from(&self.what)])?;
        let (described, faults) = world::described(sources, &vocabulary, texts)?;
        let all: Vec<String> = described.iter().map(|d| explain_in(&d.sign, d.from.as_ref(), tongue)).collect();
        terminal::out(&all.join("\n"));
        if faults { Err(Failure::Faults(None)) } else { Ok(()) }
    }
}
