//! From a clip to the BVH file that Blender, three.js and retargeters open.
//!
//! Centimetres, Y up, facing +Z. The root has the offset 0 0 0 and its place in the six channels of every row, because
//! three.js adds an offset to the channels and Blender does not. Joints keep Mixamo's names.

use super::data::{Axis, Bvh, Channel, Joint};
use super::euler::zxy;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::rotation::unit;
use crate::motion::skeleton::{JointId, Skeleton};
use crate::time::Seconds;
use glam::DVec3;

const CM_PER_METRE: f64 = 100.0;

/// What becomes of twist joints that are leaves (`LeftForeArmTwist1`), which hang beside the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TwistLeaves {
    /// They are left out. The forearm's twist is the hand's joint's too, so no bone moves otherwise; and Blender, which
    /// lets a bone end at the mean of its children, lets the forearm end at the wrist.
    #[default]
    Omit,
    /// They are written, for a mesh whose skin hangs on them.
    Keep,
}

/// What can be chosen about a written file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The forearm's twist joints.
    pub twist_leaves: TwistLeaves,
}

/// A clip as the text of a BVH file: [`print`](super::print()) of [`from_clip`].
///
/// # Errors
/// Those of [`from_clip`].
///
/// ```
/// # use chereme::{format::bvh, motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton}, time::Fps};
/// # use std::sync::Arc;
/// let rig = Arc::new(Skeleton::from_json(chereme::avatar::SKELETON).unwrap());
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(vec![]), vec![rest.clone(), rest]).unwrap();
/// let text = bvh::write(&clip, &bvh::Options::default()).unwrap();
/// assert!(text.starts_with("HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 0\n\tCHANNELS 6 Xposition"));
/// assert!(text.contains("Frames: 2\nFrame Time: 0.01666667\n0 91.929200 1.679700 0 0 0"));
/// ```
pub fn write(clip: &Clip, options: &Options) -> Result<String, Error> {
    from_clip(clip, options).map(|bvh| super::print(&bvh))
}

/// A clip as a BVH file's data, in centimetres and degrees, rotations in the order `Zrotation Xrotation Yrotation`.
///
/// Joints come depth first, and among siblings in the skeleton's order. Angles are chosen near those of the frame before,
/// so that curves do not jump; they may go beyond 180°. Face morphs have no place in the format and are left out.
///
/// # Errors
/// A name that the format cannot hold (braces, line ends, spaces around it), a place or rotation that is not finite.
pub fn from_clip(clip: &Clip, options: &Options) -> Result<Bvh, Error> {
    let rig = clip.skeleton();
    let order = order(rig, options.twist_leaves);
    let joints = joints(rig, &order);
    let mut values = Vec::with_capacity(clip.frames().len() * (3 * order.len() + 3));
    let mut before = vec![[0.0; 3]; order.len()];
    for (at, frame) in clip.frames().iter().enumerate() {
        let fault = |what: &str| Error::new(format!("frame {at} has {what} that is not finite"));
        if !frame.pose.root_model.is_finite() {
            return Err(fault("a place of the root"));
        }
        values.extend((frame.pose.root_model * CM_PER_METRE).to_array());
        for (id, before) in order.iter().zip(&mut before) {
            let q = frame.pose.rotation(*id);
            if !q.is_finite() {
                return Err(fault(&format!("a rotation of {}", rig[*id].name)));
            }
            *before = zxy(unit(q), *before);
            values.extend(before.map(f64::to_degrees));
        }
    }
    Bvh::new(joints, Seconds(1.0 / clip.fps().get()), values)
}

/// The joints to write, depth first.
fn order(rig: &Skeleton, twist_leaves: TwistLeaves) -> Vec<JointId> {
    let mut children = vec![Vec::new(); rig.len()];
    for id in rig.ids() {
        if let Some(parent) = rig[id].parent {
            children[parent.index()].push(id);
        }
    }
    let omitted = |id: JointId| match twist_leaves {
        TwistLeaves::Keep => false,
        TwistLeaves::Omit => children[id.index()].is_empty() && is_twist(&rig[id].name),
    };
    let mut order = Vec::with_capacity(rig.len());
    let mut next = vec![JointId(0)];
    while let Some(id) = next.pop() {
        order.push(id);
        next.extend(children[id.index()].iter().rev().filter(|c| !omitted(**c)));
    }
    order
}

/// Whether a name is of the form `…Twist` or `…Twist2`.
fn is_twist(name: &str) -> bool {
    name.trim_end_matches(|c: char| c.is_ascii_digit()).ends_with("Twist")
}

fn joints(rig: &Skeleton, order: &[JointId]) -> Vec<Joint> {
    let mut written = vec![0; rig.len()];
    for (at, id) in order.iter().enumerate() {
        written[id.index()] = at;
    }
    let mut has_children = vec![false; rig.len()];
    order.iter().filter_map(|id| rig[*id].parent).for_each(|p| has_children[p.index()] = true);
    let rotations = [Axis::Z, Axis::X, Axis::Y].map(Channel::Rotation);
    let positions = [Axis::X, Axis::Y, Axis::Z].map(Channel::Position);
    let joint = |id: &JointId| {
        let here = &rig[*id];
        let (offset, channels) = match here.parent {
            None => (DVec3::ZERO, [positions, rotations].concat()),
            Some(_) => (rig.offset(*id) * CM_PER_METRE, rotations.to_vec()),
        };
        let tail = (here.tail_model - here.rest_model) * CM_PER_METRE;
        Joint {
            name: here.name.clone(),
            parent: here.parent.map(|p| written[p.index()]),
            offset,
            channels,
            end_sites: if has_children[id.index()] { vec![] } else { vec![tail] },
        }
    };
    order.iter().map(joint).collect()
}
