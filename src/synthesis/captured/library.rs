//! Takes out of a corpus: which one is meant, cut to one sign, with phases; captured hands; how fast joints turn.

use super::{Pace, Take, Takes};
use crate::body::channel::Channels;
use crate::body::measure::HandForm;
use crate::body::retarget::Coverage;
use crate::body::signer::Signer;
use crate::corpus::index::Index;
use crate::corpus::label::Vocabulary;
use crate::corpus::library::{Library, vocabulary_of};
use crate::corpus::query::{Options, parse};
use crate::corpus::segment::{Component, Segment};
use crate::diagnostics::{Error, Source};
use crate::motion::clip::Clip;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::angle_between;
use crate::motion::skeleton::JointId;
use crate::phonology::grammar::fold;
use crate::phonology::handshape::{HandAngles, HandshapeInventory};
use crate::phonology::{Configuration, Side, label};
use crate::tier::Tier;
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;
use std::collections::BTreeSet;

/// The pace is taken from so many recordings at most, spread over the corpus.
const PACED: usize = 64;
/// So much of a longer recording is taken before and after a sign, seconds, so that phases are known.
const AROUND_S: f64 = 0.5;
/// So many hits are looked through for the stillest hand.
const LOOKED_THROUGH: usize = 48;
/// A captured hand that is farther from the inventory's than this, metres (root mean square over the joints), is not taken for it: what a
/// tracker took for a handshape may be none.
const LIKE_M: f64 = 0.018;

/// A corpus as a source of takes.
pub struct Captures<'l> {
    library: &'l Library,
    signer: Signer,
    vocabulary: Vocabulary,
    index: Index,
    pace: Pace,
    handshapes: HandshapeInventory,
}

impl<'l> Captures<'l> {
    /// Makes ready what retrieval needs.
    ///
    /// # Errors
    /// Damaged recordings.
    pub fn of(library: &'l Library, signer: &Signer) -> Result<Captures<'l>, Error> {
        let vocabulary = vocabulary_of(library.listing(), signer)?;
        let index = library.index(&vocabulary);
        let step = library.len().div_ceil(PACED).max(1);
        let mut paced: Vec<(Clip, Vec<JointId>)> = Vec::new();
        for at in (0..library.len()).step_by(step) {
            paced.push((library.clip(at)?, joints(library.coverage(at), signer)));
        }
        let pace = Pace::of(paced.iter().map(|(clip, joints)| (clip, &joints[..])));
        Ok(Captures {
            library,
            signer: signer.clone(),
            vocabulary,
            index,
            pace,
            handshapes: HandshapeInventory::builtin(),
        })
    }

    /// The glosses that were captured.
    pub fn glosses(&self) -> BTreeSet<String> {
        self.index.glosses().iter().cloned().collect()
    }

    /// How the signer rests: a whole body's first frame in which both hands hang and nothing moves; none where no recording has a body.
    ///
    /// # Errors
    /// Damaged recordings.
    pub fn resting(&self) -> Result<Option<LocalPose>, Error> {
        let (chest, hands) = (self.signer.skeleton.joint("Spine2")?, [Side::Left, Side::Right]);
        for at in (0..self.library.len()).filter(|at| self.library.coverage(*at).body) {
            let clip = self.library.clip(at)?;
            let hangs = |pose: &LocalPose| {
                let model = pose.to_model(&self.signer.skeleton);
                hands.iter().all(|side| {
                    let arm = self.signer.arm(*side);
                    let below = model.position(chest).y - model.position(arm.hand).y;
                    below > 0.7 * arm.length_m()
                })
            };
            if let Some(frame) = clip.frames().iter().find(|frame| hangs(&frame.pose)) {
                let mut pose = frame.pose.clone();
                pose.root_model = self.signer.skeleton.joints()[0].rest_model;
                return Ok(Some(pose));
            }
        }
        Ok(None)
    }

    /// The segments that a query finds; none where it cannot be asked.
    fn find(&self, query: &str, limit: usize) -> Vec<Segment> {
        let Ok(parsed) = parse(&Source::new("query", query), &self.vocabulary) else { return Vec::new() };
        let hits = self.index.find(&parsed.query, &Options { limit, strict: true });
        hits.iter().filter_map(|hit| self.index.segment(hit.segment)).collect()
    }

    /// A stretch of a recording as a take of one sign.
    fn take(&self, recording: usize, sign: Option<&Segment>) -> Result<Take, Error> {
        let (whole, name) = (self.library.clip(recording)?, self.library.take(recording).name.clone());
        let tiers = self.library.tiers(recording);
        let long = whole.duration();
        let one = tiers.iter().filter(|t| t.name.ends_with("Gloss")).all(|t| t.values().len() <= 1);
        let (from, to) = match sign {
            Some(sign) if !one => (sign.start.0 - AROUND_S, sign.end.0 + AROUND_S),
            _ => (0.0, long.0),
        };
        let (from, to) = (from.clamp(0.0, long.0), to.clamp(0.0, long.0));
        let span = sign.filter(|_| !one).map(|sign| (sign.start, sign.end));
        let (clip, begins) = cut(&whole, from, to)?;
        let sides = self.library.coverage(recording);
        let tiers = one_sign(tiers, begins, clip.duration(), span, sides);
        Ok(Take { name, track: Track { clip, tiers }, covers: sides })
    }
}

impl Takes for Captures<'_> {
    /// The take of a gloss whose length is the median of all its takes: neither hurried nor drawn out.
    fn of_gloss(&self, gloss: &str) -> Result<Option<Take>, Error> {
        let known = self.index.glosses().iter().find(|known| fold(known) == fold(gloss));
        let Some(known) = known else { return Ok(None) };
        let mut all = self.find(&format!("gloss={}", quoted(known)), self.index.len());
        all.sort_by(|a, b| {
            let lengths = a.duration().0.total_cmp(&b.duration().0);
            lengths.then(a.recording.cmp(&b.recording)).then(a.start.0.total_cmp(&b.start.0))
        });
        match all.get(all.len() / 2) {
            Some(segment) => self.take(segment.recording, Some(segment)).map(Some),
            None => Ok(None),
        }
    }

