//! Hands in the body while they sign.

use super::Checking;
use super::finding::{Finding, Kind, Worst};
use crate::body::solid::HAND_M;
use crate::phonology::Side;

/// Joints lie under the skin, and the surface that they are measured against is coarse: this deep is in the body, metres.
const DEEP: f64 = 0.03;

impl Checking<'_> {
    /// Hands that are in trunk or head, from the first stroke to the end of the last hold.
    pub(super) fn inside(&self) -> Vec<Finding> {
        let (solid, skeleton) = (&self.signer.solid, &self.signer.skeleton);
        let report = &self.performance.report;
        let signed = report.stroke_start..=report.sign_end;
        let of = |side: Side| {
            let joints = self.signer.hand(side).joints();
            let mut worst = Worst::default();
            for (number, model) in
                self.frames.iter().enumerate().filter(|(frame, _)| signed.contains(&self.time_of(*frame)))
            {
                if solid.is_beyond(HAND_M, model.position(self.signer.arm(side).hand), model) {
                    continue;
                }
                for joint in joints {
                    let (deep, _) = solid.depth(model.position(joint), model);
                    worst.look(deep, DEEP, number, || skeleton[joint].name.clone());
                }
            }
            worst.finding(Kind::InBody, Some(side), |frame| self.time_of(frame))
        };
        [Side::Left, Side::Right].into_iter().filter_map(of).collect()
    }
}
