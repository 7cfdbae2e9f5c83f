//! Where wrists and fingertips are, kept: wrists from the middle of the shoulders in arm lengths, tips from the middle of the
//! knuckles in finger lengths. (Not from the wrist: a sensor's hand has its origin in the palm.)

use super::humanoid::Bone;
use super::inward::{Onto, way_of, write_digit};
use crate::body::signer::Signer;
use crate::motion::arm::{ArmHint, orient};
use crate::motion::fabrik::{Options, Pole, solve_chain};
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::reach::reach;
use crate::motion::rotation::shortest_arc;
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::{Digit, Side};
use glam::DVec3;

/// The tips of a hand are brought so much nearer to the knuckles, so that a digit that begins elsewhere reaches: a share of the
/// least ratio of lengths.
const WITHIN: f64 = 0.995;

/// The digits whose knuckles the tips are seen from.
const FINGERS: [Digit; 4] = [Digit::Index, Digit::Middle, Digit::Ring, Digit::Pinky];

/// Where wrists and tips should be in one frame, from the root, axes of model space, metres.
#[derive(Debug, Clone, Default)]
pub(super) struct Goals {
    pub wrists: Vec<(JointId, DVec3)>,
    /// The last joint of a digit, and its tip.
    pub tips: Vec<(JointId, DVec3)>,
}

/// Solves wrists, then fingers, of a pose that keeps directions already.
pub(super) fn solve(onto: &Onto, theirs: &ModelPose, pose: &mut LocalPose) -> Goals {
    let mut goals = Goals::default();
    for side in [Side::Left, Side::Right] {
        if onto.humanoid.covers().arms[side as usize] {
            goals.wrists.extend(wrist(onto, side, theirs, pose));
        }
        if onto.humanoid.covers().hands[side as usize] {
            tips(onto, side, theirs, pose, &mut goals.tips);
        }
    }
    goals
}

/// Puts a wrist where theirs is, seen from the middle of the shoulders.
fn wrist(onto: &Onto, side: Side, theirs: &ModelPose, pose: &mut LocalPose) -> Option<(JointId, DVec3)> {
    let (signer, humanoid) = (onto.signer, onto.humanoid);
    let uppers = [Side::Left, Side::Right].map(|side| signer.arm(side).upper);
    let middle_of = |at: &dyn Fn(JointId) -> Option<DVec3>| Some((at(uppers[0])? + at(uppers[1])?) / 2.0);
    let their_middle = middle_of(&|joint| humanoid.bone(joint).map(|bone| theirs.position(bone.theirs)))?;
    let model = pose.to_model(&signer.skeleton);
    let our_middle = middle_of(&|joint| Some(model.position(joint)))?;
    let arm = signer.arm(side);
    let [upper, fore, hand] = [arm.upper, arm.fore, arm.hand].map(|joint| humanoid.bone(joint));
    let their_arm = length(humanoid.skeleton(), upper?, fore?) + length(humanoid.skeleton(), fore?, hand?);
    let scale = arm.length_m() / their_arm.max(1e-6);
    let target = our_middle + humanoid.turn * (theirs.position(hand?.theirs) - their_middle) * scale;
    let joints = [arm.upper, arm.fore, arm.hand].map(|joint| model.position(joint));
    let solved = reach(joints, target, &Options { tolerance_m: 1e-6, ..Options::default() });
    let hinge_model = model.rotation(arm.upper) * arm.rest.hinge();
    let twist = arm.rest.angles(pose.rotation(arm.hand)).twist;
    let hint = ArmHint { hinge_model, twist };
    let parent = model.rotation(arm.clavicle);
    arm.write(&orient(&arm.rest, parent, solved.joints, model.rotation(arm.hand), Some(hint)), pose);
    Some((arm.hand, target - pose.root_model))
}

fn length(skeleton: &Skeleton, from: &Bone, to: &Bone) -> f64 {
    skeleton[from.theirs].rest_model.distance(skeleton[to.theirs].rest_model)
}

/// Solves the digits of a hand so that their tips lie before the knuckles as theirs do.
fn tips(onto: &Onto, side: Side, theirs: &ModelPose, pose: &mut LocalPose, goals: &mut Vec<(JointId, DVec3)>) {
    let (signer, humanoid) = (onto.signer, onto.humanoid);
    let Some(scale) = finger_scale(onto, side) else { return };
    let knuckles: Vec<&Bone> =
        FINGERS.iter().filter_map(|d| humanoid.bone(signer.hand(side).of_digit(*d)[0])).collect();
    let model = pose.to_model(&signer.skeleton);
    let n = knuckles.len() as f64;
    let our_middle = knuckles.iter().map(|bone| model.position(bone.ours)).sum::<DVec3>() / n;
    let their_middle = knuckles.iter().map(|bone| theirs.position(bone.theirs)).sum::<DVec3>() / n;
    // A stretched finger bends to the palm: its joints stand out of the back of the hand.
    let back = model.rotation(signer.arm(side).hand) * DVec3::Y;
    let options = Options { tolerance_m: 1e-5, pole: Pole::WhenStraight(back), ..Options::default() };
    for digit in Digit::ALL {
        let joints = signer.hand(side).of_digit(digit);
        let Some(last) = humanoid.bone(joints[2]) else { continue };
        let their_tip = theirs.position(last.theirs) + way_of(humanoid.skeleton(), last.theirs, last.their_end, theirs);
        let goal = our_middle + humanoid.turn * (their_tip - their_middle) * scale;
        let tip = tail(signer, joints[2], &model);
        let start = [model.position(joints[0]), model.position(joints[1]), model.position(joints[2]), tip];
        let solved = solve_chain(&start, goal, &options).joints;
        let along: [DVec3; 3] = std::array::from_fn(|i| (solved[i + 1] - solved[i]).normalize_or(DVec3::X));
        let thumb = (digit == Digit::Thumb).then(|| {
            let before = model.rotation(joints[0]);
            shortest_arc(start[1] - start[0], along[0], before * DVec3::Y) * before
        });
        write_digit(signer, side, digit, thumb, along, pose);
        goals.push((joints[2], goal - pose.root_model));
    }
}

/// A digit's tip in a pose.
pub(super) fn tail(signer: &Signer, last: JointId, model: &ModelPose) -> DVec3 {
    let bone = &signer.skeleton[last];
    model.point(last, bone.tail_model - bone.rest_model)
}

/// Our fingers by theirs: the least ratio over the digits of the lengths from knuckle to tip, so that every tip can be reached.
fn finger_scale(onto: &Onto, side: Side) -> Option<f64> {
    let (ours, theirs) = (&*onto.signer.skeleton, &**onto.humanoid.skeleton());
    let ratio = |digit: &Digit| {
        let joints = onto.signer.hand(side).of_digit(*digit);
        let [first, second, third] = joints.map(|joint| onto.humanoid.bone(joint));
        let (first, second, third) = (first?, second?, third?);
        let chain = |s: &Skeleton, at: [JointId; 3]| {
            let bones: f64 = at.windows(2).map(|w| s[w[0]].rest_model.distance(s[w[1]].rest_model)).sum();
            bones + s[at[2]].tail_model.distance(s[at[2]].rest_model)
        };
        let our = chain(ours, [first.ours, second.ours, third.ours]);
        let their = chain(theirs, [first.theirs, second.theirs, third.theirs]);
        (their > 1e-6).then_some(our / their)
    };
    Digit::ALL.iter().filter_map(ratio).reduce(f64::min).map(|least| least * WITHIN)
}