    fn named(&self, name: &str) -> Result<Take, Error> {
        let folded = fold(name);
        let found = (0..self.library.len()).find(|at| fold(&self.library.take(*at).name) == folded);
        match found {
            Some(at) => self.take(at, None),
            None => {
                let names = (0..self.library.len()).map(|at| self.library.take(at).name.as_str());
                let near = crate::diagnostics::suggest::nearest(name, names);
                let hint = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
                Err(Error::new(format!("the corpus has no take `{name}`{hint}")))
            }
        }
    }

    /// The hand of that configuration in the frame of slowest fingers of its intervals (facts, papers-decisions 8).
    fn configuration(&self, configuration: &Configuration) -> Option<(HandAngles, String)> {
        let name = label::configuration(configuration);
        let asked = fold(&name);
        let wanted = HandForm::of_angles(&self.signer, &self.handshapes.angles(configuration, None).ok()?);
        let mut best: Option<(f64, HandAngles, String)> = None;
        for segment in self.find(&format!("configuration={}", quoted(&name)), LOOKED_THROUGH) {
            let side = segment.side?;
            let Ok(clip) = self.library.clip(segment.recording) else { continue };
            let own = segment.of(Component::Configuration).iter().filter(|value| fold(&value.label) == asked);
            for value in own {
                let Some((speed, frame)) = self.stillest(&clip, side, value.start, value.end) else { continue };
                let angles = self.signer.hand(side).angles_of(&clip.frames()[frame].pose);
                let alike = HandForm::of_angles(&self.signer, &angles).distance(&wanted) < LIKE_M;
                if alike && best.as_ref().is_none_or(|(least, ..)| speed < *least) {
                    let at = clip.fps().time_of(FrameIndex(frame));
                    let from = &self.library.take(segment.recording).name;
                    best = Some((speed, angles, format!("corpus: {from} at {at}")));
                }
            }
        }
        best.map(|(_, angles, source)| (angles, source))
    }

    fn pace(&self) -> &Pace {
        &self.pace
    }
}

