//! A plan signed: its items laid out in time, strokes written hand by hand, ways between them, face and body.

use super::layout::{Slower, end_place, lay_out, start_place, to_rest};
use super::phased::Phased;
use super::plan::HandPlan;
use super::prepare::{Prepared, prepare};
use super::report::Report;
use super::schedule::{Measured, Schedule};
use super::stage::Stage;
use super::stroke::{Body, Stint, Stroke};
use super::timeline::Timeline;
use super::ways::AtRest;
use super::{Grammar, Options, Performance, clip, tiers};
use crate::body::signer::{Shoulder, Signer};
use crate::diagnostics::Error;
use crate::motion::clip::Frame;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{angle_between, continuous};
use crate::phonology::Side;
use crate::score::plan::{Act, Plan};
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;
use glam::DVec3;

/// The wrist stays under this speed, metres a second: durations that the sign leaves open grow.
pub const WRIST_SPEED: f64 = 3.0;
/// Joints of an arm stay under this speed, radians a second, as far as that takes no more than so many times as long: what is faster
/// then is a leap, which is eased where it is.
const TURN_SPEED: (f64, f64) = (18.0, 1.6);
/// A posture that nothing moves in is seen when it is held this long, seconds (facts/phonology.md §5, cued speech).
const LEAST_POSTURE: f64 = 0.10;
/// Strokes may be pressed to this part of their usual time, where the wrist's speed allows it.
const MOST_PRESSED: f64 = 0.5;
/// Transitions are not shorter than this, seconds, nor than the wrist's speed allows.
const LEAST_WAY: f64 = 0.10;
/// Transitions become at most so many times as long for slow wrists.
const SLOWEST_WAY: f64 = 4.0;
/// A hand returns to the neutral pose between two strokes where it can stay there so long, seconds.
const WORTH_RESTING: f64 = 0.15;

/// The greatest speeds of a wrist, metres a second, and of the joints of an arm, radians a second: in each item's stroke, on the
/// way there, and on the way back.
#[derive(Debug, Clone)]
struct Speeds {
    strokes: Vec<Speed>,
    ways: Vec<Speed>,
    retraction: Speed,
}

/// How fast an arm is at its fastest.
#[derive(Debug, Clone, Copy, Default)]
struct Speed {
    /// Of the wrist, metres a second.
    wrist: f64,
    /// Of a joint, radians a second.
    turn: f64,
}

impl Speed {
    /// The greater of two, each by itself.
    fn most(self, other: Speed) -> Speed {
        Speed { wrist: self.wrist.max(other.wrist), turn: self.turn.max(other.turn) }
    }
}

/// Signs a plan at its own pace.
pub(super) fn perform(plan: &Plan, stage: &Stage) -> Result<Performance, Error> {
    let phased = Phased::of(plan);
    settle(&phased, stage).map(|(performance, ..)| whole_signs(&phased, performance))
}

/// What a plan takes: its phases as they come out when nothing presses, and how short they may become.
pub(super) fn measure(plan: &Plan, stage: &Stage) -> Result<Measured, Error> {
    let phased = Phased::of(plan);
    let (_, mut measured, speeds) = settle(&phased, stage)?;
    let least =
        |usual: Seconds, speed: f64, floor: f64| Seconds((usual.0 * speed / WRIST_SPEED).max(floor).min(usual.0));
    for (i, (phases, item)) in measured.items.iter_mut().zip(&phased.plan.items).enumerate() {
        phases.transition.least = least(phases.transition.usual, speeds.ways[i].wrist, LEAST_WAY);
        let pressed = phases.stroke.usual.0 * MOST_PRESSED;
        phases.stroke.least = least(phases.stroke.usual, speeds.strokes[i].wrist, pressed);
        let floor = match &item.act {
            Act::Sign(sign) if sign.intervals == 0 => LEAST_POSTURE,
            Act::Sign(_) | Act::Hold(..) | Act::Rest(_) | Act::Captured(_) => 0.0,
        };
        phases.hold.least = least(phases.hold.usual, 0.0, floor);
    }
    measured.retraction.least = least(measured.retraction.usual, speeds.retraction.wrist, LEAST_WAY);
    Ok(phased.merged(measured))
}

