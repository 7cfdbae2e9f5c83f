//! One hand's stroke and hold, frame by frame: the fingers eased from key to key, the arm solved behind the hand.

use super::anchor::Anchor;
use super::leg::{FingerOrder, LegEnd};
use super::path_of_hand::{Instant, instant};
use super::plan::{HandPlan, Riding};
use super::reach::{ArmFrame, HandTarget, ReachOptions, follow};
use super::stage::Stage;
use super::timeline::Timeline;
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Shoulder;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use glam::{DQuat, DVec3};

/// How often an arm is solved again whose point above the wrist is placed.
const ROUNDS: usize = 4;

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
        let let_go = let_go(plan, &instants, &models);
        let plan = let_go.as_ref().unwrap_or(plan);
        let target = |(n, now): (usize, &Instant)| {
            let model = models.get(n).unwrap_or(&self.neutral_model);
            let (clavicle, trunk) = (model.position(arm.clavicle), model.rotation(trunk));
            let raised = raised[stint.first + n][plan.side as usize];
            if let Some(path) = &plan.wrist_path {
                let share = if natural > 0.0 { own_time(stint.first + n) / natural } else { 0.0 };
                let (point, rotation) = path.at(share);
                return HandTarget { point, rotation, offset: DVec3::ZERO, clavicle, trunk, raised, aside_m: 0.0 };
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
                aside_m: 0.0,
            }
        };
        let mut targets: Vec<HandTarget> = instants.iter().enumerate().map(target).collect();
        if !self.options.paper && plan.wrist_path.is_none() && !plan.on_other_hand {
            self.keep_clear(plan.side, &models, &poses[frames.clone()], &mut targets);
        }
        let options = ReachOptions {
            limits: super::limits(self.options),
            clavicle: !self.options.paper,
            free_hand: plan.free_hand,
            knot_every: (fps * 0.15).round().max(1.0) as usize,
        };
        let solve = |targets: &[HandTarget], poses: &mut [LocalPose]| {
            let solved = follow(arm, skeleton.offset(arm.upper), targets, &options);
            for (pose, frame) in poses[frames.clone()].iter_mut().zip(&solved) {
                pose.set(arm.clavicle, frame.clavicle);
                arm.write(&frame.arm, pose);
            }
            solved
        };
        let mut solved = solve(&targets, poses);
        if plan.wrist_path.is_none() && plan.points.iter().any(|point| self.is_above_wrist(plan.side, point)) {
            // Where a point of the arm is, is known only when the arm is: the target is moved by what is missed.
            let wanted: Vec<DVec3> = targets.iter().map(|t| t.point).collect();
            for _ in 0..ROUNDS {
                for (n, target) in targets.iter_mut().enumerate() {
                    let model = poses[stint.first + n].to_model(skeleton);
                    let turned = model.rotation(arm.hand).inverse();
                    let offset = instants[n].offset(plan, |point: &ContactPoint| {
                        turned * (point.position(&model) - model.position(arm.hand))
                    });
                    let missed = wanted[n] - model.point(arm.hand, offset);
                    target.point += missed.clamp_length_max(0.3);
                }
                solved = solve(&targets, poses);
            }
            for (n, frame) in solved.iter_mut().enumerate() {
                let model = poses[stint.first + n].to_model(skeleton);
                let turned = model.rotation(arm.hand).inverse();
                let offset = instants[n]
                    .offset(plan, |point: &ContactPoint| turned * (point.position(&model) - model.position(arm.hand)));
                frame.residual_m = wanted[n].distance(model.point(arm.hand, offset));
            }
        }
        self.smooth(plan.side, &solved, &mut poses[frames]);
        solved
    }

    /// Whether a point of a limb lies above its hand.
    fn is_above_wrist(&self, side: Side, point: &ContactPoint) -> bool {
        let (skeleton, hand) = (&self.signer.skeleton, self.signer.arm(side).hand);
        point.parts().iter().any(|part| {
            let mut at = Some(part.joint);
            while let Some(joint) = at {
                if joint == hand {
                    return false;
                }
                at = skeleton[joint].parent;
            }
            true
        })
    }

    /// The contact point in the hand's axes, from the wrist, for the fingers as they are now.
    fn offset(&self, plan: &HandPlan, now: &Instant, pose: &LocalPose) -> DVec3 {
        if self.options.paper {
            // The paper places the wrist (Naert et al. 2021, §4).
            return DVec3::ZERO;
        }
        now.offset(plan, |contact: &ContactPoint| self.signer.in_hand(plan.side, contact, pose))
    }

    /// The fingers from posture to posture, eased in joint space (Naert et al. 2021, §5.2).
    fn write_fingers(&self, plan: &HandPlan, instants: &[Instant], poses: &mut [LocalPose]) {
        let easing = self.options.easing;
        let shapes: Vec<[DQuat; 15]> = plan.postures.iter().map(|k| self.fingers(plan.side, &k.angles)).collect();
        // The ways from one shape to another, each made once.
        let mut ways: Vec<((usize, usize), [ShortArc; 15])> = Vec::new();
        let hand = self.signer.hand(plan.side);
        let joints = hand.joints();
        for (now, pose) in instants.iter().zip(poses) {
            let change = now.change(plan);
            let order = now.leg(plan).map_or(FingerOrder::Together, |(placed, _)| placed.leg.fingers);
            let between = order != FingerOrder::Together || (now.done > 0.0 && now.done < 1.0);
            let mut fingers = match now.done {
                d if !between && d <= 0.0 => shapes[change.from],
                _ if !between => shapes[change.to],
                d => {
                    let pair = (change.from, change.to);
                    let known = ways.iter().rposition(|(of, _)| *of == pair).unwrap_or_else(|| {
                        let way = std::array::from_fn(|j| ShortArc::new(shapes[pair.0][j], shapes[pair.1][j]));
                        ways.push((pair, way));
                        ways.len() - 1
                    });
                    let arcs = &ways[known].1;
                    match order {
                        FingerOrder::Together => std::array::from_fn(|j| arcs[j].eased(easing, d)),
                        // Joints come thumb first, three a digit.
                        FingerOrder::TowardPinky | FingerOrder::TowardThumb => std::array::from_fn(|j| {
                            let done = change.done(order.share(j / 3, now.share), easing);
                            arcs[j].eased(easing, done.clamp(0.0, 1.0))
                        }),
                    }
                }
            };
            let wiggle = now.wiggle(plan);
            for (finger, bend) in wiggle.into_iter().flatten().enumerate() {
                // Flexion is about ∓Z.
                let knuckle = 3 * (finger + 1);
                let out = -plan.side.sign();
                let bent = 2.0 * (fingers[knuckle].z * out).atan2(fingers[knuckle].w.abs());
                // A knuckle that is bent already plays less.
                let bend = bend.min((KNUCKLE_MOST - bent).max(0.0));
                fingers[knuckle] *= DQuat::from_rotation_z(bend * out);
            }
            for (joint, rotation) in joints.iter().zip(fingers) {
                pose.set(*joint, rotation);
            }
            // Between two shapes, and while they play, fingers are bent otherwise than in either.
            if between || wiggle.is_some() {
                hand.limit_spread(pose);
            }
        }
    }
}

