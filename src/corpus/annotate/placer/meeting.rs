//! Where the two hands are on each other.

use super::super::Placed;
use super::Placer;
use super::space::Hands;
use crate::motion::pose::ModelPose;
use crate::phonology::{Distance, HandPart, HandPoint, Side};
use glam::DVec3;

/// Hands touch whose points are so near, metres.
const TOUCH_M: f64 = 0.015;
/// Hands are close to each other whose own point and any point are so near, metres.
const CLOSE_M: f64 = 0.06;

/// Two hands that are on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// The point of the hand that was asked for.
    pub with: HandPoint,
    /// The point of the other hand.
    pub other: HandPoint,
    /// Touch or close.
    pub distance: Distance,
    /// How far the points are apart, metres.
    pub off: f64,
    /// Whether the hand is on the other one; else both are at one place, and touch there.
    pub is_place: bool,
}

impl Placer<'_> {
    /// Where two hands are that touch: the place of the points that do.
    pub fn place_of_meeting(&self, side: Side, met: Meeting, model: &ModelPose) -> Option<(Placed, f64)> {
        let (own, other) = (self.point(side, met.with, model)?, self.point(side.other(), met.other, model)?);
        let middle = (own + other) / 2.0;
        let found = self.nearest(side, Hands::Meeting, (met.with, middle), &[], middle, model);
        found.map(|(placed, off)| (Placed { with: met.with, ..placed }, off))
    }

    /// Where the two hands are on each other, if they are; `own` is the point with which the given hand's shape touches.
    pub fn meeting(&self, side: Side, own: HandPoint, model: &ModelPose) -> Option<Meeting> {
        let others = self.posed(side.other(), model);
        let nearest = |at: DVec3| {
            let far = others.iter().map(|(p, there)| (*p, at.distance(*there)));
            far.min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let (other, off) = nearest(self.point(side, own, model)?)?;
        if off < TOUCH_M {
            return Some(Meeting { with: own, other, distance: Distance::Touch, off, is_place: false });
        }
        let arm = |p: &HandPoint| {
            matches!(p.part(), HandPart::LowerArm | HandPart::Elbow | HandPart::ElbowInside | HandPart::UpperArm)
        };
        // A hand meets the other arm; two arms that touch are no place.
        let own_points = self.posed(side, model).into_iter().filter(|(p, _)| !arm(p));
        let any = own_points.filter_map(|(p, at)| nearest(at).map(|(o, off)| (p, o, off)));
        let (with, touched, least) = any.min_by(|a, b| a.2.total_cmp(&b.2))?;
        if least < TOUCH_M {
            return Some(Meeting { with, other: touched, distance: Distance::Touch, off: least, is_place: false });
        }
        (off < CLOSE_M).then_some(Meeting { with: own, other, distance: Distance::Close, off, is_place: false })
    }
}
