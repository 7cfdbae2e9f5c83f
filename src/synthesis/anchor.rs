//! Where a placement is: points that ride on the body, on the other hand, or stand in space.

use crate::body::landmarks::{ContactPoint, Landmark};
use crate::motion::pose::ModelPose;
use crate::motion::skeleton::{JointId, Skeleton};
use glam::DVec3;

/// A point that may be carried by a joint.
#[derive(Debug, Clone, PartialEq)]
pub enum Anchor {
    /// A point of model space, metres.
    Fixed(DVec3),
    /// A point that rides on a joint.
    Carried {
        /// The joint.
        joint: JointId,
        /// From the joint, in its rest axes, metres.
        offset: DVec3,
    },
    /// The middle of several, at least one.
    Middle(Vec<Anchor>),
    /// Moved by a vector of model space, metres.
    Moved(Box<Anchor>, DVec3),
}

impl Anchor {
    /// A point at a distance from a landmark along its normal, metres.
    pub fn over(landmark: &Landmark, distance_m: f64) -> Anchor {
        Anchor::Carried { joint: landmark.joint, offset: landmark.offset + landmark.normal * distance_m }
    }

    /// A point at a distance from a hand's contact point along its normal, metres.
    pub fn over_contact(contact: &ContactPoint, distance_m: f64) -> Anchor {
        Anchor::Middle(contact.parts().iter().map(|part| Anchor::over(part, distance_m)).collect())
    }

    /// The same anchor moved by a vector of model space.
    pub fn moved(self, by: DVec3) -> Anchor {
        match self {
            anchor if by == DVec3::ZERO => anchor,
            // One vector, however many legs lead there.
            Anchor::Moved(anchor, before) => Anchor::Moved(anchor, before + by),
            anchor => Anchor::Moved(Box::new(anchor), by),
        }
    }

    /// Where it is in a pose, model space, metres.
    pub fn position(&self, model: &ModelPose) -> DVec3 {
        match self {
            Anchor::Fixed(point) => *point,
            Anchor::Carried { joint, offset } => model.point(*joint, *offset),
            Anchor::Middle(parts) => parts.iter().map(|a| a.position(model)).sum::<DVec3>() / parts.len().max(1) as f64,
            Anchor::Moved(anchor, by) => anchor.position(model) + *by,
        }
    }

    /// Whether it goes where a joint goes.
    pub fn rides_on(&self, carrier: JointId, skeleton: &Skeleton) -> bool {
        match self {
            Anchor::Fixed(_) => false,
            Anchor::Carried { joint, .. } => {
                let mut at = Some(*joint);
                while let Some(joint) = at {
                    if joint == carrier {
                        return true;
                    }
                    at = skeleton[joint].parent;
                }
                false
            }
            Anchor::Middle(parts) => parts.iter().any(|part| part.rides_on(carrier, skeleton)),
            Anchor::Moved(anchor, _) => anchor.rides_on(carrier, skeleton),
        }
    }
}
