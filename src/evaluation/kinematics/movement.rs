//! One thing that moves in one take, and the ways that interpolation could take between two of its poses.

use super::hand::hands;
use crate::motion::clip::Clip;
use crate::motion::easing::slerp;
use crate::motion::point::Point;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{direction, shortest_arc};
use crate::motion::skeleton::JointId;
use crate::time::Fps;
use glam::{DQuat, DVec3};
use std::fmt;
use std::sync::Arc;

/// How finely a way is sampled: between samples it is straight, 2e-5 of a right angle's radius beside its arc.
const SAMPLES: usize = 129;

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Fingertips seen from the wrist; all finger joints are interpolated.
    Fingers,
    /// The wrist seen from the chest or the shoulder; the joints of the arm are interpolated.
    Reaching,
    /// The hand of a recording that has no arm; its place is interpolated, in a straight line.
    Hand,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Kind::Fingers => "fingers",
            Kind::Reaching => "reaching",
            Kind::Hand => "hand",
        })
    }
}

/// One thing that moves in one take.
///
/// Invariant: at least one frame, each with the same number of points, at least one.
#[derive(Debug, Clone)]
pub struct Movement {
    take: String,
    kind: Kind,
    fps: Fps,
    frames: Vec<Vec<DVec3>>,
    poses: Poses,
}

/// What is interpolated.
#[derive(Debug, Clone)]
enum Poses {
    /// The joints of a clip.
    Joints { clip: Arc<Clip>, points: Vec<Point>, origin: JointId },
    /// The directions of upper arm and forearm: shoulder, elbow and wrist of each frame.
    Arm(Vec<[DVec3; 3]>),
    /// The points themselves.
    Straight,
}

impl Movement {
    /// All that moves in a clip: fingers, arms, and hands that have no arm. `take` is its name; what comes from one take is one cluster.
    pub fn of_clip(take: &str, clip: &Arc<Clip>) -> Vec<Movement> {
        let mut all = Vec::new();
        for hand in hands(clip) {
            if hand.tips.len() == 5 {
                all.push(Movement::of_points(take, Kind::Fingers, clip, hand.tips.clone(), hand.wrist));
            }
            let wrist = Point::of_joint(clip.skeleton(), hand.wrist);
            match hand.chest {
                Some(chest) => all.push(Movement::of_points(take, Kind::Reaching, clip, vec![wrist], chest)),
                None if clip.skeleton()[hand.wrist].parent.is_none() => {
                    let path = clip.frames().iter().map(|f| f.pose.root_model).collect();
                    all.extend(Movement::of_path(take, clip.fps(), path));
                }
                None => {}
            }
        }
        all
    }

    fn of_points(take: &str, kind: Kind, clip: &Arc<Clip>, points: Vec<Point>, origin: JointId) -> Movement {
        let frames = clip.frames().iter().map(|f| seen(clip, &f.pose, &points, origin)).collect();
        let poses = Poses::Joints { clip: Arc::clone(clip), points, origin };
        Movement { take: take.to_owned(), kind, fps: clip.fps(), frames, poses }
    }

    /// A path alone, as of a marker, in metres; between two places it is taken straight. `None` for no frame, or one that is not finite.
    ///
    /// ```
    /// use chereme::{evaluation::kinematics::Movement, time::Fps};
    /// use glam::DVec3;
    /// let movement = Movement::of_path("take", Fps::DEFAULT, vec![DVec3::ZERO, DVec3::Y, DVec3::X]).unwrap();
    /// assert_eq!(movement.way(0, 2).at(0.5), [DVec3::X * 0.5]);
    /// ```
    pub fn of_path(take: &str, fps: Fps, path: Vec<DVec3>) -> Option<Movement> {
        let sound = !path.is_empty() && path.iter().all(|p| p.is_finite());
        let frames = path.into_iter().map(|p| vec![p]).collect();
        sound.then(|| Movement { take: take.to_owned(), kind: Kind::Hand, fps, frames, poses: Poses::Straight })
    }

