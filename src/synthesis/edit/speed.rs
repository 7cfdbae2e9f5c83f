//! Faster and slower on the same path.

use super::{continue_signs, may_last, remade};
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::time::Seconds;

/// The clip at another speed: 2 is twice as fast, in half the time.
///
/// The frame rate stays; rotations between the source's frames are on their short arcs. Where the new duration is no
/// whole number of frames the last frame is held for the rest of one.
///
/// # Errors
/// A speed that does not lie between 0.05 and 20; a result that is too long.
///
/// ```
/// # use chereme::{motion::{clip::{Clip, Frame}, pose::LocalPose}, time::Fps};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let frames = vec![Frame { pose: LocalPose::rest(&signer.skeleton), weights: vec![0.0; signer.morphs.len()] }; 61];
/// # let clip = Clip::new(signer.skeleton.clone(), Fps::DEFAULT, signer.morphs.clone(), frames).unwrap();
/// let fast = chereme::synthesis::edit::at_speed(&clip, 2.0).unwrap();
/// assert_eq!(fast.duration().0, clip.duration().0 / 2.0);
/// ```
pub fn at_speed(clip: &Clip, factor: f64) -> Result<Clip, Error> {
    if !(0.05..=20.0).contains(&factor) {
        return Err(Error::new(format!("the speed {factor} does not lie between 0.05 and 20")));
    }
    let fps = clip.fps();
    let duration = Seconds(clip.duration().0 / factor);
    may_last(duration.0 * fps.get())?;
    let at = |i: usize| clip.sample(Seconds(i as f64 * factor / fps.get()));
    let mut frames: Vec<_> = (0..fps.frame_count(duration)).map(at).collect();
    continue_signs(&mut frames, 1);
    Ok(remade(clip, frames))
}
