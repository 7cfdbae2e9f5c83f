//! Pieces of motion joined by eased ways.

use super::Pace;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Frame;
use crate::motion::easing::Easing;
use crate::motion::rotation::angle_between;
use crate::phonology::{Configuration, Side};
use crate::synthesis::edit::track::Phases;
use crate::synthesis::edit::{self, Sides, Way};
use crate::synthesis::report::Report;
use crate::synthesis::{Grammar, Options};
use crate::tier::Tier;
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;

/// A way takes this long at least, seconds.
const LEAST_WAY_S: f64 = 0.15;
/// The body's own place moves no faster than this on a way, metres a second.
const ROOT_SPEED: f64 = 1.0;
/// Wrists move no faster than this on a way, metres a second.
const WRIST_SPEED: f64 = 3.0;
/// The signer stands this long before and after, seconds.
const STILL_S: f64 = 0.2;

/// One thing after another.
pub(super) enum Piece {
    /// Frames of signs, with their tiers from the first frame on, and the hands that act in them.
    Signs { frames: Vec<Frame>, tiers: Vec<Tier>, sides: Sides },
    /// The posture reached is held, seconds.
    Hold(f64),
    /// The neutral pose, seconds.
    Rest(f64),
}

impl Piece {
    /// Stroke and hold of the one sign of a track.
    pub fn of_sign(track: &Track) -> Result<Piece, Error> {
        let phases = Phases::of(track)?;
        Piece::cut(track, phases.stroke, phases.sign_end)
    }

    /// What lies between two instants of a track.
    pub fn cut(track: &Track, start: Seconds, end: Seconds) -> Result<Piece, Error> {
        let fps = track.clip.fps();
        let last = track.clip.frames().len() - 1;
        let first = ((start.0 * fps.get()).round().max(0.0) as usize).min(last);
        let until = ((end.0 * fps.get()).round().max(0.0) as usize).clamp(first, last);
        let (from, to) = (fps.time_of(FrameIndex(first)), fps.time_of(FrameIndex(until)));
        let mut tiers = Vec::new();
        for tier in &track.tiers {
            let mut kept = Tier::new(tier.name.clone());
            for v in tier.values() {
                let (a, b) = (v.start.0.max(from.0), v.end.0.min(to.0));
                if b > a || (v.start == v.end && a == b) {
                    kept.push(Seconds(a) - from, Seconds(b) - from, v.label.clone(), v.source.clone());
                }
            }
            if !kept.values().is_empty() {
                tiers.push(kept);
            }
        }
        let acts = |prefix: &str| tiers.iter().any(|tier: &Tier| tier.name == format!("{prefix} Phase"));
        let sides = match (acts("RH"), acts("LH")) {
            (true, true) => Sides::Both,
            (false, true) => Sides::Left,
            (true, false) => Sides::Right,
            (false, false) => return Err(Error::new("a sign has no phases")),
        };
        Ok(Piece::Signs { frames: track.clip.frames()[first..=until].to_vec(), tiers, sides })
    }
}

/// All pieces as one track.
pub(super) struct Joined {
    pub track: Track,
    pub report: Report,
}

/// Joins pieces, from the neutral pose and back to it.
pub(super) fn join(
    pieces: Vec<Piece>,
    pace: &Pace,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<Joined, Error> {
    let rest = grammar.handshapes.angles(&Configuration::named("rest"), None).map_err(|e| Error::new(e.to_string()))?;
    let neutral = Frame { pose: signer.neutral(&rest), weights: vec![0.0; signer.morphs.len()] };
    let mut line =
        Line { frames: vec![neutral.clone()], tiers: Vec::new(), pace, signer, options, first: None, last: 0 };
    line.stay(STILL_S);
    let mut acting = Sides::Both;
    for piece in pieces {
        match piece {
            Piece::Signs { frames, tiers, sides } => {
                let way = if line.first.is_none() || line.rested(&neutral) { "preparation" } else { "transition" };
                line.way_to(&frames[0], way, sides)?;
                line.signs(frames, tiers)?;
                acting = sides;
            }
            Piece::Hold(seconds) => {
                let start = line.now();
                line.stay(seconds);
                line.phase("hold", start, acting);
                line.last = line.frames.len() - 1;
            }
            Piece::Rest(seconds) => {
                line.way_to(&neutral, "retraction", acting)?;
                line.stay(seconds);
            }
        }
    }
    line.way_to(&neutral, "retraction", acting)?;
    line.stay(STILL_S);
    line.done()
}

/// What was joined so far.
struct Line<'a> {
    frames: Vec<Frame>,
    tiers: Vec<Tier>,
    pace: &'a Pace,
    signer: &'a Signer,
    options: &'a Options,
    /// The first frame of a sign.
    first: Option<usize>,
    /// The last frame of one.
    last: usize,
}

