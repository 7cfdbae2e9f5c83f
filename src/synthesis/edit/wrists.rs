//! Wrists put elsewhere, frame by frame, by FABRIK on each arm (Naert et al. 2021, §4.1, figure 3).
//!
//! The chain runs from the shoulder to the wrist: clavicle, trunk and fingers stay. The elbow keeps its swivel
//! ([`crate::motion::carry`]).

use super::{Extent, fits, rewritten};
use crate::body::arm::ArmRig;
use crate::body::channel::Channels;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::carry::{PlacedArm, carried};
use crate::motion::clip::Clip;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::rotation::{twist_angle, unit, unwrap_near};
use crate::motion::short_arc::ShortArc;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;
use crate::time::{FrameIndex, Seconds};
use glam::{DQuat, DVec3};

/// Which arms an operator takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sides {
    /// The left arm.
    Left,
    /// The right arm.
    Right,
    /// Both arms.
    Both,
}

impl Sides {
    /// The sides, right before left.
    ///
    /// ```
    /// use chereme::{phonology::Side, synthesis::edit::Sides};
    /// assert_eq!(Sides::Both.each(), [Side::Right, Side::Left]);
    /// ```
    pub fn each(self) -> &'static [Side] {
        match self {
            Sides::Left => &[Side::Left],
            Sides::Right => &[Side::Right],
            Sides::Both => &[Side::Right, Side::Left],
        }
    }
}

/// What a hand keeps while its arm goes elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum HandKept {
    /// Its rotation in model space: signs keep their orientation when spatialized.
    #[default]
    Global,
    /// Its rotation relative to the forearm: the hand turns along with the arm.
    Local,
}

/// A clip whose wrists went elsewhere, and how near they came.
#[derive(Debug, Clone)]
pub struct Moved {
    /// The new clip.
    pub clip: Clip,
    /// The greatest distance of a wrist from where it should be, metres; above a micrometre only where a target is
    /// out of the arm's reach.
    pub residual_m: f64,
    /// When that is.
    pub at: Seconds,
}

/// Where wrists are in every frame, model space, metres: one list a side.
pub(super) fn paths(clip: &Clip, signer: &Signer, sides: &[Side]) -> Vec<Vec<DVec3>> {
    let models: Vec<ModelPose> = clip.frames().iter().map(|f| f.pose.to_model(clip.skeleton())).collect();
    sides.iter().map(|side| models.iter().map(|m| m.position(signer.arm(*side).hand)).collect()).collect()
}

/// Puts the wrists where `target` says, given the side and the wrist's place, in the frames in which the extent holds.
///
/// On the ways there and back the joints are turned by an eased share of what they are turned by at the extent's edge, as
/// described signs come and go too: a translation would stretch an arm that is on its way from hanging.
pub(super) fn moved(
    clip: &Clip,
    signer: &Signer,
    (sides, kept): (Sides, HandKept),
    extent: &Extent,
    target: impl Fn(Side, DVec3) -> DVec3,
) -> Result<Moved, Error> {
    fits(clip, signer)?;
    let joints: Vec<JointId> = sides.each().iter().flat_map(|s| arm_joints(signer, *s)).collect();
    let weights = extent.weights(clip);
    let mut worst = (0.0, 0);
    // By how much the forearm of a side was turned further in the frame before.
    let mut turned = [0.0; 2];
    let held = rewritten(clip, &joints, |i, pose| {
        if weights[i] < 1.0 {
            return;
        }
        let model = pose.to_model(clip.skeleton());
        for &side in sides.each() {
            let arm = signer.arm(side);
            let wrist = model.position(arm.hand);
            let goal = target(side, wrist);
            if goal == wrist || !goal.is_finite() {
                turned[side as usize] = 0.0;
                continue;
            }
            let (placed, residual_m) = carried(&placed(arm, &model), goal);
            if residual_m > worst.0 {
                worst = (residual_m, i);
            }
            write(arm, &placed, kept, &model, &mut turned[side as usize], pose);
        }
    });
    let at = clip.fps().time_of(FrameIndex(worst.1));
    Ok(Moved { clip: with_ways(clip, &held, &joints, &weights, extent), residual_m: worst.0, at })
}

/// Turns the joints outside the extent by an eased share of their turn at its edge.
fn with_ways(source: &Clip, held: &Clip, joints: &[JointId], weights: &[f64], extent: &Extent) -> Clip {
    let first = weights.iter().position(|w| *w >= 1.0);
    let Some((first, last)) = first.zip(weights.iter().rposition(|w| *w >= 1.0)) else { return held.clone() };
    let edge = |at: usize| -> Vec<ShortArc> {
        let (before, after) = (&source.frames()[at].pose, &held.frames()[at].pose);
        let turn = |j: &JointId| before.rotation(*j).conjugate() * after.rotation(*j);
        joints.iter().map(|j| ShortArc::new(DQuat::IDENTITY, unit(turn(j)))).collect()
    };
    let (coming, going) = (edge(first), edge(last));
    rewritten(held, joints, |i, pose| {
        if weights[i] > 0.0 && weights[i] < 1.0 {
            for (joint, turn) in joints.iter().zip(if i < first { &coming } else { &going }) {
                pose.set(*joint, unit(pose.rotation(*joint) * turn.eased(extent.easing, weights[i])));
            }
        }
    })
}

/// The joints that an arm's new place rewrites: upper arm, forearm, and those of orientation.
fn arm_joints(signer: &Signer, side: Side) -> Vec<JointId> {
    let channels = Channels::of(signer, side);
    channels.placement[1..].iter().chain(&channels.orientation).copied().collect()
}

fn placed(arm: &ArmRig, model: &ModelPose) -> PlacedArm {
    let upper = model.rotation(arm.upper);
    PlacedArm {
        joints: [arm.upper, arm.fore, arm.hand].map(|j| model.position(j)),
        upper,
        fore: model.rotation(arm.fore),
        hinge: upper * arm.rest.hinge(),
    }
}

/// Writes an arm in its new place into the pose that `before` was made of.
fn write(arm: &ArmRig, placed: &PlacedArm, kept: HandKept, before: &ModelPose, turned: &mut f64, pose: &mut LocalPose) {
    pose.set(arm.upper, unit(before.rotation(arm.clavicle).conjugate() * placed.upper));
    pose.set(arm.fore, unit(placed.upper.conjugate() * placed.fore));
    match kept {
        HandKept::Global => turn_hand(arm, unit(placed.fore.conjugate() * before.rotation(arm.hand)), turned, pose),
        HandKept::Local => {}
    }
}

/// Gives the hand another rotation relative to the forearm, and the forearm's skin its share of the change.
///
/// `turned` is by how much the forearm was turned further in the frame before, radians: a change past half a turn goes on.
pub(in crate::synthesis) fn turn_hand(arm: &ArmRig, hand: DQuat, turned: &mut f64, pose: &mut LocalPose) {
    let twist = |q| twist_angle(q, arm.rest.fore());
    *turned = unwrap_near(*turned, twist(hand) - twist(pose.rotation(arm.hand)));
    pose.set(arm.hand, hand);
    arm.add_twist(*turned, pose);
}
