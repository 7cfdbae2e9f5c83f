//! A recording's motion: from its file's bytes to a clip in metres whose joints are known.

use super::files::{Finding, Place};
use super::manifest::{Manifest, Rig, Take};
use crate::body::retarget::names::{Recognised, recognise};
use crate::body::retarget::{Axes, Mode, begins_with_t_pose, propose_axes, stands};
use crate::diagnostics::{Diagnostic, Source};
use crate::format::bvh::{self, Bvh, ClipOptions, Roots};
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::time::Seconds;
use glam::{DQuat, DVec3};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

/// A recording as its file has it, in metres, in the file's own space.
#[derive(Debug, Clone)]
pub struct Captured {
    /// The motion, less the frames that are not to be used.
    pub clip: Clip,
    /// The instant of the file that the clip begins at.
    pub begins: Seconds,
    /// How long the whole file is.
    pub file_duration: Seconds,
    /// Our joint to the file's.
    pub joints: BTreeMap<String, String>,
    /// Where up and front are.
    pub axes: Axes,
    /// How the body stands where bones are compared with ours: an inserted T-pose, else at rest.
    pub stands: LocalPose,
    /// What of its motion is kept.
    pub mode: Mode,
    /// The size of the body, or of the hand, in metres.
    pub size: Option<Size>,
    /// What is odd about the file.
    pub findings: Vec<Finding>,
}

/// How large what was recorded is at rest, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Size {
    /// The largest extent of a whole body.
    Body(f64),
    /// From the wrist to the tip of the longest finger.
    Hand(f64),
}

/// The extents of people, metres: see [`propose_unit`](bvh::propose_unit).
pub const PERSON_M: std::ops::Range<f64> = 1.2..2.3;

/// Lengths of hands from the wrist to the tip of the longest finger, metres: from a child's to a large man's, with room for
/// how sensors see them.
pub const HAND_M: std::ops::Range<f64> = 0.11..0.26;

/// Units that hands are recorded in, the frequent ones first.
const HAND_UNITS: [(f64, &str); 4] = [(0.001, "millimetre"), (0.01, "centimetre"), (1.0, "metre"), (0.0254, "inch")];

/// Metres in one unit of the file, and the unit's name: that which makes the body a person's, or a hand alone a hand.
pub fn propose_unit(file: &Bvh, joints: &BTreeMap<String, String>) -> Option<(f64, &'static str)> {
    if let Some(proposal) = bvh::propose_unit(file) {
        return Some((proposal.metres_per_unit, proposal.name));
    }
    let length = hand_length(file, joints)?;
    HAND_UNITS.into_iter().find(|(metres, _)| HAND_M.contains(&(length * metres)))
}

/// From the wrist along the bones to the tip of the longest finger, in the file's unit, for a hand without a body.
fn hand_length(file: &Bvh, joints: &BTreeMap<String, String>) -> Option<f64> {
    let wrist = ["RightHand", "LeftHand"].into_iter().find_map(|hand| joints.get(hand))?;
    let wrist = file.joints().iter().position(|joint| joint.name == *wrist)?;
    let mut along: Vec<Option<f64>> = vec![None; file.joints().len()];
    let mut longest: f64 = 0.0;
    for (at, joint) in file.joints().iter().enumerate() {
        along[at] = match joint.parent {
            _ if at == wrist => Some(0.0),
            Some(parent) => along[parent].map(|way| way + joint.offset.length()),
            None => None,
        };
        if let Some(way) = along[at] {
            longest = joint.end_sites.iter().map(|tip| way + tip.length()).fold(longest.max(way), f64::max);
        }
    }
    (longest > 0.0).then_some(longest)
}

/// How large a file's body or hand is.
fn size(file: &Bvh, joints: &BTreeMap<String, String>, metres: f64) -> Option<Size> {
    if !joints.contains_key("Hips") && !joints.contains_key("Spine") {
        return hand_length(file, joints).map(|length| Size::Hand(length * metres));
    }
    let rest = file.rest_positions();
    let tips =
        file.joints().iter().zip(&rest).flat_map(|(joint, at)| joint.end_sites.iter().map(move |tip| *at + *tip));
    let points = rest.iter().copied().chain(tips);
    let (low, high) =
        points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)));
    Some(Size::Body((high - low).max_element() * metres))
}

/// The names that a file gives our joints: what the skeleton says, else what is known of them.
pub fn joints_of(file: &Bvh, rig: Option<&Rig>) -> BTreeMap<String, String> {
    match rig.filter(|rig| !rig.joints.is_empty()) {
        Some(rig) => rig.joints.iter().map(|(ours, theirs)| (ours.value.clone(), theirs.value.clone())).collect(),
        None => recognised(file).joints,
    }
}

