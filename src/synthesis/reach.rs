//! An arm that follows its hand: from targets of the contact point to rotations, frame by frame.
//!
//! The wrist goes where the contact point needs it (`wrist = point − rotation · offset`), FABRIK places the
//! elbow, a hinge. The elbow's swivel is free: at knots along the stroke it is chosen so that the wrist bends
//! like a wrist, the elbow stays out of the trunk, hangs, and moves little (dynamic programming over the
//! knots), then interpolated. Priority: contact, stated orientation, the wrist's limits, comfort; what the limits
//! take from the orientation is reported.

use crate::body::arm::{ArmRig, WristLimits};
use crate::body::signer::Shoulder;
use crate::motion::arm::{ArmAngles, ArmHint, ArmPose, orient};
use crate::motion::easing::{slerp, smoothstep};
use crate::motion::fabrik::{Options as FabrikOptions, Pole};
use crate::motion::reach::reach;
use crate::motion::rotation::angle_between;
use crate::motion::two_bone;
use crate::phonology::Direction;
use glam::{DQuat, DVec3};

/// Where a hand should be at one frame, model space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandTarget {
    /// Where the contact point should be, metres.
    pub point: DVec3,
    /// The hand's rotation.
    pub rotation: DQuat,
    /// The contact point in the hand's own axes, from the wrist, metres.
    pub offset: DVec3,
    /// Where the clavicle starts, and how the trunk below it is turned.
    pub clavicle: DVec3,
    /// Rotation of the clavicle's parent.
    pub trunk: DQuat,
    /// How the description moves the shoulder.
    pub raised: Shoulder,
    /// How far the contact point was moved so that the hand stays out of the body, metres.
    pub aside_m: f64,
}

/// An arm at one frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmFrame {
    /// The clavicle's local rotation.
    pub clavicle: DQuat,
    /// Rotations of the arm's joints.
    pub arm: ArmPose,
    /// Model space, metres.
    pub shoulder: DVec3,
    /// Model space, metres.
    pub elbow: DVec3,
    /// Model space, metres.
    pub wrist: DVec3,
    /// From the contact point to its target, metres.
    pub residual_m: f64,
    /// How far the contact point was moved beforehand so that the hand stays out of the body, metres.
    pub aside_m: f64,
    /// How far the hand is turned away from the rotation asked for, radians.
    pub tilt: f64,
    /// What the rotation asked for would take, before the limits; radians.
    pub wanted: ArmAngles,
}

/// What the arm may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachOptions {
    /// Limits of the wrist; `None` in the paper's mode, which has none.
    pub limits: Option<WristLimits>,
    /// Whether the clavicle helps with far targets (the paper's chain starts at the shoulder).
    pub clavicle: bool,
    /// Frames between the knots at which the swivel is chosen.
    pub knot_every: usize,
    /// The description leaves the hand's rotation open: the hand follows the forearm.
    pub free_hand: bool,
}

/// Beyond this share of the arm's length the clavicle helps.
const HELP_FROM: f64 = 0.95;
/// The clavicle turns at most this far, radians.
const CLAVICLE_MOST: f64 = 0.40;
/// Swivels tried at each knot, degrees from hanging, outwards positive.
const SWIVELS: std::ops::RangeInclusive<i32> = -3..=12;
const SWIVEL_STEP: f64 = 10.0;

/// How often a hand is turned back within the wrist's limits, at most.
const LIMIT_ROUNDS: usize = 12;

/// Solves an arm over consecutive frames.
///
/// Returns one frame a target. Nothing here fails: what cannot be reached leaves a residual.
pub fn follow(
    arm: &ArmRig,
    clavicle_to_shoulder: DVec3,
    targets: &[HandTarget],
    options: &ReachOptions,
) -> Vec<ArmFrame> {
    let chain = Chain { arm, clavicle_to_shoulder, options };
    let swivels = chain.swivels(targets);
    let mut hint = None;
    let mut frames = Vec::with_capacity(targets.len());
    for (target, swivel) in targets.iter().zip(swivels) {
        let frame = chain.solve(target, swivel, hint);
        hint = Some(frame.arm.hint());
        frames.push(frame);
    }
    frames
}

