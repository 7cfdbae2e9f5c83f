//! How fast wrists are, and how long a sign takes.

use super::Checking;
use super::finding::{Finding, Kind, Worst};
use crate::phonology::Side;

/// A wrist above this speed is faster than signers usually are, metres a second.
const FAST: f64 = 3.0;
/// A wrist above this speed is faster than anyone signs, metres a second.
const TOO_FAST: f64 = 5.0;
/// The share that a speed measured from frame to frame may lie above the one that the synthesis keeps to.
const MEASURED: f64 = 1.02;
/// The shortest and the longest sign, seconds (docs/DESIGN.md, "How long does a sign take?").
const LASTS: [f64; 2] = [0.4, 4.0];
/// Signs of more intervals than this are spelled words or performances in a row, which take their time.
const LONG_SIGN: usize = 8;

impl Checking<'_> {
    /// Wrists that are too fast, and a sign that is too short or too long.
    pub(super) fn pace(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let fps = self.performance.track.clip.fps().get();
        for side in [Side::Left, Side::Right] {
            let wrist = self.signer.arm(side).hand;
            let (mut fast, mut too_fast) = (Worst::default(), Worst::default());
            for (number, pair) in self.frames.windows(2).enumerate() {
                let speed = pair[0].position(wrist).distance(pair[1].position(wrist)) * fps;
                fast.look(speed, FAST * MEASURED, number + 1, || "the wrist".into());
                too_fast.look(speed, TOO_FAST, number + 1, || "the wrist".into());
            }
            let gravest = match too_fast.finding(Kind::TooFast, Some(side), |frame| self.time_of(frame)) {
                Some(finding) => Some(finding),
                None => fast.finding(Kind::Fast, Some(side), |frame| self.time_of(frame)),
            };
            findings.extend(gravest);
        }
        findings.extend(self.lasting());
        findings
    }

    fn lasting(&self) -> Option<Finding> {
        let report = &self.performance.report;
        let lasts = (report.sign_end - report.stroke_start).0;
        let [least, most] = LASTS;
        let intervals: usize = self.sign.phases().map(|phase| phase.intervals).sum();
        let (kind, bound) = match lasts {
            short if short < least - 1e-6 => (Kind::Short, least),
            long if long > most && intervals <= LONG_SIGN => (Kind::Long, most),
            _ => return None,
        };
        let what = "stroke and hold".to_owned();
        Some(Finding { kind, side: None, time: report.stroke_start, measured: lasts, bound, what })
    }
}
