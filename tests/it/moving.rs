//! Random smooth motion on the avatar's rig, and measuring wrists and hands in clips and tracks.

use crate::signing::world;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::rotation::{angle_between, continuous, from_vector};
use chereme::motion::skeleton::JointId;
use chereme::phonology::Side;
use chereme::synthesis::edit::track::Phases;
use chereme::time::{Fps, Seconds};
use chereme::track::Track;
use glam::{DQuat, DVec3};
use proptest::prelude::*;

/// Numbers from −1 to 1 that follow from a seed.
struct Dice(u64);

impl Dice {
    fn throw(&mut self) -> f64 {
        // SplitMix64 (Steele, Lea and Flood 2014).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.throw(), self.throw(), self.throw())
    }
}

/// A clip of 8 to 20 frames in which every joint, the root and the face wave slowly about a bent-armed pose.
pub fn any_clip() -> impl Strategy<Value = Clip> {
    (any::<u64>(), 8usize..=20).prop_map(|(seed, frames)| waving(seed, frames))
}

fn waving(seed: u64, count: usize) -> Clip {
    let signer = &world().signer;
    let skeleton = &signer.skeleton;
    let mut dice = Dice(seed);
    let waves: Vec<(DVec3, f64, f64)> =
        skeleton.ids().map(|_| (dice.vector() * 0.35, dice.throw() * 0.2, dice.throw() * 3.0)).collect();
    let (sway, faces) = (dice.vector() * 0.1, signer.morphs.iter().map(|_| dice.throw()).collect::<Vec<_>>());
    let shape = world().grammar.handshapes.find("claw", None).or_else(|_| world().grammar.handshapes.find("5", None));
    let mut start = signer.neutral(&shape.unwrap().angles());
    for side in [Side::Left, Side::Right] {
        let arm = signer.arm(side);
        start.set(arm.fore, DQuat::from_axis_angle(arm.rest.hinge(), 1.3));
    }
    let mut frames: Vec<Frame> = Vec::new();
    for i in 0..count {
        let mut pose = start.clone();
        for joint in skeleton.ids() {
            let (size, rate, phase) = waves[joint.index()];
            let turn = from_vector(size * (rate * i as f64 + phase).sin());
            let before = frames.last().map_or(pose.rotation(joint), |f| f.pose.rotation(joint));
            pose.set(joint, continuous(before, (pose.rotation(joint) * turn).normalize()));
        }
        pose.root_model += sway * (0.2 * i as f64).sin();
        let weights = faces.iter().map(|f| (0.5 + 0.5 * (f + 0.1 * i as f64).sin()) as f32).collect();
        frames.push(Frame { pose, weights });
    }
    Clip::new(skeleton.clone(), Fps::DEFAULT, signer.morphs.clone(), frames).expect("a clip")
}

/// Expectations 12 and 13: unit quaternions, each on the side of the one before.
pub fn is_sound(clip: &Clip) -> bool {
    let unit = clip.frames().iter().flat_map(|f| &f.pose.rotations).all(|q| (q.length() - 1.0).abs() < 1e-6);
    let pairs = clip.frames().windows(2);
    unit && pairs
        .into_iter()
        .all(|w| w[0].pose.rotations.iter().zip(&w[1].pose.rotations).all(|(p, q)| p.dot(*q) >= 0.0))
}

/// Where a joint is in every frame, model space, metres.
pub fn path(clip: &Clip, joint: JointId) -> Vec<DVec3> {
    clip.frames().iter().map(|f| f.pose.to_model(clip.skeleton()).position(joint)).collect()
}

pub fn wrist_path(clip: &Clip, side: Side) -> Vec<DVec3> {
    path(clip, world().signer.arm(side).hand)
}

/// How a hand is turned in every frame, model space.
pub fn hand_turns(clip: &Clip, side: Side) -> Vec<DQuat> {
    let hand = world().signer.arm(side).hand;
    clip.frames().iter().map(|f| f.pose.to_model(clip.skeleton()).rotation(hand)).collect()
}

/// The greatest distance between places of the same number.
pub fn apart(a: &[DVec3], b: &[DVec3]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
}

/// The greatest angle between rotations of the same number.
pub fn turned(a: &[DQuat], b: &[DQuat]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(p, q)| angle_between(*p, *q)).fold(0.0, f64::max)
}

/// Whether two clips are one bit for bit in all joints but some, in the root and in the face.
pub fn same_but(a: &Clip, b: &Clip, joints: &[JointId]) -> bool {
    let same = |(f, g): (&Frame, &Frame)| {
        let others = world().signer.skeleton.ids().filter(|j| !joints.contains(j));
        f.weights == g.weights
            && f.pose.root_model == g.pose.root_model
            && others.into_iter().all(|j| f.pose.rotation(j) == g.pose.rotation(j))
    };
    a.frames().len() == b.frames().len() && a.frames().iter().zip(b.frames()).all(same)
}

/// From one instant to another.
pub type Stretch = (Seconds, Seconds);

/// How far two clips' wrists are apart, metres, and how differently their hands are turned, radians: the worst at the
/// same shares of a stretch of each.
pub fn stretches_apart((a, of_a): (&Clip, Stretch), (b, of_b): (&Clip, Stretch), side: Side) -> (f64, f64) {
    let signer = &world().signer;
    let mut worst = (0.0f64, 0.0f64);
    for i in 0..=40 {
        let share = f64::from(i) / 40.0;
        let [p, q] = [(a, of_a), (b, of_b)].map(|(clip, (start, end))| {
            let model = clip.sample(start + (end - start) * share).pose.to_model(&signer.skeleton);
            let hand = signer.arm(side).hand;
            (model.position(hand), model.rotation(hand))
        });
        worst = (worst.0.max(p.0.distance(q.0)), worst.1.max(angle_between(p.1, q.1)));
    }
    worst
}

/// The same over the strokes of two tracks.
pub fn strokes_apart(a: &Track, b: &Track, side: Side) -> (f64, f64) {
    let [p, q] = [a, b].map(|track| Phases::of(track).unwrap());
    stretches_apart((&a.clip, (p.stroke, p.stroke_end)), (&b.clip, (q.stroke, q.stroke_end)), side)
}