/// The rotation of a hand whose description leaves it open: in line with a comfortable forearm.
///
/// `point` is where the contact point should be, `offset` where it is in the hand, from the wrist; metres. `fingers`
/// or `palm` may be given; the free part is the one that strains the wrist least.
pub fn natural_rotation(
    arm: &ArmRig,
    shoulder: DVec3,
    point: DVec3,
    offset: DVec3,
    fingers: Option<DVec3>,
    palm: Option<DVec3>,
) -> DQuat {
    let trunk = DQuat::IDENTITY;
    let place = |fingers: DVec3, palm: DVec3| arm.hand_rotation(fingers, palm);
    let candidates: Vec<DQuat> = match (fingers, palm) {
        (Some(f), Some(p)) => place(f, p).into_iter().collect(),
        (Some(f), None) => around(f).filter_map(|p| place(f, p)).collect(),
        (None, Some(p)) => around(p).filter_map(|f| place(f, p)).collect(),
        (None, None) => {
            let mut rotation = trunk;
            for _ in 0..8 {
                let wrist = point - rotation * offset;
                let elbow = elbow_at(arm, shoulder, wrist, natural_swivel());
                let solved = orient(&arm.rest, trunk, [shoulder, elbow, wrist], rotation, None);
                rotation = (trunk * solved.upper * solved.fore).normalize();
            }
            return rotation;
        }
    };
    let strain = |rotation: &DQuat| strain(arm, shoulder, point, offset, *rotation);
    candidates
        .into_iter()
        .min_by(|a, b| strain(a).total_cmp(&strain(b)))
        .unwrap_or_else(|| DQuat::from_rotation_arc(arm.rest_fingers(), DVec3::Z))
}

/// The rotation of a hand that touches a skin: the fingers come from outside, the wrist strains least and stays out of
/// the trunk. `outward` is the skin's normal; the rest as in [`natural_rotation`].
pub fn from_outside(arm: &ArmRig, shoulder: DVec3, point: DVec3, offset: DVec3, outward: DVec3) -> DQuat {
    let cost = |rotation: &DQuat| {
        let along = *rotation * offset.normalize_or(arm.rest_fingers());
        let slant = (along.dot(outward) + 0.45).max(0.0);
        let wrist = point - *rotation * offset;
        let elbow = elbow_at(arm, shoulder, wrist, natural_swivel());
        let inside = trunk_depth(wrist, shoulder) + trunk_depth((elbow + wrist) / 2.0, shoulder);
        strain(arm, shoulder, point, offset, *rotation) + 3.0 * slant * slant + 40.0 * inside
    };
    let candidates = Direction::all().flat_map(|fingers| {
        let fingers = fingers.vector();
        around(fingers).filter_map(move |palm| arm.hand_rotation(fingers, palm))
    });
    candidates
        .min_by(|a, b| cost(a).total_cmp(&cost(b)))
        .unwrap_or_else(|| natural_rotation(arm, shoulder, point, offset, None, None))
}

/// How much a hand's rotation strains the wrist where the elbow hangs naturally; 0 is the middle of every range.
pub fn strain(arm: &ArmRig, shoulder: DVec3, point: DVec3, offset: DVec3, rotation: DQuat) -> f64 {
    let wrist = point - rotation * offset;
    let elbow = elbow_at(arm, shoulder, wrist, natural_swivel());
    let a = orient(&arm.rest, DQuat::IDENTITY, [shoulder, elbow, wrist], rotation, None).angles;
    WristLimits::ANATOMICAL.scaled(0.6).excess(&a) + 0.05 * (a.twist.powi(2) + a.flexion.powi(2) + a.radial.powi(2))
}

