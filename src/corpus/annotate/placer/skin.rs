//! Places of the skin: what a hand touches, or is close to.

use super::super::Placed;
use super::{Placer, halves, laterals};
use crate::body::landmarks::{CLOSE_ARMS, Landmark};
use crate::body::signer::Signer;
use crate::motion::pose::ModelPose;
use crate::phonology::location::Location;
use crate::phonology::{Distance, HandPoint, Lateral, Place, Placement, Sited};
use glam::DVec3;

/// A point so near to a place of the skin touches it, metres: places are points of skin that has an extent.
const TOUCHES_M: f64 = 0.03;
/// Another point than the shape's own must be so much nearer, metres.
const NOT_ITS_OWN_M: f64 = 0.012;
/// A hand is close to a place whose own point is so near to where `close` would put it, metres.
const CLOSE_M: f64 = 0.04;
/// Another point must be so near.
const OTHERS_CLOSE_M: f64 = 0.02;
/// The middle of two places must be so much nearer than a place, metres.
const HALFWAY_M: f64 = 0.004;

/// A place of the skin, or the middle of two.
#[derive(Debug, Clone)]
pub(super) struct OnSkin {
    pub place: Place,
    pub lateral: Option<Lateral>,
    /// The landmarks of which the middle is meant, at least one.
    pub landmarks: Vec<Landmark>,
    /// Whether a hand that is close to it is in the signing space before it.
    pub is_region: bool,
}

impl OnSkin {
    /// Where it is, so far out of the skin, metres.
    pub fn over(&self, out: f64, model: &ModelPose) -> DVec3 {
        let all = self.landmarks.iter().map(|l| l.position(model) + l.normal(model) * out);
        all.sum::<DVec3>() / self.landmarks.len().max(1) as f64
    }
}

/// The places of the skin on a signer's body: each with its sides, halfway between two of its sides, and on the trunk halfway to the
/// next one.
pub(super) fn places<'l>(signer: &Signer, rows: impl Iterator<Item = &'l Location>) -> Vec<OnSkin> {
    let mut all = Vec::new();
    let mut above: Option<&Location> = None;
    let landmark = |row: &Location, lateral| signer.landmarks.body_place(&row.id, lateral).ok();
    for row in rows {
        let is_region = row.space.is_some();
        let place = |row: &Location| Place::Body(row.id.clone());
        for lateral in laterals() {
            let own = landmark(row, lateral);
            all.extend(own.map(|l| OnSkin { place: place(row), lateral, landmarks: vec![l], is_region }));
            // The tops of the shoulders lie beside the others.
            let next = above.filter(|a| is_region && a.space.is_some() && row.id != "shouldertop");
            if let Some((other, landmarks)) =
                next.and_then(|a| Some((a, vec![landmark(a, lateral)?, landmark(row, lateral)?])))
            {
                let half = |row: &Location| Box::new(Sited { place: place(row), lateral });
                let place = Place::Between(half(other), half(row));
                all.push(OnSkin { place, lateral: None, landmarks, is_region });
            }
        }
        for (a, b) in halves() {
            let half = |lateral| Box::new(Sited { place: place(row), lateral });
            let both = landmark(row, a).zip(landmark(row, b)).map(|(a, b)| vec![a, b]);
            let place = Place::Between(half(a), half(b));
            all.extend(both.map(|landmarks| OnSkin { place, lateral: None, landmarks, is_region }));
        }
        if row.id != "shouldertop" {
            above = Some(row);
        }
    }
    all
}

impl Placer<'_> {
    /// How far out of the skin `close` is, metres.
    pub(super) fn close(&self) -> f64 {
        CLOSE_ARMS * self.signer.landmarks.arm_length()
    }

    /// A hand that touches the skin of trunk or head: the place, and how far it is off, metres. `all` are points of the hand that may
    /// touch besides its own.
    pub(super) fn touching(
        &self,
        (own, own_at): (HandPoint, DVec3),
        all: &[(HandPoint, DVec3)],
        model: &ModelPose,
    ) -> Option<(Placed, f64)> {
        let mut best: Option<(f64, f64, Placed)> = None;
        let mut offer = |cost: f64, off: f64, with: HandPoint, on: &OnSkin| {
            if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                let placement =
                    Placement { lateral: on.lateral, distance: Distance::Touch, ..Placement::at(on.place.clone()) };
                best = Some((cost, off, Placed::at(placement, with)));
            }
        };
        for on in &self.skin {
            let at = on.over(0.0, model);
            let halfway = if on.landmarks.len() > 1 { HALFWAY_M } else { 0.0 };
            let off = own_at.distance(at);
            if off < TOUCHES_M {
                offer(off + halfway, off, own, on);
            }
            for (point, there) in all {
                let off = there.distance(at);
                if off + NOT_ITS_OWN_M < TOUCHES_M {
                    offer(off + NOT_ITS_OWN_M + halfway, off, *point, on);
                }
            }
        }
        best.map(|(_, off, placed)| (placed, off))
    }

    /// A hand that is close to a place of the skin that is no region: the place, how far it is off, metres, and the same with what
    /// makes the place less likely.
    pub(super) fn close_to(
        &self,
        (own, own_at): (HandPoint, DVec3),
        all: &[(HandPoint, DVec3)],
        model: &ModelPose,
    ) -> Option<(Placed, f64, f64)> {
        let mut best: Option<(f64, f64, Placed)> = None;
        for on in self.skin.iter().filter(|on| !on.is_region) {
            let at = on.over(self.close(), model);
            let halfway = if on.landmarks.len() > 1 { HALFWAY_M } else { 0.0 };
            let others = all.iter().map(|(point, there)| (*point, there.distance(at), NOT_ITS_OWN_M, OTHERS_CLOSE_M));
            for (with, off, aside, least) in std::iter::once((own, own_at.distance(at), 0.0, CLOSE_M)).chain(others) {
                let cost = off + halfway + aside;
                if off < least && best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                    let placement =
                        Placement { lateral: on.lateral, distance: Distance::Close, ..Placement::at(on.place.clone()) };
                    best = Some((cost, off, Placed::at(placement, with)));
                }
            }
        }
        best.map(|(cost, off, placed)| (placed, off, cost))
    }
}
