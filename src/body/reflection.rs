//! The body seen in a mirror: left and right joints and face morphs exchanged across X = 0.
//!
//! # Conventions
//! A rotation (w, x, y, z) becomes (w, x, −y, −z), a place (x, y, z) becomes (−x, y, z): exact where the rig itself is
//! symmetric, as the avatar's is. A joint's counterpart has `Left` for `Right` at the start of its name; a morph's has
//! the word `left` for `right`. What has no counterpart is its own.

use crate::motion::clip::Frame;
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::{JointId, Skeleton};
use glam::{DQuat, DVec3};

/// Which joint and which morph stands for which.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reflection {
    joints: Vec<JointId>,
    morphs: Vec<usize>,
}

impl Reflection {
    /// Pairs the joints of a rig and the morphs of a face by their names.
    ///
    /// ```
    /// use chereme::body::reflection::Reflection;
    /// let signer = chereme::avatar::signer().unwrap();
    /// let reflection = Reflection::new(&signer.skeleton, &signer.morphs);
    /// let joint = |name| signer.skeleton.joint(name).unwrap();
    /// assert_eq!(reflection.joint(joint("LeftEye")), joint("RightEye"));
    /// assert_eq!(reflection.joint(joint("Head")), joint("Head"));
    /// ```
    pub fn new(skeleton: &Skeleton, morphs: &[String]) -> Reflection {
        let joint = |id: JointId| {
            let name = &skeleton[id].name;
            let other = match (name.strip_prefix("Left"), name.strip_prefix("Right")) {
                (Some(part), _) => format!("Right{part}"),
                (None, Some(part)) => format!("Left{part}"),
                (None, None) => return id,
            };
            skeleton.find(&other).unwrap_or(id)
        };
        let morph = |i: usize| {
            let other = exchange_words(&morphs[i]);
            let found = morphs.iter().position(|m| *m == other).unwrap_or(i);
            // Of two morphs of one name only the first has a counterpart, so that twice is always once around.
            if morphs.iter().position(|m| *m == morphs[i]) == Some(i) { found } else { i }
        };
        Reflection { joints: skeleton.ids().map(joint).collect(), morphs: (0..morphs.len()).map(morph).collect() }
    }

    /// The joint that stands for a joint on the other side.
    pub fn joint(&self, joint: JointId) -> JointId {
        self.joints[joint.index()]
    }

    /// A joint's rotation, relative to its parent, as its counterpart's in the mirror.
    pub fn seen(&self, joint: JointId, pose: &LocalPose) -> DQuat {
        reflected(pose.rotation(self.joint(joint)))
    }

    /// A whole frame in the mirror: root, joints and face.
    pub fn frame(&self, frame: &Frame) -> Frame {
        let pose = &frame.pose;
        let rotations = (0..self.joints.len() as u16).map(|i| self.seen(JointId(i), pose)).collect();
        Frame {
            pose: LocalPose { root_model: across(pose.root_model), rotations },
            weights: self.morphs.iter().map(|m| frame.weights[*m]).collect(),
        }
    }
}

/// A rotation in the mirror at X = 0.
///
/// ```
/// use chereme::body::reflection::reflected;
/// use glam::DQuat;
/// assert_eq!(reflected(DQuat::from_rotation_y(0.4)), DQuat::from_rotation_y(-0.4));
/// assert_eq!(reflected(DQuat::from_rotation_x(0.4)), DQuat::from_rotation_x(0.4));
/// ```
pub fn reflected(q: DQuat) -> DQuat {
    DQuat::from_xyzw(q.x, -q.y, -q.z, q.w)
}

/// A place in the mirror at X = 0.
///
/// ```
/// use glam::DVec3;
/// assert_eq!(chereme::body::reflection::across(DVec3::ONE), DVec3::new(-1.0, 1.0, 1.0));
/// ```
pub fn across(place: DVec3) -> DVec3 {
    DVec3::new(-place.x, place.y, place.z)
}

/// A text with the words `left` and `right` exchanged; parts of words stay.
///
/// ```
/// use chereme::body::reflection::exchange_words;
/// assert_eq!(exchange_words("eye-left-slit"), "eye-right-slit");
/// assert_eq!(exchange_words("fingers out-right, palm left"), "fingers out-left, palm right");
/// assert_eq!(exchange_words("brightly"), "brightly");
/// ```
pub fn exchange_words(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 1);
    for piece in text.split_inclusive(|c: char| !c.is_alphanumeric()) {
        let word = piece.trim_end_matches(|c: char| !c.is_alphanumeric());
        out += match word {
            "left" => "right",
            "right" => "left",
            other => other,
        };
        out += &piece[word.len()..];
    }
    out
}
