//! From a stranger's skeleton to our rig, frame by frame.

use super::finger::{chain, finger};
use super::humanoid::{Bone, End, Humanoid};
use super::report::Report;
use super::{Mode, Options, Retargeted, contacts, root};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::arm::{ArmHint, orient};
use crate::motion::clip::{Clip, Frame};
use crate::motion::fabrik::{self, Pole};
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::reach::reach;
use crate::motion::rotation::{direction, frame_to_frame, perpendicular, shortest_arc, unit};
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::{Digit, Side};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// What the joints of the legs begin with.
const LEGS: [&str; 2] = ["Left", "Right"];
/// Where a hand without a body is placed, arm lengths from the middle of the shoulders (x to its own side, y up, z out).
const HAND_ALONE_ARMS: DVec3 = DVec3::new(0.25, -0.28, 0.6);

/// A motion of a stranger's skeleton on our rig, at its own frame rate.
///
/// # Errors
/// A clip of another skeleton than the humanoid's; no frame left after those that are skipped; a rest pose of another rig.
pub fn retarget(source: &Clip, humanoid: &Humanoid, signer: &Signer, options: &Options) -> Result<Retargeted, Error> {
    if source.skeleton().len() != humanoid.skeleton().len() {
        return Err(Error::new("the clip has another skeleton than the one that was mapped"));
    }
    if options.rest.rotations.len() != signer.skeleton.len() {
        return Err(Error::new("the pose for what is not recorded has another skeleton than ours"));
    }
    let frames = source.frames().get(options.skip_frames..).filter(|frames| !frames.is_empty());
    let frames = frames.ok_or_else(|| Error::new("no frame is left after those that are skipped"))?;
    let mut onto = Onto::new(frames, humanoid, signer, options);
    let mut poses: Vec<LocalPose> = frames.iter().map(|frame| onto.pose(frame)).collect();
    if humanoid.covers().body {
        root::place(&mut poses, source, options.skip_frames, humanoid, signer);
    }
    continue_signs(&mut poses);
    let report = Report::measure(&poses, frames, source.fps(), humanoid, signer, &onto.goals, &onto.wrists_left);
    let frames = poses.into_iter().map(|pose| Frame { pose, weights: Vec::new() }).collect();
    let clip = Clip::new(signer.skeleton.clone(), source.fps(), Arc::new(Vec::new()), frames);
    let clip = clip.ok_or_else(|| Error::new("the frames do not fit the rig"))?;
    Ok(Retargeted { clip, covers: humanoid.covers(), report })
}

/// Every joint's quaternion on the side of the one before.
fn continue_signs(poses: &mut [LocalPose]) {
    for i in 1..poses.len() {
        let (before, after) = poses.split_at_mut(i);
        for (was, is) in before[i - 1].rotations.iter().zip(&mut after[0].rotations) {
            *is = crate::motion::rotation::continuous(*was, *is);
        }
    }
}

/// What stays the same from frame to frame, and what one leaves the next.
pub(super) struct Onto<'a> {
    pub humanoid: &'a Humanoid,
    pub signer: &'a Signer,
    options: &'a Options,
    hints: [Option<ArmHint>; 2],
    /// The mean place of the wrists of hands without arms, our axes.
    middles: [DVec3; 2],
    /// Their wrists and tips as they should be in ours, by frame; with [`Mode::Contacts`].
    pub goals: Vec<contacts::Goals>,
    /// How far wrists stay from where hands alone were placed, metres.
    pub wrists_left: Vec<f64>,
}

