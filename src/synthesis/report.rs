//! What was measured while a plan was signed, and sentences for its author.

use super::prepare::Prepared;
use super::reach::ArmFrame;
use super::schedule::Times;
use super::stage::Stage;
use super::stroke::Stint;
use crate::diagnostics::Error;
use crate::phonology::Side;
use crate::time::{FrameIndex, Seconds};

/// Above this speed of the wrist a sign is at fault, metres a second.
const WRIST_SPEED_FAULT: f64 = 5.0;
/// A contact point farther than this from its target is worth a warning, metres.
const RESIDUAL_WARNED: f64 = 5e-3;
/// A hand turned farther than this from what is stated is worth a warning, radians.
const TILT_WARNED: f64 = 2.0 * std::f64::consts::PI / 180.0;
/// Signs of more intervals than this are spelled words or performances in a row, which take their time.
const LONG_SIGN: usize = 8;

/// What was measured while a plan was signed.
#[derive(Debug, Clone, Default)]
pub struct Report {
    /// When the first stroke begins, from the clip's start.
    pub stroke_start: Seconds,
    /// The instants of the signs' keys, from the clip's start.
    pub keys: Vec<Seconds>,
    /// When the last sign (stroke and hold) ends.
    pub sign_end: Seconds,
    /// When each item of the plan is signed.
    pub items: Vec<Times>,
    /// The greatest speed of a wrist, metres a second.
    pub wrist_speed: f64,
    /// The greatest distance of a contact point from its target during the strokes, metres.
    pub residual_m: f64,
    /// The greatest distance that a hand keeps from its stated way so that it stays out of the body, metres.
    pub aside_m: f64,
    /// How far a hand was turned away from the stated orientation by the wrist's limits, at most, radians.
    pub tilt: f64,
    /// Sentences for the author.
    pub warnings: Vec<String>,
}

impl Report {
    /// Notes what a hand's stroke came to, and warns of what a body cannot do. `whose` goes before each warning.
    pub(super) fn measure(&mut self, stage: &Stage, stint: &Stint, solved: &[ArmFrame], whose: &str) {
        let fps = stage.options.fps;
        let hand = match stint.side {
            Side::Left => "left",
            Side::Right => "right",
        };
        let by = |value: fn(&ArmFrame) -> f64| {
            let worst = solved.iter().enumerate().max_by(|a, b| value(a.1).total_cmp(&value(b.1)));
            worst.map(|(n, frame)| (fps.time_of(FrameIndex(stint.first + n)), frame))
        };
        if let Some((time, frame)) = by(|f| f.residual_m) {
            self.residual_m = self.residual_m.max(frame.residual_m);
            if frame.residual_m > RESIDUAL_WARNED {
                let mm = frame.residual_m * 1e3;
                self.warnings.push(format!(
                    "{whose}{hand} hand at {time}: out of reach, it stays {mm:.0} mm away from its place"
                ));
            }
        }
        if let Some((_, frame)) = by(|f| f.aside_m) {
            self.aside_m = self.aside_m.max(frame.aside_m);
        }
        if let Some((time, frame)) = by(|f| f.tilt) {
            self.tilt = self.tilt.max(frame.tilt);
            let complaint = super::limits(stage.options).and_then(|l| l.complaint(&frame.wanted));
            if let Some(complaint) = complaint.filter(|_| frame.tilt > TILT_WARNED) {
                let degrees = frame.tilt.to_degrees();
                self.warnings.push(format!(
                    "{whose}{hand} hand at {time}: {complaint}; it is turned {degrees:.0}° less than stated"
                ));
            }
        }
    }

    /// Warns of a sign that is too fast or too long.
    ///
    /// # Errors
    /// A stroke that is faster than anyone signs because its author says how long it lasts.
    pub(super) fn judge(
        &mut self,
        stage: &Stage,
        sign: &Prepared,
        times: &Times,
        stroke_speed: f64,
        whose: &str,
    ) -> Result<(), Error> {
        if stroke_speed > WRIST_SPEED_FAULT && sign.states_its_time {
            return Err(Error::new(format!(
                "the wrist would move at {stroke_speed:.1} m/s, faster than anyone signs: give it more time"
            )));
        }
        if stroke_speed > super::perform::WRIST_SPEED {
            self.warnings.push(format!("{whose}the wrist moves at {stroke_speed:.1} m/s; signers stay under 3"));
        }
        let whole = times.hold_end.0 - times.stroke.0;
        let greatest = stage.grammar.movements.timing.greatest_sign;
        if whole * stage.options.speed > greatest && sign.sign.intervals <= LONG_SIGN {
            self.warnings
                .push(format!("{whose}the sign lasts {whole:.1} s; signs rarely take more than {greatest:.0} s"));
        }
        Ok(())
    }
}
