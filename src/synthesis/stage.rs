//! What does not change from sign to sign: the inventories, the body, the knobs, and the neutral pose.

use super::plan::Planner;
use super::{Grammar, Options};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::phonology::handshape::HandAngles;
use crate::phonology::{Configuration, Side};
use glam::{DQuat, DVec3};

/// The stage on which plans are signed.
pub(super) struct Stage<'a> {
    pub grammar: &'a Grammar,
    pub signer: &'a Signer,
    pub options: &'a Options,
    /// The signer standing neutral.
    pub neutral: LocalPose,
    /// The same in model space.
    pub neutral_model: ModelPose,
}

/// The joints of one arm and hand at one frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Posture {
    /// Clavicle, upper arm, forearm, hand.
    pub arm: [DQuat; 4],
    /// In the order of the hand's joints.
    pub fingers: [DQuat; 15],
}

impl<'a> Stage<'a> {
    /// # Errors
    /// Inventories without the resting hand.
    pub fn new(grammar: &'a Grammar, signer: &'a Signer, options: &'a Options) -> Result<Stage<'a>, Error> {
        let rest = grammar.handshapes.angles(&Configuration::named("rest"), None);
        let relaxed = rest.map_err(|e| Error::new(e.to_string()))?;
        let neutral = signer.neutral(&relaxed);
        let neutral_model = neutral.to_model(&signer.skeleton);
        Ok(Stage { grammar, signer, options, neutral, neutral_model })
    }

    pub fn planner(&self) -> Planner<'_> {
        Planner { grammar: self.grammar, signer: self.signer, neutral: &self.neutral_model }
    }

    /// The posture of one side in a pose.
    pub fn posture(&self, side: Side, pose: &LocalPose) -> Posture {
        let arm = self.signer.arm(side);
        Posture {
            arm: arm.joints().map(|j| pose.rotation(j)),
            fingers: self.signer.hand(side).joints().map(|j| pose.rotation(j)),
        }
    }

    /// The rotations of the fingers of a handshape.
    pub fn fingers(&self, side: Side, angles: &HandAngles) -> [DQuat; 15] {
        let hand = self.signer.hand(side);
        let mut pose = self.neutral.clone();
        hand.apply(angles, &mut pose);
        hand.joints().map(|j| pose.rotation(j))
    }

    /// Where the hand's joint is when the arm hangs neutral, model space, metres.
    pub fn neutral_wrist(&self, side: Side) -> DVec3 {
        self.neutral_model.position(self.signer.arm(side).hand)
    }
}
