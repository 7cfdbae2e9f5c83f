//! `chereme corpus build`

use super::super::Failure;
use super::super::parallel::Loudness;
use super::super::terminal::{self, count};
use super::open::{TOLD, open, tell};
use super::{Named, Opening};
use crate::corpus::examine::is_fault;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The cache is only ever a copy: it may be deleted, and is made anew. It is written aside and renamed, so a build that is\nstopped leaves the old one. Only recordings whose files or settings changed are made again.\n\nExamples:\n  chereme corpus build takes\n  chereme corpus build /data/takes --cache /tmp/cache"
)]
pub(super) struct Build {
    #[command(flatten)]
    named: Named,
    #[command(flatten)]
    opening: Opening,
    /// Tell nothing but the result, and draw no bar
    #[arg(short, long)]
    quiet: bool,
}

impl Build {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let loudness = if self.quiet { Loudness::Quiet } else { Loudness::Told };
        let (library, tally) = open(&self.named, &self.opening, loudness)?;
        let faults: Vec<_> = tally.findings.iter().filter(|found| is_fault(&found.diagnostic)).collect();
        if !self.quiet {
            tell(&faults, TOLD, "`chereme corpus check --all` tells them");
        }
        let seconds: f64 = (0..library.len()).map(|at| library.duration(at).0).sum();
        let mut text = format!(
            "{}, {:.1} minutes: {} made, {} as they were",
            count(library.len(), "recording"),
            seconds / 60.0,
            tally.made,
            tally.kept
        );
        let warnings = tally.findings.len() - faults.len();
        if tally.failed > 0 {
            text.push_str(&format!("; {} left out", tally.failed));
        }
        if tally.failed > 0 || warnings > 0 {
            text.push_str("; `chereme corpus check` tells what is odd");
        }
        terminal::out(&(text + "\n"));
        if tally.failed == 0 && faults.is_empty() { Ok(()) } else { Err(Failure::Faults(None)) }
    }
}
