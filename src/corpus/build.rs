//! What makes a cache: each recording taken from the old cache where nothing changed, and from its files where something did.
//!
//! A recording is kept where the program, the rig, all that the manifest says of it and the content of its files are what
//! they were. That the content is the same is told by size and time, where these can be trusted, else by its hash.

use super::annotate::{self, Annotator};
use super::cache::disk::OnDisk;
use super::cache::{Cache, Entry, Frames, Head, Off, SourceFile, hash};
use super::files::{Files, Finding, Stamp};
use super::manifest::{Listing, Rig, Take, our_tiers};
use super::motion::{self, captured};
use super::tiers::{Window, annotations_of, tiers};
use crate::body::retarget::{Humanoid, Options, Report, retarget};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::phonology::handshape::HandshapeInventory;
use crate::phonology::{Configuration, LocationInventory, Side};
use crate::time::FrameIndex;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

/// Raised with every change of how motions and tiers are made, so that older caches are built anew.
const MAKER: u32 = 2;

/// The head of a cache that this program makes for a signer.
pub fn head(signer: &Signer) -> Head {
    let joints: String = signer
        .skeleton
        .joints()
        .iter()
        .map(|joint| format!("{} {:?} {} {}\n", joint.name, joint.parent, joint.rest_model, joint.tail_model))
        .collect();
    let rig = joints + &signer.morphs.join("\n");
    Head { program: format!("{} {MAKER}", env!("CARGO_PKG_VERSION")), rig: hash(rig.as_bytes()) }
}

/// A recording that was made, or taken over.
#[derive(Debug, Clone)]
pub struct Made {
    /// What the cache's table says.
    pub entry: Entry,
    /// The motion; no frames where it failed.
    pub frames: Frames,
    /// What is odd about it; a fault where it failed.
    pub findings: Vec<Finding>,
    /// Whether its motion was taken over from the old cache.
    pub kept: bool,
}

impl Made {
    fn kept(entry: Entry, frames: Frames) -> Made {
        Made { entry, frames, findings: Vec::new(), kept: true }
    }
}

/// How far an old cache holds as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Freshness {
    /// Nothing is to be done.
    Fresh,
    /// The content of all files is as it was, but their times could not tell.
    ByContent,
    /// Something is to be made.
    Stale,
}

/// How far a recording of the old cache holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Old<'c> {
    /// Motion and tiers do.
    Fresh(&'c Entry),
    /// Motion and tiers do by their content; times are other, or say nothing.
    SameContent(Entry),
    /// The motion does, the tiers do not.
    Motion(Entry),
    /// It is not there, or does not.
    Nothing,
}

/// Makes recordings.
pub struct Builder<'a> {
    listing: &'a Listing,
    signer: &'a Signer,
    files: &'a dyn Files,
    old: Option<&'a OnDisk>,
    by_name: BTreeMap<&'a str, &'a Entry>,
    /// How our body stands where a recording has nothing of it.
    rest: LocalPose,
    annotator: Annotator<'a>,
}

/// The places that annotation knows.
static PLACES: LazyLock<LocationInventory> = LazyLock::new(LocationInventory::builtin);

