//! `chereme check`

use super::world::Linking;
use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::Severity;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme check lexicon\n  chereme check bol.sign assiette.sign\n  pbpaste | chereme check -"
)]
pub(super) struct Check {
    /// Files, folders, or - for standard input
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
}

impl Check {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let words = world::words(&world::grammar(sources)?);
        let texts = files::read_all(&self.paths)?;
        let read = world::read_texts(sources, &words, texts, Linking::Always)?;
        let (mut faults, mut warnings) = (0, 0);
        for checkup in &read.checkups {
            let all = &checkup.diagnostics;
            faults += all.iter().filter(|d| d.severity == Severity::Fault).count();
            warnings += all.iter().filter(|d| d.severity == Severity::Warning).count();
            terminal::tell(all, &checkup.text.source);
        }
        let (signs, checked) = (read.signs.len(), &read.checkups);
        if signs == 0 && faults == 0 {
            return Err(Failure::Faults(Some("there is no sign in what was read".to_owned())));
        }
        let mut summary = format!(
            "{} in {}: {}",
            terminal::count(signs, "sound sign"),
            terminal::count(checked.len(), "file"),
            if faults == 0 { "no faults".to_owned() } else { terminal::count(faults, "fault") }
        );
        if warnings > 0 {
            summary.push_str(&format!(", {}", terminal::count(warnings, "warning")));
        }
        terminal::out(&format!("{summary}\n"));
        if faults > 0 { Err(Failure::Faults(None)) } else { Ok(()) }
    }
}
