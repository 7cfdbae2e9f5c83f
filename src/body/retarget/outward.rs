//! From our rig to a stranger's skeleton.

use super::Humanoid;
use super::root;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{continuous, unit};
use crate::motion::skeleton::JointId;
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// A motion of our rig on a stranger's skeleton: the directions of its bones are ours. Joints that are none of ours stay as
/// they rest on their parents; the way over the floor is in leg lengths. Face morphs are left out.
///
/// # Errors
/// A clip of another rig than the signer's.
pub fn to_theirs(clip: &Clip, humanoid: &Humanoid, signer: &Signer) -> Result<Clip, Error> {
    if clip.skeleton().len() != signer.skeleton.len() {
        return Err(Error::new("the clip is not one of our rig"));
    }
    let theirs = humanoid.skeleton();
    let mut wanted: Vec<Option<(JointId, DQuat)>> = vec![None; theirs.len()];
    for bone in &humanoid.bones {
        wanted[bone.theirs.index()] = Some((bone.ours, bone.lie.conjugate()));
    }
    let back = humanoid.turn.conjugate();
    let hips = signer.skeleton.find("Hips").and_then(|hips| humanoid.bone(hips));
    let scale = 1.0 / root::scale(humanoid, signer);
    let mut before: Option<LocalPose> = None;
    let frames = clip.frames().iter().map(|frame| {
        let model = frame.pose.to_model(&signer.skeleton);
        let mut pose = LocalPose::rest(theirs);
        let mut turned: Vec<DQuat> = Vec::with_capacity(theirs.len());
        for joint in theirs.ids() {
            let parent = theirs[joint].parent.map_or(DQuat::IDENTITY, |p| turned[p.index()]);
            if let Some((ours, lie)) = wanted[joint.index()] {
                let rotation = unit(back * model.rotation(ours) * lie);
                pose.set(joint, unit(parent.conjugate() * rotation));
            }
            turned.push(unit(parent * pose.rotation(joint)));
        }
        if let Some(hips) = hips {
            let at: DVec3 = back * (model.position(hips.ours) * scale);
            let is = pose.to_model(theirs).position(hips.theirs);
            pose.root_model += at - is;
        }
        if let Some(before) = &before {
            for (was, is) in before.rotations.iter().zip(&mut pose.rotations) {
                *is = continuous(*was, *is);
            }
        }
        before = Some(pose.clone());
        Frame { pose, weights: Vec::new() }
    });
    let frames = frames.collect();
    Clip::new(theirs.clone(), clip.fps(), Arc::new(Vec::new()), frames)
        .ok_or_else(|| Error::new("the frames do not fit the skeleton"))
}
