//! `chereme check`

use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::{Severity, Source};
use std::collections::HashMap;
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
        let vocabulary = world::vocabulary(sources)?;
        let texts = files::read_all(&self.paths)?;
        let mut bytes: HashMap<String, _> =
            texts.iter().filter_map(|t| t.fault.clone().map(|f| (t.source.name.clone(), f))).collect();
        let texts: Vec<Source> = texts.into_iter().map(|t| t.source).collect();
        let (_, checked) = world::with_texts(sources, &vocabulary, texts)?;
        let (mut signs, mut faults, mut warnings) = (0, 0, 0);
        for text in &checked {
            let mut all = text.diagnostics.clone();
            all.extend(bytes.remove(&text.source.name));
            all.sort_by_key(|d| d.span.start);
            signs += text.signs;
            faults += all.iter().filter(|d| d.severity == Severity::Fault).count();
            warnings += all.iter().filter(|d| d.severity == Severity::Warning).count();
            terminal::tell(&all, &text.source);
        }
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
