//! Constructed takes of a hand whose motion is known, for the analyses of captured motion.

use chereme::motion::clip::{Clip, Frame};
use chereme::motion::easing::Easing;
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::{Joint, JointId, Skeleton};
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// When a channel moves, seconds, and how.
#[derive(Debug, Clone, Copy)]
pub struct When {
    pub start: f64,
    pub end: f64,
    pub easing: Easing,
}

impl When {
    pub fn new(start: f64, end: f64, easing: Easing) -> When {
        When { start, end, easing }
    }

    fn weight(self, t: f64) -> f64 {
        self.easing.weight((t - self.start) / (self.end - self.start))
    }
}

/// A right hand alone, as the sensor records it: the palm is the root, three joints a finger.
fn hand() -> Arc<Skeleton> {
    let mut joints =
        vec![Joint { name: "RightHand".into(), parent: None, rest_model: DVec3::ZERO, tail_model: DVec3::ZERO }];
    for (i, finger) in ["Thumb", "Index", "Middle", "Ring", "Pinky"].into_iter().enumerate() {
        let side = DVec3::X * (0.03 - 0.015 * i as f64);
        for part in 1u16..=3 {
            let parent = if part == 1 { 0 } else { joints.len() as u16 - 1 };
            let at = |n: u16| side - DVec3::Z * (0.04 + 0.03 * f64::from(n));
            let name = format!("RightHand{finger}{part}");
            joints.push(Joint { name, parent: Some(JointId(parent)), rest_model: at(part), tail_model: at(part + 1) });
        }
    }
    Arc::new(Skeleton::new(joints).unwrap())
}

/// A take of 2.4 s at a frame rate: the wrist goes 30 cm, the palm turns by 80°, the fingers bend by 60° at each joint.
pub fn take(fps: f64, wrist: When, palm: When, fingers: When) -> Arc<Clip> {
    let skeleton = hand();
    let frame = |i: usize| {
        let t = i as f64 / fps;
        let mut pose = LocalPose::rest(&skeleton);
        pose.root_model = DVec3::new(0.1, 0.2, 0.3) + DVec3::new(0.2, 0.2, 0.1) * wrist.weight(t);
        for joint in skeleton.ids() {
            pose.set(joint, DQuat::from_rotation_x(-1.05 * fingers.weight(t)));
        }
        pose.set(JointId(0), DQuat::from_rotation_z(1.4 * palm.weight(t)));
        Frame { pose, weights: vec![] }
    };
    let frames = (0..(2.4 * fps) as usize).map(frame).collect();
    Arc::new(Clip::new(Arc::clone(&skeleton), Fps::new(fps).unwrap(), Arc::new(vec![]), frames).unwrap())
}
