//! A hand of the rig: anatomical angles to finger joints and back.
//!
//! # Conventions
//! Everything is computed for the left hand at rest (T-pose: fingers +X, back of the hand +Y, thumb's side
//! +Z); the right hand is its mirror image. A finger's first joint turns by its abduction about Y, then by its
//! flexion about the turned side axis, so that a bent finger stays in its plane.
//!
//! The thumb's bones do not point along an axis of the rig at rest. Each has a rest direction, taken from the
//! skeleton, and a rest pad direction, measured on the mesh ([`THUMB_PAD_AT_REST`]). The angles name a
//! direction and a pad direction for the metacarpal (see `phonology::handshape`), and the joint turns the rest
//! pair onto these; at zero flexion the three bones lie in one line.

use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::handshape::{FingerAngles, HandAngles, HandLimits, ThumbAngles};
use crate::phonology::{Digit, Side};
use glam::{DMat3, DQuat, DVec3};

/// Where the thumb's pad looks at rest: toward the thumb's side, toward the fingers, out of the palm.
///
/// The short principal axis of the last phalanx's cross-section on the avatar's mesh (the nail's normal,
/// reversed), within about 3°.
pub const THUMB_PAD_AT_REST: [f64; 3] = [-0.946, 0.096, 0.308];

/// The finger joints of one hand.
#[derive(Debug, Clone)]
pub struct HandRig {
    side: Side,
    hand: JointId,
    fingers: [[JointId; 3]; 4],
    thumb: [JointId; 3],
    /// For each bone of the thumb, as a left one: columns direction, pad, flexion axis.
    thumb_rest: [DMat3; 3],
}

impl HandRig {
    /// Finds a hand in a skeleton with Mixamo's names.
    ///
    /// # Errors
    /// Names the joint that is missing, or the thumb bone that has no length.
    pub fn new(skeleton: &Skeleton, side: Side) -> Result<HandRig, Error> {
        let prefix = match side {
            Side::Left => "LeftHand",
            Side::Right => "RightHand",
        };
        let joint = |digit: &str, k: usize| skeleton.joint(&format!("{prefix}{digit}{k}"));
        let three = |digit: &str| Ok::<_, Error>([joint(digit, 1)?, joint(digit, 2)?, joint(digit, 3)?]);
        let thumb = three("Thumb")?;
        let mut thumb_rest = [DMat3::IDENTITY; 3];
        for (frame, id) in thumb_rest.iter_mut().zip(thumb) {
            let along = left(skeleton[id].tail_model - skeleton[id].rest_model, side);
            let along = along.try_normalize().ok_or_else(|| Error::new("a bone of the thumb has no length"))?;
            *frame = frame_of(along, from_hand_axes(DVec3::from(THUMB_PAD_AT_REST)));
        }
        let fingers = [three("Index")?, three("Middle")?, three("Ring")?, three("Pinky")?];
        Ok(HandRig { side, hand: skeleton.joint(prefix)?, fingers, thumb, thumb_rest })
    }

    /// Which hand.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The hand's own joint, at the wrist.
    pub fn hand(&self) -> JointId {
        self.hand
    }

    /// The three joints of a digit, from the hand outwards.
    pub fn of_digit(&self, digit: Digit) -> [JointId; 3] {
        match digit {
            Digit::Thumb => self.thumb,
            Digit::Index => self.fingers[0],
            Digit::Middle => self.fingers[1],
            Digit::Ring => self.fingers[2],
            Digit::Pinky => self.fingers[3],
        }
    }

    /// All fifteen joints: three a digit, from the thumb to the little finger.
    pub fn joints(&self) -> [JointId; 15] {
        std::array::from_fn(|i| self.of_digit(Digit::ALL[i / 3])[i % 3])
    }

    /// Where the pad of a bone of the thumb looks at rest, model space; of any other joint, where the palm does.
    pub fn thumb_pad_at_rest(&self, bone: JointId) -> DVec3 {
        match self.thumb.iter().position(|joint| *joint == bone) {
            Some(at) => left(self.thumb_rest[at].y_axis, self.side),
            None => -DVec3::Y,
        }
    }

    /// Sets the fifteen finger joints; nothing else of the pose changes.
    pub fn apply(&self, angles: &HandAngles, pose: &mut LocalPose) {
        let mut set = |joint: JointId, rotation: DQuat| pose.set(joint, mirrored(rotation, self.side));
        for (i, joints) in self.fingers.iter().enumerate() {
            let f = &angles.fingers[i];
            let turn = DQuat::from_rotation_y(f.abduction * abduction_sign(i));
            set(joints[0], turn * DQuat::from_rotation_z(-f.mcp));
            set(joints[1], DQuat::from_rotation_z(-f.pip));
            set(joints[2], DQuat::from_rotation_z(-f.dip));
        }
        let t = &angles.thumb;
        let rest = &self.thumb_rest;
        let locals = [
            thumb_frame(t) * rest[0].transpose(),
            rest[0] * DMat3::from_rotation_z(t.mcp) * rest[1].transpose(),
            rest[1] * DMat3::from_rotation_z(t.ip) * rest[2].transpose(),
        ];
        for (joint, local) in self.thumb.into_iter().zip(locals) {
            set(joint, DQuat::from_mat3(&local).normalize());
        }
    }

