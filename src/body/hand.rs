//! TEMPORARY stand-in until the hands branch lands.
#![allow(missing_docs)]
use crate::diagnostics::Error;
use crate::motion::{pose::LocalPose, skeleton::{JointId, Skeleton}};
use crate::phonology::{Side, handshape::HandAngles};
use glam::DQuat;
#[derive(Debug, Clone)]
pub struct HandRig { joints: [JointId; 15], side: Side }
impl HandRig {
    pub fn new(s: &Skeleton, side: Side) -> Result<Self, Error> {
        let mut j = vec![];
        for d in ["Thumb", "Index", "Middle", "Ring", "Pinky"] { for k in 1..=3 { j.push(s.joint(&format!("{}Hand{d}{k}", if side == Side::Left { "Left" } else { "Right" }))?); } }
        Ok(Self { joints: j.try_into().unwrap(), side })
    }
    pub fn joints(&self) -> [JointId; 15] { self.joints }
    pub fn apply(&self, a: &HandAngles, p: &mut LocalPose) {
        let s = self.side.sign();
        for f in 0..4 {
            let [m, ab, pi, d] = [a.0[f * 4], a.0[f * 4 + 1], a.0[f * 4 + 2], a.0[f * 4 + 3]];
            p.set(self.joints[3 + f * 3], DQuat::from_rotation_y(-ab * m.cos() * s * if f >= 2 {-1.0} else {1.0}) * DQuat::from_rotation_z(-m * s));
            p.set(self.joints[4 + f * 3], DQuat::from_rotation_z(-pi * s));
            p.set(self.joints[5 + f * 3], DQuat::from_rotation_z(-d * s));
        }
    }
}
