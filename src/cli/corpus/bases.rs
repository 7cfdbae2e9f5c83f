//! `chereme corpus bases`

use super::super::parallel::Loudness;
use super::super::{Failure, terminal};
use super::open::{failed, open, signer};
use super::{Named, Opening};
use crate::corpus::bases::{Base, Options, bases};
use crate::corpus::library::vocabulary_of;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "From one sign of a base another is made by exchanging the configuration (Naert et al. 2021, 5.1: snail and slug).\n\nExamples:\n  chereme corpus bases takes\n  chereme corpus bases takes --tolerance 0.2 --orientation"
)]
pub(super) struct Bases {
    #[command(flatten)]
    named: Named,
    /// How far placements and movements may be apart; without it they must be said the same
    #[arg(long, value_name = "DISTANCE")]
    tolerance: Option<f64>,
    /// The orientation must be shared too
    #[arg(long)]
    orientation: bool,
    #[command(flatten)]
    opening: Opening,
}

impl Bases {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (library, _) = open(&self.named, &self.opening, Loudness::Told)?;
        let vocabulary = vocabulary_of(library.listing(), &signer()?).map_err(failed)?;
        let index = library.index(&vocabulary);
        let segments: Vec<_> = (0..index.len()).filter_map(|at| index.segment(at)).collect();
        let options = Options { orientation: self.orientation, tolerance: self.tolerance };
        let found = bases(&segments, &vocabulary, &options);
        if found.is_empty() {
            terminal::err("no two signs share placement and movement\n");
        }
        terminal::out(&found.iter().map(text).collect::<String>());
        Ok(())
    }
}

fn text(base: &Base) -> String {
    let mut text = format!("{}\n", base.shared.join("; "));
    for member in &base.members {
        let made = terminal::count(member.segments.len(), "segment");
        text.push_str(&format!("    {}  {}  ({made})\n", member.gloss, member.configuration));
    }
    text
}
