//! `chereme evaluate`: the paper's analyses (Naert et al. 2021), as tables and figures.

mod interpolation;
mod lags;
mod markers;
mod output;
mod ratings;
mod stimuli;
mod takes;

use super::{Failure, Sources};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme evaluate stimuli configuration -o page.html --key key.csv   a blind questionnaire\n  chereme evaluate ratings answers/*.csv --key key.csv --level good+ -o ratings.svg\n  chereme evaluate interpolation takes/ -o interpolation.svg           which easing moves as people do\n  chereme evaluate lags takes/ -o lags.csv                             which channel ends first"
)]
pub(super) struct EvaluateArgs {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, clap::Subcommand)]
enum What {
    /// Make the paper's stimuli a blind questionnaire that writes CSV
    Stimuli(stimuli::Stimuli),
    /// Analyse the answers of questionnaires: recognition, realism, and which versions differ
    Ratings(ratings::Ratings),
    /// Compare captured transitions with slerp, cosine, sigmoid and minimum jerk
    Interpolation(interpolation::Interpolation),
    /// Measure which ends first: configuration, palm or wrist
    Lags(lags::Lags),
}

impl EvaluateArgs {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        match &self.what {
            What::Stimuli(stimuli) => stimuli.run(sources),
            What::Ratings(ratings) => ratings.run(),
            What::Interpolation(interpolation) => interpolation.run(),
            What::Lags(lags) => lags.run(),
        }
    }
}
