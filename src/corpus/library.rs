//! A corpus that is open: its recordings, with motion and tiers from the cache.

use super::build::{Builder, Freshness, Made, head};
use super::cache::disk::{self, Aside, OnDisk};
use super::cache::{Cache, Entry, Writer};
use super::cut::segments;
use super::files::{Files, Finding};
use super::index::{About, Index};
use super::label::Vocabulary;
use super::manifest::{Listing, Take};
use crate::body::retarget::Coverage;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::skeleton::Skeleton;
use crate::tier::Tier;
use crate::time::Seconds;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// The index of a corpus's segments; recordings have the numbers that they have in its [`Library`].
pub fn index_of(listing: &Listing, entries: &[Entry], vocabulary: &Vocabulary) -> Index {
    let takes: BTreeMap<&str, &Take> = listing.takes.iter().map(|take| (take.name.as_str(), take)).collect();
    let (mut abouts, mut all) = (Vec::new(), Vec::new());
    for entry in entries.iter().filter(|entry| !entry.failed()) {
        let Some(take) = takes.get(entry.name.as_str()) else { continue };
        all.extend(segments(abouts.len(), &entry.tiers));
        let (name, signer) = (entry.name.clone(), take.signer.clone());
        abouts.push(About { name, signer, dominant: Some(take.dominant) });
    }
    Index::build(&abouts, &all, vocabulary)
}

/// The words that a corpus's labels are read with: letters are those of its language.
///
/// # Errors
/// Never for the built-in inventories.
pub fn vocabulary_of(listing: &Listing, signer: &Signer) -> Result<Vocabulary, Error> {
    let language = listing.manifest.language.as_ref().map(|language| language.value.as_str());
    Vocabulary::builtin(&signer.skeleton, language)
}

/// A cache in the making: on the disk, or in memory where that cannot be written.
pub struct Building {
    target: Target,
    built: Tally,
    fault: Option<Error>,
}

enum Target {
    Disk(Box<Aside>),
    Memory(Writer<Vec<u8>>),
}

/// What a build came to.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// How many motions were made.
    pub made: usize,
    /// How many were taken over from the old cache.
    pub kept: usize,
    /// How many recordings failed, and are left out.
    pub failed: usize,
    /// What is missing or odd, in the order of the recordings.
    pub findings: Vec<Finding>,
    /// Why the cache could not be written; it is in memory then.
    pub unwritten: Option<Error>,
}

impl Building {
    /// Begins a cache in a folder.
    ///
    /// # Errors
    /// Never for a folder that cannot be written to: that is told by [`Tally::unwritten`].
    pub fn begin(folder: &Path, signer: &Signer) -> Result<Building, Error> {
        let mut built = Tally::default();
        let target = match disk::begin(folder, head(signer)) {
            Ok(aside) => Target::Disk(Box::new(aside)),
            Err(error) => {
                built.unwritten = Some(error);
                Target::Memory(Writer::new(Vec::new(), head(signer))?)
            }
        };
        Ok(Building { target, built, fault: None })
    }

    /// Adds a recording; they come in the listing's order.
    pub fn add(&mut self, made: Made) {
        let tally = &mut self.built;
        match (made.frames.count(), made.kept) {
            (0, _) => tally.failed += 1,
            (_, true) => tally.kept += 1,
            (_, false) => tally.made += 1,
        }
        tally.findings.extend(made.findings);
        let added = match &mut self.target {
            Target::Disk(aside) => aside.writer.add(made.entry, &made.frames),
            Target::Memory(writer) => writer.add(made.entry, &made.frames),
        };
        if let Err(error) = added {
            self.fault.get_or_insert(error);
        }
    }

    /// The finished cache, in the old one's place.
    ///
    /// # Errors
    /// It could not be written, such as on a full disk; the old one stays.
    pub fn finish(self, listing: &Listing, vocabulary: &Vocabulary) -> Result<(Cache, Tally), Error> {
        let indexing = |entries: &[Entry]| index_of(listing, entries, vocabulary).to_bytes();
        if let Some(error) = self.fault {
            return Err(error.context("the cache cannot be written"));
        }
        let cache = match self.target {
            Target::Disk(aside) => {
                let index = indexing(aside.writer.entries());
                aside.finish(&index)?.cache
            }
            Target::Memory(writer) => {
                let index = indexing(writer.entries());
                Cache::from_bytes(writer.finish(&index)?)?
            }
        };
        Ok((cache, self.built))
    }
}