/// What is known of a file's joint names; nothing, where it has no frame or no skeleton can be made of it.
pub fn recognised(file: &Bvh) -> Recognised {
    let row = file.rows().next().map(<[f64]>::to_vec).unwrap_or_default();
    let first = Bvh::new(file.joints().to_vec(), file.frame_time(), row);
    let options = ClipOptions { metres_per_unit: 1.0, roots: Roots::First };
    let first = first.and_then(|first| bvh::to_clip(&first, &options));
    match first {
        Ok(first) => recognise(first.clip.skeleton()),
        Err(_) => Recognised { convention: "other", joints: BTreeMap::new(), unknown: Vec::new() },
    }
}

/// Findings about a text that a manifest names, with its text.
pub(super) fn located(path: &Path, bytes: &[u8], diagnostics: Vec<Diagnostic>) -> Vec<Finding> {
    if diagnostics.is_empty() {
        return Vec::new();
    }
    let source: Arc<Source> = Arc::new(bvh::source_of_bytes(&path.to_string_lossy(), bytes));
    diagnostics.into_iter().map(|diagnostic| Finding { source: source.clone(), diagnostic }).collect()
}

/// Reads a recording's motion.
///
/// # Errors
/// The file's own faults; no joint that is known; a unit that cannot be told; frames that leave nothing to use.
pub fn captured(bytes: &[u8], take: &Take, manifest: &Manifest, text: &Arc<Source>) -> Result<Captured, Vec<Finding>> {
    let reading = bvh::read(bytes).map_err(|faults| located(&take.motion, bytes, faults))?;
    let mut findings = located(&take.motion, bytes, reading.warnings);
    let file = reading.bvh;
    let rig = rig_of(&file, take, manifest);
    let joints = known_joints(&file, take, rig, text, &mut findings).map_err(|fault| vec![fault])?;
    let metres = match rig.and_then(|rig| rig.unit) {
        Some(unit) => unit.value.0,
        None => propose_unit(&file, &joints).map(|(metres, _)| metres).ok_or_else(|| {
            let fault = take.place.fault(format!("the unit of length of {} cannot be told", take.motion.display()));
            vec![fault.hint("say it: `unit:` of a skeleton, such as cm, mm, or metres in one unit")]
        })?,
    };
    let options = ClipOptions { metres_per_unit: metres, roots: Roots::First };
    let fault = |e: crate::diagnostics::Error| vec![take.place.fault(format!("{}: {e}", take.motion.display()))];
    let converted = bvh::to_clip(&file, &options).map_err(fault)?;
    findings.extend(converted.warnings.iter().map(|told| take.place.warning(format!("{}: {told}", take.name))));
    let whole = converted.clip;
    let axes = axes_of(&whole, &joints, rig).ok_or_else(|| {
        let fault = take.place.fault(format!("{}: up and front of its skeleton are one line", take.name));
        vec![fault]
    })?;
    let file_duration = whole.duration();
    let skips = rig.is_some_and(|rig| rig.skip_frames.value > 0);
    let stands = if skips { stands(&whole) } else { LocalPose::rest(whole.skeleton()) };
    let (clip, begins) = cut(&whole, take, rig, &mut findings).map_err(|fault| vec![fault])?;
    let (size, mode) = (size(&file, &joints, metres), rig.map(|rig| rig.mode.value).unwrap_or_default());
    Ok(Captured { clip, begins, file_duration, size, joints, axes, stands, mode, findings })
}

/// The axes that the skeleton says, where it says none those that the motion shows; `None` where they are one line.
fn axes_of(clip: &Clip, joints: &BTreeMap<String, String>, rig: Option<&Rig>) -> Option<Axes> {
    let proposed = propose_axes(clip, joints);
    let up = rig.and_then(|rig| rig.up).map_or(proposed.up(), |up| up.value);
    let front = rig.and_then(|rig| rig.front).map_or(proposed.front(), |front| front.value);
    Axes::new(up, front)
}

/// The skeleton of a recording: the one that is named, else of those whose joints the file has all, the one with the most.
pub fn rig_of<'m>(file: &Bvh, take: &Take, manifest: &'m Manifest) -> Option<&'m Rig> {
    if let Some(rig) = take.rig.and_then(|at| manifest.skeletons.get(at)) {
        return Some(rig);
    }
    let names: BTreeSet<&str> = file.joints().iter().map(|joint| joint.name.as_str()).collect();
    let has_all = |rig: &&Rig| rig.joints.iter().all(|(_, theirs)| names.contains(theirs.value.as_str()));
    let fitting = manifest.skeletons.iter().filter(|rig| !rig.joints.is_empty()).filter(has_all);
    // Of equals the first, as people read.
    fitting.fold(None, |best: Option<&Rig>, rig| match best {
        Some(best) if best.joints.len() >= rig.joints.len() => Some(best),
        _ => Some(rig),
    })
}

