//! The room that the body takes up, coarsely: what a hand that moves before it has to stay out of.
//!
//! The trunk is what lies behind a surface through the landmarks of its front; the head is an ellipsoid through those of
//! its top, its sides and its face. Both ride on a joint. The skin itself ([`super::skin`]) is for measuring; this is
//! for every frame of every hand.
//!
//! # Conventions
//! Model space, metres.

use super::landmarks::{Landmark, Landmarks};
use crate::diagnostics::Error;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::{Lateral, Side};
use glam::{DQuat, DVec3};

/// The landmarks up the front of the trunk.
const FRONT: [&str; 5] = ["belowstomach", "stomach", "chest", "shoulders", "neck"];
/// How the surface goes back at its sides: so far out and so far back, metres.
const EDGE: (f64, f64) = (0.03, 0.10);
/// How far below the chin the head's ellipsoid ends, so that the jaw is in it, metres.
const BELOW_CHIN: f64 = 0.035;
/// What lies deeper than this behind the front is behind the body, metres.
const THICK: f64 = 0.15;

/// No joint or tip of a hand is farther from its wrist, metres.
pub const HAND_M: f64 = 0.24;

/// The room that a body takes up.
#[derive(Debug, Clone)]
pub struct Solid {
    trunk: Carried,
    /// Rows from below: the height, and how far from the middle the surface is how far forward.
    front: Vec<(f64, [(f64, f64); 4])>,
    /// Nothing of the front lies farther to a side or forward.
    outermost: (f64, f64),
    head: Carried,
    centre: DVec3,
    radii: DVec3,
    /// What may be touched.
    marks: Vec<Landmark>,
}

/// A joint that carries a part, and how it is when the body stands as the part was measured.
#[derive(Debug, Clone, Copy)]
struct Carried {
    joint: JointId,
    at: DVec3,
    turned: DQuat,
}

impl Carried {
    fn new(joint: JointId, model: &ModelPose) -> Carried {
        Carried { joint, at: model.position(joint), turned: model.rotation(joint) }
    }

    /// From the axes of the measured part to those of a pose.
    fn turn(&self, model: &ModelPose) -> DQuat {
        model.rotation(self.joint) * self.turned.conjugate()
    }

    /// A point of a pose where it was measured.
    fn back(&self, point: DVec3, model: &ModelPose) -> DVec3 {
        self.turn(model).conjugate() * (point - model.position(self.joint)) + self.at
    }
}

impl Solid {
    /// The room that a body takes up, measured as the skeleton rests.
    ///
    /// # Errors
    /// Names the joint or the landmark that is missing.
    pub fn new(skeleton: &Skeleton, landmarks: &Landmarks) -> Result<Solid, Error> {
        let rest = LocalPose::rest(skeleton).to_model(skeleton);
        let place = |id: &str, beside: Option<bool>| {
            let lateral = beside.map(|beside| Lateral { side: Side::Left, beside });
            landmarks.body_place(id, lateral).map(|landmark| landmark.position(&rest))
        };
        let row = |id: &&str| {
            let (middle, at, beside) = (place(id, None)?, place(id, Some(false))?, place(id, Some(true))?);
            let edge = (beside.x + EDGE.0, beside.z - EDGE.1);
            Ok((middle.y, [(0.0, middle.z), (at.x, at.z), (beside.x, beside.z), edge]))
        };
        let mut front = FRONT.iter().map(row).collect::<Result<Vec<_>, Error>>()?;
        front.sort_by(|a, b| a.0.total_cmp(&b.0));
        let points = || front.iter().flat_map(|(_, row)| row);
        let outermost = (points().map(|p| p.0).fold(0.0, f64::max), points().map(|p| p.1).fold(0.0, f64::max));
        let (top, chin, face) = (place("headtop", None)?, place("chin", None)?, place("forehead", None)?);
        let side = place("ear", Some(false))?;
        let centre = DVec3::new(0.0, (top.y + chin.y - BELOW_CHIN) / 2.0, side.z);
        // Nose and mouth stand out of it, and what touches them with them.
        let radii = DVec3::new(side.x, top.y - centre.y, face.z - centre.z).max(DVec3::splat(0.01));
        let trunk = Carried::new(skeleton.joint("Spine2")?, &rest);
        let head = Carried::new(skeleton.joint("Head")?, &rest);
        let sides = [Side::Left, Side::Right].into_iter();
        let sides = sides.flat_map(|side| [false, true].map(|beside| Some(Lateral { side, beside })));
        let laterals: Vec<Option<Lateral>> = std::iter::once(None).chain(sides).collect();
        let marks =
            landmarks.body_ids().flat_map(|id| laterals.iter().filter_map(|at| landmarks.body_place(id, *at).ok()));
        let marks = marks.collect();
        Ok(Solid { trunk, front, outermost, head, centre, radii, marks })
    }

