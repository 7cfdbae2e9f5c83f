//! How far two profiles of the same points lie apart, and whether that is within a tolerance.
//!
//! # Conventions
//! The golden profile's instants count; the other one is read off between its own samples, and stands still after its end.

use super::curve::{Curve, Measure, Profile};
use crate::diagnostics::Error;
use crate::time::Seconds;
use std::fmt;
use std::str::FromStr;

/// How far apart is near enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// In the curve's unit.
    Absolute(f64),
    /// A share of the golden curve's range, 0.05 for 5 %.
    OfRange(f64),
}

impl Tolerance {
    /// The tolerance for a golden curve, in its unit.
    pub fn of(self, golden: &Curve) -> f64 {
        match self {
            Tolerance::Absolute(value) => value,
            Tolerance::OfRange(share) => share * golden.range(),
        }
    }
}

impl FromStr for Tolerance {
    type Err = Error;

    /// Reads `0.02` (in the curve's unit) or `5%` (of the golden curve's range).
    ///
    /// ```
    /// use chereme::motion::difference::Tolerance;
    /// assert_eq!("0.02".parse(), Ok(Tolerance::Absolute(0.02)));
    /// assert_eq!("5%".parse(), Ok(Tolerance::OfRange(0.05)));
    /// assert!("-1".parse::<Tolerance>().is_err());
    /// ```
    fn from_str(text: &str) -> Result<Tolerance, Error> {
        let (number, share) = match text.trim().strip_suffix('%') {
            Some(number) => (number.trim_end(), true),
            None => (text.trim(), false),
        };
        match number.parse::<f64>() {
            Ok(value) if value.is_finite() && value >= 0.0 && share => Ok(Tolerance::OfRange(value / 100.0)),
            Ok(value) if value.is_finite() && value >= 0.0 => Ok(Tolerance::Absolute(value)),
            _ => Err(Error::new(format!(
                "`{text}` is no tolerance; expected a number in the curve's unit such as 0.02, or a share of its range such as 5%"
            ))),
        }
    }
}

/// Where a curve lies farthest from its golden one.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The curve in words, as [`Curve::name`].
    pub curve: String,
    /// Its measure.
    pub measure: Measure,
    /// When.
    pub time: Seconds,
    /// The golden value then, in the measure's unit.
    pub golden: f64,
    /// The value found then.
    pub found: f64,
    /// How far apart the two may be, in the measure's unit.
    pub tolerance: f64,
}

impl Difference {
    /// How far apart, in the measure's unit.
    pub fn size(&self) -> f64 {
        (self.found - self.golden).abs()
    }

    /// Whether it is more than the tolerance.
    pub fn is_fault(&self) -> bool {
        self.size() > self.tolerance
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = self.measure.unit();
        write!(
            f,
            "{} at {}: {:.3} {unit} instead of {:.3} {unit}, {:.3} {unit} apart (tolerance {:.3})",
            self.curve,
            self.time,
            self.found,
            self.golden,
            self.size(),
            self.tolerance
        )
    }
}

/// What came of comparing a profile with its golden one.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The largest difference of each golden curve, the worst first (measured in its tolerance).
    pub differences: Vec<Difference>,
    /// The golden duration and the one found, where they differ by more than a sample of the golden profile.
    pub durations: Option<(Seconds, Seconds)>,
}

impl Comparison {
    /// Whether a curve or the duration differs by more than it may.
    pub fn is_fault(&self) -> bool {
        self.durations.is_some() || self.differences.iter().any(Difference::is_fault)
    }
}

/// Compares each golden curve with the other profile's curve of the same point, reference and measure.
///
/// # Errors
/// A golden curve that is not in the other profile.
///
/// ```
/// use chereme::motion::curve::{Curve, Measure, Profile, Reference};
/// use chereme::motion::difference::{Tolerance, compare};
/// use chereme::time::Seconds;
/// let profile = |height| {
///     let values = vec![0.0, height, 0.0];
///     let curve = Curve { point: "RightHand".into(), reference: Reference::Floor, measure: Measure::Height, values };
///     Profile::new(vec![Seconds(0.0), Seconds(0.1), Seconds(0.2)], vec![curve]).unwrap()
/// };
/// let worst = &compare(&profile(1.0), &profile(1.03), |_| Tolerance::Absolute(0.02)).unwrap().differences[0];
/// assert!(worst.is_fault() && worst.time == Seconds(0.1) && (worst.size() - 0.03).abs() < 1e-12);
/// ```
pub fn compare(
    golden: &Profile,
    found: &Profile,
    tolerance: impl Fn(Measure) -> Tolerance,
) -> Result<Comparison, Error> {
    let mut differences = Vec::new();
    for curve in golden.curves() {
        let other = found.like(curve).ok_or_else(|| Error::new(format!("there is no curve {}", curve.name())))?;
        let apart = |(i, time): (usize, &Seconds)| (i, (found.at(other, *time) - curve.values[i]).abs());
        let farthest = golden.times().iter().enumerate().map(apart).reduce(|a, b| if b.1 > a.1 { b } else { a });
        let Some((i, _)) = farthest else { continue };
        let time = golden.times()[i];
        differences.push(Difference {
            curve: curve.name(),
            measure: curve.measure,
            time,
            golden: curve.values[i],
            found: found.at(other, time),
            tolerance: tolerance(curve.measure).of(curve),
        });
    }
    let badness = |d: &Difference| d.size() / d.tolerance.max(1e-12);
    differences.sort_by(|a, b| badness(b).total_cmp(&badness(a)));
    let (lasts, last) = (golden.duration(), found.duration());
    let sample = lasts.0 / (golden.times().len() - 1).max(1) as f64;
    let durations = ((lasts.0 - last.0).abs() > sample + 1e-9).then_some((lasts, last));
    Ok(Comparison { differences, durations })
}
