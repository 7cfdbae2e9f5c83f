//! The shape of a path: straight, with waves, an arc, or round a circle.
//!
//! What a hand draws in one move is held against each shape; the plainest one that it follows is named. Directions are the
//! nearest of the 26.

use crate::phonology::{Clock, Direction, Extent, Heading, Motion, Overlay, Size};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// A shorter way is none, metres.
pub(super) const LEAST_WAY_M: f64 = 0.018;
/// From this height of the bend on, against the chord, a way is an arc.
const BENT: f64 = 0.11;
/// From this turn about the middle on, a way is round: 285°.
const ROUND: f64 = 285.0 * PI / 180.0;
/// A way is round whose distance from the middle differs by less than this part of the radius, the root of the mean square.
const UNROUND: f64 = 0.3;
/// A narrower way is no ellipse: its short axis as a part of the long one.
const NARROWEST: f64 = 0.18;
/// From this short axis on, an ellipse is a circle.
const ROUND_ENOUGH: f64 = 0.75;
/// Nothing is round whose smaller radius is less, metres.
const LEAST_RADIUS_M: f64 = 0.008;
/// Waves are at least so high to each side, metres.
const WAVE_M: f64 = 0.004;
/// So many of them are waves.
const WAVES: usize = 3;

/// A way with its shape.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drawn {
    /// The shape.
    pub motion: Motion,
    /// From its start to its end, metres; of what is round, its axis with the length of the radius.
    pub chord: DVec3,
    /// How far the points are off the shape, the mean, metres.
    pub off: f64,
    /// The same as a part of the way's size (chord or radius), with something added for shapes that are less plain.
    pub unlike: f64,
}

/// How much plainer than an arc a straight way is, and than a straight way with waves.
const LESS_PLAIN: (f64, f64) = (0.02, 0.04);

/// The shape of a path; `None` where it is no way.
pub(super) fn shape_of(path: &[DVec3]) -> Option<Drawn> {
    let (first, last) = (*path.first()?, *path.last()?);
    let length: f64 = path.windows(2).map(|w| w[0].distance(w[1])).sum();
    if length < LEAST_WAY_M {
        return None;
    }
    let chord = last - first;
    if let Some(round) = round(path) {
        return Some(round);
    }
    let along = chord.try_normalize()?;
    let direction = Heading::Toward(Direction::nearest(along)?);
    // The side to which the path bends most, and how far each point is on that side.
    let across: Vec<DVec3> = path.iter().map(|p| (*p - first) - along * (*p - first).dot(along)).collect();
    let top = across.iter().copied().reduce(|a, b| if b.length_squared() > a.length_squared() { b } else { a })?;
    let to_top = top.normalize_or_zero();
    let heights: Vec<f64> = across.iter().map(|p| p.dot(to_top)).collect();
    let mean = |off: &dyn Fn(usize) -> f64| (0..path.len()).map(off).sum::<f64>() / path.len() as f64;
    let extent = Extent::Metres(chord.length());
    let waves = swings(&heights, WAVE_M);
    if waves >= WAVES && top.length() < 0.5 * chord.length() {
        let size = if top.length() < 0.015 {
            Size::Small
        } else if top.length() < 0.035 {
            Size::Normal
        } else {
            Size::Large
        };
        let motion = Motion::Straight { direction, extent, overlay: Some(Overlay::new(false, size)) };
        return Some(Drawn { motion, chord, off: 0.0, unlike: LESS_PLAIN.1 });
    }
    if top.length() > BENT * chord.length() {
        let bulge = Heading::Toward(Direction::nearest(to_top)?);
        let depth = match top.length() / chord.length() {
            d if d < 0.37 => Size::Small,
            d if d < 0.7 => Size::Normal,
            _ => Size::Large,
        };
        let off = off_arc(path, chord, top);
        let unlike = off / chord.length() + LESS_PLAIN.0;
        let motion = Motion::Arc { direction, extent, bulge, depth, overlay: None };
        return Some(Drawn { motion, chord, off, unlike });
    }
    let off = mean(&|i| across[i].length());
    let unlike = off / chord.length();
    Some(Drawn { motion: Motion::Straight { direction, extent, overlay: None }, chord, off, unlike })
}

/// The mean distance of points from the arc of a circle through both ends and the top of its bend, metres.
fn off_arc(path: &[DVec3], chord: DVec3, top: DVec3) -> f64 {
    let (length, height) = (chord.length(), top.length());
    let radius = (length * length / 4.0 + height * height) / (2.0 * height);
    let centre = path[0] + chord / 2.0 + top / height * (height - radius);
    let normal = chord.cross(top).normalize_or_zero();
    let off = |p: &DVec3| {
        let from = *p - centre;
        let aside = from.dot(normal);
        ((from - normal * aside).length() - radius).hypot(aside)
    };
    path.iter().map(off).sum::<f64>() / path.len() as f64
}

/// How often values swing from one side to the other, each at least so far from the middle of the two ends.
pub(super) fn swings(values: &[f64], least: f64) -> usize {
    let (mut side, mut count) = (0.0, 0);
    for value in values.iter().filter(|v| v.abs() > least) {
        if value.signum() != side {
            side = value.signum();
            count += 1;
        }
    }
    count
}