/// Signs a plan at times that were allotted from outside; they are kept unchanged.
pub(super) fn render(plan: &Plan, schedule: &Schedule, stage: &Stage) -> Result<Performance, Error> {
    schedule.check(plan.items.len()).map_err(|e| e.context(title(plan)))?;
    let phased = Phased::of(plan);
    let prepared = prepare(stage, &phased)?;
    let inner = match phased.plan.items.len() == plan.items.len() {
        true => schedule.clone(),
        false => {
            let usual = lay_out(stage, &phased.plan, &prepared, &Slower::usual(stage, phased.plan.items.len()));
            phased.schedule(schedule, &usual)
        }
    };
    let (performance, _) = write(stage, &phased, &prepared, &inner)?;
    Ok(whole_signs(&phased, performance))
}

/// A performance whose report is about whole signs.
fn whole_signs(phased: &Phased, mut performance: Performance) -> Performance {
    performance.report.items = phased.times(&performance.report.items);
    performance
}

/// Signs a plan; durations grow until the wrists are slow enough.
fn settle(phased: &Phased, stage: &Stage) -> Result<(Performance, Measured, Speeds), Error> {
    let plan = &*phased.plan;
    let mut prepared = prepare(stage, phased)?;
    let mut slower = Slower::usual(stage, plan.items.len());
    // Each round measures the speed that the last one came to; two are enough, the third is for luck.
    for round in 0.. {
        let mut measured = lay_out(stage, plan, &prepared, &slower);
        phased.keep_stated(&mut measured, stage.options.speed);
        let schedule = measured.schedule();
        schedule.check(plan.items.len()).map_err(|e| e.context(title(plan)))?;
        let (performance, speeds) = write(stage, phased, &prepared, &schedule)?;
        let mut settled = true;
        let mut grow = |speed: Speed| {
            // A leap stays as fast however long it takes, so the turns count once.
            let turned = if round == 0 { (speed.turn / TURN_SPEED.0).min(TURN_SPEED.1) } else { 0.0 };
            let over = (speed.wrist / WRIST_SPEED).max(turned);
            settled &= over <= 1.0;
            if over > 1.0 { over * 1.02 } else { 1.0 }
        };
        for sign in prepared.iter_mut().filter(|p| !p.states_its_time) {
            sign.slow_down(grow(speeds.strokes[sign.item]));
        }
        for (factor, speed) in slower.ways.iter_mut().zip(&speeds.ways) {
            *factor = (*factor * grow(*speed)).min(SLOWEST_WAY.max(*factor));
        }
        slower.retraction = (slower.retraction * grow(speeds.retraction)).min(SLOWEST_WAY);
        if settled || round == 3 {
            return Ok((performance, measured, speeds));
        }
    }
    Err(Error::new("no plan was written"))
}

