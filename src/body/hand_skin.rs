//! A hand's surface, for measuring handshapes: contacts of the thumb, and how deep one part lies in another.
//!
//! # Conventions
//! Millimetres for gaps and depths, since they are read by people; everything else as elsewhere. A *patch* is the
//! skin within [`PATCH_MM`] of a named point that looks the same way. Two parts touch as well as their patches come
//! near. Depth is measured at vertices, against the nearest vertex of the other part and its normal.

use super::hand::{HandRig, THUMB_PAD_AT_REST};
use super::skin::{PosedSkin, Skin, SkinPoint};
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::handshape::{HandAngles, ThumbGoal, ThumbPart, ThumbTarget};
use crate::phonology::{Digit, Digits, Side};
use glam::DVec3;

/// The radius of a patch, millimetres.
pub const PATCH_MM: f64 = 8.0;

/// A bone of a digit, or the hand itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HandBone {
    /// The palm and the back of the hand, and the ball of the thumb.
    Palm,
    /// A phalanx: 0 to 2 from the knuckle; of the thumb 1 and 2 (its metacarpal counts as palm).
    Phalanx(Digit, usize),
}

/// A named point of the skin and the skin around it.
#[derive(Debug, Clone)]
pub struct Patch {
    at: SkinPoint,
    vertices: Vec<usize>,
}

/// The surface of one hand.
#[derive(Debug, Clone)]
pub struct HandSkin {
    skeleton: Skeleton,
    rig: HandRig,
    skin: Skin,
    bones: Vec<HandBone>,
    /// Vertices beside another part: where parts join, inside and outside mean nothing.
    seam: Vec<bool>,
}

/// A hand's surface in a handshape, the arm at rest.
#[derive(Debug)]
pub struct PosedHand<'a> {
    hand: &'a HandSkin,
    /// The surface.
    pub skin: PosedSkin<'a>,
}

impl HandSkin {
    /// The surface of a side's hand.
    ///
    /// # Errors
    /// Names the joint that is missing.
    pub fn new(skeleton: &Skeleton, skin: &Skin, side: Side) -> Result<HandSkin, Error> {
        let rig = HandRig::new(skeleton, side)?;
        let own = rig.joints();
        let skin = skin.subset(|j| j == rig.hand() || own.contains(&j));
        let bones: Vec<HandBone> = (0..skin.len()).map(|v| bone_of(skin.main_joint(v), &own)).collect();
        let mut seam = vec![false; skin.len()];
        for triangle in skin.triangles() {
            let [a, b, c] = triangle.map(|v| part_of(bones[v as usize]));
            if a != b || b != c {
                triangle.iter().for_each(|v| seam[*v as usize] = true);
            }
        }
        Ok(HandSkin { skeleton: skeleton.clone(), rig, skin, bones, seam })
    }

    /// The hand's joints.
    pub fn rig(&self) -> &HandRig {
        &self.rig
    }

    /// The bone that each vertex belongs to.
    pub fn bones(&self) -> &[HandBone] {
        &self.bones
    }

