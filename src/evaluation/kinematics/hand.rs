//! The hands of a clip, found by the names of their joints.

use crate::motion::clip::Clip;
use crate::motion::point::Point;
use crate::motion::skeleton::{JointId, Skeleton};

/// The fingers, by Mixamo's names.
const FINGERS: [&str; 5] = ["Thumb", "Index", "Middle", "Ring", "Pinky"];

/// A hand of a skeleton.
#[derive(Debug, Clone, PartialEq)]
pub struct Hand {
    /// `Right` or `Left`.
    pub side: &'static str,
    /// The joint of the wrist.
    pub wrist: JointId,
    /// The fingertips that there are.
    pub tips: Vec<Point>,
    /// What the arm hangs on (the chest); `None` where there is no arm.
    pub chest: Option<JointId>,
}

/// The hands of a clip's skeleton. Names are Mixamo's, with any prefix (`mixamorig:RightHand`, `mixamorig_RightHand`).
///
/// ```
/// use chereme::evaluation::kinematics::hands;
/// use chereme::motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton};
/// use chereme::time::Fps;
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig.into(), Fps::DEFAULT, vec![].into(), vec![rest]).unwrap();
/// let hands = hands(&clip);
/// assert_eq!((hands.len(), hands[0].side, hands[0].tips.len()), (2, "Right", 5));
/// assert!(hands[0].chest.is_some());
/// ```
pub fn hands(clip: &Clip) -> Vec<Hand> {
    let skeleton = clip.skeleton();
    let hand = |side: &'static str| {
        let wrist = joint(skeleton, &format!("{side}Hand"))?;
        let tips = FINGERS.iter().filter_map(|finger| tip(skeleton, side, finger)).collect();
        let shoulder = joint(skeleton, &format!("{side}Shoulder")).or_else(|| joint(skeleton, &format!("{side}Arm")));
        let chest = shoulder.and_then(|joint| skeleton[joint].parent);
        Some(Hand { side, wrist, tips, chest })
    };
    ["Right", "Left"].into_iter().filter_map(hand).collect()
}

/// The joint of a name, with any prefix.
fn joint(skeleton: &Skeleton, name: &str) -> Option<JointId> {
    skeleton.find(name).or_else(|| skeleton.ids().find(|id| plain(&skeleton[*id].name) == name))
}

/// A name without Mixamo's prefix.
fn plain(name: &str) -> &str {
    let name = name.rsplit(':').next().unwrap_or(name);
    name.strip_prefix("mixamorig").map_or(name, |rest| rest.trim_start_matches('_'))
}

/// The tip of a finger: its fourth joint, or where the third one ends.
fn tip(skeleton: &Skeleton, side: &str, finger: &str) -> Option<Point> {
    if let Some(end) = joint(skeleton, &format!("{side}Hand{finger}4")) {
        return Some(Point::of_joint(skeleton, end));
    }
    let last = joint(skeleton, &format!("{side}Hand{finger}3"))?;
    let bone = &skeleton[last];
    Some(Point { name: format!("{side}Hand{finger}Tip"), joint: last, offset: bone.tail_model - bone.rest_model })
}