/// Writes all frames of a plan.
fn write(
    stage: &Stage,
    phased: &Phased,
    prepared: &[Prepared],
    schedule: &Schedule,
) -> Result<(Performance, Speeds), Error> {
    let plan = &*phased.plan;
    let timelines = timelines(prepared, schedule);
    let cues = stage.cues(plan, prepared, &timelines, schedule)?;
    let fps = stage.options.fps;
    let count = fps.frame_count(schedule.end);
    let mut poses = vec![stage.neutral.clone(); count];
    let mut weights = vec![vec![0.0f32; stage.signer.morphs.len()]; count];
    let mut raised = vec![[Shoulder::default(); 2]; count];
    if !cues.is_empty() {
        for i in 0..count {
            raised[i] = stage.express(&cues, fps.time_of(FrameIndex(i)).0, &mut poses[i], &mut weights[i]);
        }
    }
    let mut report = Report {
        stroke_start: schedule.items.first().map_or(schedule.start, |t| t.stroke),
        keys: timelines.iter().flat_map(|t| &t.keys).map(|t| Seconds(*t)).collect(),
        sign_end: schedule.items.last().map_or(schedule.start, |t| t.hold_end),
        items: schedule.items.clone(),
        ..Report::default()
    };
    let named = phased.groups.len() > 1;
    let whose = |sign: &Prepared| if named { format!("{}: ", plan.items[sign.item].gloss) } else { String::new() };
    for sign in prepared {
        report.warnings.extend(sign.known.warnings.iter().map(|warning| format!("{}{warning}", whose(sign))));
    }
    let mut stints: [Vec<(Stint, &HandPlan)>; 2] = Default::default();
    for (sign, timeline) in prepared.iter().zip(&timelines) {
        for hand in &sign.hands {
            let until = held_until(stage, plan, prepared, schedule, sign.item, hand);
            let stint = stint(stage, hand.side, sign.item, timeline.stroke, until, count);
            let own = &mut stints[hand.side as usize];
            let Some(stint) = follow_on(own.last_mut().map(|(s, _)| s), stint) else {
                report.warnings.push(format!("{}there is no time for it; it is passed over", whose(sign)));
                continue;
            };
            let still = cues.is_empty() && !hand.on_other_hand;
            let body = if still { Body::Still } else { Body::Moving };
            let stroke = Stroke { plan: hand, stint: &stint, timeline, natural: sign.natural(), body, raised: &raised };
            let solved = stage.write_stroke(&stroke, &mut poses);
            report.measure(stage, &stint, &solved, &whose(sign));
            own.push((stint, hand));
        }
    }
    for own in &stints {
        write_ways(stage, plan, schedule, own, &mut poses);
    }
    let speeds = speeds(stage, plan.items.len(), &stints, &poses);
    report.wrist_speed = speeds.strokes.iter().chain(&speeds.ways).copied().fold(speeds.retraction, Speed::most).wrist;
    for sign in prepared {
        let judged =
            report.judge(stage, sign, &schedule.items[sign.item], speeds.strokes[sign.item].wrist, &whose(sign));
        judged.map_err(|e| e.context(&plan.items[sign.item].gloss))?;
    }
    for i in 1..count {
        let (before, after) = poses.split_at_mut(i);
        for (q, p) in after[0].rotations.iter_mut().zip(&before[i - 1].rotations) {
            *q = continuous(*p, *q);
        }
    }
    let frames = poses.into_iter().zip(weights).map(|(pose, weights)| Frame { pose, weights }).collect();
    let tiers = tiers::with_captured(tiers::of_plan(plan, prepared, &timelines, schedule), prepared, stage.grammar);
    let track = Track { clip: clip(stage.signer, fps, frames)?, tiers };
    Ok((Performance { track, report }, speeds))
}

/// What a message calls a plan.
fn title(plan: &Plan) -> String {
    let glosses: Vec<&str> = plan.items.iter().map(|i| i.gloss.as_str()).take(4).collect();
    format!("{}{}", glosses.join(" "), if plan.items.len() > 4 { " …" } else { "" })
}

/// The instants of every sign.
fn timelines(prepared: &[Prepared], schedule: &Schedule) -> Vec<Timeline> {
    let start = |item: usize| match item.checked_sub(1).and_then(|i| schedule.items.get(i)) {
        Some(before) => before.hold_end,
        None => schedule.start,
    };
    let of = |p: &Prepared| {
        let timeline = Timeline::new(p, start(p.item).0, &schedule.items[p.item]);
        let ends = p.group.end.checked_sub(1).and_then(|last| schedule.items.get(last));
        match ends.filter(|_| p.group.start == p.item) {
            Some(last) => Timeline { sign_end: last.hold_end.0, ..timeline },
            None => timeline,
        }
    };
    prepared.iter().map(of).collect()
}

