//! Writing a sign's frames: non-manuals, fingers, arms, and the ways from and to the neutral pose.

use super::path_of_hand::{Instant, instant};
use super::plan::{HandPlan, Planner, stretch};
use super::reach::{ArmFrame, HandTarget, ReachOptions, follow};
use super::timeline::Timeline;
use super::{Grammar, Options, Performance, Report, clip, limits, tiers};
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Frame;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::rotation::continuous;
use crate::phonology::handshape::HandAngles;
use crate::phonology::{Configuration, Movement, Side, Sign};
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;
use glam::DVec3;

/// The wrist stays under this speed, metres a second: durations that the sign leaves open grow.
pub const WRIST_SPEED: f64 = 3.0;
/// Above this speed of the wrist a sign is at fault, metres a second.
pub const WRIST_SPEED_FAULT: f64 = 5.0;
/// A contact point farther than this from its target is worth a warning, metres.
const RESIDUAL_WARNED: f64 = 5e-3;
/// A hand turned farther than this from what is stated is worth a warning, radians.
const TILT_WARNED: f64 = 2.0 * std::f64::consts::PI / 180.0;

/// Signs a sign; durations grow until the wrist is slow enough.
pub(super) fn perform(
    sign: &Sign,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<Performance, Error> {
    let relaxed = grammar.angles(&Configuration::named("rest"), sign)?;
    let neutral = signer.neutral(&relaxed);
    let model = neutral.to_model(&signer.skeleton);
    let planner = Planner { grammar, signer, neutral: &model };
    let mut plans = planner.plan(sign)?;
    let mut writer = Writer { sign, grammar, signer, options, planner: &planner, neutral, relaxed, slower: 1.0 };
    let fixed = states_its_time(sign);
    // Each round measures the speed that the last one came to; two are enough, the third is for luck.
    for _ in 0..3 {
        let (performance, stroke_speed, way_speed) = writer.write(&plans)?;
        let stroke_factor = if fixed { 1.0 } else { stroke_speed / WRIST_SPEED };
        let way_factor = way_speed / WRIST_SPEED;
        if stroke_factor <= 1.0 && way_factor <= 1.0 {
            return Ok(performance);
        }
        if stroke_factor > 1.0 {
            stretch(&mut plans, stroke_factor * 1.02);
        }
        writer.slower *= way_factor.max(1.0) * 1.02;
    }
    writer.write(&plans).map(|(performance, ..)| performance)
}

/// Whether the author has said how long the sign or a movement of it lasts.
fn states_its_time(sign: &Sign) -> bool {
    fn stated(movement: &Movement) -> bool {
        match movement {
            Movement::Action(action) => action.duration.is_some(),
            Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => parts.iter().any(stated),
            Movement::Backwards(inner) => stated(inner),
        }
    }
    sign.duration.is_some() || sign.strong.movement.iter().chain(&sign.weak.movement).any(stated)
}

pub(super) struct Writer<'a> {
    pub(super) sign: &'a Sign,
    pub(super) grammar: &'a Grammar,
    pub(super) signer: &'a Signer,
    pub(super) options: &'a Options,
    pub(super) planner: &'a Planner<'a>,
    pub(super) neutral: LocalPose,
    pub(super) relaxed: HandAngles,
    /// How much longer than usual preparation and retraction last.
    pub(super) slower: f64,
}

