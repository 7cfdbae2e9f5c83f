//! `chereme corpus check`

use super::super::parallel::{Loudness, Progress, in_order, pool};
use super::super::terminal::{self, count};
use super::super::{Failure, Sources, world};
use super::Named;
use super::disk::Disk;
use super::open::{TOLD, listing_of, signer, tell};
use crate::corpus::examine::{self, Names, is_fault};
use crate::corpus::files::Finding;
use crate::phonology::handshape::Handshape;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme corpus check takes\n  chereme corpus check takes --all > /dev/null\n  chereme corpus check takes/corpus.yaml --quiet\n\nExit codes: 0 fine (warnings included), 1 a fault, 2 wrong usage."
)]
pub(super) struct Check {
    #[command(flatten)]
    named: Named,
    /// How many cores to work on; all without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Tell all faults and warnings, not the first 50 only
    #[arg(long, conflicts_with = "quiet")]
    all: bool,
    /// The summary only
    #[arg(short, long)]
    quiet: bool,
}

impl Check {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let grammar = world::grammar(sources)?;
        let owned = |names: &mut dyn Iterator<Item = &str>| names.map(str::to_owned).collect::<Vec<_>>();
        let names = Names {
            configurations: owned(&mut grammar.handshapes.shapes().iter().flat_map(Handshape::names)),
            places: owned(&mut grammar.locations.names()),
            joints: signer()?.skeleton.joints().iter().map(|joint| joint.name.clone()).collect(),
        };
        let (listing, _) = listing_of(&self.named)?;
        let mut findings = examine::whole(&listing, &names);
        let loudness = if self.quiet { Loudness::Quiet } else { Loudness::Told };
        let progress = Progress::of(listing.takes.len(), "recordings", loudness);
        let look = |take| examine::recording(take, &listing, &Disk, &names);
        let takes: Vec<_> = listing.takes.iter().collect();
        in_order(&pool(self.jobs)?, takes, look, |found: Vec<Finding>| {
            progress.step();
            findings.extend(found);
        });
        drop(progress);
        let (faults, warnings): (Vec<_>, Vec<_>) = findings.iter().partition(|found| is_fault(&found.diagnostic));
        let most = match (self.quiet, self.all) {
            (true, _) => 0,
            (false, true) => usize::MAX,
            (false, false) => TOLD,
        };
        // Faults first, for they are what has to be mended.
        let told: Vec<&Finding> = faults.iter().chain(&warnings).copied().collect();
        tell(&told, most, "--all tells them, --quiet counts them");
        let of =
            |all: &[&Finding], one: &str| if all.is_empty() { format!("no {one}s") } else { count(all.len(), one) };
        let recordings = count(listing.takes.len(), "recording");
        terminal::out(&format!("{recordings}: {}, {}\n", of(&faults, "fault"), of(&warnings, "warning")));
        if faults.is_empty() { Ok(()) } else { Err(Failure::Faults(None)) }
    }
}
