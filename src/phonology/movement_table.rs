//! Default sizes of movements, and the one timing model of every notation (`grammar/movements.ron`).

use super::grammar::read_table;
use super::movement::{Extent, Size, WristMotion};
use crate::diagnostics::{Diagnostic, Source, Span};
use serde::Deserialize;

/// A number for each size.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BySize {
    small: f64,
    normal: f64,
    large: f64,
}

impl BySize {
    /// The number for a size.
    pub fn of(self, size: Size) -> f64 {
        match size {
            Size::Small => self.small,
            Size::Normal => self.normal,
            Size::Large => self.large,
        }
    }

    /// The number for an extent: by its size, or the metres it says.
    pub fn metres(self, extent: Extent) -> f64 {
        match extent {
            Extent::Size(size) => self.of(size),
            Extent::Metres(metres) => metres,
        }
    }

    fn sound(self) -> bool {
        [self.small, self.normal, self.large].iter().all(|v| v.is_finite() && *v > 0.0)
    }
}

/// The table of movements. Metres, seconds, degrees, hertz.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MovementTable {
    /// Length of a straight path or of an arc's chord, metres.
    pub straight: BySize,
    /// Radius of a circle, metres.
    pub circle_radius: BySize,
    /// Height of an arc's bend, as a part of its chord.
    pub arc_depth: BySize,
    /// Amplitude of waves along a path, metres.
    pub wave_amplitude: BySize,
    /// Waves on one path.
    pub waves: f64,
    /// Small movements of the wrist.
    pub wrist: WristTable,
    /// Playing fingers.
    pub wiggle: WiggleTable,
    /// Durations.
    pub timing: Timing,
}

/// Amplitudes of wrist movements, degrees to each side, and their frequency, hertz.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WristTable {
    nod: BySize,
    swing: BySize,
    twist: BySize,
    stir: BySize,
    /// Cycles a second.
    pub frequency: f64,
}

impl WristTable {
    /// Degrees to each side.
    pub fn amplitude(&self, motion: WristMotion, size: Size) -> f64 {
        match motion {
            WristMotion::Nod => self.nod,
            WristMotion::Swing => self.swing,
            WristMotion::Twist => self.twist,
            WristMotion::StirClockwise | WristMotion::StirCounterclockwise => self.stir,
        }
        .of(size)
    }
}

/// Playing fingers: amplitude at the knuckles, degrees, and frequency, hertz.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WiggleTable {
    /// Degrees from one extreme to the other.
    pub amplitude: f64,
    /// Cycles a second.
    pub frequency: f64,
}

/// The timing model; each field is explained where the table stands. Seconds and factors.
#[allow(missing_docs, reason = "the table in grammar/movements.ron says what each number is")]
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Timing {
    pub move_time: f64,
    pub length_exponent: f64,
    pub least: f64,
    pub arc: BySize,
    pub circle: f64,
    pub turn: f64,
    pub waves: f64,
    pub change: f64,
    pub hold: f64,
    pub wrist: f64,
    pub wiggle: f64,
    pub back: f64,
    pub again: f64,
    pub fast: f64,
    pub slow: f64,
    pub tense: f64,
    pub rest: f64,
    pub halt: f64,
    pub final_hold: f64,
    pub posture: f64,
    pub inner_hold: f64,
    pub inner_posture: f64,
    pub least_sign: f64,
    pub greatest_sign: f64,
    pub least_inner: f64,
    pub transition_least: f64,
    pub between_least: f64,
    pub transition_speed: f64,
    pub handshape_lead: f64,
    pub still: f64,
}

impl Timing {
    fn sound(&self) -> bool {
        let t = self;
        let positive = [
            t.move_time,
            t.least,
            t.circle,
            t.turn,
            t.waves,
            t.change,
            t.hold,
            t.wrist,
            t.wiggle,
            t.back,
            t.again,
            t.fast,
            t.slow,
            t.tense,
            t.final_hold,
            t.posture,
            t.inner_posture,
            t.least_sign,
            t.greatest_sign,
            t.least_inner,
            t.transition_least,
            t.between_least,
            t.transition_speed,
        ];
        let not_negative = [t.length_exponent, t.rest, t.halt, t.inner_hold, t.still];
        positive.iter().all(|v| v.is_finite() && *v > 0.0)
            && not_negative.iter().all(|v| v.is_finite() && *v >= 0.0)
            && t.handshape_lead > 0.0
            && t.handshape_lead <= 1.0
            && t.arc.sound()
    }
}

impl MovementTable {
    /// Reads and checks the table.
    ///
    /// # Errors
    /// The place where the text is not such a table; a number that is not finite or not above 0.
    pub fn read(source: &Source) -> Result<MovementTable, Diagnostic> {
        let table: MovementTable = read_table(source)?;
        let sizes = [table.straight, table.circle_radius, table.arc_depth, table.wave_amplitude].into_iter().chain([
            table.wrist.nod,
            table.wrist.swing,
            table.wrist.twist,
            table.wrist.stir,
        ]);
        let numbers = [table.waves, table.wrist.frequency, table.wiggle.amplitude, table.wiggle.frequency];
        let sound = sizes.into_iter().all(BySize::sound)
            && numbers.iter().all(|v| v.is_finite() && *v > 0.0)
            && table.timing.sound();
        if !sound {
            return Err(Diagnostic::fault(Span::default(), "a size or a time is not a number above 0")
                .hint("sizes are metres, times seconds, handshape_lead lies between 0 and 1"));
        }
        Ok(table)
    }

    /// The program's own table.
    ///
    /// ```
    /// use chereme::phonology::movement_table::MovementTable;
    /// assert!(MovementTable::embedded().timing.move_time > 0.0);
    /// ```
    pub fn embedded() -> MovementTable {
        let source = Source::new("grammar/movements.ron", include_str!("../../grammar/movements.ron"));
        MovementTable::read(&source).expect("the embedded table is read by a test")
    }
}
