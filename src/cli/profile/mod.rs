//! `chereme profile`: kinematic profiles of motions, as tables and figures, and against golden ones.

mod against;
mod input;
mod output;
mod points;
mod table;

use super::{Failure, Sources, terminal};
use crate::format::profile_plot::Layout;
use crate::format::svg::Mark;
use crate::motion::curve::{Measure, Profile, Reference};
use crate::motion::difference::Tolerance;
use crate::motion::easing::Easing;
use crate::time::Fps;
use std::path::PathBuf;
use std::str::FromStr;

#[derive(Debug, clap::Args)]
#[command(
    name = "profile",
    after_help = "Examples:\n  chereme profile BOL                                            peaks, as a table\n  chereme profile BOL --joint RightHand,LeftHand -o bol.svg -o bol.csv\n  chereme profile DODO --easing linear,cosine,sigmoid --joint 'RightHand*Tip' --frame wrist -o figure10.svg\n  chereme profile a.csv b.csv -o compare.svg                     two profiles, one figure\n  chereme profile BOL --measure speed --against golden.csv --tolerance 0.02 -o difference.svg\n  chereme profile BOL --measure height,speed --against golden.csv --update\n\nJoints are named as in the rig; RightHandIndexTip is the tip of a finger, RightHand*Tip are all five, \"left ear\" is a place of the body.\nExit codes: 0 fine, 1 the profile differs from the golden one, 2 wrong usage."
)]
pub(super) struct ProfileArgs {
    /// Motions: names of signs, files of signs (.sign), recordings (.bvh), or profiles (.csv)
    #[arg(value_name = "FILE|NAME", required = true)]
    what: Vec<String>,
    /// The joints, fingertips or places of the body that are followed; * stands for any letters [default: RightHand, or all of a .csv]
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    joint: Vec<String>,
    /// Where they are seen from: floor, body (the rig's root) or wrist
    #[arg(long, value_name = "FRAME")]
    frame: Option<Reference>,
    /// What is measured: x, y, z, position (distance from the frame's origin), height, speed, acceleration, jerk
    /// [default: height,speed; from the wrist position,speed; or all of a .csv]
    #[arg(long, value_name = "MEASURE", value_delimiter = ',')]
    measure: Vec<Measure>,
    /// How joints ease between poses, for signs; several make a motion each: linear,cosine,sigmoid
    #[arg(long, value_name = "NAME", value_delimiter = ',', default_value = "sigmoid")]
    easing: Vec<Easing>,
    /// Frames a second, for signs
    #[arg(long, value_name = "N", default_value_t = Fps::DEFAULT.get())]
    fps: f64,
    /// How fast, for signs: 2 is twice as fast
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    speed: f64,
    /// The language of signs given by name, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// Where to: a figure (.svg), a table (.csv), or - for a table on standard output; repeatable
    #[arg(short, long, value_name = "OUT")]
    output: Vec<String>,
    /// Several motions in a figure: laid over one another, or side by side [default: overlaid for one joint, else columns]
    #[arg(long, value_name = "LAYOUT")]
    layout: Option<Arrangement>,
    /// The heading of the figure [default: the names of the motions]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Decimals of a table
    #[arg(long, value_name = "N", default_value_t = crate::format::csv::DECIMALS)]
    decimals: usize,
    /// Compare with this profile (.csv), and exit with 1 where a curve differs by more than the tolerance
    #[arg(long, value_name = "GOLDEN")]
    against: Option<PathBuf>,
    /// How far curves may differ: 0.02 (in the curve's unit), 5% (of the golden curve's range), or for one measure speed=0.05
    #[arg(long, value_name = "SIZE", value_delimiter = ',', requires = "against", default_value = "1%")]
    tolerance: Vec<Allowed>,
    /// Write the golden profile anew instead of comparing
    #[arg(long, requires = "against")]
    update: bool,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but faults
    #[arg(short, long)]
    quiet: bool,
}

/// How several motions stand in a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Arrangement {
    /// Laid over one another, a colour a motion
    Overlaid,
    /// Side by side, a colour a joint
    Columns,
}

impl Arrangement {
    fn layout(self) -> Layout {
        match self {
            Arrangement::Overlaid => Layout::Overlaid,
            Arrangement::Columns => Layout::Columns,
        }
    }
}

/// A tolerance, of every measure or of one.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Allowed {
    measure: Option<Measure>,
    tolerance: Tolerance,
}

impl FromStr for Allowed {
    type Err = crate::diagnostics::Error;

    fn from_str(text: &str) -> Result<Allowed, Self::Err> {
        match text.split_once('=') {
            Some((measure, size)) => Ok(Allowed { measure: Some(measure.parse()?), tolerance: size.parse()? }),
            None => Ok(Allowed { measure: None, tolerance: text.parse()? }),
        }
    }
}

/// What is asked of a motion.
struct Wanted<'a> {
    joints: &'a [String],
    reference: Option<Reference>,
    measures: &'a [Measure],
    /// Where nothing is asked: the curves of a golden profile.
    golden: Option<&'a Profile>,
}

/// A letter an instant, from A on; past Z nothing can be told apart.
fn letters(instants: impl IntoIterator<Item = crate::time::Seconds>) -> Vec<Mark> {
    ('A'..='Z').zip(instants).map(|(letter, time)| Mark { name: letter.to_string(), time }).collect()
}

impl ProfileArgs {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let outputs = output::Outputs::of(self)?;
        let golden = self.against.as_deref().map(|path| against::golden(path, self.update)).transpose()?.flatten();
        let wanted =
            Wanted { joints: &self.joint, reference: self.frame, measures: &self.measure, golden: golden.as_ref() };
        let motions = input::motions(self, sources, &wanted)?;
        outputs.check(&motions)?;
        if let Some(path) = &self.against {
            return against::compare(self, path, golden.as_ref(), &wanted, &motions, &outputs);
        }
        if self.output.is_empty() {
            terminal::out(&table::table(&motions));
            return Ok(());
        }
        outputs.write(&motions, || outputs.figure(&motions))
    }

    /// How far a measure may differ: what is said of it, else what is said last of all.
    fn tolerance(&self, measure: Measure) -> Tolerance {
        let said = |m: Option<Measure>| self.tolerance.iter().rev().find(|a| a.measure == m).map(|a| a.tolerance);
        said(Some(measure)).or_else(|| said(None)).unwrap_or(Tolerance::OfRange(0.01))
    }
}