    /// The surface in a handshape.
    pub fn pose(&self, angles: &HandAngles) -> PosedHand<'_> {
        let mut pose = LocalPose::rest(&self.skeleton);
        self.rig.apply(angles, &mut pose);
        PosedHand { hand: self, skin: self.skin.pose(&pose.to_model(&self.skeleton)) }
    }

    /// The patches of the thumb's part and of each touched finger, for goals that name some.
    pub fn patches(&self, goal: &ThumbGoal) -> Option<(Patch, Vec<Patch>)> {
        let several = |digits: Digits| digits.iter().count() > 1;
        let (thumb, targets) = match *goal {
            ThumbGoal::Posture(_) => return None,
            ThumbGoal::Touch(part, digits, target) => {
                let thumb = self.thumb_patch(part)?;
                let lies_along = several(digits) || part == ThumbPart::Joint;
                let thumb = if lies_along { self.widened(thumb) } else { thumb };
                (thumb, digits.iter().map(|d| self.target_patch(d, target)).collect::<Vec<_>>())
            }
            ThumbGoal::Gap(digits, _) => {
                let pads = digits.iter().map(|d| self.target_patch(d, ThumbTarget::Pad));
                (self.thumb_patch(ThumbPart::Pad)?, pads.collect())
            }
            ThumbGoal::Between(a, b) => {
                // Under the one finger and over the next: there is no room for a thumb between parallel knuckles.
                let facing = DVec3::new(0.0, 1.0, 1.0);
                let thumb = self.thumb_patch(ThumbPart::Tip)?;
                let last = |v: &usize| self.bones[*v] == HandBone::Phalanx(Digit::Thumb, 2);
                let thumb = Patch { at: thumb.at, vertices: (0..self.skin.len()).filter(last).collect() };
                let (near, far) = (a.min(b), a.max(b));
                (thumb, vec![self.finger_patch(near, 1, 0.5, -facing), self.finger_patch(far, 1, 0.4, facing)])
            }
        };
        Some((thumb, targets.into_iter().collect::<Option<Vec<_>>>()?))
    }

    /// The patch of a part of the thumb.
    pub fn thumb_patch(&self, part: ThumbPart) -> Option<Patch> {
        let [radial, distal, palmar] = THUMB_PAD_AT_REST;
        let x = self.rig.side().sign();
        let pad = DVec3::new(distal * x, -palmar, radial);
        let last = self.rig.of_digit(Digit::Thumb)[2];
        let along = self.along(last).normalize();
        match part {
            ThumbPart::Pad => self.patch(last, 0.55, pad),
            ThumbPart::Tip => self.patch(last, 0.7, along + pad * 0.2),
            ThumbPart::Joint => self.patch(last, 0.0, pad),
            ThumbPart::Side => self.patch(last, 0.6, along.cross(pad) * x),
        }
    }

    /// The patch of a place on a finger.
    pub fn target_patch(&self, digit: Digit, target: ThumbTarget) -> Option<Patch> {
        let x = DVec3::X * self.rig.side().sign();
        match target {
            ThumbTarget::MiddleBack => self.finger_patch(digit, 1, 0.5, DVec3::Y),
            ThumbTarget::MiddleFront => self.finger_patch(digit, 1, 0.5, -DVec3::Y),
            ThumbTarget::Pad => self.finger_patch(digit, 2, 0.55, -DVec3::Y),
            ThumbTarget::Nail => self.finger_patch(digit, 2, 0.6, DVec3::Y),
            ThumbTarget::Tip => self.finger_patch(digit, 2, 0.7, x - DVec3::Y * 0.2),
            ThumbTarget::ProximalRadial => self.finger_patch(digit, 0, 0.6, DVec3::Z),
            ThumbTarget::Palm => {
                let knuckle = self.rig.of_digit(digit)[0];
                let from = self.skeleton[knuckle].rest_model - x * 0.012;
                self.cast(from, -DVec3::Y)
            }
        }
    }

    /// The patch on a finger's phalanx, at a share of its length, in a direction at rest.
    pub fn finger_patch(&self, digit: Digit, phalanx: usize, share: f64, direction: DVec3) -> Option<Patch> {
        self.patch(self.rig.of_digit(digit)[phalanx], share, direction)
    }

    /// The same side of both free phalanges of the thumb: what lies on several fingers.
    fn widened(&self, patch: Patch) -> Patch {
        let rest = self.at_rest();
        let normal = rest.normal(patch.at);
        let of_thumb = |v: &usize| matches!(self.bones[*v], HandBone::Phalanx(Digit::Thumb, 1 | 2));
        let alike = |v: &usize| of_thumb(v) && rest.normals[*v].dot(normal) > 0.3;
        Patch { at: patch.at, vertices: (0..self.skin.len()).filter(alike).collect() }
    }

    fn at_rest(&self) -> PosedSkin<'_> {
        self.skin.pose(&LocalPose::rest(&self.skeleton).to_model(&self.skeleton))
    }

    fn along(&self, joint: JointId) -> DVec3 {
        self.skeleton[joint].tail_model - self.skeleton[joint].rest_model
    }

    fn patch(&self, joint: JointId, share: f64, direction: DVec3) -> Option<Patch> {
        self.cast(self.skeleton[joint].rest_model + self.along(joint) * share, direction)
    }

    /// The patch where a ray from inside meets the resting skin.
    fn cast(&self, from: DVec3, direction: DVec3) -> Option<Patch> {
        let rest = self.at_rest();
        let all = self.skin.region(|_| true);
        let at = rest.first_hit(from, direction.normalize(), 0.03, &all)?;
        let (point, normal) = (rest.point(at), rest.normal(at));
        let near =
            |v: &usize| rest.positions[*v].distance(point) < PATCH_MM / 1000.0 && rest.normals[*v].dot(normal) > 0.3;
        Some(Patch { at, vertices: (0..self.skin.len()).filter(near).collect() })
    }
}

impl Patch {
    /// The vertices of the patch.
    pub fn vertices(&self) -> &[usize] {
        &self.vertices
    }
}

