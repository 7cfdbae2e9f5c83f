//! An eased way between two frames: every joint on its short arc, root and face on a line.

use crate::motion::clip::Frame;
use crate::motion::easing::Easing;
use crate::motion::pose::LocalPose;
use crate::motion::short_arc::ShortArc;

/// A way, prepared for many samples.
pub(in crate::synthesis) struct Way<'f> {
    from: &'f Frame,
    to: &'f Frame,
    arcs: Vec<ShortArc>,
    easing: Easing,
}

impl<'f> Way<'f> {
    pub fn new(from: &'f Frame, to: &'f Frame, easing: Easing) -> Way<'f> {
        let pairs = from.pose.rotations.iter().zip(&to.pose.rotations);
        Way { from, to, arcs: pairs.map(|(p, q)| ShortArc::new(*p, *q)).collect(), easing }
    }

    /// The frame at a share of the way's time.
    pub fn at(&self, share: f64) -> Frame {
        let weight = self.easing.weight(share);
        let (a, b) = (&self.from.pose, &self.to.pose);
        Frame {
            pose: LocalPose {
                root_model: a.root_model.lerp(b.root_model, weight),
                rotations: self.arcs.iter().map(|arc| arc.eased(self.easing, weight)).collect(),
            },
            weights: self.from.weights.iter().zip(&self.to.weights).map(|(p, q)| p + (q - p) * weight as f32).collect(),
        }
    }
}
