//! How near a retargeted motion is, measured on both motions as they are.

use super::contacts::{Goals, tail};
use super::humanoid::Humanoid;
use super::inward::way_of;
use crate::body::signer::Signer;
use crate::motion::clip::Frame;
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::JointId;
use crate::time::{Fps, FrameIndex, Seconds};

/// A part of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// Spine, neck and head.
    Trunk,
    /// Clavicles, upper arms and forearms.
    Arms,
    /// From wrists to the middle knuckles.
    Hands,
    /// The finger joints.
    Fingers,
    /// From hips to toes.
    Legs,
}

impl Part {
    /// All parts.
    pub const ALL: [Part; 5] = [Part::Trunk, Part::Arms, Part::Hands, Part::Fingers, Part::Legs];

    /// The name for people.
    pub fn name(self) -> &'static str {
        match self {
            Part::Trunk => "trunk",
            Part::Arms => "arms",
            Part::Hands => "hands",
            Part::Fingers => "fingers",
            Part::Legs => "legs",
        }
    }

    fn of(name: &str) -> Part {
        let part = name.trim_start_matches("Left").trim_start_matches("Right");
        match part {
            "Hand" => Part::Hands,
            "Shoulder" | "Arm" | "ForeArm" => Part::Arms,
            "UpLeg" | "Leg" | "Foot" | "ToeBase" => Part::Legs,
            _ if part.starts_with("Hand") => Part::Fingers,
            _ => Part::Trunk,
        }
    }
}

/// How far the bones of a part look away from the source's.
#[derive(Debug, Clone, PartialEq)]
pub struct PartError {
    /// The part.
    pub part: Part,
    /// The mean angle over its bones and all frames, radians.
    pub mean: f64,
    /// The greatest angle, radians.
    pub worst: f64,
    /// Our joint at which that is.
    pub joint: String,
    /// When that is, from the clip's start.
    pub at: Seconds,
}

/// What retargeting could not keep.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Directions of bones, by part.
    pub directions: Vec<PartError>,
    /// The greatest distance of a fingertip from where it should be, metres; 0 where tips are not asked for.
    pub tips_m: f64,
    /// The mean of these distances, metres.
    pub tips_mean_m: f64,
    /// The greatest distance of a wrist from where it should be, metres.
    pub wrists_m: f64,
}

impl Report {
    /// The greatest angle of any bone, radians.
    pub fn worst(&self) -> f64 {
        self.directions.iter().map(|part| part.worst).fold(0.0, f64::max)
    }

    pub(super) fn measure(
        poses: &[LocalPose],
        frames: &[Frame],
        fps: Fps,
        humanoid: &Humanoid,
        signer: &Signer,
        goals: &[Goals],
        wrists_left: &[f64],
    ) -> Report {
        let mut sums: Vec<(Part, f64, usize, f64, JointId, usize)> = Vec::new();
        let (mut tips, mut wrists) = (Vec::new(), wrists_left.to_vec());
        for (i, (pose, frame)) in poses.iter().zip(frames).enumerate() {
            let (ours, theirs) = (pose.to_model(&signer.skeleton), frame.pose.to_model(humanoid.skeleton()));
            for bone in humanoid.bones.iter().filter(|bone| bone.directed) {
                let wanted = humanoid.turn * way_of(humanoid.skeleton(), bone.theirs, bone.their_end, &theirs);
                let is = way_of(&signer.skeleton, bone.ours, bone.our_end, &ours);
                if wanted.length() < 1e-9 {
                    continue;
                }
                let off = is.angle_between(wanted);
                let part = Part::of(&signer.skeleton[bone.ours].name);
                match sums.iter_mut().find(|sum| sum.0 == part) {
                    Some(sum) => {
                        (sum.1, sum.2) = (sum.1 + off, sum.2 + 1);
                        if off > sum.3 {
                            (sum.3, sum.4, sum.5) = (off, bone.ours, i);
                        }
                    }
                    None => sums.push((part, off, 1, off, bone.ours, i)),
                }
            }
            if let Some(goals) = goals.get(i) {
                let root = pose.root_model;
                tips.extend(goals.tips.iter().map(|(last, goal)| (tail(signer, *last, &ours) - root).distance(*goal)));
                wrists.extend(goals.wrists.iter().map(|(hand, goal)| (ours.position(*hand) - root).distance(*goal)));
            }
        }
        sums.sort_by_key(|sum| sum.0);
        let directions = sums.into_iter().map(|(part, sum, n, worst, joint, frame)| PartError {
            part,
            mean: sum / n as f64,
            worst,
            joint: signer.skeleton[joint].name.clone(),
            at: fps.time_of(FrameIndex(frame)),
        });
        let greatest = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
        let tips_mean_m = tips.iter().sum::<f64>() / tips.len().max(1) as f64;
        Report { directions: directions.collect(), tips_m: greatest(&tips), tips_mean_m, wrists_m: greatest(&wrists) }
    }
}
