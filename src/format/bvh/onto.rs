//! A motion in another file's own hierarchy: its offsets, its channels in their order, its unit.

use super::data::{Axis, Bvh, Channel};
use super::euler::{about, near, nearest};
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::rotation::unit;
use crate::time::Seconds;
use glam::{DMat3, DQuat, DVec3};

/// The rows of a clip for a file's joints: the clip's skeleton is that of [`to_clip`](super::to_clip) of the file.
///
/// Positions of joints below the root are their offsets. A joint with fewer than three rotation channels turns as far as these
/// let it; joints of further roots stay at rest.
///
/// # Errors
/// A clip of another skeleton; two rotation channels about one axis; a rotation that is not finite.
///
/// ```
/// use chereme::format::bvh;
/// let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 4 Yposition Yrotation Zrotation Xrotation\n End Site {\n OFFSET 0 10 0 } }\n\
///             MOTION\nFrames: 2\nFrame Time: 0.04\n95 10 20 30\n96 11 -21 31\n";
/// let file = bvh::read(text.as_bytes()).unwrap().bvh;
/// let clip = bvh::to_clip(&file, &bvh::ClipOptions::default()).unwrap().clip;
/// let again = bvh::onto(&file, &clip, 0.01).unwrap();
/// assert!(again.rows().flatten().zip(file.rows().flatten()).all(|(a, b)| (a - b).abs() < 1e-9));
/// ```
pub fn onto(file: &Bvh, clip: &Clip, metres_per_unit: f64) -> Result<Bvh, Error> {
    let (joints, rig) = (file.joints(), clip.skeleton());
    if joints.len() < rig.len() || joints.iter().zip(rig.joints()).any(|(a, b)| a.name != b.name) {
        return Err(Error::new("the motion is not one of the file's skeleton"));
    }
    let mut before = vec![[0.0; 3]; joints.len()];
    let mut values = Vec::with_capacity(file.channel_count() * clip.frames().len());
    for frame in clip.frames() {
        for (at, joint) in joints.iter().enumerate() {
            let place = if at == 0 { frame.pose.root_model / metres_per_unit } else { joint.offset };
            let q = frame.pose.rotations.get(at).copied().unwrap_or(DQuat::IDENTITY);
            if !q.is_finite() || !place.is_finite() {
                return Err(Error::new(format!("joint {} has a rotation or a place that is not finite", joint.name)));
            }
            let axes: Vec<Axis> = joint.channels.iter().filter_map(|c| rotation(*c)).collect();
            let angles = angles(unit(q), &axes, before[at]);
            before[at] = angles;
            let mut turns = angles.iter();
            for channel in &joint.channels {
                values.push(match channel {
                    Channel::Position(axis) => place.dot(axis.vector()),
                    Channel::Rotation(_) => turns.next().copied().unwrap_or(0.0).to_degrees(),
                });
            }
        }
    }
    Bvh::new(joints.to_vec(), Seconds(1.0 / clip.fps().get()), values)
}

fn rotation(channel: Channel) -> Option<Axis> {
    match channel {
        Channel::Rotation(axis) => Some(axis),
        Channel::Position(_) => None,
    }
}

/// Angles about up to three different axes whose product in this order is the rotation, or as near as so few axes come, nearest to those before.
fn angles(q: DQuat, axes: &[Axis], before: [f64; 3]) -> [f64; 3] {
    match *axes {
        [a, b, c] => three(q, [a, b, c].map(|axis| axis.vector()), before),
        // One axis, or two: each takes the twist that is left about it.
        _ => {
            let (mut left, mut out) = (q, [0.0; 3]);
            for (i, axis) in axes.iter().enumerate() {
                let v = axis.vector();
                let twist = 2.0 * DVec3::new(left.x, left.y, left.z).dot(v).atan2(left.w);
                out[i] = near(twist, before[i]);
                left = about(*axis, -twist) * left;
            }
            out
        }
    }
}

/// `q = R(a, x) · R(b, y) · R(c, z)` for three axes in any order (Tait–Bryan).
fn three(q: DQuat, [a, b, c]: [DVec3; 3], before: [f64; 3]) -> [f64; 3] {
    // Even orders (x y z, y z x, z x y) and odd ones differ in the sign of the middle sine.
    let sign = a.cross(b).dot(c);
    let m = DMat3::from_quat(q);
    let entry = |row: DVec3, column: DVec3| row.dot(m * column);
    let sine = (sign * entry(a, c)).clamp(-1.0, 1.0);
    let middle = sine.asin();
    let (first, last) = if sine.abs() < 1.0 - 1e-12 {
        ((-sign * entry(b, c)).atan2(entry(c, c)), (-sign * entry(a, b)).atan2(entry(a, a)))
    } else {
        // Locked: the last angle stays, the first takes all.
        ((sign * entry(c, b)).atan2(entry(b, b)) - sine.signum() * sign * before[2], before[2])
    };
    nearest([first, middle, last], before)
}
