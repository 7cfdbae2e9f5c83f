//! Easings between the ends of a cut: whole, or cut by the rule that the motion was cut by.

use crate::motion::easing::Easing;

/// Which part of an easing stands between the ends of a cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ends {
    /// All of it.
    Whole,
    /// From where its rate rises above this share of its peak to where it falls below it.
    Cut(f64),
}

/// An easing, or the middle part of one, from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    easing: Easing,
    /// The share of the time that is cut away at either end.
    trim: f64,
}

impl Timing {
    /// The part of an easing; all of our easings are symmetric, rising to the middle.
    ///
    /// ```
    /// use chereme::evaluation::interpolation::{Ends, Timing};
    /// use chereme::motion::easing::Easing;
    /// let cut = Timing::of(Easing::MinimumJerk, Ends::Cut(0.1));
    /// assert_eq!([cut.weight(0.0), cut.weight(0.5), cut.weight(1.0)], [0.0, 0.5, 1.0]);
    /// assert!((cut.rate(0.0) / cut.rate(0.5) - 0.1).abs() < 1e-9);
    /// ```
    pub fn of(easing: Easing, ends: Ends) -> Timing {
        let trim = match ends {
            Ends::Whole => 0.0,
            Ends::Cut(rest) => crossing(easing, rest * easing.rate(0.5)),
        };
        Timing { easing, trim }
    }

    /// The share of the way at a share of the time.
    pub fn weight(self, w: f64) -> f64 {
        let below = self.easing.weight(self.trim);
        let weight = self.easing.weight(self.trim + w.clamp(0.0, 1.0) * (1.0 - 2.0 * self.trim));
        ((weight - below) / (1.0 - 2.0 * below)).clamp(0.0, 1.0)
    }

    /// The speed, in mean speeds.
    pub fn rate(self, w: f64) -> f64 {
        let inner = 1.0 - 2.0 * self.trim;
        self.easing.rate(self.trim + w.clamp(0.0, 1.0) * inner) * inner / (1.0 - 2.0 * self.easing.weight(self.trim))
    }
}

/// Where an easing's rate, rising from the start to the middle, crosses a value; 0 where it begins above.
fn crossing(easing: Easing, value: f64) -> f64 {
    if easing.rate(0.0) >= value {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 0.5);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if easing.rate(middle) < value { low = middle } else { high = middle }
    }
    low
}