/// A path round a circle or ellipse.
fn round(path: &[DVec3]) -> Option<Drawn> {
    let count = path.len() as f64;
    let mean = path.iter().sum::<DVec3>() / count;
    let area: DVec3 = path.windows(2).map(|w| (w[0] - mean).cross(w[1] - mean)).sum();
    let axis = area.try_normalize()?;
    let u = axis.any_orthonormal_vector();
    let v = axis.cross(u);
    let flat: Vec<(f64, f64)> = path.iter().map(|p| ((*p - mean).dot(u), (*p - mean).dot(v))).collect();
    let (turn, narrow) = flattened(&flat);
    if narrow < NARROWEST {
        return None;
    }
    // An ellipse is a circle of which the short axis is drawn out.
    let (sin, cos) = turn.sin_cos();
    let wide: Vec<(f64, f64)> = flat.iter().map(|(x, y)| (x * cos + y * sin, (y * cos - x * sin) / narrow)).collect();
    let (cx, cy) = centre(&wide)?;
    let radii: Vec<f64> = wide.iter().map(|(x, y)| (x - cx).hypot(y - cy)).collect();
    let radius = radii.iter().sum::<f64>() / count;
    let unround = (radii.iter().map(|r| (r - radius).powi(2)).sum::<f64>() / count).sqrt();
    let angle = |(x, y): (f64, f64)| (y - cy).atan2(x - cx);
    let step = |w: &[(f64, f64)]| {
        let by = angle(w[1]) - angle(w[0]);
        by - TAU * (by / TAU).round()
    };
    let swept: f64 = wide.windows(2).map(step).sum();
    if swept < ROUND || unround > UNROUND * radius || radius * narrow < LEAST_RADIUS_M {
        return None;
    }
    let (x, y) = (cx * cos - cy * narrow * sin, cx * sin + cy * narrow * cos);
    let start = clock(axis, path[0] - (mean + u * x + v * y));
    let along = u * cos + v * sin;
    let long = Direction::nearest(along).filter(|_| narrow < ROUND_ENOUGH);
    let motion = Motion::Circle {
        axis: Heading::Toward(Direction::nearest(axis)?),
        extent: Extent::Metres(radius),
        start,
        turns: (swept / TAU * 4.0).round() / 4.0,
        ellipse: long.map(|long| ((narrow * 10.0).round() / 10.0, long)),
        growth: 0,
        overlay: None,
    };
    Some(Drawn { motion, chord: axis * radius, off: unround, unlike: unround / radius })
}

/// The direction of the longest extent of points in a plane, radians, and the other extent as a part of it.
fn flattened(points: &[(f64, f64)]) -> (f64, f64) {
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (mx, my) = (mean(&|p| p.0), mean(&|p| p.1));
    let (xx, yy) = (mean(&|p| (p.0 - mx).powi(2)), mean(&|p| (p.1 - my).powi(2)));
    let xy = mean(&|p| (p.0 - mx) * (p.1 - my));
    let turn = 0.5 * (2.0 * xy).atan2(xx - yy);
    let spread = ((xx - yy).powi(2) / 4.0 + xy * xy).sqrt();
    let (long, short) = ((xx + yy) / 2.0 + spread, (xx + yy) / 2.0 - spread);
    let narrow = if long > 0.0 { (short.max(0.0) / long).sqrt() } else { 0.0 };
    // What is nearly a circle has no longest extent.
    if narrow > ROUND_ENOUGH { (0.0, 1.0) } else { (turn, narrow) }
}

/// The middle of the circle that points lie on (Kåsa 1976: the least squares of the circle's equation).
fn centre(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let n = points.len() as f64;
    let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (mx, my) = (mean(&|p| p.0), mean(&|p| p.1));
    let mz = mean(&|p| (p.0 - mx).powi(2) + (p.1 - my).powi(2));
    for (x, y) in points {
        let (x, y) = (x - mx, y - my);
        let z = x * x + y * y - mz;
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
        (xz, yz) = (xz + x * z, yz + y * z);
    }
    let determinant = xx * yy - xy * xy;
    // Points on a line have no circle.
    if determinant <= 1e-6 * (xx + yy).powi(2) {
        return None;
    }
    Some((mx + (xz * yy - yz * xy) / (2.0 * determinant), my + (yz * xx - xz * xy) / (2.0 * determinant)))
}

/// Where a circle about an axis starts, on its clock: clockwise from its top as seen by one who looks along the axis.
fn clock(axis: DVec3, from_centre: DVec3) -> Clock {
    let up = if axis.y.abs() > 0.9 { DVec3::Z } else { DVec3::Y };
    let top = (up - axis * up.dot(axis)).normalize_or(axis.any_orthonormal_vector());
    let side = axis.cross(top);
    let angle = from_centre.dot(side).atan2(from_centre.dot(top));
    let eighths = (angle / TAU * 8.0).round().rem_euclid(8.0) as u8;
    Clock::new(eighths % 8).unwrap_or_default()
}
