//! `chereme evaluate interpolation`: captured transitions against interpolations.

use super::super::Failure;
use super::output::Output;
use super::takes::{Take, each};
use crate::evaluation::interpolation::{Rule, Trim, chart, find, print, summarise};
use crate::evaluation::kinematics::Movement;
use crate::format::svg;
use crate::time::Seconds;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme evaluate interpolation takes/                          a table\n  chereme evaluate interpolation takes/ -o interpolation.svg -o interpolation.csv\n  chereme evaluate interpolation body.bvh markers.tsv --rest 0.1\n\nRecordings: BVH with Mixamo's joint names (a hand alone, or a body), tables of Qualisys markers (.tsv) with shoulder, elbow and hand; folders are\nsearched. A transition goes from rest to rest; between the poses at its ends, slerp, cosine, sigmoid (k = 10, and the k that fits) and minimum jerk\nare compared with the captured motion: distance over the amplitude, correlation of speeds, time and height of the peak.\nThe fitted k belongs to --rest: a sigmoid cut at 5 % of its peak has k = 8.7, at 10 % 7.3, at 2.7 % 10.\nThe cut takes slow ends away, and so speaks against interpolations that have them (minimum jerk, sigmoid); --trim cuts these too.\nExit codes: 0 fine, 1 nothing to measure, 2 wrong usage."
)]
pub(super) struct Interpolation {
    /// Recordings (.bvh, .tsv), folders of them, or - for a BVH file on standard input
    #[arg(value_name = "FILE|DIR", required = true)]
    takes: Vec<PathBuf>,
    /// Rest is at most this share of a transition's peak speed
    #[arg(long, value_name = "SHARE", default_value_t = Rule::default().rest)]
    rest: f64,
    /// Cut the interpolations by the same rule as the motion: compares shapes, not what synthesis plays
    #[arg(long)]
    trim: bool,
    /// Speeds are smoothed by a Gaussian of this standard deviation, seconds
    #[arg(long, value_name = "SECONDS", default_value_t = Rule::default().smoothing.0)]
    smooth: f64,
    /// Of the bootstrap
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    #[command(flatten)]
    output: Output,
}

/// Refuses thresholds that are no shares, and smoothing that leaves nothing.
pub(super) fn checked(rest: f64, smooth: f64) -> Result<(), Failure> {
    if !(rest > 0.0 && rest < 1.0) {
        return Err(Failure::Usage(format!("--rest {rest}: a share of the peak speed lies between 0 and 1")));
    }
    match (0.0..=0.5).contains(&smooth) {
        true => Ok(()),
        false => Err(Failure::Usage(format!("--smooth {smooth}: seconds from 0 to 0.5"))),
    }
}

impl Interpolation {
    pub(super) fn run(&self) -> Result<(), Failure> {
        checked(self.rest, self.smooth)?;
        self.output.check()?;
        let trim = if self.trim { Trim::AsCut } else { Trim::Whole };
        let rule = Rule { rest: self.rest, smoothing: Seconds(self.smooth), trim, ..Rule::default() };
        let mut transitions = Vec::new();
        let work = |take: &Take| {
            let movements = match take {
                Take::Clip(name, clip) => Movement::of_clip(name, clip),
                Take::Markers(movement) => vec![movement.clone()],
            };
            movements.iter().flat_map(|movement| find(movement, &rule)).collect::<Vec<_>>()
        };
        each(&self.takes, self.output.quiet, work, |found| transitions.extend(found))?;
        if transitions.is_empty() {
            return Err(Failure::Faults(Some(
                "there is no transition from rest to rest in what was read; a greater --rest finds more".into(),
            )));
        }
        let reports = summarise(&transitions, self.seed);
        let subtitle =
            format!("rest: at most {} % of the peak speed; every transition from rest to rest", 100.0 * rule.rest);
        let figure = || svg::chart::write(&chart::chart(&reports, &subtitle, rule.ends()));
        self.output.write(&print::text(&reports, &rule), || print::csv(&transitions), figure)
    }
}
