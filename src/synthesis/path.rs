//! The shapes that a hand draws: displacements over the time of one movement.
//!
//! # Conventions
//! A path starts at 0 and is given by a share of its own time, 0 to 1; displacements are metres in model
//! space. Straight strokes follow minimum jerk. Circles and ellipses are run through by angle at an even
//! rate (a harmonic ellipse has the speed ∝ curvature^(−1/3) of the two-thirds power law, facts §5), eased
//! at both ends.

use crate::motion::easing::{Easing, smoothstep};
use glam::DVec3;
use std::f64::consts::TAU;

/// A displacement over time.
#[derive(Debug, Clone, PartialEq)]
pub enum Path {
    /// No displacement.
    Still,
    /// Straight to a displacement.
    Straight(DVec3),
    /// Along an arc of a circle: the chord, and the height of the bend over its middle.
    Arc {
        /// From start to end.
        chord: DVec3,
        /// From the chord's middle to the arc's, across the chord.
        bend: DVec3,
    },
    /// Round a circle or ellipse.
    Round {
        /// From the centre to the clock's top (12).
        top: DVec3,
        /// From the centre to the clock's 3, as seen by one who looks along the axis.
        side: DVec3,
        /// Where it starts, radians clockwise from the top.
        start: f64,
        /// Turns, above 0.
        turns: f64,
        /// The size after one turn, against the size before it.
        growth: f64,
    },
    /// Waves across a path, none at its ends.
    Waves {
        /// Amplitude and direction.
        across: DVec3,
        /// How many.
        count: f64,
        /// Straight flanks (zigzag) rather than round ones.
        zigzag: bool,
    },
    /// At the same time.
    Sum(Vec<Path>),
    /// One after the other, each with its share of the time.
    Chain(Vec<(f64, Path)>),
    /// Each begins when the one before is half over.
    Fused(Vec<Path>),
    /// The same path from its end to its start, smaller or larger.
    Backwards(Box<Path>),
    /// The same path, smaller or larger.
    Scaled(f64, Box<Path>),
    /// A path that becomes larger or smaller while it is drawn.
    Swelling {
        /// The size at its start.
        from: f64,
        /// The size at its end.
        to: f64,
        /// The path.
        path: Box<Path>,
    },
    /// What a path draws between two shares of its time.
    Part(f64, f64, Box<Path>),
}

impl Path {
    /// The displacement at a share of the path's time.
    ///
    /// ```
    /// use chereme::synthesis::path::Path;
    /// use glam::DVec3;
    /// let up = Path::Straight(DVec3::Y * 0.12);
    /// assert_eq!(up.at(0.0), DVec3::ZERO);
    /// assert!((up.at(0.5).y - 0.06).abs() < 1e-12);
    /// assert_eq!(up.at(1.0), up.end());
    /// ```
    pub fn at(&self, share: f64) -> DVec3 {
        let share = share.clamp(0.0, 1.0);
        match self {
            Path::Still => DVec3::ZERO,
            Path::Straight(to) => *to * Easing::MinimumJerk.weight(share),
            Path::Arc { chord, bend } => arc(*chord, *bend, Easing::MinimumJerk.weight(share)),
            Path::Round { top, side, start, turns, growth } => {
                let turned = turns * even(share, *turns);
                let size = growth.powf(turned);
                let angle = start + TAU * turned;
                (*top * angle.cos() + *side * angle.sin()) * size - (*top * start.cos() + *side * start.sin())
            }
            Path::Waves { across, count, zigzag } => {
                let phase = (share * count).fract();
                let wave = if *zigzag { triangle(phase) } else { (TAU * phase).sin() };
                // Fades in and out over a sixth of the path, so that the ends are smooth.
                *across * wave * smoothstep(6.0 * share.min(1.0 - share))
            }
            Path::Sum(paths) => paths.iter().map(|p| p.at(share)).sum(),
            Path::Chain(parts) => {
                let whole: f64 = parts.iter().map(|(length, _)| length).sum();
                let mut left = share * whole;
                let mut displacement = DVec3::ZERO;
                for (length, path) in parts {
                    displacement += path.at(if *length > 0.0 { left / length } else { 1.0 });
                    left -= length;
                    if left <= 0.0 {
                        break;
                    }
                }
                displacement
            }
            Path::Fused(paths) => {
                let length = 2.0 / (paths.len() as f64 + 1.0);
                paths.iter().enumerate().map(|(i, p)| p.at((share - i as f64 * length / 2.0) / length)).sum()
            }
            Path::Backwards(path) => path.at(1.0 - share) - path.end(),
            Path::Scaled(factor, path) => path.at(share) * *factor,
            Path::Swelling { from, to, path } => path.at(share) * (from + (to - from) * share),
            Path::Part(from, to, path) => path.at(from + (to - from) * share) - path.at(*from),
        }
    }

