//! The short arc between two rotations, prepared once for many samples.
//!
//! [`super::easing::slerp`] finds angle and axis anew at each call; a clip samples the same arc at every frame.

use super::easing::{Easing, sum};
use super::rotation::{to_vector, unit};
use glam::DQuat;

/// From one rotation to another, the short way about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortArc {
    from: DQuat,
    to: DQuat,
    /// Half the turn, about its axis in the axes of `from`.
    half: glam::DVec3,
    half_angle: f64,
}

impl ShortArc {
    /// The arc between two unit quaternions (`q` and `−q` are one rotation).
    pub fn new(from: DQuat, to: DQuat) -> ShortArc {
        let to = if from.dot(to) < 0.0 { -to } else { to };
        let turn = if from == to { glam::DVec3::ZERO } else { to_vector(unit(from.conjugate() * to)) / 2.0 };
        let half_angle = turn.length();
        let half = if half_angle > 1e-9 { turn / half_angle } else { glam::DVec3::ZERO };
        ShortArc { from, to, half, half_angle }
    }

    /// The rotation at a share of the way, from 0 to 1; exact at both ends.
    ///
    /// ```
    /// use chereme::motion::{easing::slerp, rotation::angle_between, short_arc::ShortArc};
    /// use glam::DQuat;
    /// let (a, b) = (DQuat::from_rotation_x(0.3), DQuat::from_rotation_y(1.2));
    /// assert!(angle_between(ShortArc::new(a, b).at(0.4), slerp(a, b, 0.4)) < 1e-9);
    /// ```
    pub fn at(&self, weight: f64) -> DQuat {
        if weight <= 0.0 || self.half_angle <= 1e-9 {
            return self.from;
        }
        if weight >= 1.0 {
            return self.to;
        }
        let (sine, cosine) = (self.half_angle * weight).sin_cos();
        let turn = DQuat::from_xyzw(self.half.x * sine, self.half.y * sine, self.half.z * sine, cosine);
        self.from * turn
    }

    /// The rotation at a share of the time under an easing whose `weight` there is known; the paper's raw
    /// equations sum quaternions (Naert et al. 2021, equations 2 and 3).
    pub fn eased(&self, easing: Easing, weight: f64) -> DQuat {
        match easing {
            Easing::PaperCosine | Easing::PaperSigmoid => unit(sum(self.from, self.to, weight)),
            Easing::Sigmoid { .. } | Easing::Cosine | Easing::Linear | Easing::MinimumJerk => self.at(weight),
        }
    }
}
