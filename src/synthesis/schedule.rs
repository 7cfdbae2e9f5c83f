//! When each item of a plan is signed: what it takes (phases), and what it is given (times).
//!
//! [`super::measure`] says how long each phase of a plan usually and at least lasts; a song or another clock may then
//! allot times of its own, and [`super::render`] keeps them unchanged. Fluent signers who hurry shorten holds before
//! anything else (facts/phonology.md §5), so a hold's least time is often nothing.

use crate::diagnostics::Error;
use crate::time::Seconds;

/// How long a phase lasts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lasting {
    /// When nothing presses.
    pub usual: Seconds,
    /// At least: below it wrists would be faster than signers'.
    pub least: Seconds,
}

/// The phases of one item, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Phases {
    /// From where the hands were to the stroke's first posture.
    pub transition: Lasting,
    /// From the first key to the last; nothing for a sign without intervals.
    pub stroke: Lasting,
    /// The last posture held.
    pub hold: Lasting,
}

impl Phases {
    /// How long the item usually lasts, its transition included.
    pub fn usual(&self) -> Seconds {
        self.transition.usual + self.stroke.usual + self.hold.usual
    }

    /// How long the item lasts at least, its transition included.
    pub fn least(&self) -> Seconds {
        self.transition.least + self.stroke.least + self.hold.least
    }
}

/// What a plan takes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measured {
    /// Stillness before the first item and after the last.
    pub still: Seconds,
    /// One an item.
    pub items: Vec<Phases>,
    /// From the last posture back to the neutral pose.
    pub retraction: Lasting,
}

impl Measured {
    /// Every phase as long as it usually is, one after the other.
    pub fn schedule(&self) -> Schedule {
        let mut at = self.still;
        let items = self.items.iter().map(|phases| {
            let stroke = at + phases.transition.usual;
            let stroke_end = stroke + phases.stroke.usual;
            at = stroke_end + phases.hold.usual;
            Times { stroke, stroke_end, hold_end: at }
        });
        let items = items.collect();
        let retracted = at + self.retraction.usual;
        Schedule { start: self.still, items, retracted, end: retracted + self.still }
    }
}

/// When an item is signed, from the clip's start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Times {
    /// The first key: transition ends, stroke begins.
    pub stroke: Seconds,
    /// The last key: the stroke ends, the hold begins.
    pub stroke_end: Seconds,
    /// The hold ends; the next transition begins.
    pub hold_end: Seconds,
}

/// When a plan is signed, from the clip's start.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Schedule {
    /// The first preparation begins.
    pub start: Seconds,
    /// One an item.
    pub items: Vec<Times>,
    /// The hands are back at rest.
    pub retracted: Seconds,
    /// The clip ends.
    pub end: Seconds,
}

impl Schedule {
    /// The longest clip made, seconds: an hour.
    pub const LONGEST: Seconds = Seconds(3600.0);

    /// Checks a schedule that came from outside.
    ///
    /// # Errors
    /// A number of times that is not the number of items, instants that are not finite or go back, a clip of more than
    /// an hour.
    pub fn check(&self, items: usize) -> Result<(), Error> {
        if self.items.len() != items {
            return Err(Error::new(format!("{} items have {} times", items, self.items.len())));
        }
        let inner = self.items.iter().flat_map(|t| [t.stroke, t.stroke_end, t.hold_end]);
        let all: Vec<f64> = [Seconds(0.0), self.start]
            .into_iter()
            .chain(inner)
            .chain([self.retracted, self.end])
            .map(|s| s.0)
            .collect();
        if let Some(bad) = all.windows(2).find(|w| !(w[0].is_finite() && w[1].is_finite() && w[0] <= w[1] + 1e-9)) {
            return Err(Error::new(format!("the times go from {:.3} s back to {:.3} s", bad[0], bad[1])));
        }
        if self.end > Schedule::LONGEST {
            return Err(Error::new(format!("the clip would last {}; an hour is the most", self.end)));
        }
        Ok(())
    }
}
