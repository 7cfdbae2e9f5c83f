//! Which interpolation moves as people do: slerp, cosine, sigmoid and minimum jerk against captured transitions (Naert et al. 2021,
//! §4.2 and §5.2, figures 6 and 10).
//!
//! A take is cut where its speed comes to rest ([`find`]); between the poses at both ends each interpolation takes the same way, and
//! only its timing differs ([`compare()`]). Errors are shares of the amplitude, so that large and small movements count alike; intervals
//! are bootstrapped over takes ([`summarise`]).
//!
//! # What to keep in mind
//! - Where rest begins decides what fits: a sigmoid that is cut where its speed falls to a share r of its peak is a sigmoid with
//!   k = 4 arcosh(1/√r): 8.7 for 5 %, 7.3 for 10 %, 10 for 2.7 %. So the fitted k belongs to the threshold, which is printed with it.
//!   A minimum-jerk movement cut at 5 % is nearer to the cosine (error 1.1 %) than to minimum jerk (2.0 %): the cut takes slow ends
//!   away, and so speaks against the interpolations that have them. [`Trim::AsCut`] cuts the interpolations by the same rule: then shapes
//!   are compared, and a sigmoid's k cannot be told from any greater one once both are cut.
//! - Sensors smooth, and so do we (both sides alike): a jerk that is shorter than the smoothing is not seen.
//! - The paper judged two gestures by eye. Here many are measured; results are printed whatever they say.

pub mod chart;
mod compare;
pub mod print;
mod summary;
mod timing;

pub use compare::{Closeness, Model, PROFILE, Transition, compare};
pub use summary::{Interval, Report, Row, summarise};
pub use timing::{Ends, Timing};

use super::kinematics::cut::transitions;
use super::kinematics::{Kind, Movement, distance, smoothed, speed};
use crate::time::Seconds;

/// What counts as a transition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rule {
    /// Rest is at most this share of the transition's own peak speed.
    pub rest: f64,
    /// Standard deviation of the Gaussian that speeds are smoothed by.
    pub smoothing: Seconds,
    /// The least amplitude of fingers, metres (mean of the fingertips).
    pub least_fingers: f64,
    /// The least amplitude of arms and hands, metres.
    pub least_arm: f64,
    /// The shortest and the longest duration.
    pub lasts: (Seconds, Seconds),
    /// The least share of the path that leads to its end: below it the motion goes out and back, or round.
    pub straightness: f64,
    /// Whether interpolations are trimmed as the motion is.
    pub trim: Trim,
}

/// What is held against the motion between the ends of a cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trim {
    /// The whole interpolation, as the paper did and as synthesis plays it.
    Whole,
    /// What is left of it where it is cut by the same rule.
    AsCut,
}

impl Default for Rule {
    fn default() -> Rule {
        Rule {
            rest: 0.05,
            smoothing: Seconds(0.02),
            least_fingers: 0.015,
            least_arm: 0.08,
            lasts: (Seconds(0.1), Seconds(2.0)),
            straightness: 0.75,
            trim: Trim::Whole,
        }
    }
}

impl Rule {
    /// What is held against the motion.
    pub fn ends(&self) -> Ends {
        match self.trim {
            Trim::Whole => Ends::Whole,
            Trim::AsCut => Ends::Cut(self.rest),
        }
    }
}

/// The transitions of a movement, compared with the interpolations.
///
/// ```
/// use chereme::evaluation::interpolation::{Model, Rule, find};
/// use chereme::evaluation::kinematics::Movement;
/// use chereme::{motion::easing::Easing, time::Fps};
/// use glam::DVec3;
/// let place = |i: i32| DVec3::X * 0.3 * Easing::MinimumJerk.weight(f64::from(i - 20) / 30.0);
/// let movement = Movement::of_path("take", Fps::DEFAULT, (0..70).map(place).collect()).unwrap();
/// let found = find(&movement, &Rule::default());
/// assert_eq!(found.len(), 1);
/// let error = |model: Model| found[0].models[model as usize].error;
/// assert!(error(Model::MinimumJerk) < error(Model::Slerp));
/// ```
pub fn find(movement: &Movement, rule: &Rule) -> Vec<Transition> {
    let smooth = smoothed(movement.frames(), movement.fps(), rule.smoothing);
    let cuts = transitions(&speed(&smooth, movement.fps()), rule.rest);
    let least = match movement.kind() {
        Kind::Fingers => rule.least_fingers,
        Kind::Reaching | Kind::Hand => rule.least_arm,
    };
    let counts = |start: usize, end: usize| {
        let lasts = (end - start) as f64 / movement.fps().get();
        let length: f64 = smooth[start..=end].windows(2).map(|pair| distance(&pair[0], &pair[1])).sum();
        let amplitude = distance(&smooth[start], &smooth[end]);
        (rule.lasts.0.0..=rule.lasts.1.0).contains(&lasts)
            && amplitude >= least
            && amplitude >= rule.straightness * length
    };
    let found = cuts.iter().filter(|cut| counts(cut.start, cut.end));
    found.filter_map(|cut| compare::compare_with(movement, cut.start, cut.end, rule.smoothing, rule.ends())).collect()
}