impl<'a> Builder<'a> {
    /// A maker of a corpus's recordings; an old cache of another head is not looked at.
    pub fn new(listing: &'a Listing, signer: &'a Signer, files: &'a dyn Files, old: Option<&'a OnDisk>) -> Builder<'a> {
        let old = old.filter(|old| *old.cache.head() == head(signer));
        let entries = old.map(|old| old.cache.entries()).unwrap_or_default();
        let by_name = entries.iter().map(|entry| (entry.name.as_str(), entry)).collect();
        let annotator = Annotator::new(signer, &HandshapeInventory::builtin(), &PLACES);
        Builder { listing, signer, files, old, by_name, rest: rest_of(signer), annotator }
    }

    /// The cache that recordings are kept from.
    pub fn old_cache(&self) -> Option<&'a Cache> {
        self.old.map(|old| &old.cache)
    }

    /// How far the old cache holds as a whole.
    pub fn freshness(&self) -> Freshness {
        let Some(old) = self.old_cache() else { return Freshness::Stale };
        let (takes, entries) = (&self.listing.takes, old.entries());
        if takes.len() != entries.len() {
            return Freshness::Stale;
        }
        let mut freshness = Freshness::Fresh;
        for (take, entry) in takes.iter().zip(entries) {
            match self.old(take) {
                Old::Fresh(own) if own.name == entry.name => {}
                Old::SameContent(own) if own == *entry => freshness = Freshness::ByContent,
                Old::Fresh(_) | Old::SameContent(_) | Old::Motion(_) | Old::Nothing => return Freshness::Stale,
            }
        }
        freshness
    }

    /// How far the old cache holds for a recording.
    pub fn old(&self, take: &Take) -> Old<'a> {
        let Some(entry) = self.by_name.get(take.name.as_str()).copied() else { return Old::Nothing };
        let same_motion = entry.motion_recipe == self.motion_recipe(take);
        let motion = match same_motion.then(|| self.unchanged(&entry.motion, &take.motion)).flatten() {
            Some(motion) => motion,
            None => return Old::Nothing,
        };
        let same_files = entry.annotations.len() == take.annotations.len();
        let annotations: Option<Vec<SourceFile>> =
            entry.annotations.iter().zip(&take.annotations).map(|(file, path)| self.unchanged(file, path)).collect();
        match annotations {
            Some(annotations) if same_files && entry.tiers_recipe == self.tiers_recipe(take) => {
                let trusted = [&motion].into_iter().chain(&annotations).all(|file| self.trusts(file.stamp));
                if trusted && motion == entry.motion && annotations == entry.annotations {
                    return Old::Fresh(entry);
                }
                let mut entry = entry.clone();
                (entry.motion, entry.annotations) = (motion, annotations);
                Old::SameContent(entry)
            }
            _ => {
                let mut entry = entry.clone();
                entry.motion = motion;
                Old::Motion(entry)
            }
        }
    }

    /// Whether a stamp says something about the content; that there is no file always does.
    fn trusts(&self, stamp: Stamp) -> bool {
        let before = self.old.map_or(0, |old| old.trusted_before_ns);
        stamp == Stamp::default() || (0 < stamp.modified_ns && stamp.modified_ns < before)
    }

    /// A file as it is now, where its content is as it was.
    fn unchanged(&self, then: &SourceFile, path: &Path) -> Option<SourceFile> {
        let stamp = self.files.stamp(path).unwrap_or_default();
        if then.path != path.to_string_lossy() || then.stamp.size != stamp.size {
            return None;
        }
        let same = (then.stamp == stamp && self.trusts(stamp))
            || self.files.read(path).is_ok_and(|bytes| hash(&bytes) == then.hash);
        same.then(|| SourceFile { stamp, ..then.clone() })
    }

    /// All that is said of how a motion is to be taken: of its skeleton, or of all of them where the file's joints choose.
    fn motion_recipe(&self, take: &Take) -> u64 {
        let rigs = &self.listing.manifest.skeletons;
        let rigs = take.rig.map_or(&rigs[..], |at| &rigs[at..=at]);
        let rig = |rig: &Rig| {
            let joints: Vec<_> = rig.joints.iter().map(|(ours, theirs)| (&ours.value, &theirs.value)).collect();
            let (unit, axes) = (rig.unit.map(|unit| unit.value), (rig.up.map(|a| a.value), rig.front.map(|a| a.value)));
            format!("{unit:?} {axes:?} {} {:?} {joints:?}", rig.skip_frames.value, rig.mode.value)
        };
        let rigs: Vec<String> = rigs.iter().map(rig).collect();
        hash(format!("{rigs:?} {:?} {:?}", take.span, take.hand).as_bytes())
    }

    /// All that is said of how its annotations are to be taken, what it says of the motion included.
    fn tiers_recipe(&self, take: &Take) -> u64 {
        let manifest = &self.listing.manifest;
        let rules: Vec<_> = manifest.tiers.iter().map(|rule| (&rule.theirs.value, &rule.ours.value)).collect();
        let values: Vec<_> =
            manifest.values.iter().map(|rule| (rule.component, &rule.theirs.value, &rule.ours.value)).collect();
        let own = (&take.gloss, take.offset, self.motion_recipe(take));
        hash(format!("{rules:?} {values:?} {own:?}").as_bytes())
    }

    /// Makes a recording, with what the old cache has of it. One that failed before is tried again, and its faults told.
    pub fn make(&self, take: &Take) -> Made {
        let kept = |entry: &Entry| {
            let cache = self.old_cache().filter(|_| !entry.failed())?;
            // Frames that are damaged are made anew.
            Frames::kept(cache, entry).ok()
        };
        match self.old(take) {
            Old::Fresh(entry) => {
                if let Some(frames) = kept(entry) {
                    return Made::kept(entry.clone(), frames);
                }
            }
            Old::SameContent(entry) => {
                if let Some(frames) = kept(&entry) {
                    return Made::kept(entry, frames);
                }
            }
            Old::Motion(entry) => {
                if let Some(frames) = kept(&entry) {
                    return self.annotated(take, Made::kept(entry, frames));
                }
            }
            Old::Nothing => {}
        }
        let (motion, bytes) = self.source(&take.motion);
        let entry = Entry::new(&take.name, motion, self.motion_recipe(take));
        let mut made = Made { entry, frames: Frames::default(), findings: Vec::new(), kept: false };
        let done = bytes.map_err(|e| vec![take.place.fault(e.to_string())]);
        if let Err(faults) = done.and_then(|bytes| self.moved(take, &bytes, &mut made)) {
            made.findings.extend(faults);
        }
        self.annotated(take, made)
    }

    /// A recording's motion on our rig.
    fn moved(&self, take: &Take, bytes: &[u8], made: &mut Made) -> Result<(), Vec<Finding>> {
        let fault = |e: Error| vec![take.place.fault(format!("{}: {e}", take.name))];
        let manifest = &self.listing.manifest;
        let captured = captured(bytes, take, manifest, &self.listing.source)?;
        made.findings = captured.findings;
        // Frames that are not to be used are cut off already.
        let options = Options { mode: captured.mode, skip_frames: 0, rest: self.rest.clone() };
        let skeleton = captured.clip.skeleton();
        let humanoid = Humanoid::standing(skeleton, &captured.stands, &captured.joints, captured.axes, self.signer);
        let humanoid = humanoid.map_err(fault)?;
        let done = retarget(&captured.clip, &humanoid, self.signer, &options).map_err(fault)?;
        let warnings = told(&done.report);
        let finding = |text: &String| take.place.warning(format!("{}: {text}", take.name));
        made.findings.extend(warnings.iter().map(finding));
        made.frames = Frames::of(&done.clip).map_err(fault)?;
        let entry = &mut made.entry;
        entry.joints = u32::try_from(captured.clip.skeleton().len()).unwrap_or(u32::MAX);
        (entry.begins, entry.covers, entry.warnings) = (captured.begins, done.covers, warnings);
        let (tip_m, wrist_m) = (done.report.tips_m, done.report.wrists_m);
        entry.off = Off { direction: done.report.worst(), tip_m, wrist_m };
        entry.fps = done.clip.fps();
        Ok(())
    }

    /// A made recording with its tiers; without frames, where its annotations have faults.
    fn annotated(&self, take: &Take, mut made: Made) -> Made {
        let mut read = Vec::with_capacity(take.annotations.len());
        let mut faults = Vec::new();
        made.entry.annotations.clear();
        for (path, place) in take.annotations.iter().zip(&take.annotation_places) {
            let (file, bytes) = self.source(path);
            made.entry.annotations.push(file);
            match bytes
                .map(|bytes| annotations_of(path, &take.name, &bytes).map_err(|all| motion::located(path, &bytes, all)))
            {
                Ok(Ok(tiers)) => read.push((name_of(path), tiers)),
                Ok(Err(all)) => faults.extend(all),
                Err(e) => faults.push(place.fault(e.to_string())),
            }
        }
        made.entry.tiers_recipe = self.tiers_recipe(take);
        if !faults.is_empty() {
            made.frames = Frames::default();
            made.findings.extend(faults);
        }
        let frames = made.frames.count();
        if frames > 0 {
            let duration = made.entry.fps.time_of(FrameIndex(frames - 1));
            let window = Window { begins: made.entry.begins, duration };
            made.entry.tiers = tiers(&self.listing.manifest, take, &read, window, made.entry.covers);
            self.measured(&mut made);
        }
        made
    }

    /// Adds what was measured of the motion, for each tier of a hand that nobody annotated.
    fn measured(&self, made: &mut Made) {
        let covers = made.entry.covers;
        let Ok(clip) = made.frames.clip(self.signer, made.entry.fps) else { return };
        let measured = self.annotator.annotate(&clip, covers.into(), &annotate::Options::default()).tiers();
        for tier in measured {
            let side = if tier.name.starts_with("LH") { Side::Left } else { Side::Right };
            let fingers = covers.hands[side as usize] || !tier.name.ends_with("Configuration");
            if fingers && !made.entry.tiers.iter().any(|own| own.name == tier.name) {
                made.entry.tiers.push(tier);
            }
        }
        let order: Vec<String> = our_tiers().collect();
        made.entry.tiers.sort_by_key(|tier| order.iter().position(|name| *name == tier.name));
    }

    /// What tells later whether a file's content is the same, and its content.
    fn source(&self, path: &Path) -> (SourceFile, Result<Vec<u8>, Error>) {
        // The stamp first: a file that changes in between has another one later.
        let stamp = self.files.stamp(path).unwrap_or_default();
        let bytes = self.files.read(path);
        let hash = bytes.as_ref().map_or(0, |bytes| hash(bytes));
        (SourceFile { path: path.to_string_lossy().into_owned(), stamp, hash }, bytes)
    }
}

