//! FABRIK: forward and backward reaching inverse kinematics (Aristidou and Lasenby 2011).
//!
//! Naert et al. compute the pointing pose and every spatialized wrist with it ("Phonological
//! recombination", sections 4.1 and 4.2). Each iteration has two passes: from tip to base, the tip is put on the
//! target and each joint pulled along its bone; from base to tip, the base is put back and the joints follow.
//! [`solve_chain`] does that for any chain; [`solve_arm`] does the same iteration for shoulder, elbow and wrist,
//! in the plane that the elbow never leaves.
//!
//! # Conventions
//! Model space, metres, radians. Bone lengths are those of the start pose, and the result keeps them.
//! The swivel of the elbow is inherited from the start pose, so start from the source frame's pose rather than
//! from the last solution where the result must not depend on history.
//!
//! # Departs from the paper
//! - A chain that starts straight along the line to its target never converges: it is bent by [`PRE_BEND`] first,
//!   toward the [`Pole`].
//! - Limits act in the base-to-tip pass only: in both passes they make reachable targets fail.
//!
//! # What it refuses
//! Coordinates so large that squares overflow come back unmoved, as [`Outcome::Refused`]. Bones without length
//! and targets on the base are solved like any other.

mod arm;
mod chain;

pub use arm::solve_arm;
pub use chain::solve_chain;

use super::rotation::perpendicular;
use glam::DVec3;

/// How far a straight chain is bent before the first pass: 1°.
pub const PRE_BEND: f64 = std::f64::consts::PI / 180.0;

/// Where the elbow should point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Pole {
    /// Where the start pose has it; any side where that is straight.
    #[default]
    Inherited,
    /// Where the start pose has it; along this direction where that is straight (bent less than [`PRE_BEND`]).
    WhenStraight(DVec3),
    /// Along this direction, whatever the start pose.
    Always(DVec3),
}

/// Least and greatest inner angle between two bones (π is straight), radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InnerAngles {
    /// Fully flexed.
    pub least: f64,
    /// Fully stretched.
    pub greatest: f64,
}

/// What a solve may take and must keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The tip may end this far from the target, metres.
    pub tolerance_m: f64,
    /// Iterations (two passes each). 1 mm takes 4 on average, 74 at .99 of the reach.
    pub max_iterations: u32,
    /// Where the elbow should point.
    pub pole: Pole,
    /// Limits of every inner angle; `None` as in the paper.
    pub limits: Option<InnerAngles>,
}

impl Default for Options {
    fn default() -> Options {
        Options { tolerance_m: 1e-3, max_iterations: 100, pole: Pole::Inherited, limits: None }
    }
}

impl Options {
    /// Whether a start whose tip is on the target already is the answer.
    fn may_stay(&self) -> bool {
        self.limits.is_none() && !matches!(self.pole, Pole::Always(_))
    }
}

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The tip is within tolerance of the target.
    Converged,
    /// The target is beyond full stretch: the chain is straight toward it.
    TooFar,
    /// The target is nearer than full fold: the chain is folded toward it.
    TooNear,
    /// The limits keep the tip from the target; it is as near as they let it.
    Limited,
    /// The iterations ran out.
    IterationLimit,
    /// The coordinates are too large to compute with: nothing moved.
    Refused,
}

/// A solved chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution<J> {
    /// The joints from base to tip, model space, metres.
    pub joints: J,
    /// From the tip to the target, metres.
    pub residual_m: f64,
    /// Iterations done.
    pub iterations: u32,
    /// How it ended.
    pub outcome: Outcome,
}

impl<J> Solution<J> {
    /// Whether the tip is within tolerance of the target.
    pub fn converged(&self) -> bool {
        self.outcome == Outcome::Converged
    }
}

/// The side of `axis` on which the first bone bends: across the axis, a unit vector.
fn bend_side(across: DVec3, straight: bool, axis: DVec3, pole: Pole) -> DVec3 {
    match pole {
        Pole::Always(toward) => perpendicular(toward, axis),
        Pole::WhenStraight(toward) if straight => perpendicular(toward, axis),
        // Bent, so `across` is perpendicular already and far from zero.
        Pole::WhenStraight(_) | Pole::Inherited if !straight => across * (1.0 / across.length()),
        Pole::WhenStraight(_) | Pole::Inherited => perpendicular(across, axis),
    }
}

/// The direction nearest to `along` whose inner angle with the bone before (of direction `before`) is allowed.
fn within(before: DVec3, along: DVec3, limits: InnerAngles) -> DVec3 {
    let outer = 2.0 * (along - before).length().atan2((along + before).length());
    let inner = std::f64::consts::PI - outer;
    let ordered = limits.least <= limits.greatest;
    if !ordered || (limits.least..=limits.greatest).contains(&inner) {
        return along;
    }
    let outer = std::f64::consts::PI - inner.clamp(limits.least, limits.greatest);
    before * outer.cos() + perpendicular(along, before) * outer.sin()
}
