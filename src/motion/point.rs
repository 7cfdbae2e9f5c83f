//! Points that a kinematic profile follows: a joint, the tip of a bone that ends a chain, or a point that rides on a joint.
//!
//! # Conventions
//! A tip is named after its chain: the tail of `RightHandIndex3` is `RightHandIndexTip`, that of `Head` is `HeadTip`.
//! Offsets are in the joint's rest axes, metres.

use super::pose::ModelPose;
use super::skeleton::{JointId, Skeleton};
use glam::DVec3;

/// A named point of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// What it is called: a joint's name, a tip's, a place's.
    pub name: String,
    /// The joint that carries it.
    pub joint: JointId,
    /// From the joint, in its rest axes, metres.
    pub offset: DVec3,
}

impl Point {
    /// The joint itself.
    pub fn of_joint(skeleton: &Skeleton, joint: JointId) -> Point {
        Point { name: skeleton[joint].name.clone(), joint, offset: DVec3::ZERO }
    }

    /// Where the point is, model space, metres.
    pub fn position(&self, pose: &ModelPose) -> DVec3 {
        pose.point(self.joint, self.offset)
    }
}

/// All joints of a rig, then the tips of its chains.
///
/// ```
/// use chereme::motion::{point, skeleton::Skeleton};
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// assert!(point::all(&rig).iter().any(|p| p.name == "RightHandIndexTip" && p.joint == rig.joint("RightHandIndex3").unwrap()));
/// ```
pub fn all(skeleton: &Skeleton) -> Vec<Point> {
    let mut points: Vec<Point> = skeleton.ids().map(|id| Point::of_joint(skeleton, id)).collect();
    let mut ends = vec![true; skeleton.len()];
    for parent in skeleton.joints().iter().filter_map(|j| j.parent) {
        ends[parent.index()] = false;
    }
    for joint in skeleton.ids().filter(|id| ends[id.index()]) {
        let bone = &skeleton[joint];
        let name = format!("{}Tip", bone.name.trim_end_matches(|c: char| c.is_ascii_digit()));
        // Two leaves of one chain's name (a forearm's twists) have one tip; a joint of that name is the joint.
        if points.iter().all(|p| p.name != name) {
            points.push(Point { name, joint, offset: bone.tail_model - bone.rest_model });
        }
    }
    points
}

/// The points of a rig whose name is `pattern`, in which each `*` stands for any letters: `RightHand*Tip` are five.
///
/// ```
/// use chereme::motion::{point, skeleton::Skeleton};
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// assert_eq!(point::matching(&rig, "RightHand*Tip").len(), 5);
/// assert_eq!(point::matching(&rig, "RightHand").len(), 1);
/// assert!(point::matching(&rig, "Tail").is_empty());
/// ```
pub fn matching(skeleton: &Skeleton, pattern: &str) -> Vec<Point> {
    all(skeleton).into_iter().filter(|p| fits(&p.name, pattern)).collect()
}

/// Whether a name is what a pattern with `*` says: its parts stand in the name one after the other.
fn fits(name: &str, pattern: &str) -> bool {
    let mut parts = pattern.split('*');
    let Some(mut rest) = parts.next().and_then(|first| name.strip_prefix(first)) else { return false };
    let Some(last) = parts.next_back() else { return rest.is_empty() };
    for part in parts {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}
