//! Where in time an edit holds, and how it comes and goes.

use crate::motion::clip::Clip;
use crate::motion::easing::Easing;
use crate::time::{FrameIndex, Seconds};

/// A stretch of a clip in which an edit holds fully; outside it comes and goes by an eased way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// From here on the edit holds.
    pub start: Seconds,
    /// Up to here the edit holds.
    pub end: Seconds,
    /// How long it comes, before the start; 0 is at once.
    pub coming: Seconds,
    /// How long it goes, after the end; 0 is at once.
    pub going: Seconds,
    /// The law of coming and going.
    pub easing: Easing,
}

impl Extent {
    /// A stretch that the edit enters and leaves at once.
    pub fn between(start: Seconds, end: Seconds) -> Extent {
        Extent { start, end, coming: Seconds(0.0), going: Seconds(0.0), easing: Easing::default() }
    }

    /// All of a clip.
    pub fn whole(clip: &Clip) -> Extent {
        Extent::between(Seconds(0.0), clip.duration())
    }

    /// The same stretch, eased over the given times before and after it.
    pub fn eased(self, coming: Seconds, going: Seconds) -> Extent {
        Extent { coming, going, ..self }
    }

    /// How much of the edit holds at an instant, from 0 to 1.
    ///
    /// ```
    /// use chereme::{synthesis::edit::Extent, time::Seconds};
    /// let extent = Extent::between(Seconds(1.0), Seconds(2.0)).eased(Seconds(0.5), Seconds(0.0));
    /// assert_eq!([0.5, 0.75, 1.0, 2.0, 2.1].map(|t| extent.weight(Seconds(t))), [0.0, 0.5, 1.0, 1.0, 0.0]);
    /// ```
    pub fn weight(&self, time: Seconds) -> f64 {
        // A frame that stands on a bound up to rounding noise stands on it.
        const NOISE: f64 = 1e-9;
        let outside = |by: f64, ease: f64| if by < ease { self.easing.weight(1.0 - by / ease) } else { 0.0 };
        if time.0 < self.start.0 - NOISE {
            outside(self.start.0 - time.0, self.coming.0)
        } else if time.0 > self.end.0 + NOISE {
            outside(time.0 - self.end.0, self.going.0)
        } else {
            1.0
        }
    }

    /// The weight at each frame of a clip.
    pub(in crate::synthesis) fn weights(&self, clip: &Clip) -> Vec<f64> {
        (0..clip.frames().len()).map(|i| self.weight(clip.fps().time_of(FrameIndex(i)))).collect()
    }
}
