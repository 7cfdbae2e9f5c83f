//! The shape and the time of a single motion, from the sizes and times of `grammar/movements.ron`.
//!
//! Numbers that no description may hold (not finite, endless) are brought within bounds here, so that no motion is
//! without end.

use super::path::Path;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::{Action, Clock, Direction, Extent, Heading, Manner, Motion, Overlay, Size};
use glam::DVec3;
use std::f64::consts::TAU;

/// No single way is longer than this, metres: more than twice what two arms span.
const LONGEST_M: f64 = 3.0;
/// No circle has more turns.
const MOST_TURNS: f64 = 40.0;
/// Nothing that a description states lasts longer, seconds.
const LONGEST_S: f64 = 120.0;

/// A number within bounds; `otherwise` where it is none.
pub(super) fn within(value: f64, least: f64, most: f64, otherwise: f64) -> f64 {
    if value.is_nan() { otherwise } else { value.clamp(least, most) }
}

/// How fast an action goes against its usual time.
pub(super) fn pace(action: &Action) -> f64 {
    within(action.pace, 0.05, 20.0, 1.0)
}

fn straight_metres(extent: Extent, table: &MovementTable) -> f64 {
    within(table.straight.metres(extent), 0.0, LONGEST_M, 0.0)
}

fn radius_metres(extent: Extent, table: &MovementTable) -> f64 {
    within(table.circle_radius.metres(extent), 0.0, LONGEST_M / 2.0, 0.0)
}

/// How long one performance of an action lasts, seconds.
pub(super) fn duration_of(action: &Action, table: &MovementTable) -> f64 {
    let t = &table.timing;
    if let Some(stated) = action.duration {
        return within(stated.0, 0.01, LONGEST_S, t.move_time) / pace(action);
    }
    let by_length = |metres: f64, normal: f64| t.move_time * (metres / normal).max(1e-3).powf(t.length_exponent);
    let straight = |extent: Extent| by_length(straight_metres(extent, table), table.straight.of(Size::Normal));
    let waves = |overlay: &Option<Overlay>| if overlay.is_some() { t.waves } else { 1.0 };
    let plain = match &action.motion {
        Motion::Hold => t.hold,
        Motion::Change | Motion::Return { .. } => t.change,
        Motion::Straight { extent, overlay, .. } => straight(*extent) * waves(overlay),
        Motion::Arc { extent, depth, overlay, .. } => straight(*extent) * t.arc.of(*depth) * waves(overlay),
        Motion::Circle { extent, turns, overlay, .. } => {
            let turns = within(*turns, 0.01, MOST_TURNS, 1.0);
            let one = by_length(radius_metres(*extent, table), table.circle_radius.of(Size::Normal)) * t.circle;
            let all = if turns <= 1.0 { one * turns.max(0.4) } else { one + (turns - 1.0) * one / t.circle * t.turn };
            all * waves(overlay)
        }
        Motion::Wrist(..) => t.wrist,
        Motion::Wiggle(_) => t.wiggle,
    };
    let manner: f64 = action
        .manner
        .iter()
        .map(|m| match m {
            Manner::Fast => t.fast,
            Manner::Slow => t.slow,
            Manner::Tense => t.tense,
            // Fingers that change one after the other take longer than all at once.
            Manner::TowardPinky | Manner::TowardThumb => 1.5,
            Manner::Rest | Manner::Halt | Manner::Bouncing => 1.0,
        })
        .product();
    (plain * manner).max(t.least) / pace(action)
}