impl PosedHand<'_> {
    /// The middle of a patch and the normal there, model space, metres.
    pub fn middle(&self, patch: &Patch) -> (DVec3, DVec3) {
        (self.skin.point(patch.at), self.skin.normal(patch.at))
    }

    /// How far a point hangs above a part's vertices; negative inside, millimetres.
    pub fn above_mm(&self, point: DVec3, part: &[usize]) -> f64 {
        let squared = part.iter().map(|v| (self.skin.positions[*v].distance_squared(point), *v));
        let Some((_, v)) = squared.min_by(|a, b| a.0.total_cmp(&b.0)) else { return 0.0 };
        (point - self.skin.positions[v]).dot(self.skin.normals[v]) * 1000.0
    }

    /// How far a goal is missed, millimetres: for contacts the widest gap between the thumb's patch and a named
    /// finger's; for gaps the difference from the distance asked for; 0 for a free thumb.
    pub fn residual_mm(&self, goal: &ThumbGoal) -> f64 {
        let Some((thumb, targets)) = self.hand.patches(goal) else { return 0.0 };
        if let ThumbGoal::Gap(_, mm) = goal {
            return (self.gap_mm(&thumb, &targets) - f64::from(*mm)).abs();
        }
        targets.iter().map(|t| self.patch_distance_mm(&thumb, t)).fold(0.0, f64::max)
    }

    /// From the thumb's point to the middle of the others', millimetres.
    fn gap_mm(&self, thumb: &Patch, targets: &[Patch]) -> f64 {
        let middle = targets.iter().map(|t| self.middle(t).0).sum::<DVec3>() / targets.len() as f64;
        self.middle(thumb).0.distance(middle) * 1000.0
    }

    /// The least distance of two patches, each vertex of the one from the surface around the other's, millimetres.
    pub fn patch_distance_mm(&self, a: &Patch, b: &Patch) -> f64 {
        let at = |v: &usize| self.skin.positions[*v];
        let one_way = |from: &Patch, to: &Patch| {
            let region = self.hand.skin.region_of_vertices(&to.vertices);
            let distances = from.vertices.iter().filter_map(|v| self.skin.nearest(at(v), Some(&region)));
            distances.map(|n| n.signed_m.abs()).fold(f64::INFINITY, f64::min)
        };
        one_way(a, b).min(one_way(b, a)) * 1000.0
    }

    /// How deep a vertex lies in a part, millimetres; 0 outside and where the parts join. `others` are the part's vertices.
    pub fn depth_mm(&self, vertex: usize, others: &[usize]) -> f64 {
        let at = self.skin.positions[vertex];
        let mut best = (f64::INFINITY, 0);
        for v in others {
            let d = self.skin.positions[*v].distance_squared(at);
            if d < best.0 {
                best = (d, *v);
            }
        }
        if best.0 > 0.012 * 0.012 || self.hand.seam[best.1] {
            return 0.0;
        }
        let inward = (self.skin.positions[best.1] - at).dot(self.skin.normals[best.1]);
        // A vertex far aside of the nearest one is beside the part, not in it.
        let aside = best.0 > 0.004 * 0.004 && inward < 0.6 * best.0.sqrt();
        if aside { 0.0 } else { (inward * 1000.0).max(0.0) }
    }

    /// The deepest that any of the vertices lies in a part, millimetres.
    pub fn deepest_mm(&self, vertices: &[usize], others: &[usize]) -> f64 {
        vertices.iter().map(|v| self.depth_mm(*v, others)).fold(0.0, f64::max)
    }

    /// The ends of the digits, thumb first, model space, metres.
    pub fn tips(&self) -> [DVec3; 5] {
        Digit::ALL.map(|digit| {
            let patch = match digit {
                Digit::Thumb => self.hand.thumb_patch(ThumbPart::Tip),
                _ => self.hand.target_patch(digit, ThumbTarget::Tip),
            };
            patch.map_or(DVec3::ZERO, |p| self.middle(&p).0)
        })
    }
}

/// The digit that a bone belongs to; `None` for the palm.
fn part_of(bone: HandBone) -> Option<Digit> {
    match bone {
        HandBone::Palm => None,
        HandBone::Phalanx(digit, _) => Some(digit),
    }
}

fn bone_of(joint: JointId, own: &[JointId; 15]) -> HandBone {
    match own.iter().position(|j| *j == joint) {
        None | Some(0) => HandBone::Palm,
        Some(i) => HandBone::Phalanx(Digit::ALL[i / 3], i % 3),
    }
}
