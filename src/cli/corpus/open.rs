//! A corpus opened: its manifest read, its cache brought up to date on all cores.

use super::super::parallel::{Loudness, Progress, in_order, pool};
use super::super::{Failure, files, terminal};
use super::disk::Disk;
use super::{Named, Opening};
use crate::avatar;
use crate::body::signer::Signer;
use crate::corpus::build::Builder;
use crate::corpus::cache::disk;
use crate::corpus::files::Finding;
use crate::corpus::library::{Building, Library, Tally, fresh, vocabulary_of};
use crate::corpus::manifest::{FILE_NAME, Listing, listing};
use crate::diagnostics::Error;
use crate::notation::source_of_bytes;
use std::path::{Path, PathBuf};

/// How many findings are told without `--all`.
pub(super) const TOLD: usize = 50;

/// The manifest's file of a corpus.
pub(super) fn manifest_of(path: &Path) -> Result<PathBuf, Failure> {
    let file = if path.is_dir() { path.join(FILE_NAME) } else { path.to_owned() };
    match file.is_file() {
        true => Ok(file),
        false => Err(Failure::Usage(format!(
            "there is no {}; `chereme corpus init {}` writes one",
            file.display(),
            file.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new(".")).display()
        ))),
    }
}

/// What a corpus's manifest and tables say; its faults are told.
pub(super) fn listing_of(named: &Named) -> Result<(Listing, PathBuf), Failure> {
    let path = manifest_of(&named.path)?;
    let (source, fault) = source_of_bytes(&path.to_string_lossy(), &files::read_bytes(&path)?);
    terminal::tell(fault.as_slice(), &source);
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let listing = match fault {
        None => listing(source.clone(), &folder, &Disk),
        Some(_) => return Err(Failure::Faults(Some(format!("{} cannot be used", path.display())))),
    };
    let listing = listing.map_err(|faults| {
        terminal::tell(&faults, &source);
        Failure::Faults(Some(format!("{} cannot be used", path.display())))
    })?;
    Ok((listing, folder))
}

/// The folder of a corpus's cache.
pub(super) fn cache_folder(opening: &Opening, folder: &Path) -> PathBuf {
    opening.cache.clone().unwrap_or_else(|| folder.join(disk::FOLDER))
}

/// The signer whose rig the motions are on.
pub(super) fn signer() -> Result<Signer, Failure> {
    avatar::signer().map_err(failed)
}

pub(super) fn failed(error: Error) -> Failure {
    Failure::Faults(Some(error.to_string()))
}

/// Opens a corpus; what its cache lacks is made. Its faulty recordings are left out, and counted in the tally.
pub(in crate::cli) fn open(named: &Named, opening: &Opening, loudness: Loudness) -> Result<(Library, Tally), Failure> {
    let (listing, folder) = listing_of(named)?;
    let (cache_at, signer) = (cache_folder(opening, &folder), signer()?);
    let old = match fresh(&listing, &signer, &Disk, &cache_at) {
        Ok(cache) => {
            let kept = cache.entries().iter().filter(|entry| !entry.failed()).count();
            let tally = Tally { kept, failed: cache.entries().len() - kept, ..Tally::default() };
            return Ok((Library::new(listing, cache, &signer), tally));
        }
        Err(old) => old,
    };
    let builder = Builder::new(&listing, &signer, &Disk, old.as_ref());
    let mut building = Building::begin(&cache_at, &signer).map_err(failed)?;
    let progress = Progress::of(listing.takes.len(), "recordings", loudness);
    let takes: Vec<_> = listing.takes.iter().collect();
    in_order(
        &pool(opening.jobs)?,
        takes,
        |take| builder.make(take),
        |made| {
            progress.step();
            building.add(made);
        },
    );
    drop(progress);
    let (cache, mut tally) =
        building.finish(&listing, &vocabulary_of(&listing, &signer).map_err(failed)?).map_err(failed)?;
    tally.findings.splice(0..0, listing.findings.iter().cloned());
    if let Some(why) = &tally.unwritten {
        terminal::err(&format!("the cache cannot be written, so the corpus is made each time ({why}); see --cache\n"));
    }
    Ok((Library::new(listing, cache, &signer), tally))
}

/// Tells the first of many findings, and how many there are more.
pub(super) fn tell(findings: &[&Finding], most: usize, more: &str) {
    for finding in findings.iter().take(most) {
        terminal::tell_all(std::slice::from_ref(&finding.diagnostic), &finding.source);
    }
    if findings.len() > most && most > 0 {
        terminal::err(&format!("{} more of {}: {more}\n\n", findings.len() - most, findings.len()));
    }
}
