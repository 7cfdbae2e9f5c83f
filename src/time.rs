//! Time, with its unit in the type.
//!
//! A sign is written in seconds, a song in beats, a clip in frames; mixing them up is the oldest
//! fault in the field ("did you supply event times in seconds?"), so each is a type.
//!
//! # Conventions
//! `t = 0` is the start of the clip. Frame `i` of a clip shows the instant `i / fps`.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::ops::{Add, Mul, Sub};

/// A duration or an instant, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default, Serialize, Deserialize)]
pub struct Seconds(pub f64);

impl Add for Seconds {
    type Output = Seconds;
    fn add(self, other: Seconds) -> Seconds {
        Seconds(self.0 + other.0)
    }
}

impl Sub for Seconds {
    type Output = Seconds;
    fn sub(self, other: Seconds) -> Seconds {
        Seconds(self.0 - other.0)
    }
}

impl Mul<f64> for Seconds {
    type Output = Seconds;
    fn mul(self, factor: f64) -> Seconds {
        Seconds(self.0 * factor)
    }
}

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.2} s", self.0)
    }
}

/// Frames per second: a finite number above 0 and at most [`Fps::MAX`].
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Fps(f64);

impl Fps {
    /// The greatest frame rate accepted.
    pub const MAX: f64 = 1000.0;
    /// The default of every output: 60 frames a second.
    pub const DEFAULT: Fps = Fps(60.0);

    /// A frame rate, or `None` where the number is not finite, not above 0 or above [`Fps::MAX`].
    ///
    /// ```
    /// use chereme::time::Fps;
    /// assert!(Fps::new(60.0).is_some());
    /// assert!(Fps::new(0.0).is_none());
    /// assert!(Fps::new(f64::NAN).is_none());
    /// ```
    pub fn new(frames_per_second: f64) -> Option<Fps> {
        (frames_per_second > 0.0 && frames_per_second <= Self::MAX).then_some(Fps(frames_per_second))
    }

    /// Frames per second, as a number.
    pub fn get(self) -> f64 {
        self.0
    }

    /// The instant that a frame shows.
    pub fn time_of(self, frame: FrameIndex) -> Seconds {
        Seconds(frame.0 as f64 / self.0)
    }

    /// The number of frames of a clip that covers `duration`, its first and last instants included.
    pub fn frame_count(self, duration: Seconds) -> usize {
        // A duration that is a whole number of frames up to rounding noise gets exactly that many.
        (duration.0.max(0.0) * self.0 - 1e-6).ceil().max(0.0) as usize + 1
    }
}

/// The number of a frame in a clip, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FrameIndex(pub usize);
