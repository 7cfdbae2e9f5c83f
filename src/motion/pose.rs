//! Poses of a skeleton, in local and in model space as distinct types.

use super::skeleton::{JointId, Skeleton};
use glam::{DQuat, DVec3};

/// Rotations of each joint relative to its parent, and where the root stands.
///
/// `rotations` has one unit quaternion a joint, in the skeleton's order.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalPose {
    /// The root joint's position, model space, metres.
    pub root_model: DVec3,
    /// One unit quaternion a joint, relative to its parent.
    pub rotations: Vec<DQuat>,
}

impl LocalPose {
    /// The rest pose: a T-pose with identity rotations.
    pub fn rest(skeleton: &Skeleton) -> LocalPose {
        LocalPose { root_model: skeleton.joints()[0].rest_model, rotations: vec![DQuat::IDENTITY; skeleton.len()] }
    }

    /// The joint's rotation relative to its parent.
    pub fn rotation(&self, joint: JointId) -> DQuat {
        self.rotations[joint.index()]
    }

    /// Sets the joint's rotation relative to its parent.
    pub fn set(&mut self, joint: JointId, rotation: DQuat) {
        self.rotations[joint.index()] = rotation;
    }

    /// Forward kinematics: every joint in model space.
    pub fn to_model(&self, skeleton: &Skeleton) -> ModelPose {
        let mut positions = Vec::with_capacity(skeleton.len());
        let mut rotations: Vec<DQuat> = Vec::with_capacity(skeleton.len());
        for id in skeleton.ids() {
            let local = self.rotations[id.index()];
            match skeleton[id].parent {
                None => {
                    positions.push(self.root_model);
                    rotations.push(local);
                }
                Some(parent) => {
                    let up = rotations[parent.index()];
                    positions.push(positions[parent.index()] + up * skeleton.offset(id));
                    rotations.push(up * local);
                }
            }
        }
        ModelPose { positions, rotations }
    }
}

/// Positions (metres) and rotations of each joint relative to the floor between the feet.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelPose {
    /// One position a joint, model space, metres.
    pub positions: Vec<DVec3>,
    /// One unit quaternion a joint, model space.
    pub rotations: Vec<DQuat>,
}

impl ModelPose {
    /// Where the joint is, model space, metres.
    pub fn position(&self, joint: JointId) -> DVec3 {
        self.positions[joint.index()]
    }

    /// How the joint is turned, model space.
    pub fn rotation(&self, joint: JointId) -> DQuat {
        self.rotations[joint.index()]
    }

    /// A point that rests at `offset` from the joint (rest axes, metres), carried along, model space.
    pub fn point(&self, joint: JointId, offset: DVec3) -> DVec3 {
        self.position(joint) + self.rotation(joint) * offset
    }
}