    /// An arm of three markers: shoulder, elbow and wrist of each frame, metres. The wrist is seen from the shoulder; between two poses
    /// both bones turn the short way. `None` for no frame, or one that is not finite.
    pub fn of_arm(take: &str, fps: Fps, arm: Vec<[DVec3; 3]>) -> Option<Movement> {
        let sound = !arm.is_empty() && arm.iter().flatten().all(|p| p.is_finite());
        let frames = arm.iter().map(|[shoulder, _, wrist]| vec![*wrist - *shoulder]).collect();
        let poses = Poses::Arm(arm);
        sound.then(|| Movement { take: take.to_owned(), kind: Kind::Reaching, fps, frames, poses })
    }

    /// The take's name.
    pub fn take(&self) -> &str {
        &self.take
    }

    /// What moves.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Frames a second.
    pub fn fps(&self) -> Fps {
        self.fps
    }

    /// Its points in each frame, metres.
    pub fn frames(&self) -> &[Vec<DVec3>] {
        &self.frames
    }

    /// The way that interpolation takes from the pose of one frame to that of another: each joint on its short arc.
    pub fn way(&self, from: usize, to: usize) -> Way {
        let samples = (0..SAMPLES).map(|i| self.between(from, to, i as f64 / (SAMPLES - 1) as f64)).collect();
        Way { samples }
    }

    fn between(&self, from: usize, to: usize, weight: f64) -> Vec<DVec3> {
        match &self.poses {
            Poses::Straight => {
                self.frames[from].iter().zip(&self.frames[to]).map(|(a, b)| a.lerp(*b, weight)).collect()
            }
            Poses::Arm(arm) => vec![arm_between(&arm[from], &arm[to], weight)],
            Poses::Joints { clip, points, origin } => {
                let (a, b) = (&clip.frames()[from].pose, &clip.frames()[to].pose);
                let mut pose = a.clone();
                for joint in clip.skeleton().ids() {
                    pose.set(joint, slerp(a.rotation(joint), b.rotation(joint), weight));
                }
                seen(clip, &pose, points, *origin)
            }
        }
    }
}

/// Points seen from a joint.
fn seen(clip: &Clip, pose: &LocalPose, points: &[Point], origin: JointId) -> Vec<DVec3> {
    let model = pose.to_model(clip.skeleton());
    let turn = model.rotation(origin).inverse();
    points.iter().map(|p| turn * (p.position(&model) - model.position(origin))).collect()
}

/// The wrist from the shoulder, between two poses of shoulder, elbow and wrist.
fn arm_between(a: &[DVec3; 3], b: &[DVec3; 3], weight: f64) -> DVec3 {
    bone(a[1] - a[0], b[1] - b[0], weight) + bone(a[2] - a[1], b[2] - b[1], weight)
}

/// A bone between two directions: it turns the short way, and its length (skin moves under markers) changes evenly.
fn bone(a: DVec3, b: DVec3, weight: f64) -> DVec3 {
    let (Some(from), Some(to)) = (direction(a), direction(b)) else { return a.lerp(b, weight) };
    let turn = shortest_arc(from, to, DVec3::Y);
    let length = a.length() + (b.length() - a.length()) * weight;
    slerp(DQuat::IDENTITY, turn, weight) * from * length
}

/// The way between two poses, without time: what all easings share.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    samples: Vec<Vec<DVec3>>,
}

impl Way {
    /// The points at a share of the way, from 0 to 1.
    pub fn at(&self, weight: f64) -> Vec<DVec3> {
        let last = self.samples.len() - 1;
        let at = weight.clamp(0.0, 1.0) * last as f64;
        let below = (at.floor() as usize).min(last.saturating_sub(1));
        let share = at - below as f64;
        self.samples[below].iter().zip(&self.samples[(below + 1).min(last)]).map(|(a, b)| a.lerp(*b, share)).collect()
    }

    /// All samples, from the first pose to the last.
    pub fn samples(&self) -> &[Vec<DVec3>] {
        &self.samples
    }
}
