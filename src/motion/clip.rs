//! Clips: poses and face morph weights at a steady frame rate.

use super::pose::LocalPose;
use super::skeleton::Skeleton;
use crate::time::{Fps, FrameIndex, Seconds};
use std::sync::Arc;

/// A motion of a skeleton and of named face morphs.
///
/// Invariant: at least one frame; each frame has one rotation a joint, and one weight a morph.
#[derive(Debug, Clone)]
pub struct Clip {
    skeleton: Arc<Skeleton>,
    fps: Fps,
    morphs: Arc<Vec<String>>,
    frames: Vec<Frame>,
}

/// One frame: joints and face.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The joints.
    pub pose: LocalPose,
    /// One weight a morph, in the clip's order, 0 (neutral) to 1.
    pub weights: Vec<f32>,
}

impl Clip {
    /// A clip of frames, or `None` where a frame's arrays do not fit the skeleton and the morphs, or there is no frame.
    pub fn new(skeleton: Arc<Skeleton>, fps: Fps, morphs: Arc<Vec<String>>, frames: Vec<Frame>) -> Option<Clip> {
        let fits = |f: &Frame| f.pose.rotations.len() == skeleton.len() && f.weights.len() == morphs.len();
        let whole = !frames.is_empty() && frames.iter().all(fits);
        whole.then_some(Clip { skeleton, fps, morphs, frames })
    }

    /// The rig that moves.
    pub fn skeleton(&self) -> &Arc<Skeleton> {
        &self.skeleton
    }

    /// Frames per second.
    pub fn fps(&self) -> Fps {
        self.fps
    }

    /// Names of the face morphs, in the order of each frame's weights.
    pub fn morphs(&self) -> &Arc<Vec<String>> {
        &self.morphs
    }

    /// The frames, in order.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// From the first frame's instant to the last one's.
    pub fn duration(&self) -> Seconds {
        self.fps.time_of(FrameIndex(self.frames.len() - 1))
    }

    /// The pose at any instant: rotations by slerp along the short arc between neighbouring frames,
    /// everything else linearly; before the start and after the end the clip stands still.
    pub fn sample(&self, time: Seconds) -> Frame {
        let last = self.frames.len() - 1;
        let at = (time.0 * self.fps.get()).clamp(0.0, last as f64);
        let i = at.floor() as usize;
        let w = at - i as f64;
        if w < 1e-9 || i == last {
            return self.frames[i].clone();
        }
        let (a, b) = (&self.frames[i], &self.frames[i + 1]);
        let rotations =
            a.pose.rotations.iter().zip(&b.pose.rotations).map(|(p, q)| super::easing::slerp(*p, *q, w)).collect();
        Frame {
            pose: LocalPose { root_model: a.pose.root_model.lerp(b.pose.root_model, w), rotations },
            weights: a.weights.iter().zip(&b.weights).map(|(p, q)| p + (q - p) * w as f32).collect(),
        }
    }
}
