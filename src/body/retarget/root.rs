//! Where the body stands: its way over the floor in leg lengths, its feet on the floor.

use super::Humanoid;
use crate::body::signer::Signer;
use crate::motion::clip::Clip;
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::{JointId, Skeleton};
use glam::DVec3;

/// This share of the frames may have a foot below the floor: noise, and what is no floor.
const BELOW: f64 = 0.02;

/// Our legs by theirs, in lengths; 1 where there are none.
pub(super) fn scale(humanoid: &Humanoid, signer: &Signer) -> f64 {
    let lengths = |our: &str, end: &str| {
        let (joint, end) = (signer.skeleton.find(our)?, signer.skeleton.find(end)?);
        let (a, b) = (humanoid.bone(joint)?, humanoid.bone(end)?);
        let way = |skeleton: &Skeleton, a: JointId, b: JointId| skeleton[a].rest_model.distance(skeleton[b].rest_model);
        Some((way(&signer.skeleton, joint, end), way(humanoid.skeleton(), a.theirs, b.theirs)))
    };
    let parts =
        [("LeftUpLeg", "LeftLeg"), ("LeftLeg", "LeftFoot"), ("RightUpLeg", "RightLeg"), ("RightLeg", "RightFoot")];
    let all: Option<Vec<(f64, f64)>> = parts.iter().map(|(a, b)| lengths(a, b)).collect();
    let (ours, theirs) = all.unwrap_or_default().iter().fold((0.0, 0.0), |sum, pair| (sum.0 + pair.0, sum.1 + pair.1));
    if theirs > 1e-6 { ours / theirs } else { 1.0 }
}

/// Gives the poses their roots: as the hips go, from where ours rest, and with the lowest feet on the floor.
pub(super) fn place(poses: &mut [LocalPose], source: &Clip, skipped: usize, humanoid: &Humanoid, signer: &Signer) {
    let Some(hips) = signer.skeleton.find("Hips").and_then(|hips| humanoid.bone(hips)) else { return };
    let scale = scale(humanoid, signer);
    let rest = signer.skeleton[hips.ours].rest_model;
    let feet: Vec<JointId> = ["LeftFoot", "RightFoot", "LeftToeBase", "RightToeBase"]
        .iter()
        .filter_map(|name| signer.skeleton.find(name).filter(|joint| humanoid.bone(*joint).is_some()))
        .collect();
    let mut first = None;
    let mut lowest: Vec<f64> = Vec::new();
    for (pose, frame) in poses.iter_mut().zip(source.frames().iter().skip(skipped)) {
        let theirs = frame.pose.to_model(humanoid.skeleton()).position(hips.theirs);
        let at = humanoid.turn * theirs * scale;
        let start = *first.get_or_insert(at);
        pose.root_model = DVec3::new(at.x - start.x + rest.x, at.y, at.z - start.z + rest.z);
        let model = pose.to_model(&signer.skeleton);
        let over = |joint: &JointId| model.position(*joint).y - signer.skeleton[*joint].rest_model.y;
        lowest.extend(feet.iter().map(over).reduce(f64::min));
    }
    lowest.sort_by(f64::total_cmp);
    let floor = match lowest.get((lowest.len() as f64 * BELOW) as usize) {
        Some(floor) => *floor,
        None => first.map_or(0.0, |start| start.y - rest.y),
    };
    poses.iter_mut().for_each(|pose| pose.root_model.y -= floor);
}