/// The frames of a stroke and its hold.
fn stint(stage: &Stage, side: Side, item: usize, stroke: f64, until: f64, count: usize) -> Stint {
    let fps = stage.options.fps.get();
    let first = ((stroke * fps - 1e-6).ceil().max(0.0) as usize).min(count - 1);
    let last = ((until * fps + 1e-6).floor().max(0.0) as usize).clamp(first, count - 1);
    Stint { side, item, first, last }
}

/// Keeps two stints of a hand from sharing a frame; `None` where the second has none left.
fn follow_on(before: Option<&mut Stint>, mut stint: Stint) -> Option<Stint> {
    if let Some(before) = before
        && stint.first <= before.last
    {
        // The frame that both touch shows the first posture of the second.
        if stint.first > before.first {
            before.last = stint.first - 1;
        } else {
            stint.first = before.last + 1;
        }
    }
    (stint.first <= stint.last).then_some(stint)
}

/// Until when a hand keeps its last posture: to the end of its sign's hold, or longer where the line says so.
fn held_until(
    stage: &Stage,
    plan: &Plan,
    prepared: &[Prepared],
    schedule: &Schedule,
    item: usize,
    hand: &HandPlan,
) -> f64 {
    let mut until = schedule.items[item].hold_end.0;
    // A buoy: this hand is held while the other goes on.
    let mut buoy = false;
    for (j, next) in plan.items.iter().enumerate().skip(item + 1) {
        match &next.act {
            Act::Hold(None, _) => until = schedule.items[j].hold_end.0,
            Act::Hold(Some(held), _) => {
                if super::side_of(*held) == hand.side {
                    buoy = true;
                    until = schedule.items[j].hold_end.0;
                }
            }
            Act::Sign(sign) if !buoy && !sign.holds_over => return until,
            Act::Sign(_) => {
                let own = prepared.binary_search_by_key(&j, |p| p.item).ok().map(|n| &prepared[n]);
                let Some(again) = own.and_then(|p| p.hands.iter().find(|h| h.side == hand.side)) else {
                    until = schedule.items[j].hold_end.0;
                    continue;
                };
                let way = end_place(stage, hand).distance(start_place(stage, again));
                let needs = way / stage.grammar.movements.timing.transition_speed / stage.options.speed;
                let at_least = schedule.items[j].stroke.0 - schedule.items[j - 1].hold_end.0;
                return until.max(schedule.items[j].stroke.0 - needs.max(at_least));
            }
            Act::Rest(_) | Act::Captured(_) => return until,
        }
    }
    until
}

/// Writes what lies before, between and after the strokes of one hand.
fn write_ways(stage: &Stage, plan: &Plan, schedule: &Schedule, stints: &[(Stint, &HandPlan)], poses: &mut [LocalPose]) {
    let fps = stage.options.fps.get();
    let (Some((first, first_hand)), Some((last, last_hand))) = (stints.first(), stints.last()) else { return };
    let begin = match first.item {
        0 => schedule.start.0,
        _ => {
            let needs = to_rest(stage, first.side, start_place(stage, first_hand));
            (first.first as f64 / fps - needs).max(schedule.start.0)
        }
    };
    stage.write_preparation(first, begin, poses);
    for pair in stints.windows(2) {
        let [(a, from), (b, to)] = pair else { continue };
        let (begin, end) = (a.last as f64 / fps, b.first as f64 / fps);
        let leave = to_rest(stage, a.side, end_place(stage, from));
        let come = to_rest(stage, b.side, start_place(stage, to));
        let between = plan.items.iter().zip(&schedule.items).take(b.item).skip(a.item + 1);
        let mut rests = between.filter(|(item, _)| matches!(item.act, Act::Rest(_))).map(|(_, times)| times);
        let rest = match (rests.next(), rests.next_back()) {
            (Some(one), later) => {
                let until = later.unwrap_or(one).hold_end.0;
                Some(AtRest { from: one.stroke.0.min(begin + leave), until: until.max(end - come) })
            }
            (None, _) if end - begin >= leave + come + WORTH_RESTING / stage.options.speed => {
                Some(AtRest { from: begin + leave, until: end - come })
            }
            (None, _) => None,
        };
        stage.write_between(a, b, rest, poses);
    }
    let ends_the_line = plan.items.iter().skip(last.item + 1).all(|item| matches!(item.act, Act::Hold(..)));
    let rested = plan.items.iter().zip(&schedule.items).skip(last.item + 1);
    let mut rested = rested.filter(|(item, _)| matches!(item.act, Act::Rest(_))).map(|(_, times)| times.stroke.0);
    let leaves = last.last as f64 / fps + to_rest(stage, last.side, end_place(stage, last_hand));
    let end = match rested.next() {
        Some(rest) => rest,
        None if ends_the_line => schedule.retracted.0,
        None => leaves.min(schedule.retracted.0),
    };
    stage.write_retraction(last, end, poses);
}

