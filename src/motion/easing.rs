//! Easing: how the way from one pose to the next is spread over its time.
//!
//! Naert et al., "Phonological recombination", section 4.2, give three laws for a joint that turns from
//! `q_i` to `q_f` while a weight `w` runs from 0 to 1: slerp (equation 1), a cosine (2), a sigmoid (3).
//!
//! # Conventions
//! `w` is the share of the time, `weight(w)` the share of the way; both are 0 at the start and 1 at the
//! end, and `w` outside [0, 1] stands still at its end. A *rate* is weight per unit of `w`, so dividing
//! it by the duration gives shares of the way a second.
//!
//! # Departs from the paper
//! - Equation 3 runs from .0067 to .9933: playing it leaves a step of .67 % of the way at each key (a spike
//!   of .35 m/s at the wrist at 60 frames a second). [`Easing::Sigmoid`] is scaled to reach 0 and 1.
//! - Equations 2 and 3 are sums of quaternions, whose norm falls to cos(Ω/2) half-way. The default turns by
//!   slerp at the eased weight, at most .92° away for a turn of 90°.
//!
//! [`Easing::PaperCosine`] and [`Easing::PaperSigmoid`] are the printed equations, normalised after the sum.

use super::rotation::unit;
use crate::diagnostics::Error;
use glam::DQuat;
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// The paper's steepness of the sigmoid (equation 3).
pub const PAPER_STEEPNESS: f64 = 10.0;
/// The greatest steepness that text may ask for; above it the ends no longer move in `f64`.
pub const MAX_STEEPNESS: f64 = 50.0;

/// A law of motion between two poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Easing {
    /// The logistic curve of equation 3, scaled to run from 0 to 1; `k` is its steepness (the paper's is 10).
    /// A `k` near 0 is linear.
    Sigmoid {
        /// Steepness.
        k: f64,
    },
    /// Equation 2's weight, (1 − cos πw)/2, with slerp.
    Cosine,
    /// Equation 1: slerp at constant speed.
    Linear,
    /// 10w³ − 15w⁴ + 6w⁵, the least jerk from rest to rest (Flash and Hogan 1985).
    MinimumJerk,
    /// Equation 2 as printed: a sum of quaternions, normalised.
    PaperCosine,
    /// Equation 3 as printed: from .0067 to .9933, a sum of quaternions, normalised.
    PaperSigmoid,
}

impl Default for Easing {
    /// The sigmoid that the paper chose, scaled to reach its ends.
    fn default() -> Easing {
        Easing::Sigmoid { k: PAPER_STEEPNESS }
    }
}

impl Easing {
    /// The share of the way at the share `w` of the time.
    ///
    /// ```
    /// use chereme::motion::easing::Easing;
    /// assert_eq!(Easing::default().weight(0.0), 0.0);
    /// assert_eq!(Easing::default().weight(1.0), 1.0);
    /// assert!((Easing::default().weight(0.25) - 0.0701037).abs() < 1e-7);
    /// assert!((Easing::PaperSigmoid.weight(0.0) - 0.0066929).abs() < 1e-7);
    /// ```
    pub fn weight(self, w: f64) -> f64 {
        let w = w.clamp(0.0, 1.0);
        match self {
            Easing::Sigmoid { k } if is_flat(k) => w,
            // (s(w) − s(0)) / (1 − 2 s(0)) for the logistic s, written so that both ends are exact.
            Easing::Sigmoid { k } => 0.5 + 0.5 * (0.5 * k * (w - 0.5)).tanh() / (0.25 * k).tanh(),
            Easing::Cosine | Easing::PaperCosine => 0.5 * (1.0 - (w * PI).cos()),
            Easing::Linear => w,
            Easing::MinimumJerk => w * w * w * (10.0 + w * (6.0 * w - 15.0)),
            Easing::PaperSigmoid => 1.0 / (1.0 + (-PAPER_STEEPNESS * (w - 0.5)).exp()),
        }
    }

    /// The derivative of [`Easing::weight`]: the speed, in mean speeds.
    ///
    /// ```
    /// use chereme::motion::easing::Easing;
    /// assert!((Easing::default().rate(0.5) - 2.5339).abs() < 1e-3);
    /// assert!((Easing::MinimumJerk.rate(0.5) - 1.875).abs() < 1e-12);
    /// ```
    pub fn rate(self, w: f64) -> f64 {
        let w = w.clamp(0.0, 1.0);
        match self {
            Easing::Sigmoid { k } if is_flat(k) => 1.0,
            Easing::Sigmoid { k } => {
                let t = (0.5 * k * (w - 0.5)).tanh();
                0.25 * k * (1.0 - t * t) / (0.25 * k).tanh()
            }
            Easing::Cosine | Easing::PaperCosine => 0.5 * PI * (w * PI).sin(),
            Easing::Linear => 1.0,
            Easing::MinimumJerk => 30.0 * (w * (1.0 - w)).powi(2),
            Easing::PaperSigmoid => {
                let s = self.weight(w);
                PAPER_STEEPNESS * s * (1.0 - s)
            }
        }
    }