/// How far a playing knuckle bends, radians.
const KNUCKLE_MOST: f64 = 98.0 * std::f64::consts::PI / 180.0;

/// The plan with the ways of a hand that lets go of the other one standing where they begin; `None` where none does.
fn let_go(plan: &HandPlan, instants: &[Instant], models: &[ModelPose]) -> Option<HandPlan> {
    if plan.legs.iter().all(|leg| leg.hold == Riding::Rides) || models.is_empty() {
        return None;
    }
    let mut own = plan.clone();
    // Where the hand is now, once it has let go: the place that the plan has for it, and the one that it is at.
    let mut now: Option<(Anchor, Anchor)> = None;
    for n in 0..own.legs.len() {
        let interval = own.legs[n].interval;
        let first = own.legs.iter().position(|leg| leg.interval == interval).unwrap_or(n);
        let leg = &own.legs[n];
        let (planned, was) = (leg.from.clone(), leg.to.clone());
        let mut from = now.take().filter(|(planned, _)| *planned == leg.from).map_or(leg.from.clone(), |(_, at)| at);
        if leg.hold == Riding::LetsGo {
            let frame = instants.iter().position(|i| i.leg >= Some(n)).unwrap_or(models.len() - 1);
            from = Anchor::Fixed(from.position(&models[frame.min(models.len() - 1)]));
        }
        let to = match &leg.leg.end {
            _ if from == planned => was.clone(),
            LegEnd::StartOf(earlier) => own.legs.get(first + earlier).map_or(was.clone(), |leg| leg.from.clone()),
            LegEnd::Displaced if was == planned.moved(leg.leg.path.end()) => from.clone().moved(leg.leg.path.end()),
            LegEnd::Displaced
            | LegEnd::At(_)
            | LegEnd::Meeting(_)
            | LegEnd::Rebound(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey
            | LegEnd::Off(..) => was.clone(),
        };
        now = Some((was, to.clone()));
        (own.legs[n].from, own.legs[n].to) = (from, to);
    }
    Some(own)
}
