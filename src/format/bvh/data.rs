//! What a BVH file says, in its own units and order.

use crate::diagnostics::Error;
use crate::time::Seconds;
use glam::DVec3;

/// An axis of the file's space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// In our own files, the signer's left.
    X,
    /// In our own files, up.
    Y,
    /// In our own files, to the front.
    Z,
}

impl Axis {
    /// The unit vector.
    pub fn vector(self) -> DVec3 {
        match self {
            Axis::X => DVec3::X,
            Axis::Y => DVec3::Y,
            Axis::Z => DVec3::Z,
        }
    }
}

/// What one number of a row is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Channel {
    /// A coordinate relative to the parent joint, in the file's unit.
    Position(Axis),
    /// A turn about an axis, degrees.
    Rotation(Axis),
}

impl Channel {
    /// All six, positions first.
    pub const ALL: [Channel; 6] = [
        Channel::Position(Axis::X),
        Channel::Position(Axis::Y),
        Channel::Position(Axis::Z),
        Channel::Rotation(Axis::X),
        Channel::Rotation(Axis::Y),
        Channel::Rotation(Axis::Z),
    ];

    /// The word in the file.
    ///
    /// ```
    /// use chereme::format::bvh::{Axis, Channel};
    /// assert_eq!(Channel::Rotation(Axis::Z).word(), "Zrotation");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Channel::Position(Axis::X) => "Xposition",
            Channel::Position(Axis::Y) => "Yposition",
            Channel::Position(Axis::Z) => "Zposition",
            Channel::Rotation(Axis::X) => "Xrotation",
            Channel::Rotation(Axis::Y) => "Yrotation",
            Channel::Rotation(Axis::Z) => "Zrotation",
        }
    }
}

/// A joint of the hierarchy.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The name, which may have spaces inside.
    pub name: String,
    /// The parent's number in [`Bvh::joints`]; `None` for a root.
    pub parent: Option<usize>,
    /// `OFFSET`: from the parent at rest (from the origin, for a root), in the file's unit.
    pub offset: DVec3,
    /// `CHANNELS`, in their order, each at most once; possibly none.
    pub channels: Vec<Channel>,
    /// `OFFSET` of each `End Site`, from this joint, in the file's unit: usually one at a leaf, none elsewhere.
    pub end_sites: Vec<DVec3>,
}

/// A BVH file as it was read or will be printed: joints, time of a frame, and rows of numbers.
///
/// Invariants: at least one joint; parents come before their children, and all joints below one come right after it
/// (the order in which a file lists them, and in which rows have their channels); names are one line without braces
/// and without spaces at the ends; offsets and values are finite; no channel is listed twice for a joint; the frame
/// time is above 0; every row has one number a channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Bvh {
    joints: Vec<Joint>,
    frame_time: Seconds,
    channels: usize,
    values: Vec<f64>,
}

impl Bvh {
    /// Data that keeps what [`Bvh`] promises; `values` are the rows, one after the other.
    ///
    /// # Errors
    /// Names the joint or the number that breaks a promise.
    ///
    /// ```
    /// use chereme::format::bvh::{Bvh, Channel, Axis, Joint};
    /// use chereme::time::Seconds;
    /// let channels = vec![Channel::Rotation(Axis::Y)];
    /// let joint = Joint { name: "Hips".into(), parent: None, offset: glam::DVec3::ZERO, channels, end_sites: vec![] };
    /// let bvh = Bvh::new(vec![joint], Seconds(0.02), vec![10.0, 20.0]).unwrap();
    /// assert_eq!(bvh.rows().len(), 2);
    /// ```
    pub fn new(joints: Vec<Joint>, frame_time: Seconds, values: Vec<f64>) -> Result<Bvh, Error> {
        if joints.is_empty() {
            return Err(Error::new("a BVH file has at least one joint"));
        }
        // The joints from the root down to the one before.
        let mut open: Vec<usize> = Vec::new();
        for (at, joint) in joints.iter().enumerate() {
            check_joint(joint)?;
            while open.last().is_some_and(|&last| Some(last) != joint.parent) {
                open.pop();
            }
            if open.last().copied() != joint.parent {
                return Err(Error::new(format!("joint {} does not come right after its parent's others", joint.name)));
            }
            open.push(at);
        }
        if !(frame_time.0 > 0.0 && frame_time.0.is_finite()) {
            return Err(Error::new(format!("the frame time is above 0 s, not {}", frame_time.0)));
        }
        let channels: usize = joints.iter().map(|j| j.channels.len()).sum();
        if values.len().checked_rem(channels).unwrap_or(values.len()) != 0 {
            let n = values.len();
            return Err(Error::new(format!("{n} numbers are no whole number of rows of {channels} channels")));
        }
        if let Some(at) = values.iter().position(|v| !v.is_finite()) {
            return Err(Error::new(format!("row {} has a number that is not finite", at / channels)));
        }
        Ok(Bvh { joints, frame_time, channels, values })
    }

    /// The same, for the reader, which has checked all of it with line and column.
    pub(super) fn checked(joints: Vec<Joint>, frame_time: Seconds, values: Vec<f64>) -> Bvh {
        let channels = joints.iter().map(|j| j.channels.len()).sum();
        Bvh { joints, frame_time, channels, values }
    }

    /// The joints, in the file's order.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Time from one row to the next.
    pub fn frame_time(&self) -> Seconds {
        self.frame_time
    }

    /// How many numbers a row has.
    pub fn channel_count(&self) -> usize {
        self.channels
    }

    /// The rows, each with all joints' channels in order.
    pub fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.channels.max(1))
    }

    /// Where each joint stands at rest, in the file's unit and space: offsets added up from the root.
    pub fn rest_positions(&self) -> Vec<DVec3> {
        let mut all: Vec<DVec3> = Vec::with_capacity(self.joints.len());
        for joint in &self.joints {
            all.push(joint.parent.map_or(DVec3::ZERO, |p| all[p]) + joint.offset);
        }
        all
    }
}

fn check_joint(joint: &Joint) -> Result<(), Error> {
    let Joint { name, offset, channels, end_sites, .. } = joint;
    if name.is_empty() || name.trim() != name || name.contains(['{', '}', '\n', '\r']) {
        return Err(Error::new(format!("{name:?} cannot be a joint's name in a BVH file")));
    }
    if !offset.is_finite() || !end_sites.iter().all(|e| e.is_finite()) {
        return Err(Error::new(format!("joint {name} has an offset that is not finite")));
    }
    if let Some(twice) = (1..channels.len()).find(|&i| channels[..i].contains(&channels[i])) {
        return Err(Error::new(format!("joint {name} has {} twice", channels[twice].word())));
    }
    Ok(())
}
