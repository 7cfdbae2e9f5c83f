//! Queries by example: where in recorded motion is something like this?
//!
//! A motion becomes a row of numbers a frame ([`features`]), the example is warped in time over the recordings ([`warp`]), and the
//! stretches that are nearest come back, ranked. The same features, each component for
//! itself ([`components`]), tell which gloss a take is likely to be ([`neighbours`]).
//!
//! # Conventions
//! Distances are those of features: about 1 where hands differ as two handshapes, two orientations or two places do, 0 where nothing
//! differs; there is no upper end.

pub mod components;
pub mod features;
pub mod neighbours;
pub mod warp;

use crate::diagnostics::Error;
use crate::time::{Fps, FrameIndex, Seconds};

/// How many numbers of a frame are taken together; rows are filled up with zeros to a multiple of it.
const LANES: usize = 8;

/// Features over time: a row of numbers a frame, at a steady rate.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    fps: Fps,
    dims: usize,
    /// Rows of `stride` numbers; all finite.
    values: Vec<f32>,
    stride: usize,
}

impl Motion {
    /// A motion of rows of `dims` numbers each, one after the other.
    ///
    /// # Errors
    /// No dimension, a last row that is not whole, no row, a number that is not finite.
    ///
    /// ```
    /// use chereme::corpus::example::Motion;
    /// use chereme::time::Fps;
    /// let motion = Motion::new(Fps::DEFAULT, 2, &[0.0, 1.0, 0.5, 1.0]).unwrap();
    /// assert_eq!((motion.len(), motion.row(1)), (2, &[0.5, 1.0][..]));
    /// assert!(Motion::new(Fps::DEFAULT, 2, &[0.0, 1.0, 0.5]).is_err());
    /// ```
    pub fn new(fps: Fps, dims: usize, values: &[f32]) -> Result<Motion, Error> {
        if dims == 0 || values.is_empty() || !values.len().is_multiple_of(dims) {
            return Err(Error::new(format!("{} numbers are no rows of {dims}", values.len())));
        }
        if let Some(at) = values.iter().position(|v| !v.is_finite()) {
            return Err(Error::new(format!("number {} of frame {} is not finite", at % dims, at / dims)));
        }
        let stride = dims.next_multiple_of(LANES);
        let mut padded = Vec::with_capacity(values.len() / dims * stride);
        for row in values.chunks_exact(dims) {
            padded.extend_from_slice(row);
            padded.resize(padded.len() + stride - dims, 0.0);
        }
        Ok(Motion { fps, dims, values: padded, stride })
    }

    /// Frames per second.
    pub fn fps(&self) -> Fps {
        self.fps
    }

    /// Numbers a frame.
    pub fn dims(&self) -> usize {
        self.dims
    }

    /// How many frames there are; at least one.
    pub fn len(&self) -> usize {
        self.values.len() / self.stride
    }

    /// Whether there is no frame (never).
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The numbers of a frame.
    pub fn row(&self, frame: usize) -> &[f32] {
        &self.padded(frame)[..self.dims]
    }

    /// The numbers of a frame with zeros up to whole lanes.
    fn padded(&self, frame: usize) -> &[f32] {
        &self.values[frame * self.stride..(frame + 1) * self.stride]
    }

    /// The frames from one up to another (not included), within the motion; `None` where there are none.
    pub fn part(&self, from: usize, to: usize) -> Option<Motion> {
        let (from, to) = (from.min(self.len()), to.min(self.len()));
        (from < to).then(|| Motion { values: self.values[from * self.stride..to * self.stride].to_vec(), ..*self })
    }
}

/// A stretch of a recording that is like the example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The number of the recording in the list.
    pub recording: usize,
    /// When it begins.
    pub start: Seconds,
    /// When it ends.
    pub end: Seconds,
    /// The mean distance of the example's frames from those that they are laid on.
    pub distance: f64,
}

/// The stretches that are most like an example, nearest first; of one recording no two overlap.
///
/// # Errors
/// Recordings of other dimensions or another frame rate than the example.
///
/// ```
/// use chereme::corpus::example::{Motion, search};
/// use chereme::time::{Fps, Seconds};
/// let of = |values: &[f32]| Motion::new(Fps::new(10.0).unwrap(), 1, values).unwrap();
/// let (bump, long) = (of(&[0.0, 1.0, 0.0]), of(&[5.0, 5.0, 0.0, 1.0, 0.0, 5.0]));
/// let found = search(&bump, &[long], 1).unwrap();
/// assert_eq!((found[0].start, found[0].end, found[0].distance), (Seconds(0.2), Seconds(0.4), 0.0));
/// ```
pub fn search(example: &Motion, recordings: &[Motion], limit: usize) -> Result<Vec<Found>, Error> {
    let mut all: Vec<(usize, warp::Stretch)> = Vec::new();
    for (number, recording) in recordings.iter().enumerate() {
        if (recording.dims, recording.fps) != (example.dims, example.fps) {
            return Err(Error::new(format!(
                "recording {number} has {} numbers a frame at {} frames a second, the example {} at {}",
                recording.dims,
                recording.fps.get(),
                example.dims,
                example.fps.get()
            )));
        }
        all.extend(warp::stretches(example, recording).into_iter().map(|stretch| (number, stretch)));
    }
    all.sort_by(|(n, a), (m, b)| {
        a.distance.total_cmp(&b.distance).then(n.cmp(m)).then(a.start.cmp(&b.start)).then(a.end.cmp(&b.end))
    });
    let mut taken: Vec<(usize, warp::Stretch)> = Vec::new();
    for (number, stretch) in all {
        if taken.len() >= limit {
            break;
        }
        if !taken.iter().any(|(n, t)| *n == number && t.start <= stretch.end && stretch.start <= t.end) {
            taken.push((number, stretch));
        }
    }
    let time = |frame: usize| example.fps.time_of(FrameIndex(frame));
    let found = |(recording, stretch): (usize, warp::Stretch)| Found {
        recording,
        start: time(stretch.start),
        end: time(stretch.end),
        distance: f64::from(stretch.distance),
    };
    Ok(taken.into_iter().map(found).collect())
}
