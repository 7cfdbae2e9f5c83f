//! Where the two hands are on each other.

use super::super::Placed;
use super::Placer;
use super::space::Hands;
use crate::body::landmarks::ContactPoint;
use crate::motion::pose::ModelPose;
use crate::phonology::{Distance, HandPart, HandPoint, Side};
use glam::DVec3;

/// Hands touch whose points are so near, metres.
const TOUCH_M: f64 = 0.015;
/// A hand is close to the other one whose own point is no higher over it than this, metres.
const CLOSE_M: f64 = 0.06;
/// And no farther aside of one of its points, metres.
const ASIDE_M: f64 = 0.025;

/// Hands whose wrists are farther apart than an arm and a hand are on nothing of each other, metres.
const FARTHEST_M: f64 = 0.75;

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

    /// The point of a hand over which another point is, close to it; and how far off, metres.
    fn below(&self, side: Side, at: DVec3, model: &ModelPose) -> Option<(HandPoint, f64)> {
        let over = |(point, contact): &(HandPoint, ContactPoint)| {
            let (from, normal) = (at - contact.position(model), contact.normal(model));
            let height = from.dot(normal);
            let aside = (from - normal * height).length();
            (height > 0.0 && height < CLOSE_M && aside < ASIDE_M).then_some((*point, aside, from.length()))
        };
        let found = self.points[usize::from(side == Side::Right)].iter().filter_map(over);
        found.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(point, _, off)| (point, off))
    }

    /// Where the two hands are on each other, if they are; `own` is the point with which the given hand's shape touches.
    pub fn meeting(&self, side: Side, own: HandPoint, model: &ModelPose) -> Option<Meeting> {
        let wrist = |side: Side| model.position(self.signer.arm(side).hand);
        // A hand may lie on the other arm, up to its shoulder.
        if wrist(side).distance(wrist(side.other())) > FARTHEST_M {
            return None;
        }
        let others = self.posed(side.other(), model);
        let nearest = |at: DVec3| {
            let far = others.iter().map(|(p, there)| (*p, at.distance(*there)));
            far.min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let own_at = self.point(side, own, model)?;
        let (other, off) = nearest(own_at)?;
        if off < TOUCH_M {
            return Some(Meeting { with: own, other, distance: Distance::Touch, off, is_place: false });
        }
        // A hand meets the other arm; two arms that touch are no place.
        let own_points = self.posed(side, model).into_iter().filter(|(p, _)| !is_arm(*p));
        let any = own_points.filter_map(|(p, at)| nearest(at).map(|(o, off)| (p, o, off)));
        let (with, touched, least) = any.min_by(|a, b| a.2.total_cmp(&b.2))?;
        if least < TOUCH_M {
            return Some(Meeting { with, other: touched, distance: Distance::Touch, off: least, is_place: false });
        }
        let (other, off) = self.below(side.other(), own_at, model)?;
        Some(Meeting { with: own, other, distance: Distance::Close, off, is_place: false })
    }
}

/// Whether a point is on the arm rather than on the hand.
pub(super) fn is_arm(point: HandPoint) -> bool {
    matches!(point.part(), HandPart::LowerArm | HandPart::Elbow | HandPart::ElbowInside | HandPart::UpperArm)
}
