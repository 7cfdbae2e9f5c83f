//! Annotations as a table: what an EAF file or a TextGrid says, a row a value.
//!
//! `cargo run --example annotations_table -- interview.eaf` prints `tier`, `start`, `end`, `label` and `source` (of EAF, the
//! annotation's id), tab-separated. Warnings and faults go to standard error. `tools/check_eaf.py --read` takes it.

use chereme::diagnostics::Diagnostic;
use chereme::diagnostics::render::render;
use chereme::format::segments::{self, Recording};
use chereme::format::text::source_of_bytes;
use chereme::format::{eaf, textgrid};
use chereme::tier::Tier;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("give an .eaf or .TextGrid file")?;
    let bytes = std::fs::read(&path)?;
    let source = source_of_bytes(&path, &bytes);
    let tell = |told: &[Diagnostic]| told.iter().for_each(|one| eprintln!("{}", render(one, &source, false)));
    let read = if path.ends_with(".eaf") { of_eaf(&bytes) } else { of_grid(&bytes) };
    let (tiers, warnings) = read.map_err(|faults| {
        tell(&faults);
        format!("{path} has faults")
    })?;
    tell(&warnings);
    print!("{}", segments::write(&[Recording { name: String::new(), tiers }]));
    Ok(())
}

/// Tiers and warnings, or faults.
type Read = Result<(Vec<Tier>, Vec<Diagnostic>), Vec<Diagnostic>>;

fn of_eaf(bytes: &[u8]) -> Read {
    let reading = eaf::read(bytes)?;
    Ok((reading.eaf.tiers.into_iter().map(|tier| tier.tier).collect(), reading.warnings))
}

fn of_grid(bytes: &[u8]) -> Read {
    let reading = textgrid::read(bytes)?;
    Ok((reading.grid.tiers.into_iter().map(|tier| tier.tier).collect(), reading.warnings))
}