/// Whether the first frame is no motion: nearly all joints stand as at rest, and the next frame is far from there. Some
/// programs put such a T-pose in front.
pub fn begins_at_rest(clip: &Clip) -> bool {
    const RESTS: f64 = 0.5 * std::f64::consts::PI / 180.0;
    const MOST_JOINTS: f64 = 0.65;
    const FEWER: f64 = 0.2;
    const FAR: f64 = 5.0 * std::f64::consts::PI / 180.0;
    let [first, second, ..] = clip.frames() else { return false };
    let joints = clip.skeleton().len() as f64;
    let resting = |frame: &Frame| {
        let rests = frame.pose.rotations.iter().filter(|q| q.angle_between(DQuat::IDENTITY) < RESTS);
        rests.count() as f64 / joints
    };
    let pairs = first.pose.rotations.iter().zip(&second.pose.rotations);
    let way = pairs.map(|(a, b)| a.angle_between(*b)).sum::<f64>() / joints;
    let leaps = resting(first) >= MOST_JOINTS && resting(first) - resting(second) >= FEWER && way > FAR;
    leaps || begins_with_t_pose(clip)
}

/// The joints that the file has of those that the skeleton names; the others are told.
fn known_joints(
    file: &Bvh,
    take: &Take,
    rig: Option<&Rig>,
    text: &Arc<Source>,
    findings: &mut Vec<Finding>,
) -> Result<BTreeMap<String, String>, Finding> {
    let has = |name: &str| file.joints().iter().any(|joint| joint.name == name);
    let mut joints = joints_of(file, rig);
    joints.retain(|_, theirs| has(theirs));
    if joints.is_empty() {
        let fault = take.place.fault(format!("{} has no joint that is known", take.motion.display()));
        let names: Vec<&str> = file.joints().iter().take(8).map(|joint| joint.name.as_str()).collect();
        return Err(fault
            .label(format!("its joints are {}, ...", names.join(", ")))
            .hint("say which joint is which: `joints:` of a skeleton, ours: theirs"));
    }
    for (_, theirs) in rig.iter().flat_map(|rig| &rig.joints).filter(|(_, theirs)| !has(&theirs.value)) {
        let place = Place { source: text.clone(), span: theirs.span };
        let told = place.warning(format!("{} has no joint `{}`", take.motion.display(), theirs.value));
        let near = crate::diagnostics::suggest::nearest(&theirs.value, file.joints().iter().map(|j| j.name.as_str()));
        findings.push(match near {
            Some(name) => told.label(format!("did you mean `{name}`?")),
            None => told.label("this joint stays at rest"),
        });
    }
    Ok(joints)
}

/// The frames to use, and the file's instant of the first of them.
fn cut(whole: &Clip, take: &Take, rig: Option<&Rig>, findings: &mut Vec<Finding>) -> Result<(Clip, Seconds), Finding> {
    let fps = whole.fps().get();
    let count = whole.frames().len();
    // Frames whose instants lie within the span, up to rounding noise.
    let frame = |seconds: f64, round: fn(f64) -> f64| round(seconds * fps).clamp(0.0, count as f64) as usize;
    let [from, to] = take.span.unwrap_or([0.0, f64::MAX]);
    let skipped = rig.map_or(0, |rig| rig.skip_frames.value as usize);
    let first = frame(from - 1e-6, f64::ceil).max(skipped);
    let end = frame(to + 1e-6, f64::floor).saturating_add(1).min(count);
    if take.span.is_some() && to != f64::MAX && to > whole.duration().0 + 1.0 / fps {
        let told = take.place.warning(format!("{}: the span ends after the motion, at {to} s", take.name));
        findings.push(told.label(format!("it is {:.2} s long", whole.duration().0)));
    }
    let frames = whole.frames().get(first..end).unwrap_or_default().to_vec();
    let clip = Clip::new(whole.skeleton().clone(), whole.fps(), whole.morphs().clone(), frames);
    let nothing = || {
        let fault = take.place.fault(format!("{}: no frame is left to use of {count}", take.name));
        fault.hint("`skip_frames` of its skeleton and its `span` leave them out")
    };
    Ok((clip.ok_or_else(nothing)?, Seconds(first as f64 / fps)))
}