/// The path of a motion. A hand that is half a cycle behind starts circles on the other side.
pub(super) fn path_of(motion: &Motion, table: &MovementTable, behind: bool) -> Path {
    match motion {
        Motion::Hold | Motion::Change | Motion::Return { .. } | Motion::Wrist(..) | Motion::Wiggle(_) => Path::Still,
        Motion::Straight { direction, extent, overlay } => {
            let to = direction.vector() * straight_metres(*extent, table);
            with_waves(Path::Straight(to), to, overlay, table)
        }
        Motion::Arc { direction, extent, bulge, depth, overlay } => {
            let chord = direction.vector() * straight_metres(*extent, table);
            let bend = across(bulge.vector(), chord) * chord.length() * table.arc_depth.of(*depth);
            with_waves(Path::Arc { chord, bend }, chord, overlay, table)
        }
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => {
            let radius = radius_metres(*extent, table);
            let turns = within(*turns, 0.01, MOST_TURNS, 1.0);
            let (top, side) = clock_face(*axis);
            let (top, side) = (top * radius, side * radius);
            let (top, side) = match ellipse {
                None => (top, side),
                Some((ratio, long)) => flattened(top, side, within(*ratio, 0.0, 1.0, 0.5), *long),
            };
            let half_a_turn = if behind { 4 } else { 0 };
            let start = Clock::new((start.eighths() + half_a_turn) % 8).unwrap_or_default();
            // Many turns that each grew by a third would leave the room.
            let growth = (1.0 + 0.35 * f64::from(growth.signum())).powf((3.0 / turns).min(1.0));
            let round = Path::Round { top, side, start: TAU * f64::from(start.eighths()) / 8.0, turns, growth };
            waves_around(round, axis.vector(), turns, overlay, table)
        }
    }
}

/// The clock face of a circle: its top, and its 3 as seen by one who looks along the axis.
///
/// The top is the highest point; of a level circle, the point farthest out (HamNoSys's clock).
fn clock_face(axis: Heading) -> (DVec3, DVec3) {
    let axis = axis.vector();
    let up = if axis.y.abs() > 0.9 { DVec3::Z } else { DVec3::Y };
    let top = (up - axis * up.dot(axis)).normalize();
    (top, axis.cross(top))
}

/// The two half axes with the part across `long` made shorter.
fn flattened(top: DVec3, side: DVec3, ratio: f64, long: Direction) -> (DVec3, DVec3) {
    let Some(normal) = top.cross(side).try_normalize() else { return (top, side) };
    let long = long.vector() - normal * long.vector().dot(normal);
    let Some(long) = long.try_normalize() else { return (top, side) };
    let narrow = |v: DVec3| long * v.dot(long) + (v - long * v.dot(long)) * ratio;
    (narrow(top), narrow(side))
}

/// The part of `wish` across `chord`, of length 1; any direction across where `wish` lies along the chord.
fn across(wish: DVec3, chord: DVec3) -> DVec3 {
    let Some(along) = chord.try_normalize() else { return wish };
    (wish - along * wish.dot(along)).try_normalize().unwrap_or_else(|| along.any_orthonormal_vector())
}

fn with_waves(path: Path, along: DVec3, overlay: &Option<Overlay>, table: &MovementTable) -> Path {
    let Some(overlay) = overlay else { return path };
    // Waves lie in the plane that looks most towards the addressee: across the path and level, or upright for
    // paths to the side.
    let usual = if along.y.abs() > along.x.abs() { DVec3::X } else { DVec3::Y };
    let wish = overlay.across.map_or(usual, Direction::vector);
    let across = across(wish, along) * table.wave_amplitude.of(overlay.size);
    Path::Sum(vec![path, waves(across, table.waves, overlay)])
}

/// Waves on a circle: out of its plane, or the way that is said.
fn waves_around(round: Path, axis: DVec3, turns: f64, overlay: &Option<Overlay>, table: &MovementTable) -> Path {
    let Some(overlay) = overlay else { return round };
    let across = overlay.across.map_or(axis, Direction::vector) * table.wave_amplitude.of(overlay.size);
    // A circle is about twice as long as a straight way of its size.
    let count = (2.0 * table.waves * turns).round().max(1.0);
    Path::Sum(vec![round, waves(across, count, overlay)])
}

fn waves(across: DVec3, count: f64, overlay: &Overlay) -> Path {
    let waves = Path::Waves { across, count, zigzag: overlay.zigzag };
    match overlay.growth.signum() {
        0 => waves,
        grows if grows > 0 => Path::Swelling { from: 0.3, to: 1.7, path: Box::new(waves) },
        _ => Path::Swelling { from: 1.7, to: 0.3, path: Box::new(waves) },
    }
}
