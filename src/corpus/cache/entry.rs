//! What a cache's table says of each recording, and what tells whether it still holds.

use super::bytes::{Sink, Tap};
use super::columns::Columns;
use crate::body::retarget::Coverage;
use crate::corpus::files::Stamp;
use crate::diagnostics::Error;
use crate::tier::Tier;
use crate::time::{Fps, FrameIndex, Seconds};
use std::ops::Range;

/// What a cache was made by and for. A cache of another head is not used.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Head {
    /// The program's version and that of what makes the motions.
    pub program: String,
    /// The hash of the rig: its joints, where they rest, its morphs.
    pub rig: u64,
}

impl Head {
    pub(super) fn write(&self, sink: &mut Sink) {
        sink.text(&self.program);
        sink.u64(self.rig);
    }

    pub(super) fn read(tap: &mut Tap<'_>) -> Result<Head, Error> {
        Ok(Head { program: tap.text()?, rig: tap.u64()? })
    }
}

/// A file that a recording was made from, as it was then.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceFile {
    /// Its path.
    pub path: String,
    /// Its size and time.
    pub stamp: Stamp,
    /// The hash of its content.
    pub hash: u64,
}

/// How far a motion on our rig is off its source, at most.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Off {
    /// The direction of any bone, radians.
    pub direction: f64,
    /// A fingertip from where it should be, metres; 0 where places are not asked for.
    pub tip_m: f64,
    /// A wrist from where it should be, metres: of an arm with `contacts`, of a hand without an arm always.
    pub wrist_m: f64,
}

/// A recording in a cache.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Its name.
    pub name: String,
    /// The motion's file.
    pub motion: SourceFile,
    /// The hash of all that was said of how its motion is to be taken.
    pub motion_recipe: u64,
    /// The files of its annotations.
    pub annotations: Vec<SourceFile>,
    /// The hash of all that was said of how its annotations are to be taken.
    pub tiers_recipe: u64,
    /// Frames a second.
    pub fps: Fps,
    /// The file's instant of the first frame.
    pub begins: Seconds,
    /// How many joints the file has.
    pub joints: u32,
    /// What of the body it moves.
    pub covers: Coverage,
    /// How far its motion on our rig is off the file's.
    pub off: Off,
    /// What is odd about it, each a sentence.
    pub warnings: Vec<String>,
    /// Its tiers, from the motion's start.
    pub tiers: Vec<Tier>,
    pub(super) columns: Columns,
    /// Where its frames are.
    pub(super) at: Range<usize>,
    pub(super) hash: u64,
}

impl Entry {
    /// An entry that moves nothing yet.
    pub fn new(name: &str, motion: SourceFile, motion_recipe: u64) -> Entry {
        Entry {
            name: name.to_owned(),
            motion,
            motion_recipe,
            annotations: Vec::new(),
            tiers_recipe: 0,
            fps: Fps::DEFAULT,
            begins: Seconds(0.0),
            joints: 0,
            covers: Coverage::default(),
            off: Off::default(),
            warnings: Vec::new(),
            tiers: Vec::new(),
            columns: Columns::default(),
            at: 0..0,
            hash: 0,
        }
    }

    /// Whether it could not be made: it has no frames then.
    pub fn failed(&self) -> bool {
        self.columns.frames == 0
    }

    /// How many frames it has.
    pub fn frame_count(&self) -> usize {
        self.columns.frames as usize
    }

    /// From the first frame's instant to the last one's.
    pub fn duration(&self) -> Seconds {
        self.fps.time_of(FrameIndex(self.frame_count().saturating_sub(1)))
    }

    pub(super) fn write(&self, sink: &mut Sink) {
        sink.text(&self.name);
        source(sink, &self.motion);
        sink.u64(self.motion_recipe);
        sink.list(&self.annotations, source);
        sink.u64(self.tiers_recipe);
        sink.f64(self.fps.get());
        sink.f64(self.begins.0);
        sink.u32(self.joints);
        let Coverage { body, arms, hands } = self.covers;
        let flags = [body, arms[0], arms[1], hands[0], hands[1]];
        sink.u8((0..).zip(flags).map(|(at, flag)| u8::from(flag) << at).sum());
        [self.off.direction, self.off.tip_m, self.off.wrist_m].into_iter().for_each(|number| sink.f64(number));
        sink.list(&self.warnings, |sink, text| sink.text(text));
        sink.list(&self.tiers, write_tier);
        self.columns.write(sink);
        sink.u64(self.hash);
    }

    /// An entry whose frames begin at a place.
    pub(super) fn read(tap: &mut Tap<'_>, at: usize) -> Result<Entry, Error> {
        let name = tap.text()?;
        let motion = read_source(tap)?;
        let motion_recipe = tap.u64()?;
        let annotations = tap.list(read_source)?;
        let tiers_recipe = tap.u64()?;
        let fps = Fps::new(tap.f64()?).ok_or_else(|| Error::new("it has a frame rate that is none"))?;
        let begins =
            Seconds(Some(tap.f64()?).filter(|at| at.is_finite()).ok_or_else(|| Error::new("its start is no time"))?);
        let joints = tap.u32()?;
        let flags = tap.u8()?;
        let flag = |at: u8| flags & (1 << at) != 0;
        let covers = Coverage { body: flag(0), arms: [flag(1), flag(2)], hands: [flag(3), flag(4)] };
        let mut number = || {
            let number = Some(tap.f64()?).filter(|number| number.is_finite());
            number.ok_or_else(|| Error::new("it has an error that is no number"))
        };
        let off = Off { direction: number()?, tip_m: number()?, wrist_m: number()? };
        let warnings = tap.list(Tap::text)?;
        let tiers = tap.list(read_tier)?;
        let columns = Columns::read(tap)?;
        let end = usize::try_from(columns.bytes()).ok().and_then(|bytes| at.checked_add(bytes));
        let at = at..end.ok_or_else(|| Error::new("it has more frames than there can be"))?;
        let hash = tap.u64()?;
        Ok(Entry {
            name,
            motion,
            motion_recipe,
            annotations,
            tiers_recipe,
            fps,
            begins,
            joints,
            covers,
            off,
            warnings,
            tiers,
            columns,
            at,
            hash,
        })
    }
}

fn source(sink: &mut Sink, file: &SourceFile) {
    sink.text(&file.path);
    sink.u64(file.stamp.size);
    sink.u64(file.stamp.modified_ns);
    sink.u64(file.hash);
}

fn read_source(tap: &mut Tap<'_>) -> Result<SourceFile, Error> {
    let path = tap.text()?;
    let stamp = Stamp { size: tap.u64()?, modified_ns: tap.u64()? };
    Ok(SourceFile { path, stamp, hash: tap.u64()? })
}

fn write_tier(sink: &mut Sink, tier: &Tier) {
    sink.text(&tier.name);
    sink.list(tier.values(), |sink, value| {
        sink.f64(value.start.0);
        sink.f64(value.end.0);
        sink.text(&value.label);
        sink.text(&value.source);
    });
}

fn read_tier(tap: &mut Tap<'_>) -> Result<Tier, Error> {
    let mut tier = Tier::new(tap.text()?);
    let values = tap.list(|tap| Ok((tap.f64()?, tap.f64()?, tap.text()?, tap.text()?)))?;
    for (start, end, label, source) in values {
        if !(start.is_finite() && end.is_finite()) {
            return Err(Error::new("it has a time that is not finite"));
        }
        tier.push(Seconds(start), Seconds(end), label, source);
    }
    Ok(tier)
}
