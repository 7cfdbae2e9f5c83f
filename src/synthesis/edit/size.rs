//! Larger and smaller: the wrist's path scaled about a place of its own.

use super::wrists::{HandKept, Moved, Sides, moved, paths};
use super::{Extent, fits};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::phonology::Side;
use glam::DVec3;

/// About which place a wrist's path grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum About {
    /// The wrist's mean place over the extent.
    #[default]
    Mean,
    /// Where the wrist is when the extent begins: a sign that starts at a contact keeps it.
    Start,
}

/// Which paths are scaled, when, and about what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    /// The hands that act. Each path is scaled about a place of its own, so where the hands are to each other changes.
    pub sides: Sides,
    /// Where in time; outside it the scaling comes and goes by an eased way.
    pub extent: Extent,
    /// The place that stays.
    pub about: About,
}

/// The clip with the paths of its acting wrists made larger (factor above 1) or smaller (below 1); hands keep their
/// rotation in model space.
///
/// # Errors
/// A clip of another rig; a factor that does not lie between 0 and 10.
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let text = "sign X\n configuration flat\n movement up 10cm\n";
/// # let sign = chereme::notation::read(text, &chereme::notation::Vocabulary::builtin(), "lsf");
/// # let made = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap();
/// # let (clip, report) = (made.track.clip, made.report);
/// use edit::{About, Extent, Scaling, Sides};
/// let extent = Extent::whole(&clip);
/// let how = Scaling { sides: Sides::Right, extent, about: About::Start };
/// let smaller = edit::sized(&clip, &signer, 0.5, &how).unwrap().clip;
/// let wrist = |clip: &chereme::motion::clip::Clip, t| {
///     clip.sample(t).pose.to_model(&signer.skeleton).position(signer.arm(chereme::phonology::Side::Right).hand)
/// };
/// let rises = |clip| wrist(clip, report.sign_end).y - wrist(clip, report.stroke_start).y;
/// assert!((rises(&smaller) / rises(&clip) - 0.5).abs() < 1e-3);
/// ```
pub fn sized(clip: &Clip, signer: &Signer, factor: f64, how: &Scaling) -> Result<Moved, Error> {
    if !(0.0..=10.0).contains(&factor) {
        return Err(Error::new(format!("the size {factor} does not lie between 0 and 10")));
    }
    fits(clip, signer)?;
    let weights = how.extent.weights(clip);
    let paths = paths(clip, signer, &[Side::Left, Side::Right]);
    let centres = [centre(&paths[0], &weights, how.about), centre(&paths[1], &weights, how.about)];
    moved(clip, signer, (how.sides, HandKept::Global), &how.extent, |side, wrist| {
        wrist + (wrist - centres[side as usize]) * (factor - 1.0)
    })
}

/// The place of a path that stays when it is scaled.
fn centre(path: &[DVec3], weights: &[f64], about: About) -> DVec3 {
    let held = || path.iter().zip(weights).filter(|(_, w)| **w >= 1.0).map(|(p, _)| *p);
    match about {
        About::Start => held().next().unwrap_or(path[0]),
        About::Mean => match held().count() {
            0 => path.iter().sum::<DVec3>() / path.len() as f64,
            n => held().sum::<DVec3>() / n as f64,
        },
    }
}
