//! Spatialization: a whole sign moved to another place (Naert et al. 2021, §4.1).
//!
//! The acting wrists move by one constant vector, from their mean place in the stroke (of the strong hand, or midway
//! between two acting ones) to the target; the hands keep their global orientation, and what relates them stays.
//!
//! # Departs from the paper
//! The paper states the target as a translation "at each frame" from the wrist's actual position, which would freeze
//! the sign at one point; one vector for the whole stroke keeps its movement.

use super::plan::WristPath;
use super::prepare::Prepared;
use super::schedule::Times;
use super::stage::Stage;
use super::stroke::{Body, Stint, Stroke};
use super::timeline::Timeline;
use crate::body::signer::Shoulder;
use crate::diagnostics::Error;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::phonology::{Place, Placement};
use crate::time::Seconds;
use glam::DVec3;

impl Stage<'_> {
    /// How far a planned sign is moved to be at a place: from its wrists' mean place, model space, metres.
    ///
    /// # Errors
    /// A place that the inventory lacks.
    pub(super) fn way_to(&self, prepared: &mut Prepared, place: &Place, paths: &[WristPath]) -> Result<DVec3, Error> {
        let placement = Placement::at(place.clone());
        let target = self.planner().place(&placement, prepared.sign, &mut prepared.known)?;
        let places = || paths.iter().flat_map(|path| &path.places);
        let mean = places().sum::<DVec3>() / places().count().max(1) as f64;
        Ok(target.position(&self.neutral_model) - mean)
    }

    /// Moves a planned sign by a vector, model space, metres; the wrists go their own ways.
    pub(super) fn relocate(&self, prepared: &mut Prepared, paths: Vec<WristPath>, by: DVec3) {
        for (hand, path) in prepared.hands.iter_mut().zip(paths) {
            hand.free_hand = false;
            hand.on_other_hand = false;
            hand.wrist_path = Some(path);
            hand.shift(by);
        }
    }

    /// The wrists' own ways where the description has them.
    pub(super) fn wrist_paths(&self, prepared: &Prepared) -> Vec<WristPath> {
        let citation = self.citation(prepared);
        let of = |joint| WristPath {
            places: citation.iter().map(|body| body.position(joint)).collect(),
            rotations: citation.iter().map(|body| body.rotation(joint)).collect(),
        };
        prepared.hands.iter().map(|hand| of(self.signer.arm(hand.side).hand)).collect()
    }

    /// The body in the stroke of a sign where its description has it, evenly over the stroke; one pose at least.
    fn citation(&self, prepared: &Prepared) -> Vec<ModelPose> {
        let natural = prepared.natural();
        let last = (natural * self.options.fps.get()).round() as usize;
        let mut poses: Vec<LocalPose> = vec![self.neutral.clone(); last + 1];
        // As many frames as fit, so that the last one is the stroke's end.
        let whole = Seconds(last as f64 / self.options.fps.get());
        let timeline =
            Timeline::new(prepared, 0.0, &Times { stroke: Seconds(0.0), stroke_end: whole, hold_end: whole });
        let raised = vec![[Shoulder::default(); 2]; poses.len()];
        for hand in &prepared.hands {
            let stint = Stint { side: hand.side, item: prepared.item, first: 0, last };
            let body = if hand.on_other_hand { Body::Moving } else { Body::Still };
            let stroke = Stroke { plan: hand, stint: &stint, timeline: &timeline, natural, body, raised: &raised };
            self.write_stroke(&stroke, &mut poses);
        }
        poses.iter().map(|pose| pose.to_model(&self.signer.skeleton)).collect()
    }
}
