//! `chereme explain`

use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::Severity;
use crate::notation::lexicon::language_of_path;
use crate::notation::{explain, read};
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme explain BOL\n  chereme explain BOL --language lsf\n  chereme explain bol.sign"
)]
pub(super) struct Explain {
    /// The name of a sign, a file, or - for standard input
    #[arg(value_name = "NAME|FILE")]
    what: String,
    /// The language of the sign, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
}

impl Explain {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let vocabulary = world::vocabulary(sources)?;
        let file = self.what == "-" || self.what.ends_with(".sign") || Path::new(&self.what).is_file();
        if !file {
            let lexicon = world::lexicon(sources, &vocabulary)?;
            let found = lexicon.find(&self.what, self.language.as_deref());
            let entry = found.map_err(|e| Failure::Faults(Some(e.to_string())))?;
            terminal::out(&explain(&entry.sign));
            return Ok(());
        }
        let mut faults = false;
        let mut first = true;
        for text in files::read_all(&[PathBuf::from(&self.what)])? {
            let mut reading = read(&text.source.text, &vocabulary, language_of_path(&text.source.name));
            reading.diagnostics.extend(text.fault);
            terminal::tell(&reading.diagnostics, &text.source);
            faults |= reading.diagnostics.iter().any(|d| d.severity == Severity::Fault);
            for lowered in &reading.signs {
                let gap = if std::mem::take(&mut first) { "" } else { "\n" };
                terminal::out(&format!("{gap}{}", explain(&lowered.sign)));
            }
        }
        if faults { Err(Failure::Faults(None)) } else { Ok(()) }
    }
}