/// How fast the arms are in each stroke and on each way.
fn speeds(stage: &Stage, items: usize, stints: &[Vec<(Stint, &HandPlan)>; 2], poses: &[LocalPose]) -> Speeds {
    let fps = stage.options.fps.get();
    let mut speeds = Speeds {
        strokes: vec![Speed::default(); items],
        ways: vec![Speed::default(); items],
        retraction: Speed::default(),
    };
    for own in stints {
        let Some((first, _)) = own.first() else { continue };
        let places = wrists(stage, first.side, poses);
        let arm = stage.signer.arm(first.side);
        let mut at = 0;
        for (i, pair) in places.windows(2).enumerate() {
            let turned =
                arm.joints().map(|joint| angle_between(poses[i].rotation(joint), poses[i + 1].rotation(joint)));
            let speed =
                Speed { wrist: pair[0].distance(pair[1]) * fps, turn: turned.into_iter().fold(0.0, f64::max) * fps };
            while own.get(at).is_some_and(|(s, _)| i >= s.last) {
                at += 1;
            }
            let most = match own.get(at) {
                None => &mut speeds.retraction,
                Some((stint, _)) if i < stint.first => &mut speeds.ways[stint.item],
                Some((stint, _)) => &mut speeds.strokes[stint.item],
            };
            *most = most.most(speed);
        }
    }
    speeds
}

/// Where a wrist is in every frame, model space, metres.
fn wrists(stage: &Stage, side: Side, poses: &[LocalPose]) -> Vec<DVec3> {
    let skeleton = &stage.signer.skeleton;
    let mut chain = vec![stage.signer.arm(side).hand];
    while let Some(parent) = chain.last().and_then(|j| skeleton[*j].parent) {
        chain.push(parent);
    }
    chain.reverse();
    let of = |pose: &LocalPose| {
        let (mut at, mut turned) = (pose.root_model, pose.rotation(chain[0]));
        for joint in &chain[1..] {
            at += turned * skeleton.offset(*joint);
            turned *= pose.rotation(*joint);
        }
        at
    };
    poses.iter().map(of).collect()
}

/// A stage for checked options.
pub(super) fn stage<'a>(grammar: &'a Grammar, signer: &'a Signer, options: &'a Options) -> Result<Stage<'a>, Error> {
    if !(options.speed.is_finite() && options.speed >= 0.05 && options.speed <= 20.0) {
        return Err(Error::new(format!("the speed {} does not lie between 0.05 and 20", options.speed)));
    }
    if !(0.0..=3.0).contains(&options.variation) {
        return Err(Error::new(format!("the variation {} does not lie between 0 and 3", options.variation)));
    }
    Stage::new(grammar, signer, options)
}
