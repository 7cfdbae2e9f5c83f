//! Channels: which joints carry which part of a sign (Naert et al. 2021, §3).
//!
//! Placement is where the wrist is: clavicle, upper arm and forearm. Orientation is how the hand is turned: the wrist,
//! with the skin joints of the forearm that turn along. Configuration is the fifteen finger joints. Movement is the
//! placement channel over time. Together the three are one *limb*; no joint belongs to two channels.

use super::signer::Signer;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;

/// The joints of one limb, by channel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Channels {
    /// Clavicle, upper arm, forearm.
    pub placement: [JointId; 3],
    /// The hand, then the forearm's twist joints.
    pub orientation: Vec<JointId>,
    /// Three joints a digit, from the thumb to the little finger.
    pub configuration: [JointId; 15],
}

impl Channels {
    /// The channels of a signer's left or right limb.
    ///
    /// ```
    /// use chereme::{body::channel::Channels, phonology::Side};
    /// let signer = chereme::avatar::signer().unwrap();
    /// let left = Channels::of(&signer, Side::Left);
    /// assert_eq!(left.limb().count(), 3 + 3 + 15);
    /// assert_eq!(signer.skeleton[left.orientation[0]].name, "LeftHand");
    /// ```
    pub fn of(signer: &Signer, side: Side) -> Channels {
        let arm = signer.arm(side);
        Channels {
            placement: [arm.clavicle, arm.upper, arm.fore],
            orientation: std::iter::once(arm.hand).chain(arm.twists.iter().map(|(joint, _)| *joint)).collect(),
            configuration: signer.hand(side).joints(),
        }
    }

    /// Every joint of the limb, channel by channel.
    pub fn limb(&self) -> impl Iterator<Item = JointId> {
        self.placement.iter().chain(&self.orientation).chain(&self.configuration).copied()
    }
}