/// Sixteen directions around an axis.
fn around(axis: DVec3) -> impl Iterator<Item = DVec3> {
    let axis = axis.normalize_or(DVec3::Z);
    let first = axis.any_orthonormal_vector();
    (0..16).map(move |i| DQuat::from_axis_angle(axis, f64::from(i) * std::f64::consts::TAU / 16.0) * first)
}

fn natural_swivel() -> f64 {
    22f64.to_radians()
}

/// The direction from which swivels are measured: down, and a little back for hands that hang.
fn hanging() -> DVec3 {
    DVec3::new(0.0, -1.0, -0.35)
}

fn elbow_at(arm: &ArmRig, shoulder: DVec3, wrist: DVec3, swivel: f64) -> DVec3 {
    two_bone::solve(shoulder, wrist, arm.upper_m, arm.fore_m, swivel * arm.side.sign(), hanging()).elbow
}

struct Chain<'a> {
    arm: &'a ArmRig,
    clavicle_to_shoulder: DVec3,
    options: &'a ReachOptions,
}

impl Chain<'_> {
    /// The clavicle's local rotation, and where the shoulder then is.
    fn shoulder(&self, target: &HandTarget, wrist: DVec3) -> (DQuat, DVec3) {
        let raised = target.raised.rotation(self.arm.side);
        let at = |local: DQuat| target.clavicle + target.trunk * (local * self.clavicle_to_shoulder);
        let shoulder = at(raised);
        let gap = wrist - shoulder;
        // An arm lifted above the shoulder lifts the shoulder with it (the scapula's share).
        let lift = (gap.y / self.arm.length_m()).clamp(0.0, 0.9) * 0.28;
        let excess = gap.length() - HELP_FROM * self.arm.length_m();
        let lever = self.clavicle_to_shoulder;
        let arm_length = lever.length();
        if !self.options.clavicle || (excess <= 0.0 && lift <= 0.0) || arm_length < 1e-6 {
            return (raised, shoulder);
        }
        let lifted = DQuat::from_rotation_z(lift * self.arm.side.sign()) * raised;
        if excess <= 0.0 {
            return (lifted, at(lifted));
        }
        let toward = target.trunk.inverse() * gap;
        let Some(axis) = (lifted * lever).cross(toward).try_normalize() else { return (lifted, at(lifted)) };
        let angle = (excess / arm_length * 1.3).min(CLAVICLE_MOST);
        let turned = (DQuat::from_axis_angle(axis, angle) * lifted).normalize();
        (turned, at(turned))
    }

    /// Swivels for every frame.
    fn swivels(&self, targets: &[HandTarget]) -> Vec<f64> {
        let knots = knots(targets.len(), self.options.knot_every);
        let costs: Vec<Vec<f64>> = knots.iter().map(|&i| self.costs(&targets[i])).collect();
        let chosen = least_path(&costs);
        let mut swivels = Vec::with_capacity(targets.len());
        for (a, pair) in knots.windows(2).enumerate() {
            let (from, to) = (swivel_of(chosen[a]), swivel_of(chosen[a + 1]));
            let length = (pair[1] - pair[0]) as f64;
            swivels.extend((pair[0]..pair[1]).map(|i| {
                let w = (i - pair[0]) as f64 / length;
                from + (to - from) * smoothstep(w)
            }));
        }
        swivels.extend(chosen.last().map(|c| swivel_of(*c)));
        swivels
    }

    /// What each swivel costs at a target.
    fn costs(&self, target: &HandTarget) -> Vec<f64> {
        SWIVELS
            .map(|step| {
                let swivel = f64::from(step) * SWIVEL_STEP.to_radians();
                let mut rotation = target.rotation;
                for _ in 0..if self.options.free_hand { 3 } else { 0 } {
                    let wrist = target.point - rotation * target.offset;
                    let (clavicle, shoulder) = self.shoulder(target, wrist);
                    let elbow = elbow_at(self.arm, shoulder, wrist, swivel);
                    let parent = target.trunk * clavicle;
                    let solved = orient(&self.arm.rest, parent, [shoulder, elbow, wrist], rotation, None);
                    rotation = parent * solved.upper * solved.fore;
                }
                let wrist = target.point - rotation * target.offset;
                let (clavicle, shoulder) = self.shoulder(target, wrist);
                let parent = target.trunk * clavicle;
                let elbow = elbow_at(self.arm, shoulder, wrist, swivel);
                let solved = orient(&self.arm.rest, parent, [shoulder, elbow, wrist], rotation, None);
                let a = &solved.angles;
                let hard = WristLimits::ANATOMICAL.excess(a);
                let soft = WristLimits::ANATOMICAL.scaled(0.65).excess(a);
                let inside = trunk_depth(elbow, shoulder) + 0.7 * trunk_depth((elbow + wrist) / 2.0, shoulder);
                let raised = ((elbow.y - shoulder.y + 0.03) / 0.1).max(0.0);
                let hang = (swivel - natural_swivel()) / 60f64.to_radians();
                60.0 * hard + 12.0 * soft + 400.0 * inside + 0.8 * raised * raised + hang * hang
            })
            .collect()
    }

    fn solve(&self, target: &HandTarget, swivel: f64, hint: Option<ArmHint>) -> ArmFrame {
        let mut rotation = target.rotation;
        let mut frame = self.place(target, rotation, swivel, hint);
        if self.options.free_hand {
            // The hand in line with the forearm, and the forearm where that hand needs it: they settle together.
            for _ in 0..12 {
                let along = frame.fore();
                let turned = angle_between(along, rotation);
                rotation = along.normalize();
                frame = self.place(target, rotation, swivel, hint);
                if turned < 1e-4 {
                    break;
                }
            }
        }
        let wanted = frame.arm.angles;
        if let Some(limits) = self.options.limits {
            let clamped = |fore: DQuat, angles: &ArmAngles| {
                let (twist, flexion, radial) = limits.clamp(angles);
                (fore * self.arm.rest.hand(twist, flexion, radial)).normalize()
            };
            // The hand is turned back within the wrist's limits about the contact point, and the forearm goes where that hand
            // needs it: they settle together. It is turned back from what is asked for every time, or it would drift.
            for round in 0..LIMIT_ROUNDS {
                let fore = frame.fore();
                let asked = match self.options.free_hand {
                    true => frame.arm.angles,
                    false => self.arm.rest.angles(fore.conjugate() * target.rotation),
                };
                if limits.excess(&frame.arm.angles) < 1e-10 && limits.excess(&asked) < 1e-10 {
                    break;
                }
                let within = clamped(fore, &asked);
                let turned = angle_between(within, rotation);
                // A hand that swings to and fro between two turns meets in the middle.
                rotation = if round < LIMIT_ROUNDS / 3 { within } else { slerp(rotation, within, 0.5) };
                frame = self.place(target, rotation, swivel, hint);
                if turned < 1e-5 {
                    break;
                }
            }
            if limits.excess(&frame.arm.angles) >= 1e-10 {
                // Where they do not settle the limits win, and the contact point is missed by what is left.
                rotation = clamped(frame.fore(), &frame.arm.angles);
                let bones = [frame.shoulder, frame.elbow, frame.wrist];
                frame.arm = orient(&self.arm.rest, frame.parent, bones, rotation, hint);
            }
        }
        let reached = frame.wrist + rotation * target.offset;
        ArmFrame {
            clavicle: frame.clavicle,
            arm: frame.arm,
            shoulder: frame.shoulder,
            elbow: frame.elbow,
            wrist: frame.wrist,
            residual_m: reached.distance(target.point),
            aside_m: target.aside_m,
            tilt: match self.options.free_hand {
                true => 0.0,
                false => angle_between(rotation, target.rotation),
            },
            wanted,
        }
    }

    fn place(&self, target: &HandTarget, rotation: DQuat, swivel: f64, hint: Option<ArmHint>) -> Placed {
        let goal = target.point - rotation * target.offset;
        let (clavicle, shoulder) = self.shoulder(target, goal);
        let parent = (target.trunk * clavicle).normalize();
        // FABRIK keeps the plane that it starts in: the elbow is bent to the chosen swivel first.
        let guess = elbow_at(self.arm, shoulder, goal, swivel);
        let toward = (goal - guess).normalize_or(DVec3::Z);
        let start = [shoulder, guess, guess + toward * self.arm.fore_m];
        let options =
            FabrikOptions { tolerance_m: 1e-5, pole: Pole::WhenStraight(guess - shoulder), ..FabrikOptions::default() };
        let solution = reach(start, goal, &options);
        let [shoulder, elbow, wrist] = solution.joints;
        // The forearm turns less than half a turn to either side, so its turn is read from the middle, not from the
        // frame before: a hint that has run on past half a turn would never come back within the limits.
        let hint = hint.map(|h| ArmHint { twist: 0.0, ..h });
        let arm = orient(&self.arm.rest, parent, [shoulder, elbow, wrist], rotation, hint);
        Placed { clavicle, parent, arm, shoulder, elbow, wrist }
    }
}

