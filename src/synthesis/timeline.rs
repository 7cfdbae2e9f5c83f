//! The instants of one sign in a clip: where its transition begins, its keys, and the end of its hold.

use super::prepare::Prepared;
use super::schedule::Times;

/// Instants in seconds from the clip's start.
#[derive(Debug, Clone, PartialEq)]
pub struct Timeline {
    /// The way to the stroke begins.
    pub start: f64,
    /// The stroke begins; the first key.
    pub stroke: f64,
    /// The instants of the N + 1 keys.
    pub keys: Vec<f64>,
    /// The hold at the end of the stroke ends; the sign ends.
    pub hold_end: f64,
    /// The whole sign ends: of a sign's first phase, the end of its last one.
    pub sign_end: f64,
}

impl Timeline {
    /// The instants of a sign that was given its times; `start` is where the hold of the item before ends.
    pub(super) fn new(prepared: &Prepared, start: f64, times: &Times) -> Timeline {
        let (stroke, stroke_end) = (times.stroke.0, times.stroke_end.0);
        let whole = prepared.natural();
        let mut keys = vec![stroke];
        let mut done = 0.0;
        for interval in 0..prepared.sign.intervals {
            done += prepared.interval(interval);
            let share = if whole > 0.0 { done / whole } else { 1.0 };
            keys.push(stroke + (stroke_end - stroke) * share);
        }
        Timeline { start, stroke, keys, hold_end: times.hold_end.0, sign_end: times.hold_end.0 }
    }

    /// The description's own time at an instant: 0 at the stroke's start, `natural` at its end.
    pub fn own_time(&self, instant: f64, natural: f64) -> f64 {
        let given = self.keys.last().copied().unwrap_or(self.stroke) - self.stroke;
        if given > 1e-9 { ((instant - self.stroke) / given * natural).max(0.0) } else { natural }
    }
}
