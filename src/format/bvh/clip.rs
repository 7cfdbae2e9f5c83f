//! From a BVH file's data to a clip in metres.

use super::data::{Bvh, Channel, Joint};
use super::euler::about;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::{self, JointId, Skeleton};
use crate::time::{Fps, Seconds};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// Farther from the origin, metres, nobody signs: sums and squares of such lengths would run out of `f64`.
const FARTHEST_M: f64 = 1e9;

/// What to do with a file of several roots; a clip has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Roots {
    /// Refuse it.
    One,
    /// Take the first root and what hangs on it.
    First,
}

/// What a file does not say about itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClipOptions {
    /// Metres in one unit of the file: 0.01 for our own; see [`propose_unit`](super::propose_unit).
    pub metres_per_unit: f64,
    /// Several roots.
    pub roots: Roots,
}

impl Default for ClipOptions {
    /// Centimetres, one root: what [`write`](super::write()) writes.
    fn default() -> ClipOptions {
        ClipOptions { metres_per_unit: 0.01, roots: Roots::One }
    }
}

/// A clip, and what of the file it cannot hold.
#[derive(Debug, Clone)]
pub struct Converted {
    /// The motion, in metres, in the file's own space (not every file is Y up).
    pub clip: Clip,
    /// What is lost, each a sentence.
    pub warnings: Vec<String>,
}

/// The clip of a file: rest rotations are identities, offsets are the bones, End Sites their tails (of several, the
/// first). A frame rate within a ten-thousandth of a whole one, or of one of television, is taken as that.
///
/// Position channels move the root; on other joints a clip cannot hold them, and a warning says how far they move
/// what. Coordinates without a channel come from the offset. The rest position of a root with offset 0 0 0 is 0 0 0.
///
/// # Errors
/// No rows; several roots (with [`Roots::One`]); two joints of one name; more joints than a skeleton may have; a frame
/// time that is no rate up to [`Fps::MAX`]; a unit that is not above 0; joints farther than a million kilometres from
/// the origin; so few channels on so many joints that the clip would be out of proportion to the file.
///
/// ```
/// use chereme::format::bvh;
/// let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 1 Yposition\n End Site {\n OFFSET 0 10 0 } }\n\
///             MOTION\nFrames: 1\nFrame Time: 0.0333333\n95\n";
/// let bvh = bvh::read(text.as_bytes()).unwrap().bvh;
/// let clip = bvh::to_clip(&bvh, &bvh::ClipOptions::default()).unwrap().clip;
/// assert_eq!(clip.fps().get(), 30.0);
/// assert!(clip.frames()[0].pose.root_model.distance(glam::DVec3::new(0.0, 0.95, 0.0)) < 1e-12);
/// ```
pub fn to_clip(bvh: &Bvh, options: &ClipOptions) -> Result<Converted, Error> {
    let scale = options.metres_per_unit;
    if !(scale > 0.0 && scale.is_finite()) {
        return Err(Error::new(format!("{scale} metres are no unit of length")));
    }
    let (joints, mut warnings) = one_root(bvh, options.roots)?;
    let rate = fps(bvh.frame_time())?;
    let frames = bvh.rows().len();
    if frames.saturating_mul(joints.len()) > 1_000_000 + 32 * frames * bvh.channel_count() {
        let message = format!("{} joints have {} channels between them", joints.len(), bvh.channel_count());
        return Err(Error::new(message).context("the file has too many joints that never move"));
    }
    let skeleton = skeleton(joints, scale)?;
    let readers = readers(joints);
    let frame = |row: &[f64]| Frame { pose: pose(row, joints, &readers, scale), weights: vec![] };
    let frames: Vec<Frame> = bvh.rows().map(frame).collect();
    if let Some(at) = frames.iter().position(|frame| !is_near(frame.pose.root_model)) {
        return Err(Error::new(format!("row {at} has its root more than {FARTHEST_M} m away")));
    }
    let clip = Clip::new(Arc::new(skeleton), rate, Arc::new(vec![]), frames);
    let clip = clip.ok_or_else(|| Error::new("the file has no rows, so there is no motion"))?;
    warnings.extend(moved(bvh, joints, &readers, scale));
    Ok(Converted { clip, warnings })
}

fn is_near(place: DVec3) -> bool {
    place.abs().max_element() <= FARTHEST_M
}

/// The first root and all below it: they come first in the file, and so do their channels.
fn one_root(bvh: &Bvh, roots: Roots) -> Result<(&[Joint], Vec<String>), Error> {
    let all = bvh.joints();
    let second = all.iter().skip(1).position(|j| j.parent.is_none()).map(|at| at + 1);
    match (second, roots) {
        (None, _) => Ok((all, vec![])),
        (Some(second), Roots::First) => {
            let left = &all[second];
            let n = all.len() - second;
            Ok((&all[..second], vec![format!("{n} joints, from the second root {} on, are left out", left.name)]))
        }
        (Some(second), Roots::One) => Err(Error::new(format!(
            "the file has several roots ({}, {}), and a clip has one; take the first, or cut the file apart",
            all[0].name, all[second].name
        ))),
    }
}

