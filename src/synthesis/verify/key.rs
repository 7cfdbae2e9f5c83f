//! The keys of a sign in its motion: what each hand should be at, and the body at that instant.

use super::super::side_of;
use super::Checking;
use crate::motion::pose::ModelPose;
use crate::phonology::symmetry::{Resolved, acts, resolve};
use crate::phonology::{Hand, Side, Sign};
use crate::time::Seconds;

/// One hand at one key.
pub(super) struct Key<'s> {
    /// The phase of the sign that the key belongs to.
    pub phase: &'s Sign,
    /// The hand.
    pub hand: Hand,
    /// The side of the body that it is on.
    pub side: Side,
    /// Its number in the phase, from 0.
    pub number: usize,
    /// The hand's tiers, with what follows from a symmetry.
    pub said: Resolved,
    /// When, from the clip's start.
    pub time: Seconds,
    /// The body at that instant, model space.
    pub body: ModelPose,
}

impl Key<'_> {
    /// For people, who count from 1.
    pub fn name(&self) -> String {
        format!("at key {}", self.number + 1)
    }
}

impl Checking<'_> {
    /// Each acting hand at each key whose instant the report of the motion says. A hand that is half a cycle behind the other is not
    /// at its keys when the other is, and is passed over.
    pub(super) fn keys(&self) -> Vec<Key<'_>> {
        let instants = &self.performance.report.keys;
        let counts = |phase: &Sign| phase.intervals + 1;
        let all: Vec<&Sign> = self.sign.phases().collect();
        let phases = match instants.len() {
            n if n == all.iter().map(|phase| counts(phase)).sum::<usize>() => &all[..],
            n if n == counts(self.sign) => &all[..1],
            _ => &[],
        };
        let clip = &self.performance.track.clip;
        let mut keys = Vec::new();
        let mut instants = instants.iter();
        for phase in phases {
            for (number, time) in instants.by_ref().take(counts(phase)).enumerate() {
                let body = clip.sample(*time).pose.to_model(clip.skeleton());
                for hand in Hand::BOTH.into_iter().filter(|hand| acts(phase, *hand)) {
                    let said = resolve(phase, hand);
                    let behind = said.movement.iter().any(|m| m.any_action(&|action| said.turns.behind(action)));
                    if !behind {
                        let (side, body) = (side_of(hand), body.clone());
                        keys.push(Key { phase, hand, side, number, said, time: *time, body });
                    }
                }
            }
        }
        keys
    }
}
