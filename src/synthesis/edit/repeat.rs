//! Repetition: PUNIR twice is TRAVAIL (Naert et al. 2021, §6, figure 13).
//!
//! The paper adds "a short slerp interpolation" between the instances. Here the way from the end of one performance
//! to the start of the next is eased joint by joint over the gap. A gap too short for that way is made longer, to the
//! fewest frames in which no joint steps farther than it does anywhere within the clip.

use super::size::{About, Scaling, sized};
use super::wrists::Sides;
use super::{Extent, Way, continue_signs, fits, may_last, remade};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::easing::Easing;
use crate::motion::rotation::angle_between;
use crate::time::Seconds;

/// How a clip is repeated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Repetition {
    /// How many performances there are in all; 1 is the clip itself.
    pub times: u32,
    /// From the end of a performance to the start of the next; taken to whole frames, and longer where it must be.
    pub gap: Seconds,
    /// By how much each performance's wrist paths are larger than the one's before, about their mean place; 1 is the same.
    pub growth: f64,
    /// The hands whose paths grow.
    pub sides: Sides,
    /// The law of the ways between performances.
    pub easing: Easing,
}

impl Default for Repetition {
    /// Twice, with no gap where the clip's ends meet.
    fn default() -> Repetition {
        Repetition { times: 2, gap: Seconds(0.0), growth: 1.0, sides: Sides::Both, easing: Easing::default() }
    }
}

/// The clip performed several times: it lasts `times` durations and `times − 1` gaps.
///
/// With no gap, and ends that are one pose, the last frame of a performance is the first of the next.
///
/// # Errors
/// No performance at all, a gap that is no time, a result that is too long; with growth, a clip of another rig.
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let sign = chereme::notation::read("sign X\n configuration flat\n", &chereme::notation::Vocabulary::builtin(), "lsf");
/// # let clip = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap().track.clip;
/// let twice = edit::repeated(&clip, &signer, &edit::Repetition::default()).unwrap();
/// assert!((twice.duration().0 - 2.0 * clip.duration().0).abs() < 1e-9);
/// ```
pub fn repeated(clip: &Clip, signer: &Signer, how: &Repetition) -> Result<Clip, Error> {
    if how.times == 0 {
        return Err(Error::new("a sign is performed once at least"));
    }
    if !(how.gap.0.is_finite() && how.gap.0 >= 0.0) {
        return Err(Error::new("the gap between performances is no time"));
    }
    let length = (clip.frames().len() - 1) as f64;
    may_last(f64::from(how.times) * length + f64::from(how.times - 1) * how.gap.0 * clip.fps().get())?;
    let mut frames = clip.frames().to_vec();
    for n in 1..how.times {
        let larger = grown(clip, signer, how, n)?;
        let next = larger.as_ref().unwrap_or(clip).frames();
        // Bounded: a way needs at most some three times the frames that the clip itself takes between its ends.
        let gap = gap_frames(clip, &frames[frames.len() - 1], &next[0], how);
        may_last((frames.len() + gap + next.len()) as f64)?;
        join(&mut frames, next, gap, how.easing);
    }
    let kept = clip.frames().len();
    continue_signs(&mut frames, kept);
    Ok(remade(clip, frames))
}

/// How many frames lie between the last frame of one performance and the first of the next: 0 where they are one.
fn gap_frames(clip: &Clip, end: &Frame, start: &Frame, how: &Repetition) -> usize {
    let asked = (how.gap.0 * clip.fps().get()).round() as usize;
    let way = step(end, start);
    let pairs = clip.frames().windows(2).map(|pair| step(&pair[0], &pair[1]));
    let most = pairs.fold(Step::default(), |most, s| most.max(s));
    let fewest = most.frames_for(&way, how.easing);
    asked.max(fewest)
}

/// Appends a performance after an eased way of so many frames.
fn join(frames: &mut Vec<Frame>, next: &[Frame], gap: usize, easing: Easing) {
    let (Some(end), Some(start)) = (frames.last().cloned(), next.first()) else { return };
    let way = Way::new(&end, start, easing);
    frames.extend((1..gap).map(|i| way.at(i as f64 / gap as f64)));
    frames.extend_from_slice(if gap == 0 { &next[1..] } else { next });
}

/// The performance number `n`, from 0; `None` where it is the clip.
fn grown(clip: &Clip, signer: &Signer, how: &Repetition, n: u32) -> Result<Option<Clip>, Error> {
    if how.growth == 1.0 {
        return Ok(None);
    }
    fits(clip, signer)?;
    let scaling = Scaling { sides: how.sides, extent: Extent::whole(clip), about: About::Mean };
    let factor = how.growth.powf(f64::from(n));
    Ok(Some(sized(clip, signer, factor, &scaling)?.clip))
}

/// How far joints, root and face go from one frame to another: the greatest of each.
#[derive(Debug, Clone, Copy, Default)]
struct Step {
    turn: f64,
    root_m: f64,
    weight: f64,
}

impl Step {
    fn max(self, other: Step) -> Step {
        Step {
            turn: self.turn.max(other.turn),
            root_m: self.root_m.max(other.root_m),
            weight: self.weight.max(other.weight),
        }
    }

    /// The fewest frames for a way under an easing if no step may be larger than these.
    fn frames_for(&self, way: &Step, easing: Easing) -> usize {
        let parts = [(way.turn, self.turn), (way.root_m, self.root_m), (way.weight, self.weight)];
        // Below a micrometre or a microradian two ends are one; such a way needs no frames.
        let asked = parts.iter().filter(|(way, _)| *way > 1e-6);
        let share = asked.map(|(way, most)| most / way).fold(f64::INFINITY, f64::min);
        if share == f64::INFINITY {
            return 0;
        }
        let greatest = |n: usize| {
            let weights = (0..=n).map(|i| easing.weight(i as f64 / n as f64)).collect::<Vec<_>>();
            weights.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max)
        };
        // The steepest of the offered easings needs 12.5 times its mean speed; past that nothing can help.
        let bound = (13.0 / share).ceil().clamp(1.0, super::MOST_FRAMES as f64) as usize;
        let (mut low, mut high) = (1, bound);
        while low < high {
            let middle = low + (high - low) / 2;
            if greatest(middle) <= share { high = middle } else { low = middle + 1 }
        }
        low
    }
}

fn step(a: &Frame, b: &Frame) -> Step {
    let turns = a.pose.rotations.iter().zip(&b.pose.rotations).map(|(p, q)| angle_between(*p, *q));
    let weights = a.weights.iter().zip(&b.weights).map(|(p, q)| f64::from((p - q).abs()));
    Step {
        turn: turns.fold(0.0, f64::max),
        root_m: a.pose.root_model.distance(b.pose.root_model),
        weight: weights.fold(0.0, f64::max),
    }
}
