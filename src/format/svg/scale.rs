//! Scales with round numbers.

/// The shortest range that is drawn: below it curves are called level.
const LEAST: f64 = 1e-3;
/// Beyond this values are cut off.
const FARTHEST: f64 = 1e12;

/// A range of values on a range of pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
    step: f64,
}

impl Scale {
    /// A scale of the values from `low` to `high` on the pixels from `from` to `to`, with about `count` round ticks.
    pub fn new((low, high): (f64, f64), (from, to): (f64, f64), count: f64) -> Scale {
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let (low, high) = (low.clamp(-FARTHEST, FARTHEST), high.clamp(-FARTHEST, FARTHEST));
        // A level curve stands in the middle.
        let least = LEAST.max(1e-9 * low.abs().max(high.abs()));
        let room = (least - (high - low)).max(0.0) / 2.0;
        let (low, high) = (low - room, high + room);
        Scale { low, high, from, to, step: round_step((high - low) / count.max(1.0)) }
    }

    /// The same scale, begun and ended at ticks.
    pub fn rounded(mut self) -> Scale {
        // What lies on a tick up to rounding noise ends there.
        self.low = (self.low / self.step + 1e-6).floor() * self.step;
        self.high = (self.high / self.step - 1e-6).ceil() * self.step;
        self
    }

    /// The pixel of a value.
    pub fn at(&self, value: f64) -> f64 {
        let share = (value.clamp(-FARTHEST, FARTHEST) - self.low) / (self.high - self.low);
        self.from + (self.to - self.from) * share
    }

    /// The ticks: each value and its text, all with the same decimals.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let first = (self.low / self.step - 1e-6).ceil();
        let count = ((self.high / self.step + 1e-6).floor() - first).clamp(0.0, 40.0) as usize;
        let decimals = (-self.step.log10().floor()).clamp(0.0, 9.0) as usize;
        let text = |value: f64| match self.step >= 1e5 {
            true => format!("{value:e}"),
            // Zero has no sign.
            false => format!("{:.decimals$}", if value == 0.0 { 0.0 } else { value }),
        };
        (0..=count).map(|i| (first + i as f64) * self.step).map(|value| (value, text(value))).collect()
    }
}

/// Of 1, 2, 5 and 10 times a power of ten the one nearest to `size`, in ratio.
fn round_step(size: f64) -> f64 {
    let power = 10f64.powf(size.log10().floor());
    // The boundaries are the geometric means of neighbours.
    let step = match size / power {
        share if share < 2f64.sqrt() => 1.0,
        share if share < 10f64.sqrt() => 2.0,
        share if share < 50f64.sqrt() => 5.0,
        _ => 10.0,
    };
    step * power
}
