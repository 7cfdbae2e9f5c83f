//! The phases of a sign in time: stillness, preparation, stroke, hold, retraction, stillness.

use super::plan::HandPlan;
use crate::phonology::movement_table::Timing;

/// Instants in seconds from the clip's start.
#[derive(Debug, Clone, PartialEq)]
pub struct Timeline {
    /// Preparation begins.
    pub start: f64,
    /// The stroke begins; the first key.
    pub stroke: f64,
    /// The instants of the N + 1 keys.
    pub keys: Vec<f64>,
    /// The hold at the end of the stroke ends; the sign ends.
    pub hold_end: f64,
    /// Retraction ends.
    pub retracted: f64,
    /// The clip ends.
    pub end: f64,
}

impl Timeline {
    /// Lays out the phases. `preparation` and `retraction` are seconds; `speed` divides every time.
    pub fn new(
        plans: &[HandPlan],
        intervals: usize,
        timing: &Timing,
        preparation: f64,
        retraction: f64,
        speed: f64,
    ) -> Timeline {
        let start = timing.still / speed;
        let stroke = start + preparation / speed;
        let mut keys = vec![stroke];
        let mut at = stroke;
        for i in 0..intervals {
            let legs = plans.first().map(|p| &p.legs[..]).unwrap_or_default();
            at += legs.iter().filter(|l| l.interval == i).map(|l| l.leg.duration).sum::<f64>() / speed;
            keys.push(at);
        }
        let hold = if intervals == 0 { timing.posture } else { timing.final_hold };
        // A short sign is held longer at its end.
        let hold_end = (at + hold / speed).max(stroke + timing.least_sign / speed);
        let retracted = hold_end + retraction / speed;
        Timeline { start, stroke, keys, hold_end, retracted, end: retracted + timing.still / speed }
    }
}