impl<'a> Onto<'a> {
    fn new(frames: &[Frame], humanoid: &'a Humanoid, signer: &'a Signer, options: &'a Options) -> Onto<'a> {
        let middle = |side: Side| {
            let alone = humanoid.covers().hands[side as usize] && !humanoid.covers().arms[side as usize];
            let bone = humanoid.bone(signer.arm(side).hand).filter(|_| alone);
            bone.map_or(DVec3::ZERO, |bone| {
                let at = |f: &Frame| humanoid.turn * f.pose.to_model(humanoid.skeleton()).position(bone.theirs);
                frames.iter().map(at).sum::<DVec3>() / frames.len() as f64
            })
        };
        let middles = [Side::Left, Side::Right].map(middle);
        let (goals, wrists_left) = (Vec::new(), Vec::new());
        Onto { humanoid, signer, options, hints: [None; 2], middles, goals, wrists_left }
    }

    fn pose(&mut self, frame: &Frame) -> LocalPose {
        let theirs = frame.pose.to_model(self.humanoid.skeleton());
        let mut pose = self.options.rest.clone();
        self.body(&theirs, &mut pose);
        for side in [Side::Left, Side::Right] {
            let (arm, hand) = (self.humanoid.covers().arms[side as usize], self.humanoid.covers().hands[side as usize]);
            if arm || hand {
                self.arm(side, arm, &theirs, &mut pose);
                self.digits(side, &theirs, &mut pose);
            }
        }
        if self.options.mode == Mode::Contacts {
            let goals = contacts::solve(self, &theirs, &mut pose);
            self.goals.push(goals);
        }
        pose
    }

    /// The model rotation of one of our joints, by its bone.
    pub(super) fn rotation(&self, bone: &Bone, theirs: &ModelPose) -> DQuat {
        let turned = unit(self.humanoid.turn * theirs.rotation(bone.theirs) * bone.lie);
        let ours = way_at_rest(&self.signer.skeleton, bone.ours, bone.our_end);
        if !bone.directed {
            return turned;
        }
        match self.way(bone, theirs).try_normalize() {
            Some(way) => unit(shortest_arc(turned * ours, way, turned * DVec3::Z) * turned),
            None => turned,
        }
    }

    /// A bone turned from where its parent leads it, by the least turn: the roll of a clavicle is not seen.
    fn led(&self, bone: &Bone, parent: DQuat, theirs: &ModelPose) -> DQuat {
        let ours = way_at_rest(&self.signer.skeleton, bone.ours, bone.our_end);
        match self.way(bone, theirs).try_normalize() {
            Some(way) => unit(shortest_arc(parent * ours, way, parent * DVec3::Z) * parent),
            None => parent,
        }
    }

    /// A bone of a leg, rolled so that the knee bends away from where the toes point: a file's rest pose may have its legs anyhow.
    fn by_toes(&self, bone: &Bone, theirs: &ModelPose) -> Option<DQuat> {
        let skeleton = &self.signer.skeleton;
        let (side, part) = LEGS.iter().find_map(|side| Some((side, skeleton[bone.ours].name.strip_prefix(side)?)))?;
        if part != "UpLeg" && part != "Leg" {
            return None;
        }
        let foot = self.humanoid.bone(skeleton.find(&format!("{side}Foot"))?).filter(|foot| foot.directed)?;
        let (way, toes) = (direction(self.way(bone, theirs))?, direction(self.way(foot, theirs))?);
        // Toes that point along the leg say nothing.
        if way.cross(toes).length() < 0.25 {
            return None;
        }
        let ours = direction(way_at_rest(skeleton, bone.ours, bone.our_end))?;
        Some(frame_to_frame((ours, perpendicular(DVec3::Z, ours)), (way, perpendicular(toes, way))))
    }

    /// Where a bone points, our axes, in their lengths.
    pub(super) fn way(&self, bone: &Bone, theirs: &ModelPose) -> DVec3 {
        self.humanoid.turn * way_of(self.humanoid.skeleton(), bone.theirs, bone.their_end, theirs)
    }

    /// Hips, trunk, neck, head, clavicles, legs, eyes.
    fn body(&self, theirs: &ModelPose, pose: &mut LocalPose) {
        let skeleton = &self.signer.skeleton;
        let limbs = [Side::Left, Side::Right].map(|side| self.signer.arm(side));
        let mut model: Vec<DQuat> = Vec::with_capacity(skeleton.len());
        for joint in skeleton.ids() {
            let parent = skeleton[joint].parent.map_or(DQuat::IDENTITY, |p| model[p.index()]);
            let of_limb = limbs.iter().any(|arm| joint == arm.upper || joint == arm.fore || joint == arm.hand)
                || skeleton[joint].name.contains("Hand");
            if let Some(bone) = self.humanoid.bone(joint).filter(|_| !of_limb) {
                let rotation = match self.by_toes(bone, theirs) {
                    Some(rotation) => rotation,
                    None if limbs.iter().any(|arm| joint == arm.clavicle) => self.led(bone, parent, theirs),
                    None => self.rotation(bone, theirs),
                };
                pose.set(joint, unit(parent.conjugate() * rotation));
            }
            model.push(parent * pose.rotation(joint));
        }
    }

    /// An arm along its bones, or, of a hand alone, under its wrist.
    fn arm(&mut self, side: Side, has_arm: bool, theirs: &ModelPose, pose: &mut LocalPose) {
        let arm = self.signer.arm(side);
        let model = pose.to_model(&self.signer.skeleton);
        let shoulder = model.position(arm.upper);
        let Some(hand_bone) = self.humanoid.bone(arm.hand) else { return };
        let hand = self.rotation(hand_bone, theirs);
        let along = |joint: JointId| self.humanoid.bone(joint).and_then(|b| self.way(b, theirs).try_normalize());
        let joints = match along(arm.upper).zip(along(arm.fore)).filter(|_| has_arm) {
            Some((upper, fore)) => {
                let elbow = shoulder + upper * arm.upper_m;
                [shoulder, elbow, elbow + fore * arm.fore_m]
            }
            None => {
                let at = DVec3::new(HAND_ALONE_ARMS.x * side.sign(), HAND_ALONE_ARMS.y, HAND_ALONE_ARMS.z);
                let place = self.signer.landmarks.before(at).position(&model);
                let wrist = self.humanoid.turn * theirs.position(hand_bone.theirs);
                let target = place + wrist - self.middles[side as usize];
                // The elbow hangs, a little out and back.
                let options = fabrik::Options {
                    pole: Pole::Always(DVec3::new(0.35 * side.sign(), -1.0, -0.25)),
                    ..fabrik::Options::default()
                };
                let start = [arm.upper, arm.fore, arm.hand].map(|joint| model.position(joint));
                let solved = reach(start, target, &options);
                self.wrists_left.push(solved.residual_m);
                solved.joints
            }
        };
        let parent = model.rotation(arm.clavicle);
        let solved = orient(&arm.rest, parent, joints, hand, self.hints[side as usize]);
        self.hints[side as usize] = Some(solved.hint());
        arm.write(&solved, pose);
    }

    /// The fifteen finger joints, under a hand that is turned already.
    fn digits(&self, side: Side, theirs: &ModelPose, pose: &mut LocalPose) {
        for digit in Digit::ALL {
            let joints = self.signer.hand(side).of_digit(digit);
            let bones = joints.map(|joint| self.humanoid.bone(joint));
            let Some(first) = bones[0] else { continue };
            // Of a digit of two bones the last one goes on as the second.
            let ways = bones.map(|bone| bone.and_then(|bone| self.way(bone, theirs).try_normalize()));
            let [Some(a), b, c] = ways else { continue };
            let along = [a, b.unwrap_or(a), c.or(b).unwrap_or(a)];
            let thumb = (digit == Digit::Thumb).then(|| self.rotation(first, theirs));
            write_digit(self.signer, side, digit, thumb, along, pose);
        }
    }
}

/// Turns the three bones of a digit so that they look along directions; a thumb's first bone is turned as given.
pub(super) fn write_digit(
    signer: &Signer,
    side: Side,
    digit: Digit,
    thumb: Option<DQuat>,
    along: [DVec3; 3],
    pose: &mut LocalPose,
) {
    let joints = signer.hand(side).of_digit(digit);
    let hand = model_rotation(&signer.skeleton, signer.arm(side).hand, pose);
    let last = joints[2];
    let ends = [End::Joint(joints[1]), End::Joint(last), End::Tail];
    let rest: [DVec3; 3] = std::array::from_fn(|i| way_at_rest(&signer.skeleton, joints[i], ends[i]).normalize());
    let turned = match thumb {
        Some(first) => chain(first, rest, along),
        None => finger(side, hand, rest, along),
    };
    let mut parent = hand;
    for (joint, rotation) in joints.into_iter().zip(turned) {
        pose.set(joint, unit(parent.conjugate() * rotation));
        parent = rotation;
    }
}

/// A joint's model rotation.
pub(super) fn model_rotation(skeleton: &Skeleton, joint: JointId, pose: &LocalPose) -> DQuat {
    let above = std::iter::successors(Some(joint), |id| skeleton[*id].parent);
    above.fold(DQuat::IDENTITY, |below, id| pose.rotation(id) * below)
}

fn way_at_rest(skeleton: &Skeleton, joint: JointId, end: End) -> DVec3 {
    super::humanoid::end_at_rest(skeleton, joint, end) - skeleton[joint].rest_model
}

/// From a bone's beginning to its end, in a pose.
pub(super) fn way_of(skeleton: &Skeleton, joint: JointId, end: End, model: &ModelPose) -> DVec3 {
    match end {
        End::Joint(end) => model.position(end) - model.position(joint),
        End::Tail => model.rotation(joint) * way_at_rest(skeleton, joint, end),
    }
}