/// The frame rate of a frame time: whole and television rates come back from the six or eight decimals they are written with.
fn fps(frame_time: Seconds) -> Result<Fps, Error> {
    const NEAR: f64 = 1e-4;
    let exact = 1.0 / frame_time.0;
    let whole = exact.round();
    let television = (exact * 1.001).round() / 1.001;
    let near = |rate: f64, within: f64| rate > 0.0 && (exact / rate - 1.0).abs() < within;
    let rate = match () {
        () if near(whole, NEAR) => whole,
        () if near(television, NEAR / 10.0) => television,
        () => exact,
    };
    let message = || Error::new(format!("a frame time of {} s is no frame rate up to {}", frame_time.0, Fps::MAX));
    Fps::new(rate).ok_or_else(message)
}

fn skeleton(joints: &[Joint], scale: f64) -> Result<Skeleton, Error> {
    let mut made: Vec<skeleton::Joint> = Vec::with_capacity(joints.len());
    for joint in joints {
        let parent = match joint.parent {
            None => None,
            Some(at) => Some(u16::try_from(at).map(JointId).map_err(|_| Error::new("the file has too many joints"))?),
        };
        let above = joint.parent.map_or(DVec3::ZERO, |at| made[at].rest_model);
        let rest_model = above + joint.offset * scale;
        let tail_model = rest_model + joint.end_sites.first().map_or(DVec3::ZERO, |e| *e * scale);
        if !(is_near(rest_model) && is_near(tail_model)) {
            return Err(Error::new(format!("joint {} rests more than {FARTHEST_M} m away", joint.name)));
        }
        made.push(skeleton::Joint { name: joint.name.clone(), parent, rest_model, tail_model });
    }
    tails(joints, &mut made);
    Skeleton::new(made).map_err(|e| e.context("the file's joints make no skeleton"))
}

/// A joint without an End Site ends at its first child.
fn tails(joints: &[Joint], made: &mut [skeleton::Joint]) {
    for (at, joint) in joints.iter().enumerate().rev() {
        if let Some(parent) = joint.parent.filter(|p| joints[*p].end_sites.is_empty()) {
            made[parent].tail_model = made[at].rest_model;
        }
    }
}

/// The number of each joint's first channel in a row.
fn readers(joints: &[Joint]) -> Vec<usize> {
    let first = |sum: &mut usize, joint: &Joint| {
        let at = *sum;
        *sum += joint.channels.len();
        Some(at)
    };
    joints.iter().scan(0, first).collect()
}

fn pose(row: &[f64], joints: &[Joint], readers: &[usize], scale: f64) -> LocalPose {
    let rotation = |(joint, first): (&Joint, &usize)| {
        let turn = |q: DQuat, (channel, value): (&Channel, &f64)| match channel {
            Channel::Position(_) => q,
            Channel::Rotation(axis) => q * about(*axis, value.to_radians()),
        };
        joint.channels.iter().zip(&row[*first..]).fold(DQuat::IDENTITY, turn).normalize()
    };
    let root_model = position(&joints[0], row) * scale;
    LocalPose { root_model, rotations: joints.iter().zip(readers).map(rotation).collect() }
}

/// Where a joint stands in its parent's space, in the file's unit; `row` begins with its channels.
fn position(joint: &Joint, row: &[f64]) -> DVec3 {
    let mut at = joint.offset;
    for (channel, value) in joint.channels.iter().zip(row) {
        if let Channel::Position(axis) = channel {
            at += axis.vector() * (value - at.dot(axis.vector()));
        }
    }
    at
}

/// Says of joints below the root whose position channels leave their offset how far.
fn moved(bvh: &Bvh, joints: &[Joint], readers: &[usize], scale: f64) -> Option<String> {
    const NOTICEABLE_M: f64 = 1e-4;
    let is_position = |c: &Channel| matches!(c, Channel::Position(_));
    let mut farthest: Vec<(f64, &str)> = joints
        .iter()
        .zip(readers)
        .skip(1)
        .filter(|(joint, _)| joint.channels.iter().any(is_position))
        .map(|(joint, &first)| {
            let way = |row: &[f64]| position(joint, &row[first..]).distance(joint.offset) * scale;
            (bvh.rows().map(way).fold(0.0, f64::max), joint.name.as_str())
        })
        .filter(|(way, _)| *way > NOTICEABLE_M)
        .collect();
    farthest.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(b.1)));
    let (way, name) = *farthest.first()?;
    let n = farthest.len();
    Some(format!(
        "position channels move {n} joints below the root away from their offsets ({name} by up to {:.1} mm); \
         a clip keeps bones as long as they are, so these are left out",
        way * 1e3
    ))
}
