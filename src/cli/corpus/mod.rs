//! `chereme corpus`: corpora of recorded signing.

mod annotate;
mod bases;
mod build;
mod check;
mod disk;
mod find;
mod init;
mod list;
mod motion;
pub(super) mod open;

use super::{Failure, Sources};
use clap::{Args, Subcommand};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    arg_required_else_help = true,
    after_help = "A corpus is a folder with a corpus.yaml, which names its recordings (BVH), their annotations, and what these mean.\n\nExamples:\n  chereme corpus init takes                  look at a folder, and write takes/corpus.yaml\n  chereme corpus check takes                 what is missing or odd, with file, line and column\n  chereme corpus build takes                 make the cache: the motions on our rig\n  chereme corpus list takes                  its recordings\n  chereme corpus find 'configuration~5 duration<1s' takes\n                                             segments, the nearest first\n  chereme corpus bases takes                 signs that differ in the hand configuration only\n  chereme corpus annotate takes -o tiers/    what was annotated and measured, for ELAN\n  chereme corpus init /data/takes -o my/corpus.yaml\n  chereme corpus build my --cache /tmp/cache a corpus whose folder cannot be written to\n\nExit codes: 0 fine (warnings included), 1 faults found, 2 wrong usage."
)]
pub(super) struct Corpus {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Look at a folder of recordings, and write a corpus.yaml that proposes what they are
    Init(init::Init),
    /// Tell everything that is missing or odd about a corpus, all at once
    Check(check::Check),
    /// Make a corpus's cache, or bring it up to date
    Build(build::Build),
    /// List a corpus's recordings
    List(list::List),
    /// Find segments by what is annotated on them, or by an example
    Find(find::Find),
    /// Find signs that share everything but the hand configuration
    Bases(bases::Bases),
    /// Measure motion into tiers, for correction in ELAN
    Annotate(annotate::Annotate),
}

/// A corpus on the command line.
#[derive(Debug, Args)]
pub(super) struct Named {
    /// The corpus: a folder with a corpus.yaml, or such a file
    #[arg(value_name = "CORPUS", default_value = ".")]
    pub(super) path: PathBuf,
}

/// How a corpus is opened.
#[derive(Debug, Args)]
pub(super) struct Opening {
    /// Where the cache is, instead of .chereme beside corpus.yaml
    #[arg(long, value_name = "DIR")]
    pub(super) cache: Option<PathBuf>,
    /// How many cores to work on; all without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) jobs: Option<u16>,
}

impl Corpus {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        match &self.command {
            Command::Init(init) => init.run(),
            Command::Check(check) => check.run(sources),
            Command::Build(build) => build.run(),
            Command::List(list) => list.run(),
            Command::Find(find) => find.run(),
            Command::Bases(bases) => bases.run(),
            Command::Annotate(annotate) => annotate.run(),
        }
    }
}