    /// The displacement at the end.
    pub fn end(&self) -> DVec3 {
        self.at(1.0)
    }

    /// The length of the way, metres, by `steps` chords.
    pub fn length(&self, steps: usize) -> f64 {
        let steps = steps.max(1);
        let points = (0..=steps).map(|i| self.at(i as f64 / steps as f64));
        points.clone().zip(points.skip(1)).map(|(a, b)| a.distance(b)).sum()
    }

    /// Whether the path ends where it starts, within a millimetre.
    pub fn closes(&self) -> bool {
        self.end().length() < 1e-3
    }

    /// The path with each vector multiplied by `signs` (reflection at planes through the origin).
    pub fn reflected(&self, signs: DVec3) -> Path {
        let all = |paths: &[Path]| paths.iter().map(|p| p.reflected(signs)).collect();
        match self {
            Path::Still => Path::Still,
            Path::Straight(to) => Path::Straight(*to * signs),
            Path::Arc { chord, bend } => Path::Arc { chord: *chord * signs, bend: *bend * signs },
            Path::Round { top, side, start, turns, growth } => {
                Path::Round { top: *top * signs, side: *side * signs, start: *start, turns: *turns, growth: *growth }
            }
            Path::Waves { across, count, zigzag } => {
                Path::Waves { across: *across * signs, count: *count, zigzag: *zigzag }
            }
            Path::Sum(paths) => Path::Sum(all(paths)),
            Path::Chain(parts) => Path::Chain(parts.iter().map(|(l, p)| (*l, p.reflected(signs))).collect()),
            Path::Fused(paths) => Path::Fused(all(paths)),
            Path::Backwards(path) => Path::Backwards(Box::new(path.reflected(signs))),
            Path::Scaled(factor, path) => Path::Scaled(*factor, Box::new(path.reflected(signs))),
            Path::Swelling { from, to, path } => {
                Path::Swelling { from: *from, to: *to, path: Box::new(path.reflected(signs)) }
            }
            Path::Part(from, to, path) => Path::Part(*from, *to, Box::new(path.reflected(signs))),
        }
    }
}

/// A point of the circle's arc over `chord` whose middle is off by `bend`, at a share of its length.
fn arc(chord: DVec3, bend: DVec3, share: f64) -> DVec3 {
    let (length, height) = (chord.length(), bend.length());
    if length < 1e-9 || height < 1e-9 {
        return chord * share;
    }
    let (along, across) = (chord / length, bend / height);
    // The circle through both ends and the top of the bend.
    let radius = (length * length / 4.0 + height * height) / (2.0 * height);
    let half = (length / 2.0).atan2(radius - height);
    let angle = half * (2.0 * share - 1.0);
    along * (length / 2.0 + radius * angle.sin()) + across * (radius * angle.cos() - (radius - height))
}

/// An even run from 0 to 1 with soft ends; the more turns, the shorter the ends.
fn even(share: f64, turns: f64) -> f64 {
    let ramp = (0.45 / turns.max(1.0)).min(0.45);
    // Speed rises by a smooth step over `ramp`, stays, and falls likewise; its integral is closed.
    let rise = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        ramp * (x * x * x - x * x * x * x / 2.0)
    };
    let run = |s: f64| {
        let start = rise(s / ramp);
        let middle = (s.min(1.0 - ramp) - ramp).max(0.0);
        let end = if s > 1.0 - ramp { rise(1.0) - rise((1.0 - s) / ramp) } else { 0.0 };
        start + middle + end
    };
    run(share) / run(1.0)
}

/// A triangle wave over one cycle: 0, 1, 0, −1, 0.
fn triangle(phase: f64) -> f64 {
    if phase < 0.25 {
        4.0 * phase
    } else if phase < 0.75 {
        2.0 - 4.0 * phase
    } else {
        4.0 * phase - 4.0
    }
}