/// How a signer stands where a recording says nothing: arms hanging, hands at rest.
pub fn rest_of(signer: &Signer) -> LocalPose {
    let rest = HandshapeInventory::builtin().angles(&Configuration::named("rest"), None);
    rest.map_or_else(|_| LocalPose::rest(&signer.skeleton), |hand| signer.neutral(&hand))
}

/// What of a motion could not be kept, where it is more than one sees past.
fn told(report: &Report) -> Vec<String> {
    const NOTICEABLE: f64 = 10.0 * std::f64::consts::PI / 180.0;
    let parts = report.directions.iter().filter(|part| part.worst > NOTICEABLE);
    let mut told: Vec<String> = parts
        .map(|part| {
            let (name, joint, at) = (part.part.name(), &part.joint, part.at);
            let (worst, mean) = (part.worst.to_degrees(), part.mean.to_degrees());
            format!("{name} look up to {worst:.0}° elsewhere ({joint} at {at}), {mean:.1}° in the mean")
        })
        .collect();
    if report.tips_m > 0.01 {
        let (worst, mean) = (report.tips_m * 100.0, report.tips_mean_m * 100.0);
        told.push(format!("fingertips are up to {worst:.1} cm from where they were, {mean:.1} cm in the mean"));
    }
    told
}

/// A file's name, for where a value came from.
fn name_of(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}
