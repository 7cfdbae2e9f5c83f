//! `chereme evaluate lags`: which channel of the hand ends first.

use super::super::Failure;
use super::interpolation::checked;
use super::output::Output;
use super::takes::{Take, each};
use crate::evaluation::lags::{Rule, find, print, summarise};
use crate::format::svg;
use crate::time::Seconds;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme evaluate lags takes/                     medians, as defaults for synthesis\n  chereme evaluate lags takes/ -o lags.csv -o lags.svg\n  chereme evaluate lags body.bvh --rest 0.05\n\nEach movement of a wrist is paired with the change of configuration and the turn of the palm at the same time; their ends are where the speed\nfalls to --rest of its peak. A negative lag is earlier than the wrist's stop.\nExit codes: 0 fine, 1 nothing to measure, 2 wrong usage."
)]
pub(super) struct Lags {
    /// Recordings (.bvh) with Mixamo's joint names, folders of them, or - for standard input
    #[arg(value_name = "FILE|DIR", required = true)]
    takes: Vec<PathBuf>,
    /// Rest is at most this share of a movement's peak speed
    #[arg(long, value_name = "SHARE", default_value_t = Rule::default().rest)]
    rest: f64,
    /// Paths are smoothed by a Gaussian of this standard deviation, seconds
    #[arg(long, value_name = "SECONDS", default_value_t = Rule::default().smoothing.0)]
    smooth: f64,
    /// Of the bootstrap
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    #[command(flatten)]
    output: Output,
}

impl Lags {
    pub(super) fn run(&self) -> Result<(), Failure> {
        checked(self.rest, self.smooth)?;
        self.output.check()?;
        let rule = Rule { rest: self.rest, smoothing: Seconds(self.smooth), ..Rule::default() };
        let mut stops = Vec::new();
        let work = |take: &Take| match take {
            Take::Clip(name, clip) => find(name, clip, &rule),
            Take::Markers(_) => Vec::new(),
        };
        each(&self.takes, self.output.quiet, work, |found| stops.extend(found))?;
        if stops.is_empty() {
            return Err(Failure::Faults(Some(
                "there is no movement of a wrist from rest to rest in what was read".into(),
            )));
        }
        let summaries = summarise(&stops, self.seed);
        let figure = || svg::chart::write(&print::chart(&stops));
        self.output.write(&print::text(&stops, &summaries, &rule), || print::csv(&stops), figure)
    }
}
