//! STAND-IN for retargeting until the founder's `body::retarget` is merged: joints of equal axes only.

pub mod names;

use super::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

/// A signed axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis6 {
    /// +x
    PlusX,
    /// -x
    MinusX,
    /// +y
    PlusY,
    /// -y
    MinusY,
    /// +z
    PlusZ,
    /// -z
    MinusZ,
}

const AXES: [(Axis6, &str); 6] = [
    (Axis6::PlusX, "+x"),
    (Axis6::MinusX, "-x"),
    (Axis6::PlusY, "+y"),
    (Axis6::MinusY, "-y"),
    (Axis6::PlusZ, "+z"),
    (Axis6::MinusZ, "-z"),
];

impl fmt::Display for Axis6 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(AXES.iter().find(|(axis, _)| axis == self).map_or("", |(_, text)| text))
    }
}

impl FromStr for Axis6 {
    type Err = Error;
    fn from_str(text: &str) -> Result<Axis6, Error> {
        let found =
            AXES.iter().find(|(_, name)| name.eq_ignore_ascii_case(text) || name[1..].eq_ignore_ascii_case(text));
        found.map(|(axis, _)| *axis).ok_or_else(|| Error::new(format!("{text} is no axis: +x, -x, +y, -y, +z or -z")))
    }
}

/// Where up and front are in a file's space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axes {
    /// Up.
    pub up: Axis6,
    /// To the signer's front.
    pub front: Axis6,
}

/// How motion is taken over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum Mode {
    /// Bone directions are kept.
    #[default]
    Directions,
    /// Fingertips are where they were.
    Contacts,
}

/// What can be chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// What is kept.
    pub mode: Mode,
}

/// What of our rig a motion moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    /// Trunk and legs.
    pub body: bool,
    /// Left, right.
    pub arms: [bool; 2],
    /// Left, right.
    pub hands: [bool; 2],
}

/// How well it went.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RetargetReport {
    /// What is odd, each a sentence.
    pub warnings: Vec<String>,
}

/// A motion on our rig.
#[derive(Debug, Clone)]
pub struct Retargeted {
    /// The motion.
    pub clip: Clip,
    /// What it moves.
    pub covers: Coverage,
    /// How well it went.
    pub report: RetargetReport,
}

/// Y up, to the front +Z.
pub fn propose_axes(_clip: &Clip, _joints: &BTreeMap<String, String>) -> Axes {
    Axes { up: Axis6::PlusY, front: Axis6::PlusZ }
}

/// Rotations of joints with the same axes, copied.
///
/// # Errors
/// No joint in common.
pub fn retarget(
    source: &Clip,
    joints: &BTreeMap<String, String>,
    _axes: Axes,
    signer: &Signer,
    _options: &Options,
) -> Result<Retargeted, Error> {
    let rig = &signer.skeleton;
    let pairs: Vec<_> =
        joints.iter().filter_map(|(ours, theirs)| rig.find(ours).zip(source.skeleton().find(theirs))).collect();
    if pairs.is_empty() {
        return Err(Error::new("no joint is one of ours"));
    }
    let has = |name: &str| rig.find(name).is_some_and(|id| pairs.iter().any(|p| p.0 == id));
    let body = has("Hips");
    let frame = |frame: &Frame| {
        let mut pose = LocalPose::rest(rig);
        if body {
            pose.root_model = frame.pose.root_model;
        }
        pairs.iter().for_each(|(ours, theirs)| pose.set(*ours, frame.pose.rotation(*theirs)));
        Frame { pose, weights: vec![0.0; signer.morphs.len()] }
    };
    let frames = source.frames().iter().map(frame).collect();
    let clip = Clip::new(rig.clone(), source.fps(), signer.morphs.clone(), frames);
    let covers = Coverage {
        body,
        arms: [has("LeftForeArm"), has("RightForeArm")],
        hands: [has("LeftHandIndex1"), has("RightHandIndex1")],
    };
    Ok(Retargeted {
        clip: clip.ok_or_else(|| Error::new("there is no frame"))?,
        covers,
        report: RetargetReport::default(),
    })
}