    /// Whether the body is farther than a distance from a point, in a pose; a body nearer than that may be farther all the same.
    pub fn is_beyond(&self, distance_m: f64, point: DVec3, model: &ModelPose) -> bool {
        let by_trunk = self.trunk.back(point, model);
        let (Some((low, _)), Some((high, _))) = (self.front.first(), self.front.last()) else { return true };
        let of_trunk = (by_trunk.z - self.outermost.1)
            .max(by_trunk.x.abs() - self.outermost.0)
            .max(low - by_trunk.y)
            .max(by_trunk.y - high);
        let of_head = self.head.back(point, model).distance(self.centre) - self.radii.max_element();
        of_trunk.min(of_head) > distance_m
    }

    /// How far a point is from the nearest landmark, in a pose, metres.
    pub fn from_landmark(&self, point: DVec3, model: &ModelPose) -> f64 {
        self.marks.iter().map(|mark| mark.position(model).distance(point)).fold(f64::INFINITY, f64::min)
    }

    /// How deep a point is in the body, in a pose, and which way is the shortest one out; below 0 outside, where it lies
    /// before the trunk or about the head.
    pub fn depth(&self, point: DVec3, model: &ModelPose) -> (f64, DVec3) {
        let deep = self.behind_front(self.trunk.back(point, model));
        if let Some(deep) = deep.filter(|deep| *deep > 0.0) {
            return (deep, self.trunk.turn(model) * DVec3::Z);
        }
        let local = (self.head.back(point, model) - self.centre) / self.radii;
        let level = local.length().max(1e-6);
        // Along the gradient of the ellipsoid's level, as far as that is from 1.
        let gradient = local / self.radii / level;
        let steep = gradient.length().max(1e-6);
        let of_head = (1.0 - level) / steep;
        match deep {
            Some(deep) if deep > of_head => (deep, self.trunk.turn(model) * DVec3::Z),
            _ => (of_head, self.head.turn(model) * (gradient / steep)),
        }
    }

    /// How far a point is behind the front of the trunk, below 0 before it; nothing beside it, above it and at its back.
    fn behind_front(&self, point: DVec3) -> Option<f64> {
        let across = point.x.abs();
        let pair = self.front.windows(2).find(|pair| pair[0].0 <= point.y && point.y < pair[1].0)?;
        let along = |row: &[(f64, f64); 4]| {
            let pair = row.windows(2).find(|pair| across <= pair[1].0)?;
            let share = (across - pair[0].0) / (pair[1].0 - pair[0].0).max(1e-9);
            Some(pair[0].1 + (pair[1].1 - pair[0].1) * share)
        };
        let share = (point.y - pair[0].0) / (pair[1].0 - pair[0].0).max(1e-9);
        let (low, high) = (along(&pair[0].1)?, along(&pair[1].1)?);
        Some(low + (high - low) * share - point.z).filter(|deep| *deep < THICK)
    }
}
