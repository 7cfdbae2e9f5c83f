//! `chereme check`: the faults of texts, and with `--motion` of the motion that they become.

mod motion;
mod reasons;
mod report;

use super::parallel::Loudness;
use super::world::{Checkup, Described, Linking, Texts};
use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::Severity;
use crate::time::Fps;
use report::Report;
use std::path::PathBuf;

/// How many faults and warnings are told without `--all`.
const TOLD: usize = 50;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme check lexicon                     all signs of a folder, in every notation\n  chereme check bol.sign haus.sigml\n  pbpaste | chereme check -\n  chereme check corpus --quiet              the summary: what is wrong how often\n  chereme check corpus --json > report.json\n  chereme check lexicon --motion            sign all of them, and check the motion\n\nExit codes: 0 fine (warnings included), 1 a text has a fault, a sign cannot be signed, or a motion cannot be used; 2 wrong usage."
)]
pub(super) struct Check {
    /// Files, folders (.sign, SiGML, HamNoSys, tables), or - for standard input
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Sign every sign, and check its motion: joints, contacts, orientations, speed, duration
    #[arg(long)]
    motion: bool,
    /// Frames a second of the motion that is checked
    #[arg(long, value_name = "N", default_value_t = 30.0, requires = "motion")]
    fps: f64,
    /// How many cores --motion works on; all without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Tell all faults and warnings, not the first 50 only
    #[arg(long, conflicts_with = "quiet")]
    all: bool,
    /// The summary only
    #[arg(short, long)]
    quiet: bool,
    /// A report for programs, on standard output; nothing else is told
    #[arg(long, conflicts_with_all = ["all", "quiet"])]
    json: bool,
}

impl Check {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let fps = Fps::new(self.fps).ok_or_else(|| {
            Failure::Usage(format!("--fps {}: frames a second lie above 0 and up to {}", self.fps, Fps::MAX))
        })?;
        let grammar = world::grammar(sources)?;
        let words = world::words(&grammar);
        let texts = files::read_all(&self.paths)?;
        let Texts { checkups, signs } = world::read_texts(sources, &words, texts, Linking::Always)?;
        let told = match (self.json || self.quiet, self.all) {
            (true, _) => 0,
            (false, true) => usize::MAX,
            (false, false) => TOLD,
        };
        tell(&checkups, told);
        if signs.is_empty() && !checkups.iter().any(Checkup::has_faults) {
            return Err(Failure::Faults(Some("there is no sign in what was read".to_owned())));
        }
        let mut report = Report::of(&checkups, &signs);
        if self.motion {
            let loudness = if self.quiet || self.json { Loudness::Quiet } else { Loudness::Told };
            let asked = motion::Asked { fps, jobs: self.jobs, loudness };
            report.motion = Some(motion::check(signs, &checkups, &grammar, &asked)?);
        }
        terminal::out(&if self.json { report.json() } else { report.text() });
        if report.is_fine() { Ok(()) } else { Err(Failure::Faults(None)) }
    }
}

/// Tells the first faults and warnings of all texts, and how to see the others.
fn tell(checkups: &[Checkup], most: usize) {
    let mut left = most;
    for checkup in checkups {
        let shown = checkup.diagnostics.len().min(left);
        left -= shown;
        terminal::tell_all(&checkup.diagnostics[..shown], &checkup.text.source);
    }
    let all: usize = checkups.iter().map(|checkup| checkup.diagnostics.len()).sum();
    if most > 0 && all > most {
        let more = all - most;
        terminal::err(&format!("{more} more of {all} faults and warnings: --all tells them, --quiet counts them\n\n"));
    }
}

/// How many signs have warnings: a warning belongs to the last sign that begins before it. The signs stand in the texts' order.
fn warned(checkups: &[Checkup], signs: &[Described]) -> usize {
    let with_warnings = |own: &[Described]| {
        let all = checkups[own[0].text].diagnostics.iter().filter(|d| d.severity == Severity::Warning);
        let mut hit: Vec<usize> = all.map(|d| own.partition_point(|s| s.span.start <= d.span.start)).collect();
        hit.dedup();
        hit.len().min(own.len())
    };
    signs.chunk_by(|a, b| a.text == b.text).map(with_warnings).sum()
}
