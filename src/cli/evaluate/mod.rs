//! `chereme evaluate`: the paper's analyses (Naert et al. 2021), as tables and figures.

mod output;
mod ratings;

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
    /// Analyse the answers of questionnaires: recognition, realism, and which versions differ
    Ratings(ratings::Ratings),
}

impl EvaluateArgs {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let _ = sources;
        match &self.what {
            What::Ratings(ratings) => ratings.run(),
        }
    }
}
