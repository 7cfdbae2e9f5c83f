//! Which way is up and which way a person faces, in a file that does not say.

use crate::motion::clip::Clip;
use crate::motion::skeleton::JointId;
use glam::{DMat3, DQuat, DVec3};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

/// An axis with its sign, as people write it: `+y`, `-z`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SignedAxis {
    /// 0, 1 or 2: x, y or z.
    axis: u8,
    negative: bool,
}

impl SignedAxis {
    /// Up where Y is up.
    pub const PLUS_Y: SignedAxis = SignedAxis { axis: 1, negative: false };
    /// To the front where a person faces +Z.
    pub const PLUS_Z: SignedAxis = SignedAxis { axis: 2, negative: false };
    /// To the front where a person faces −Z, as one does before a sensor on a desk.
    pub const MINUS_Z: SignedAxis = SignedAxis { axis: 2, negative: true };

    /// The axis as a unit vector.
    pub fn vector(self) -> DVec3 {
        DVec3::AXES[self.axis as usize] * if self.negative { -1.0 } else { 1.0 }
    }

    /// The axis nearest to a direction; `but` is not taken.
    fn nearest(direction: DVec3, but: Option<SignedAxis>) -> Option<SignedAxis> {
        let free = (0..3u8).filter(|axis| but.is_none_or(|b| b.axis != *axis));
        let size = |axis: &u8| direction[*axis as usize].abs();
        let axis = free.max_by(|a, b| size(a).total_cmp(&size(b)))?;
        (size(&axis) > 1e-9).then(|| SignedAxis { axis, negative: direction[axis as usize] < 0.0 })
    }
}

impl fmt::Display for SignedAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.negative { '-' } else { '+' }, ["x", "y", "z"][self.axis as usize])
    }
}

impl FromStr for SignedAxis {
    type Err = String;

    fn from_str(text: &str) -> Result<SignedAxis, String> {
        let lower = text.trim().to_lowercase();
        let (negative, letter) = match lower.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, lower.strip_prefix('+').unwrap_or(&lower)),
        };
        let axis = ["x", "y", "z"].iter().position(|name| *name == letter);
        let axis = axis.ok_or_else(|| format!("`{text}` is no axis: +x, -x, +y, -y, +z or -z is"))?;
        Ok(SignedAxis { axis: axis as u8, negative })
    }
}

/// The space of a file: which of its axes is up, and which one a person faces along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axes {
    up: SignedAxis,
    front: SignedAxis,
}

impl Axes {
    /// Y up, facing +Z: ours.
    pub const OURS: Axes = Axes { up: SignedAxis::PLUS_Y, front: SignedAxis::PLUS_Z };
    /// Y up, facing −Z: hands over a sensor on a desk.
    pub const SENSOR: Axes = Axes { up: SignedAxis::PLUS_Y, front: SignedAxis::MINUS_Z };

    /// Two axes that are across each other; `None` where they are not.
    ///
    /// ```
    /// use chereme::body::retarget::Axes;
    /// let blender = Axes::new("+z".parse().unwrap(), "-y".parse().unwrap()).unwrap();
    /// assert!((blender.turn() * glam::DVec3::Z - glam::DVec3::Y).length() < 1e-12);
    /// assert!((blender.turn() * -glam::DVec3::Y - glam::DVec3::Z).length() < 1e-12);
    /// assert_eq!(Axes::new("+z".parse().unwrap(), "-z".parse().unwrap()), None);
    /// ```
    pub fn new(up: SignedAxis, front: SignedAxis) -> Option<Axes> {
        (up.axis != front.axis).then_some(Axes { up, front })
    }

    /// Up.
    pub fn up(self) -> SignedAxis {
        self.up
    }

    /// Where a person faces.
    pub fn front(self) -> SignedAxis {
        self.front
    }

    /// The rotation from the file's space to ours.
    pub fn turn(self) -> DQuat {
        let (up, front) = (self.up.vector(), self.front.vector());
        DQuat::from_mat3(&DMat3::from_cols(up.cross(front), up, front).transpose()).normalize()
    }
}

/// How many frames are looked at.
const LOOKED_AT: usize = 64;

/// The axes that a body's motion shows: up is where the head is above the hips most of the time, the front is across that and
/// the line from right to left as the clip begins (later a dancer may turn). Hands alone show none: they are taken to be over a sensor, Y up, in front of a person who faces −Z.
pub fn propose_axes(clip: &Clip, joints: &BTreeMap<String, String>) -> Axes {
    let find = |name: &str| joints.get(name).and_then(|theirs| clip.skeleton().find(theirs));
    let either = |names: &[&str]| names.iter().find_map(|name| find(name));
    let pair = |part: &str| find(&format!("Left{part}")).zip(find(&format!("Right{part}")));
    let (Some(low), Some(high)) = (either(&["Hips", "Spine", "LeftUpLeg"]), either(&["Head", "Neck", "LeftArm"]))
    else {
        return Axes::SENSOR;
    };
    let Some((left, right)) = pair("Arm").or_else(|| pair("UpLeg")).or_else(|| pair("Shoulder")) else {
        return Axes::OURS;
    };
    let step = clip.frames().len().div_ceil(LOOKED_AT);
    let (mut up, mut across) = (DVec3::ZERO, DVec3::ZERO);
    for (i, frame) in clip.frames().iter().step_by(step.max(1)).enumerate() {
        let model = frame.pose.to_model(clip.skeleton());
        let between = |a: JointId, b: JointId| (model.position(b) - model.position(a)).normalize_or_zero();
        up += between(low, high);
        if i == 0 {
            across = between(right, left);
        }
    }
    let Some(up) = SignedAxis::nearest(up, None) else { return Axes::OURS };
    let front = SignedAxis::nearest(across.cross(up.vector()), Some(up));
    front.and_then(|front| Axes::new(up, front)).unwrap_or(Axes::OURS)
}
