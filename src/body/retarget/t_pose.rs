//! The T-pose that converters put before a motion.

use super::names::recognise;
use crate::motion::clip::Clip;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::angle_between;
use crate::motion::skeleton::JointId;
use glam::DVec3;

/// How far an arm's bones may lie from the line through both shoulders, radians.
const LEVEL: f64 = 0.3;
/// How far some joint turns at least from the inserted pose to the motion, radians, and how many times as far as in the frame after.
const LEAP: (f64, f64) = (0.35, 4.0);

/// The pose in which a clip's body stands: its first frame where that is a T-pose that a converter put in, else its rest.
pub fn stands(clip: &Clip) -> LocalPose {
    if begins_with_t_pose(clip) { clip.frames()[0].pose.clone() } else { LocalPose::rest(clip.skeleton()) }
}

/// Whether a clip's first frame is a T-pose from which the second leaps: one that a converter put in.
///
/// ```
/// use chereme::motion::{clip::{Clip, Frame}, pose::LocalPose};
/// use chereme::phonology::Side;
/// let signer = chereme::avatar::signer().unwrap();
/// let t_pose = Frame { pose: LocalPose::rest(&signer.skeleton), weights: vec![] };
/// let mut moving = t_pose.clone();
/// moving.pose.set(signer.arm(Side::Left).upper, glam::DQuat::from_rotation_z(-1.2));
/// let clip = |frames| Clip::new(signer.skeleton.clone(), chereme::time::Fps::DEFAULT, Default::default(), frames).unwrap();
/// use chereme::body::retarget::begins_with_t_pose;
/// assert!(begins_with_t_pose(&clip(vec![t_pose.clone(), moving.clone(), moving.clone()])));
/// assert!(!begins_with_t_pose(&clip(vec![moving.clone(), moving, t_pose.clone()])));
/// assert!(!begins_with_t_pose(&clip(vec![t_pose.clone(), t_pose.clone(), t_pose])));
/// ```
pub fn begins_with_t_pose(clip: &Clip) -> bool {
    let [first, second, third, ..] = clip.frames() else { return false };
    let leap = |a: &crate::motion::clip::Frame, b: &crate::motion::clip::Frame| {
        let turns = a.pose.rotations.iter().zip(&b.pose.rotations).map(|(a, b)| angle_between(*a, *b));
        turns.fold(0.0, f64::max)
    };
    let (jump, step) = (leap(first, second), leap(second, third));
    if jump < LEAP.0 || jump < step * LEAP.1 {
        return false;
    }
    let skeleton = clip.skeleton();
    let joints = recognise(skeleton).joints;
    let find = |name: &str| joints.get(name).and_then(|theirs| skeleton.find(theirs));
    let names = ["LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"];
    let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = names.map(find) else { return false };
    let model = first.pose.to_model(skeleton);
    let way = |from: JointId, to: JointId| model.position(to) - model.position(from);
    let across = way(d, a);
    let level = |bone: DVec3, along: DVec3| bone.length() > 1e-9 && bone.angle_between(along) < LEVEL;
    level(way(a, b), across) && level(way(b, c), across) && level(way(d, e), -across) && level(way(e, f), -across)
}