impl Line<'_> {
    fn now(&self) -> Seconds {
        self.options.fps.time_of(FrameIndex(self.frames.len() - 1))
    }

    fn rested(&self, neutral: &Frame) -> bool {
        self.frames.last().is_some_and(|frame| frame.pose.rotations == neutral.pose.rotations)
    }

    fn stay(&mut self, seconds: f64) {
        let frame = self.frames[self.frames.len() - 1].clone();
        let count = (seconds * self.options.fps.get() / self.options.speed).round().max(0.0) as usize;
        self.frames.extend(std::iter::repeat_n(frame, count));
    }

    /// An eased way to a frame, without the frame itself.
    fn way_to(&mut self, to: &Frame, label: &str, sides: Sides) -> Result<(), Error> {
        let from = self.frames[self.frames.len() - 1].clone();
        let easing = self.options.easing;
        let seconds = least_way(&from, to, self.pace, self.signer, easing) / self.options.speed;
        let count = (seconds * self.options.fps.get()).ceil().max(1.0) as usize;
        edit::may_last((self.frames.len() + count) as f64)?;
        let start = self.now();
        let way = Way::new(&from, to, easing);
        self.frames.extend((1..count).map(|i| way.at(i as f64 / count as f64)));
        self.frames.push(to.clone());
        self.phase(label, start, sides);
        Ok(())
    }

    fn phase(&mut self, label: &str, start: Seconds, sides: Sides) {
        let end = self.now();
        for side in sides.each() {
            let prefix = side.hand();
            self.tier(&format!("{prefix} Phase")).push(start, end, label, "procedure");
        }
    }

    fn tier(&mut self, name: &str) -> &mut Tier {
        let at = self.tiers.iter().position(|tier| tier.name == name).unwrap_or_else(|| {
            self.tiers.push(Tier::new(name));
            self.tiers.len() - 1
        });
        &mut self.tiers[at]
    }

    /// Frames whose first one the way has reached already.
    fn signs(&mut self, frames: Vec<Frame>, tiers: Vec<Tier>) -> Result<(), Error> {
        edit::may_last((self.frames.len() + frames.len()) as f64)?;
        let start = self.now();
        self.first.get_or_insert(self.frames.len() - 1);
        for tier in tiers {
            let own = self.tier(&tier.name);
            for v in tier.values() {
                own.push(start + v.start, start + v.end, v.label.clone(), v.source.clone());
            }
        }
        self.frames.extend(frames.into_iter().skip(1));
        self.last = self.frames.len() - 1;
        Ok(())
    }

    fn done(mut self) -> Result<Joined, Error> {
        edit::continue_signs(&mut self.frames, 1);
        let fps = self.options.fps;
        let mut report = Report {
            stroke_start: fps.time_of(FrameIndex(self.first.unwrap_or(0))),
            sign_end: fps.time_of(FrameIndex(self.last)),
            ..Report::default()
        };
        let clip = crate::synthesis::clip(self.signer, fps, self.frames)?;
        for side in [Side::Left, Side::Right] {
            let path = edit::wrist_path(&clip, self.signer, side);
            let speeds = crate::motion::profile::speed(&path, fps);
            report.wrist_speed = speeds.into_iter().fold(report.wrist_speed, f64::max);
        }
        Ok(Joined { track: Track { clip, tiers: edit::track::in_order(self.tiers) }, report })
    }
}

/// How long the way from one frame to another takes at least, seconds: no joint turns faster than the pace, and no wrist is faster
/// than signers' are.
pub fn least_way(from: &Frame, to: &Frame, pace: &Pace, signer: &Signer, easing: Easing) -> f64 {
    const STEPS: u32 = 64;
    let at = |i: u32| easing.weight(f64::from(i) / f64::from(STEPS));
    let steepest = (0..STEPS).map(|i| (at(i + 1) - at(i)) * f64::from(STEPS)).fold(1.0, f64::max);
    let turns = signer.skeleton.ids().map(|joint| {
        angle_between(from.pose.rotation(joint), to.pose.rotation(joint)) * steepest / pace.of_joint(joint)
    });
    let moved = from.pose.root_model.distance(to.pose.root_model) * steepest / ROOT_SPEED;
    // The wrist's way is curved; it is measured on a few frames of it.
    let way = Way::new(from, to, easing);
    let wrists = |i: u32| {
        let model = way.at(f64::from(i) / f64::from(STEPS)).pose.to_model(&signer.skeleton);
        [Side::Left, Side::Right].map(|side| model.position(signer.arm(side).hand))
    };
    let places: Vec<_> = (0..=STEPS).map(wrists).collect();
    let steps = places.windows(2).flat_map(|w| [w[0][0].distance(w[1][0]), w[0][1].distance(w[1][1])]);
    let fastest = steps.fold(0.0, f64::max) * f64::from(STEPS) / WRIST_SPEED;
    turns.fold(LEAST_WAY_S.max(moved).max(fastest), f64::max)
}