impl Captures<'_> {
    /// The frame in which the fingers turn least, and by how much, radians a second.
    fn stillest(&self, clip: &Clip, side: Side, start: Seconds, end: Seconds) -> Option<(f64, usize)> {
        let fps = clip.fps().get();
        let last = clip.frames().len().checked_sub(2)?;
        let first = ((start.0 * fps).ceil().max(1.0) as usize).min(last.max(1));
        let until = ((end.0 * fps).floor().max(0.0) as usize).clamp(first, last.max(first));
        let joints = self.signer.hand(side).joints();
        let turn = |i: usize| {
            let (a, b) = (&clip.frames()[i - 1].pose, &clip.frames()[(i + 1).min(last + 1)].pose);
            joints.iter().map(|j| angle_between(a.rotation(*j), b.rotation(*j))).sum::<f64>() * fps / 2.0
        };
        (first..=until).map(|i| (turn(i), i)).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// A value as a query writes it.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// The joints that a recording moves.
fn joints(covers: Coverage, signer: &Signer) -> Vec<JointId> {
    let mut all = Vec::new();
    for side in [Side::Left, Side::Right] {
        let channels = Channels::of(signer, side);
        if covers.arms[side as usize] {
            all.extend(channels.placement.iter().chain(&channels.orientation[..1]));
        }
        if covers.hands[side as usize] {
            all.extend(channels.configuration);
        }
    }
    if covers.body {
        let named = ["Hips", "Spine", "Spine1", "Spine2", "Neck", "Head"];
        all.extend(named.iter().filter_map(|name| signer.skeleton.find(name)));
    }
    all
}

/// The frames between two instants, and the instant of the first.
fn cut(clip: &Clip, from: f64, to: f64) -> Result<(Clip, Seconds), Error> {
    let fps = clip.fps();
    let last = clip.frames().len() - 1;
    let first = ((from * fps.get()).round() as usize).min(last);
    let until = ((to * fps.get()).round() as usize).clamp(first, last);
    let frames = clip.frames()[first..=until].to_vec();
    let part = Clip::new(clip.skeleton().clone(), fps, clip.morphs().clone(), frames);
    let part = part.ok_or_else(|| Error::new("there are no frames in the sign"))?;
    Ok((part, fps.time_of(FrameIndex(first))))
}

/// The tiers of a stretch with the phases of one sign: from its first stroke to its last hold it is stroke and hold, what lies before is
/// preparation, what lies after retraction. A hand whose phases are not known does it all in its stroke.
fn one_sign(
    tiers: &[Tier],
    begins: Seconds,
    duration: Seconds,
    span: Option<(Seconds, Seconds)>,
    covers: Coverage,
) -> Vec<Tier> {
    let mut made = Vec::new();
    let (low, high) = span.map_or((0.0, duration.0), |(a, b)| (a.0 - begins.0, b.0 - begins.0));
    for tier in tiers.iter().filter(|tier| !tier.name.ends_with("Phase")) {
        let mut part = Tier::new(tier.name.clone());
        for v in tier.values() {
            let (start, end) = (v.start.0 - begins.0, v.end.0 - begins.0);
            if end > low && start < high {
                part.push(Seconds(start.max(0.0)), Seconds(end.min(duration.0)), v.label.clone(), v.source.clone());
            }
        }
        if !part.values().is_empty() {
            made.push(part);
        }
    }
    for side in [Side::Right, Side::Left] {
        let prefix = side.hand();
        let name = format!("{prefix} Phase");
        let glossed = made.iter().any(|tier| tier.name == format!("{prefix} Gloss"));
        let acts = covers.arms[side as usize] || covers.hands[side as usize];
        if !acts || !(glossed || span.is_none() && !made.iter().any(|tier| tier.name.ends_with("Gloss"))) {
            continue;
        }
        let phases: Vec<(f64, f64, &str)> = tiers
            .iter()
            .filter(|tier| tier.name == name)
            .flat_map(Tier::values)
            .map(|v| ((v.start.0 - begins.0).max(low), (v.end.0 - begins.0).min(high), v.label.as_str()))
            .filter(|(start, end, _)| end > start)
            .collect();
        let signing = |(_, _, label): &&(f64, f64, &str)| *label == "stroke" || *label == "hold";
        let first = phases.iter().filter(signing).map(|p| p.0).reduce(f64::min).unwrap_or(low);
        let last = phases.iter().filter(signing).map(|p| p.1).reduce(f64::max).unwrap_or(high);
        // A hold at the end is one; holds between strokes are part of the sign's one stroke.
        let moved = phases.iter().filter(|p| p.2 == "stroke").map(|p| p.1).reduce(f64::max).unwrap_or(last);
        let mut tier = Tier::new(name);
        for (start, end, label) in
            [(low, first, "preparation"), (first, moved, "stroke"), (moved, last, "hold"), (last, high, "retraction")]
        {
            if end - start > 1e-6 {
                tier.push(Seconds(start), Seconds(end), label, "measured");
            }
        }
        made.push(tier);
    }
    made
}
