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
    /// Moves a planned sign to a place.
    ///
    /// # Errors
    /// A place that the inventory lacks.
    pub(super) fn relocate(&self, prepared: &mut Prepared, place: &Place) -> Result<(), Error> {
        let target = self.planner().place(&Placement::at(place.clone()), prepared.sign)?.position(&self.neutral_model);
        let citation = self.citation(prepared);
        let paths: Vec<WristPath> = prepared
            .hands
            .iter()
            .map(|hand| {
                let joint = self.signer.arm(hand.side).hand;
                WristPath {
                    places: citation.iter().map(|body| body.position(joint)).collect(),
                    rotations: citation.iter().map(|body| body.rotation(joint)).collect(),
                }
            })
            .collect();
        let places = || paths.iter().flat_map(|path| &path.places);
        let by = target - places().sum::<DVec3>() / places().count().max(1) as f64;
        for (hand, path) in prepared.hands.iter_mut().zip(paths) {
            hand.free_hand = false;
            hand.on_other_hand = false;
            hand.wrist_path = Some(path);
            hand.shift(by);
        }
        Ok(())
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