/// A cache that still holds as a whole, if there is one. Where only the content of the sources could tell, the cache is
/// marked as looked at, so that next time their times do.
pub fn fresh(listing: &Listing, signer: &Signer, files: &dyn Files, folder: &Path) -> Result<Cache, Option<OnDisk>> {
    let looked_at = disk::now();
    let Ok(old) = disk::open(folder) else { return Err(None) };
    match Builder::new(listing, signer, files, Some(&old)).freshness() {
        Freshness::Fresh => Ok(old.cache),
        Freshness::ByContent => {
            disk::found_fresh(folder, looked_at);
            Ok(old.cache)
        }
        Freshness::Stale => Err(Some(old)),
    }
}

/// An open corpus. Recordings have numbers from 0, in the manifest's order; those that failed are left out.
pub struct Library {
    listing: Listing,
    cache: Cache,
    /// The numbers in listing and cache of each recording.
    recordings: Vec<(usize, usize)>,
    rig: Arc<Skeleton>,
    morphs: Arc<Vec<String>>,
}

impl Library {
    /// A corpus with its cache, which is of the same listing and signer.
    pub fn new(listing: Listing, cache: Cache, signer: &Signer) -> Library {
        let numbers: BTreeMap<&str, usize> =
            listing.takes.iter().enumerate().map(|(at, take)| (take.name.as_str(), at)).collect();
        let sound = cache.entries().iter().enumerate().filter(|(_, entry)| !entry.failed());
        let recordings = sound.filter_map(|(at, entry)| Some((*numbers.get(entry.name.as_str())?, at))).collect();
        Library { listing, cache, recordings, rig: signer.skeleton.clone(), morphs: signer.morphs.clone() }
    }

    /// Opens a corpus: its cache where that holds, else built, one recording after the other. (The program builds on all
    /// cores, with the same parts.)
    ///
    /// # Errors
    /// The cache cannot be written for another reason than that the folder is closed to us. Recordings with faults are
    /// left out, and told of in the tally.
    pub fn open(
        listing: Listing,
        signer: &Signer,
        files: &dyn Files,
        folder: &Path,
    ) -> Result<(Library, Tally), Error> {
        let old = match fresh(&listing, signer, files, folder) {
            Ok(cache) => {
                let kept = cache.entries().iter().filter(|entry| !entry.failed()).count();
                let tally = Tally { kept, failed: cache.entries().len() - kept, ..Tally::default() };
                return Ok((Library::new(listing, cache, signer), tally));
            }
            Err(old) => old,
        };
        let builder = Builder::new(&listing, signer, files, old.as_ref());
        let mut building = Building::begin(folder, signer)?;
        listing.takes.iter().for_each(|take| building.add(builder.make(take)));
        let (cache, tally) = building.finish(&listing, &vocabulary_of(&listing, signer)?)?;
        Ok((Library::new(listing, cache, signer), tally))
    }

    /// The corpus as its manifest says.
    pub fn listing(&self) -> &Listing {
        &self.listing
    }

    /// How many recordings there are.
    pub fn len(&self) -> usize {
        self.recordings.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.recordings.is_empty()
    }

    /// The number of the recording of a name.
    pub fn find(&self, name: &str) -> Option<usize> {
        (0..self.len()).find(|at| self.take(*at).name == name)
    }

    /// What the manifest says of a recording. Panics, as the others here, for a number that is not below [`Library::len`].
    pub fn take(&self, recording: usize) -> &Take {
        &self.listing.takes[self.recordings[recording].0]
    }

    /// What the cache says of a recording: frame rate, joints, warnings.
    pub fn entry(&self, recording: usize) -> &Entry {
        &self.cache.entries()[self.recordings[recording].1]
    }

    /// A recording's motion on our rig, `f64` in memory.
    ///
    /// # Errors
    /// The cache was damaged since it was opened; a build makes it anew.
    pub fn clip(&self, recording: usize) -> Result<Clip, Error> {
        self.cache.clip(self.entry(recording), &self.rig, &self.morphs)
    }

    /// A recording's tiers, from its clip's start.
    pub fn tiers(&self, recording: usize) -> &[Tier] {
        &self.entry(recording).tiers
    }

    /// What of the body a recording moves.
    pub fn coverage(&self, recording: usize) -> Coverage {
        self.entry(recording).covers
    }

    /// How long a recording is.
    pub fn duration(&self, recording: usize) -> Seconds {
        self.entry(recording).duration()
    }

    /// The index of all segments; made anew where the cache's is not as it should be.
    pub fn index(&self, vocabulary: &Vocabulary) -> Index {
        let kept = Index::from_bytes(self.cache.index(), vocabulary);
        kept.unwrap_or_else(|_| index_of(&self.listing, self.cache.entries(), vocabulary))
    }
}