impl Writer<'_> {
    /// The performance, and the greatest speeds of a wrist in the stroke and on the ways there and back.
    fn write(&self, plans: &[HandPlan]) -> Result<(Performance, f64, f64), Error> {
        let timing = &self.grammar.movements.timing;
        let (there, back) = (self.way(plans, true), self.way(plans, false));
        let timeline = Timeline::new(plans, self.sign.intervals, timing, there, back, self.options.speed);
        let cues = self.cues(&timeline, plans)?;
        let fps = self.options.fps;
        let count = fps.frame_count(Seconds(timeline.end));
        let mut poses = vec![self.neutral.clone(); count];
        let mut weights = vec![vec![0.0f32; self.signer.morphs.len()]; count];
        let mut raised = vec![[0.0; 2]; count];
        if !cues.is_empty() {
            for i in 0..count {
                raised[i] = self.express(&cues, fps.time_of(FrameIndex(i)).0, &mut poses[i], &mut weights[i]);
            }
        }
        let mut report = Report {
            stroke_start: Seconds(timeline.stroke),
            keys: timeline.keys.iter().map(|t| Seconds(*t)).collect(),
            sign_end: Seconds(timeline.hold_end),
            ..Report::default()
        };
        let moving_body = !cues.is_empty();
        let (mut stroke_speed, mut way_speed) = (0.0f64, 0.0f64);
        for plan in plans {
            let wrists = self.write_hand(plan, &timeline, moving_body, &raised, &mut poses, &mut report);
            for (i, pair) in wrists.windows(2).enumerate() {
                let speed = pair[0].distance(pair[1]) * fps.get();
                let middle = (i as f64 + 0.5) / fps.get();
                let in_stroke = (timeline.stroke..timeline.hold_end).contains(&middle);
                let most = if in_stroke { &mut stroke_speed } else { &mut way_speed };
                *most = most.max(speed);
            }
        }
        report.wrist_speed = stroke_speed.max(way_speed);
        self.warn(&mut report, stroke_speed)?;
        for i in 1..count {
            let (before, after) = poses.split_at_mut(i);
            for (q, p) in after[0].rotations.iter_mut().zip(&before[i - 1].rotations) {
                *q = continuous(*p, *q);
            }
        }
        let frames = poses.into_iter().zip(weights).map(|(pose, weights)| Frame { pose, weights }).collect();
        let tiers = tiers::of_sign(self.sign, &timeline, plans);
        let track = Track { clip: clip(self.signer, fps, frames)?, tiers };
        Ok((Performance { track, report }, stroke_speed, way_speed))
    }

    /// Seconds from the neutral pose to the stroke, or back.
    fn way(&self, plans: &[HandPlan], there: bool) -> f64 {
        let timing = &self.grammar.movements.timing;
        let farthest = plans.iter().map(|plan| {
            let anchor = if there { Some(&plan.start) } else { plan.legs.last().map(|l| &l.to) };
            let point = anchor.unwrap_or(&plan.start).position(self.planner.neutral);
            let hand = self.signer.arm(plan.side).hand;
            self.planner.neutral.position(hand).distance(point).min(1.2)
        });
        let distance = farthest.fold(0.0, f64::max);
        (distance / timing.transition_speed).max(timing.transition_least) * self.slower
    }

    /// Writes one hand's fingers and arm into all frames; returns the wrist's places.
    fn write_hand(
        &self,
        plan: &HandPlan,
        timeline: &Timeline,
        moving_body: bool,
        raised: &[[f64; 2]],
        poses: &mut [LocalPose],
        report: &mut Report,
    ) -> Vec<DVec3> {
        let (fps, easing) = (self.options.fps.get(), self.options.easing);
        let skeleton = &self.signer.skeleton;
        let arm = self.signer.arm(plan.side);
        let frame_at = |time: f64, up: bool| {
            let frame = time * fps;
            let i = if up { (frame - 1e-6).ceil() } else { (frame + 1e-6).floor() };
            (i.max(0.0) as usize).min(poses.len() - 1)
        };
        let first = frame_at(timeline.stroke, true);
        let last = frame_at(timeline.hold_end, false).max(first);
        let instants: Vec<Instant> = (first..=last)
            .map(|i| instant(plan, (i as f64 / fps - timeline.stroke) * self.options.speed, easing))
            .collect();
        self.write_fingers(plan, timeline, &instants, first, poses);

        let still = (!moving_body && !plan.on_other_hand).then(|| self.planner.neutral.clone());
        let mut models: Vec<Option<ModelPose>> = Vec::new();
        if still.is_none() {
            models = poses[first..=last].iter().map(|p| Some(p.to_model(skeleton))).collect();
        }
        let trunk = skeleton[arm.clavicle].parent.unwrap_or(arm.clavicle);
        let targets: Vec<HandTarget> = instants
            .iter()
            .enumerate()
            .map(|(n, now)| {
                let model = models.get(n).and_then(|m| m.as_ref()).or(still.as_ref()).unwrap_or(self.planner.neutral);
                let rotation = now.rotation(plan, model);
                let offset = self.offset(plan, now, &poses[first + n]);
                let point = now.point(plan, model);
                let played = (rotation * now.play(plan)).normalize();
                HandTarget {
                    // The wrist's play turns the hand about the wrist, so the contact point goes along.
                    point: point - rotation * offset + played * offset,
                    rotation: played,
                    offset,
                    clavicle: model.position(arm.clavicle),
                    trunk: model.rotation(trunk),
                    raised: raised[first + n][plan.side as usize],
                }
            })
            .collect();
        let options = ReachOptions {
            limits: limits(self.options),
            clavicle: !self.options.paper,
            free_hand: plan.free_hand,
            knot_every: (fps * 0.15).round().max(1.0) as usize,
        };
        let solved = follow(arm, skeleton.offset(arm.upper), &targets, &options);
        for (n, frame) in solved.iter().enumerate() {
            poses[first + n].set(arm.clavicle, frame.clavicle);
            arm.write(&frame.arm, &mut poses[first + n]);
        }
        self.measure(plan, &solved, first, report);
        self.write_ways(plan, timeline, first, last, poses);
        self.wrists(plan, &solved, first, poses)
    }

    /// Notes what the stroke came to, and warns of what a body cannot do.
    fn measure(&self, plan: &HandPlan, solved: &[ArmFrame], first: usize, report: &mut Report) {
        let fps = self.options.fps;
        let hand = match plan.side {
            Side::Left => "left",
            Side::Right => "right",
        };
        let by = |value: fn(&ArmFrame) -> f64| {
            solved.iter().enumerate().max_by(|a, b| value(a.1).total_cmp(&value(b.1))).map(|(n, f)| (first + n, f))
        };
        if let Some((i, frame)) = by(|f| f.residual_m) {
            report.residual_m = report.residual_m.max(frame.residual_m);
            if frame.residual_m > RESIDUAL_WARNED {
                let (time, mm) = (fps.time_of(FrameIndex(i)), frame.residual_m * 1e3);
                report
                    .warnings
                    .push(format!("{hand} hand at {time}: out of reach, it stays {mm:.0} mm away from its place"));
            }
        }
        if let Some((i, frame)) = by(|f| f.tilt) {
            report.tilt = report.tilt.max(frame.tilt);
            let complaint = limits(self.options).and_then(|l| l.complaint(&frame.wanted));
            if let Some(complaint) = complaint.filter(|_| frame.tilt > TILT_WARNED) {
                let (time, degrees) = (fps.time_of(FrameIndex(i)), frame.tilt.to_degrees());
                report
                    .warnings
                    .push(format!("{hand} hand at {time}: {complaint}; it is turned {degrees:.0}° less than stated"));
            }
        }
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

    fn warn(&self, report: &mut Report, stroke_speed: f64) -> Result<(), Error> {
        if stroke_speed > WRIST_SPEED_FAULT && states_its_time(self.sign) {
            return Err(Error::new(format!(
                "the wrist would move at {stroke_speed:.1} m/s, faster than anyone signs: give it more time"
            )));
        }
        if stroke_speed > WRIST_SPEED {
            report.warnings.push(format!("the wrist moves at {stroke_speed:.1} m/s; signers stay under 3"));
        }
        let whole = report.sign_end.0 - report.stroke_start.0;
        let greatest = self.grammar.movements.timing.greatest_sign;
        if whole * self.options.speed > greatest {
            report.warnings.push(format!("the sign lasts {whole:.1} s; signs rarely take more than {greatest:.0} s"));
        }
        Ok(())
    }
}