    /// The rotation at the share `w` of the time, on the short arc from `from` to `to`; a unit quaternion.
    ///
    /// ```
    /// use chereme::motion::easing::Easing;
    /// use chereme::motion::rotation::angle_between;
    /// use glam::DQuat;
    /// let quarter = DQuat::from_rotation_y(1.5);
    /// let half_way = Easing::default().ease_rotation(DQuat::IDENTITY, quarter, 0.5);
    /// assert!(angle_between(half_way, DQuat::from_rotation_y(0.75)) < 1e-9);
    /// ```
    pub fn ease_rotation(self, from: DQuat, to: DQuat, w: f64) -> DQuat {
        match self {
            Easing::PaperCosine | Easing::PaperSigmoid => unit(sum(unit(from), unit(to), self.weight(w))),
            Easing::Sigmoid { .. } | Easing::Cosine | Easing::Linear | Easing::MinimumJerk => {
                slerp(from, to, self.weight(w))
            }
        }
    }
}

/// 3x² − 2x³, level at both ends: for what comes and goes without being a stroke. `x` is clamped to [0, 1].
///
/// ```
/// use chereme::motion::easing::smoothstep;
/// assert_eq!([smoothstep(-1.0), smoothstep(0.5), smoothstep(2.0)], [0.0, 0.5, 1.0]);
/// ```
pub fn smoothstep(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Whether a steepness is too small (or no number), so that the curve is linear to the last digit that shows.
fn is_flat(k: f64) -> bool {
    k.is_nan() || k.abs() < 1e-6
}

/// The sum of quaternions of equations 2 and 3, before normalisation: (1 − weight)·from ± weight·to.
///
/// Half-way its norm is cos(Ω/2): the reason why it is normalised.
///
/// ```
/// use chereme::motion::easing::sum;
/// use glam::DQuat;
/// let raw = sum(DQuat::IDENTITY, DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2), 0.5);
/// assert!((raw.length() - 0.9239).abs() < 1e-4);
/// ```
pub fn sum(from: DQuat, to: DQuat, weight: f64) -> DQuat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    from * (1.0 - weight) + to * weight
}

/// Spherical linear interpolation along the short arc (equation 1); `weight` is clamped to [0, 1].
///
/// Returns `from` where the two are the same rotation (`q` and `−q` included).
///
/// ```
/// use chereme::motion::easing::slerp;
/// use glam::DQuat;
/// let q = DQuat::from_rotation_z(0.3);
/// assert_eq!(slerp(q, q, 0.7), q);
/// assert_eq!(slerp(q, -q, 0.7), q);
/// ```
pub fn slerp(from: DQuat, to: DQuat, weight: f64) -> DQuat {
    let (from, to) = (unit(from), unit(to));
    let to = if from.dot(to) < 0.0 { -to } else { to };
    let w = weight.clamp(0.0, 1.0);
    if from == to || w == 0.0 {
        return from;
    }
    // The angle from chord and bisector, exact for small turns where acos(dot) is not.
    let omega = 2.0 * (to - from).length().atan2((to + from).length());
    let sine = omega.sin();
    if sine < 1e-9 {
        return unit(from * (1.0 - w) + to * w);
    }
    unit(from * (((1.0 - w) * omega).sin() / sine) + to * ((w * omega).sin() / sine))
}

impl fmt::Display for Easing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Easing::Sigmoid { k } if *k == PAPER_STEEPNESS => f.write_str("sigmoid"),
            Easing::Sigmoid { k } => write!(f, "sigmoid:{k}"),
            Easing::Cosine => f.write_str("cosine"),
            Easing::Linear => f.write_str("linear"),
            Easing::MinimumJerk => f.write_str("minimum-jerk"),
            Easing::PaperCosine => f.write_str("paper-cosine"),
            Easing::PaperSigmoid => f.write_str("paper-sigmoid"),
        }
    }
}

impl FromStr for Easing {
    type Err = Error;

    /// Reads a name as [`fmt::Display`] writes it; `slerp` and `paper-slerp` are `linear`.
    ///
    /// ```
    /// use chereme::motion::easing::Easing;
    /// assert_eq!("sigmoid:8".parse(), Ok(Easing::Sigmoid { k: 8.0 }));
    /// let error = "sigmod".parse::<Easing>().unwrap_err();
    /// assert!(error.to_string().contains("minimum-jerk"));
    /// ```
    fn from_str(text: &str) -> Result<Easing, Error> {
        let name = text.trim().to_ascii_lowercase();
        match name.as_str() {
            "sigmoid" => return Ok(Easing::default()),
            "cosine" => return Ok(Easing::Cosine),
            "linear" | "slerp" | "paper-slerp" => return Ok(Easing::Linear),
            "minimum-jerk" => return Ok(Easing::MinimumJerk),
            "paper-cosine" => return Ok(Easing::PaperCosine),
            "paper-sigmoid" => return Ok(Easing::PaperSigmoid),
            _ => {}
        }
        let Some(steepness) = name.strip_prefix("sigmoid:") else {
            return Err(Error::new(format!(
                "there is no easing called `{text}`; expected sigmoid, sigmoid:K (K is the steepness, such as \
                 sigmoid:8), cosine, linear, minimum-jerk, paper-cosine or paper-sigmoid"
            )));
        };
        match steepness.trim().parse::<f64>() {
            Ok(k) if k > 0.0 && k <= MAX_STEEPNESS => Ok(Easing::Sigmoid { k }),
            _ => Err(Error::new(format!(
                "`{}` is not a steepness; expected a number above 0 and at most {MAX_STEEPNESS} (the paper's is \
                 {PAPER_STEEPNESS}), as in sigmoid:8",
                steepness.trim()
            ))),
        }
    }
}