struct Placed {
    clavicle: DQuat,
    parent: DQuat,
    arm: ArmPose,
    shoulder: DVec3,
    elbow: DVec3,
    wrist: DVec3,
}

impl Placed {
    /// The forearm's rotation, model space.
    fn fore(&self) -> DQuat {
        self.parent * self.arm.upper * self.arm.fore
    }
}

fn swivel_of(candidate: usize) -> f64 {
    f64::from(SWIVELS.start() + candidate as i32) * SWIVEL_STEP.to_radians()
}

/// Frames at which the swivel is chosen: the first, the last, and evenly between.
fn knots(frames: usize, every: usize) -> Vec<usize> {
    if frames < 2 {
        return (0..frames).collect();
    }
    let last = frames - 1;
    let parts = last.div_ceil(every.max(1));
    (0..=parts).map(|i| i * last / parts).collect()
}

/// The cheapest way through the knots: Viterbi with a price on turning the elbow.
fn least_path(costs: &[Vec<f64>]) -> Vec<usize> {
    let Some(first) = costs.first() else { return Vec::new() };
    let mut reached = first.clone();
    let mut back: Vec<Vec<usize>> = Vec::with_capacity(costs.len());
    for row in &costs[1..] {
        let mut from = Vec::with_capacity(row.len());
        let mut next = Vec::with_capacity(row.len());
        for (j, cost) in row.iter().enumerate() {
            let price = |i: usize| reached[i] + 0.6 * (i as f64 - j as f64).powi(2);
            let best = (0..reached.len()).min_by(|a, b| price(*a).total_cmp(&price(*b))).unwrap_or(0);
            next.push(price(best) + cost);
            from.push(best);
        }
        back.push(from);
        reached = next;
    }
    let mut at = (0..reached.len()).min_by(|a, b| reached[*a].total_cmp(&reached[*b])).unwrap_or(0);
    let mut path = vec![at];
    for from in back.iter().rev() {
        at = from[at];
        path.push(at);
    }
    path.reverse();
    path
}

/// How deep a point is in the trunk below the shoulders, metres: an upright elliptic cylinder about the spine.
fn trunk_depth(point: DVec3, shoulder: DVec3) -> f64 {
    if point.y > shoulder.y + 0.05 {
        return 0.0;
    }
    // The waist and the thickness of an upper arm, against the shoulders.
    let (half_width, half_depth) = (shoulder.x.abs() - 0.005, 0.145);
    let z = point.z - (shoulder.z - 0.01);
    let r = ((point.x / half_width).powi(2) + (z / half_depth).powi(2)).sqrt();
    ((1.0 - r) * half_depth).max(0.0)
}
