//! One hand's stroke and hold, frame by frame: the fingers eased from key to key, the arm solved behind the hand.

use super::path_of_hand::{Instant, instant};
use super::plan::HandPlan;
use super::reach::{ArmFrame, HandTarget, ReachOptions, follow};
use super::stage::Stage;
use super::timeline::Timeline;
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Shoulder;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use glam::{DQuat, DVec3};

/// The frames of one hand's stroke and hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stint {
    /// Which side of the body.
    pub side: Side,
    /// The number of the item in its plan.
    pub item: usize,
    /// The first frame.
    pub first: usize,
    /// The last frame, its hold included.
    pub last: usize,
}

/// Whether the body moves under the arms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Body {
    Still,
    Moving,
}

/// What one hand's stroke is written from.
pub(super) struct Stroke<'s> {
    /// The hand's part of the sign.
    pub plan: &'s HandPlan,
    /// The frames that it gets.
    pub stint: &'s Stint,
    /// The sign's instants.
    pub timeline: &'s Timeline,
    /// How long the stroke lasts at the description's own speed, seconds.
    pub natural: f64,
    /// Whether the body moves under the arm.
    pub body: Body,
    /// How both shoulders are moved in each frame of the clip.
    pub raised: &'s [[Shoulder; 2]],
}

impl Stage<'_> {
    /// Writes the fingers and the arm of one hand into the frames of its stint.
    pub(super) fn write_stroke(&self, stroke: &Stroke, poses: &mut [LocalPose]) -> Vec<ArmFrame> {
        let &Stroke { plan, stint, timeline, natural, body, raised } = stroke;
        let fps = self.options.fps.get();
        let frames = stint.first..=stint.last;
        let own_time = |i: usize| timeline.own_time(i as f64 / fps, natural);
        let instants: Vec<Instant> = frames.clone().map(|i| instant(plan, own_time(i), self.options.easing)).collect();
        self.write_fingers(plan, &instants, &mut poses[frames.clone()]);

        let skeleton = &self.signer.skeleton;
        let arm = self.signer.arm(plan.side);
        let models: Vec<ModelPose> = match body {
            Body::Moving => poses[frames.clone()].iter().map(|p| p.to_model(skeleton)).collect(),
            Body::Still => Vec::new(),
        };
        let trunk = skeleton[arm.clavicle].parent.unwrap_or(arm.clavicle);
        let target = |(n, now): (usize, &Instant)| {
            let model = models.get(n).unwrap_or(&self.neutral_model);
            let (clavicle, trunk) = (model.position(arm.clavicle), model.rotation(trunk));
            let raised = raised[stint.first + n][plan.side as usize];
            if let Some(path) = &plan.wrist_path {
                let share = if natural > 0.0 { own_time(stint.first + n) / natural } else { 0.0 };
                let (point, rotation) = path.at(share);
                return HandTarget { point, rotation, offset: DVec3::ZERO, clavicle, trunk, raised };
            }
            let rotation = now.rotation(plan, model);
            let offset = self.offset(plan, now, &poses[stint.first + n]);
            let point = now.point(plan, model);
            let played = (rotation * now.play(plan)).normalize();
            HandTarget {
                // The wrist's play turns the hand about the wrist, so the contact point goes along.
                point: point - rotation * offset + played * offset,
                rotation: played,
                offset,
                clavicle,
                trunk,
                raised,
            }
        };
        let targets: Vec<HandTarget> = instants.iter().enumerate().map(target).collect();
        let options = ReachOptions {
            limits: super::limits(self.options),
            clavicle: !self.options.paper,
            free_hand: plan.free_hand,
            knot_every: (fps * 0.15).round().max(1.0) as usize,
        };
        let solved = follow(arm, skeleton.offset(arm.upper), &targets, &options);
        for (pose, frame) in poses[frames].iter_mut().zip(&solved) {
            pose.set(arm.clavicle, frame.clavicle);
            arm.write(&frame.arm, pose);
        }
        solved
    }

    /// The contact point in the hand's axes, from the wrist, for the fingers as they are now.
    fn offset(&self, plan: &HandPlan, now: &Instant, pose: &LocalPose) -> DVec3 {
        if self.options.paper {
            // The paper places the wrist (Naert et al. 2021, §4).
            return DVec3::ZERO;
        }
        let (a, b) = (&plan.keys[now.key], &plan.keys[(now.key + 1).min(plan.keys.len() - 1)]);
        let of = |contact: &ContactPoint| self.signer.in_hand(plan.side, contact, pose);
        if a.with == b.with { of(&a.with) } else { of(&a.with).lerp(of(&b.with), now.done.clamp(0.0, 1.0)) }
    }

    /// The fingers from key to key, eased in joint space (Naert et al. 2021, §5.2).
    fn write_fingers(&self, plan: &HandPlan, instants: &[Instant], poses: &mut [LocalPose]) {
        let easing = self.options.easing;
        let shapes: Vec<[DQuat; 15]> = plan.keys.iter().map(|k| self.fingers(plan.side, &k.angles)).collect();
        let after = |k: usize| &shapes[(k + 1).min(shapes.len() - 1)];
        // The way from each key's shape to the next one's.
        let changes: Vec<[ShortArc; 15]> =
            (0..shapes.len()).map(|k| std::array::from_fn(|j| ShortArc::new(shapes[k][j], after(k)[j]))).collect();
        let joints = self.signer.hand(plan.side).joints();
        for (now, pose) in instants.iter().zip(poses) {
            let mut fingers = match now.done {
                d if d <= 0.0 => shapes[now.key],
                d if d >= 1.0 => *after(now.key),
                d => std::array::from_fn(|j| changes[now.key][j].eased(easing, d)),
            };
            for (finger, bend) in now.wiggle(plan).into_iter().flatten().enumerate() {
                // Joints come thumb first, three a digit; flexion is about ∓Z.
                let knuckle = 3 * (finger + 1);
                fingers[knuckle] *= DQuat::from_rotation_z(-bend * plan.side.sign());
            }
            for (joint, rotation) in joints.iter().zip(fingers) {
                pose.set(*joint, rotation);
            }
        }
    }
}
