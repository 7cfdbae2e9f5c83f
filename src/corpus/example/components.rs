//! A motion taken apart into what phonology takes apart, for takes that are compared as wholes.
//!
//! Of each hand there are three groups of numbers (its shape, where it looks, where its wrist is) and the rate at which each changes.
//! All are laid on as many frames, whatever the take's length, so that a slow signer is compared with a quick one; rates stay those of
//! real time.

use super::Motion;
use super::features::{DIMS_A_HAND, DIRECTION_DIMS, SHAPE_DIMS};
use crate::diagnostics::Error;

/// Frames of a take, whatever its length.
const FRAMES: usize = 20;
/// A rate is taken over so many of these frames on both sides.
const REACH: usize = 2;
/// Where the groups of a hand begin and end among its numbers: shape, directions, place. Its velocity is the rate of the last.
const GROUPS: [(usize, usize); 3] = [
    (0, SHAPE_DIMS),
    (SHAPE_DIMS, SHAPE_DIMS + DIRECTION_DIMS),
    (SHAPE_DIMS + DIRECTION_DIMS, SHAPE_DIMS + DIRECTION_DIMS + 3),
];

/// How much each counts: shape, directions, place, then their rates. The shape counts twice: it alone tells more glosses than any other.
pub(super) const WEIGHTS: [f64; 6] = [2.0, 1.0, 1.0, 1.0, 1.0, 1.0];

/// A take, component by component.
#[derive(Debug, Clone, PartialEq)]
pub struct Components {
    /// In the order of [`WEIGHTS`], each of [`FRAMES`] frames.
    pub(super) parts: [Motion; 6],
}

impl Components {
    /// The components of features as [`features_of`](super::features::features_of) takes them; the unit of none matters, so their weights
    /// do not matter unless they are 0.
    ///
    /// # Errors
    /// Rows that are not those of whole hands.
    ///
    /// ```
    /// use chereme::corpus::example::{Motion, components::Components, features::DIMS_A_HAND};
    /// use chereme::time::Fps;
    /// let motion = |dims: usize| Motion::new(Fps::DEFAULT, dims, &vec![0.5; 3 * dims]).unwrap();
    /// assert!(Components::of(&motion(2 * DIMS_A_HAND)).is_ok());
    /// assert!(Components::of(&motion(DIMS_A_HAND - 1)).is_err());
    /// ```
    pub fn of(motion: &Motion) -> Result<Components, Error> {
        if !motion.dims().is_multiple_of(DIMS_A_HAND) {
            return Err(Error::new(format!(
                "rows of {} numbers are not those of hands of {DIMS_A_HAND}",
                motion.dims()
            )));
        }
        let last = motion.len() - 1;
        let rows: Vec<Vec<f32>> =
            (0..FRAMES).map(|k| row_at(motion, (k * last) as f64 / (FRAMES - 1) as f64)).collect();
        // A take of one frame does not move, whatever the step.
        let step = last as f64 / (FRAMES - 1) as f64 / motion.fps().get();
        let rates: Vec<Vec<f32>> = (0..FRAMES).map(|k| rate_at(&rows, k, step)).collect();
        let part = |rows: &[Vec<f32>], (from, to): (usize, usize)| {
            let hands =
                |row: &Vec<f32>| row.chunks_exact(DIMS_A_HAND).flat_map(|h| h[from..to].to_vec()).collect::<Vec<_>>();
            let values: Vec<f32> = rows.iter().flat_map(hands).collect();
            Motion::new(motion.fps(), values.len() / FRAMES, &values)
        };
        let [shape, directions, place] = GROUPS;
        let parts = [
            part(&rows, shape)?,
            part(&rows, directions)?,
            part(&rows, place)?,
            part(&rates, shape)?,
            part(&rates, directions)?,
            part(&rates, place)?,
        ];
        Ok(Components { parts })
    }
}

/// The numbers at a time in frames, straight between two frames.
fn row_at(motion: &Motion, at: f64) -> Vec<f32> {
    let before = (at.floor() as usize).min(motion.len() - 1);
    let after = (before + 1).min(motion.len() - 1);
    let w = (at - before as f64) as f32;
    motion.row(before).iter().zip(motion.row(after)).map(|(a, b)| a * (1.0 - w) + b * w).collect()
}

/// How fast the numbers of a frame change, a second.
fn rate_at(rows: &[Vec<f32>], frame: usize, step: f64) -> Vec<f32> {
    let (before, after) = (frame.saturating_sub(REACH), (frame + REACH).min(rows.len() - 1));
    let time = (after - before) as f64 * step;
    let rate = |(a, b): (&f32, &f32)| if time > 0.0 { (f64::from(b - a) / time) as f32 } else { 0.0 };
    rows[before].iter().zip(&rows[after]).map(rate).collect()
}