    /// Brings fingers together that are spread farther than their bent knuckles let them; the rest of the pose stays.
    pub fn limit_spread(&self, pose: &mut LocalPose) {
        for (i, [knuckle, ..]) in self.fingers.iter().enumerate() {
            let local = mirrored(pose.rotation(*knuckle), self.side);
            let (turn, mcp) = spread_and_flexion(local);
            let limits = HandLimits::ANATOMICAL.fingers[i].abduction_at(mcp);
            let abduction = turn * abduction_sign(i);
            if !limits.holds(abduction) {
                let within = DQuat::from_rotation_y(limits.clamp(abduction) * abduction_sign(i));
                let local = within * DQuat::from_rotation_y(-turn) * local;
                pose.set(*knuckle, mirrored(local, self.side));
            }
        }
    }

    /// Measures the angles of a pose. Turns that no hand can make (a twisted finger) are left out.
    pub fn angles_of(&self, pose: &LocalPose) -> HandAngles {
        let local = |joint: JointId| mirrored(pose.rotation(joint), self.side);
        let fingers = std::array::from_fn(|i| {
            let [first, second, third] = self.fingers[i].map(local);
            let (turn, mcp) = spread_and_flexion(first);
            FingerAngles { mcp, abduction: turn * abduction_sign(i), pip: flexion(second), dip: flexion(third) }
        });
        let [first, second, third] = self.thumb.map(|j| DMat3::from_quat(local(j)));
        let rest = &self.thumb_rest;
        let metacarpal = first * rest[0];
        let (along, pad) = (to_hand_axes(metacarpal.x_axis), metacarpal.y_axis);
        let bend = |m: DMat3| m.x_axis.y.atan2(m.x_axis.x);
        let (zero, quarter) = pronation_axes(metacarpal.x_axis);
        let thumb = ThumbAngles {
            radial: along.x.atan2(along.y),
            palmar: along.z.clamp(-1.0, 1.0).asin(),
            pronation: pad.dot(quarter).atan2(pad.dot(zero)),
            mcp: bend(rest[0].transpose() * second * rest[1]),
            ip: bend(rest[1].transpose() * third * rest[2]),
        };
        HandAngles { fingers, thumb }
    }
}

/// +1 where positive abduction is a positive turn about Y on the left hand: ring and little finger.
fn abduction_sign(finger: usize) -> f64 {
    if finger < 2 { -1.0 } else { 1.0 }
}

/// The turns of a knuckle of the left hand about Y, then about its side axis toward the palm, radians.
fn spread_and_flexion(knuckle: DQuat) -> (f64, f64) {
    // The side axis after abduction tells the abduction; what is left of the turn is flexion.
    let side = knuckle * DVec3::Z;
    let turn = side.x.atan2(side.z);
    (turn, flexion(DQuat::from_rotation_y(-turn) * knuckle))
}

/// The flexion of a turn about the side axis.
fn flexion(local: DQuat) -> f64 {
    let along = local * DVec3::X;
    (-along.y).atan2(along.x)
}

/// Columns direction, pad direction (made square to it), flexion axis: a positive turn about the third
/// takes the first to the second.
fn frame_of(along: DVec3, pad: DVec3) -> DMat3 {
    let pad = (pad - along * pad.dot(along)).normalize_or(along.any_orthonormal_vector());
    DMat3::from_cols(along, pad, along.cross(pad))
}

/// Pad directions of a metacarpal in that direction at pronation 0 (to the little finger's side) and 90°.
fn pronation_axes(along: DVec3) -> (DVec3, DVec3) {
    let frame = frame_of(along, -DVec3::Z);
    (frame.y_axis, frame.z_axis)
}

/// The metacarpal's frame for the angles of a thumb.
fn thumb_frame(t: &ThumbAngles) -> DMat3 {
    let d = DVec3::new(t.radial.sin() * t.palmar.cos(), t.radial.cos() * t.palmar.cos(), t.palmar.sin());
    let along = from_hand_axes(d);
    let (zero, quarter) = pronation_axes(along);
    frame_of(along, zero * t.pronation.cos() + quarter * t.pronation.sin())
}

/// From (thumb's side, fingers, out of the palm) to the left hand's rest axes.
fn from_hand_axes(v: DVec3) -> DVec3 {
    DVec3::new(v.y, -v.z, v.x)
}

/// The inverse of [`from_hand_axes`].
fn to_hand_axes(v: DVec3) -> DVec3 {
    DVec3::new(v.z, v.x, -v.y)
}

/// A vector of a hand as the left hand's.
fn left(v: DVec3, side: Side) -> DVec3 {
    DVec3::new(v.x * side.sign(), v.y, v.z)
}

/// A rotation of the left hand as the side's, or back: reflection across X = 0.
fn mirrored(q: DQuat, side: Side) -> DQuat {
    DQuat::from_xyzw(q.x, q.y * side.sign(), q.z * side.sign(), q.w)
}
