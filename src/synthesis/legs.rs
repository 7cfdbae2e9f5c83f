//! Movements laid out in time: an interval's movement becomes legs, one after the other.
//!
//! A leg is a path of the contact point (perhaps to a place), small movements of wrist and fingers on top, and
//! how far the posture has come from the key before to the key after. Repetitions become legs: there, back,
//! there again. Times are those of `grammar/movements.ron`.

use super::path::Path;
use crate::motion::easing::Easing;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::symmetry::Turns;
use crate::phonology::{
    Action, Clock, Digits, Direction, Extent, Heading, Manner, Motion, Movement, Overlay, Placement, Repeated,
    RepetitionKind, Size, WristMotion,
};
use glam::DVec3;
use std::f64::consts::TAU;

/// One leg of a movement.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    /// Seconds.
    pub duration: f64,
    /// The way of the contact point.
    pub path: Path,
    /// Where the way ends.
    pub end: LegEnd,
    /// How much of the change from the key before to the key after is done at the start and at the end, 0 to 1.
    pub posture: (f64, f64),
    /// Movements of the wrist on top.
    pub wrist: Vec<WristPlay>,
    /// Playing fingers on top.
    pub wiggle: Vec<Wiggle>,
}

/// Where a leg ends.
#[derive(Debug, Clone, PartialEq)]
pub enum LegEnd {
    /// Where the path leads from the leg's start.
    Displaced,
    /// At a place.
    At(Placement),
    /// Where an earlier leg of the same interval started.
    StartOf(usize),
    /// Where the hand was at an earlier key of the sign.
    AtKey(usize),
    /// Where the hand is at the key after the interval: as that key says, else going back along the movements from the
    /// next key that says where it is, else where the path leads.
    NextKey,
    /// As another end, and from there by a vector of model space, metres.
    Off(Box<LegEnd>, DVec3),
}

impl LegEnd {
    /// The end with its vector multiplied by `signs` (reflection at planes through the origin).
    pub fn reflected(self, signs: DVec3) -> LegEnd {
        match self {
            LegEnd::Off(end, by) => LegEnd::Off(end, by * signs),
            LegEnd::Displaced | LegEnd::At(_) | LegEnd::StartOf(_) | LegEnd::AtKey(_) | LegEnd::NextKey => self,
        }
    }
}

/// A wrist movement to and fro during a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WristPlay {
    /// Which.
    pub motion: WristMotion,
    /// Radians to each side.
    pub amplitude: f64,
    /// Whole cycles during the leg; below 0 they run backwards.
    pub cycles: f64,
    /// Share of a cycle that this hand is ahead.
    pub phase: f64,
}

/// Playing fingers during a leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wiggle {
    /// Which fingers.
    pub digits: Digits,
    /// Radians at the knuckle, from one extreme to the other.
    pub amplitude: f64,
    /// Whole cycles during the leg; below 0 they run backwards.
    pub cycles: f64,
}

/// Lays out the movement of one interval.
///
/// The legs last together as long as the movement; there is at least one.
pub fn lay_out(movement: &Movement, table: &MovementTable, turns: Turns) -> Vec<Leg> {
    let mut legs = match movement {
        Movement::Sequence(parts) if !parts.is_empty() => sequence(parts, table, turns),
        Movement::Action(action) => of_action(action, table, turns),
        Movement::Repeated(group) => of_group(group, table, turns),
        Movement::Backwards(inner) => backwards(lay_out(inner, table, turns)),
        // What goes on at the same time or is fused is one leg, repeated if its first member is.
        Movement::Together(parts) | Movement::Fused(parts) => {
            let simple = simple_leg(movement, table, turns);
            match parts.iter().find_map(repeating) {
                Some(action) => repeated(simple, action, table, turns),
                None => vec![simple],
            }
        }
        Movement::Sequence(_) => vec![simple_leg(movement, table, turns)],
    };
    if legs.is_empty() {
        legs.push(simple_leg(movement, table, turns));
    }
    legs
}

/// A posture kept, or changed to the next key's, without a path.
pub fn change(duration: f64) -> Leg {
    Leg {
        duration,
        path: Path::Still,
        end: LegEnd::Displaced,
        posture: (0.0, 1.0),
        wrist: Vec::new(),
        wiggle: Vec::new(),
    }
}

fn sequence(parts: &[Movement], table: &MovementTable, turns: Turns) -> Vec<Leg> {
    let mut legs: Vec<Leg> = Vec::new();
    for part in parts {
        let shift = legs.len();
        legs.extend(lay_out(part, table, turns).into_iter().map(|mut leg| {
            leg.end = shifted(leg.end, shift);
            leg
        }));
    }
    // The posture changes evenly over the whole sequence.
    let whole: f64 = legs.iter().map(|l| l.duration).sum();
    let mut done = 0.0;
    for leg in &mut legs {
        let from = done / whole;
        done += leg.duration;
        leg.posture = (from, done / whole);
    }
    legs
}

/// An end in a sequence in which `shift` legs stand before its own.
fn shifted(end: LegEnd, shift: usize) -> LegEnd {
    match end {
        LegEnd::StartOf(leg) => LegEnd::StartOf(leg + shift),
        LegEnd::Off(end, by) => LegEnd::Off(Box::new(shifted(*end, shift)), by),
        LegEnd::Displaced | LegEnd::At(_) | LegEnd::AtKey(_) | LegEnd::NextKey => end,
    }
}

/// The legs from the last to the first, each from its end to its start.
fn backwards(legs: Vec<Leg>) -> Vec<Leg> {
    let starts: Vec<LegEnd> = (0..legs.len()).map(|i| start_of(&legs, i)).collect();
    let reversed = legs.into_iter().zip(starts).rev();
    reversed.map(|(leg, start)| Leg { end: start, ..reversed_in_time(leg) }).collect()
}

/// Where a leg began, said as the end of the same leg played backwards.
fn start_of(legs: &[Leg], leg: usize) -> LegEnd {
    let Some(before) = leg.checked_sub(1).map(|i| &legs[i]) else { return LegEnd::NextKey };
    match &before.end {
        LegEnd::At(place) => LegEnd::At(place.clone()),
        LegEnd::StartOf(earlier) => start_of(legs, *earlier),
        // Its own path leads there, unless a place lies on the way.
        LegEnd::Displaced if legs[leg].end == LegEnd::Displaced => LegEnd::Displaced,
        LegEnd::Displaced => off(start_of(legs, leg - 1), before.path.end()),
        // A leg that was itself backwards or went back to a key: as far as its path leads.
        LegEnd::AtKey(_) | LegEnd::NextKey | LegEnd::Off(..) => LegEnd::Displaced,
    }
}

fn off(end: LegEnd, by: DVec3) -> LegEnd {
    match end {
        LegEnd::Off(end, before) => LegEnd::Off(end, before + by),
        end => LegEnd::Off(Box::new(end), by),
    }
}

/// A leg from its end to its start; where it ends then is another matter.
fn reversed_in_time(leg: Leg) -> Leg {
    let path = match leg.path {
        Path::Backwards(path) => *path,
        path => Path::Backwards(Box::new(path)),
    };
    Leg {
        path,
        posture: (1.0 - leg.posture.1, 1.0 - leg.posture.0),
        wrist: leg.wrist.into_iter().map(|w| WristPlay { cycles: -w.cycles, ..w }).collect(),
        wiggle: leg.wiggle.into_iter().map(|w| Wiggle { cycles: -w.cycles, ..w }).collect(),
        ..leg
    }
}

fn repeating(movement: &Movement) -> Option<&Action> {
    match movement {
        Movement::Action(action) if action.repetition.is_some() => Some(action),
        _ => None,
    }
}

fn of_action(action: &Action, table: &MovementTable, turns: Turns) -> Vec<Leg> {
    let leg = leg_of(action, table, turns);
    let mut legs = Vec::new();
    if action.manner.contains(&Manner::Rest) {
        legs.push(Leg { posture: (0.0, 0.0), ..change(table.timing.rest) });
    }
    legs.extend(repeated(leg, action, table, turns));
    if action.manner.contains(&Manner::Halt) {
        legs.push(Leg { posture: (1.0, 1.0), ..change(table.timing.halt) });
    }
    legs
}

/// A group performed more than once: from where it ended on, leg by leg; otherwise squeezed into one leg.
fn of_group(group: &Repeated, table: &MovementTable, turns: Turns) -> Vec<Leg> {
    match group.repetition.kind {
        RepetitionKind::Continue => sequence(&performances(group), table, turns),
        RepetitionKind::FromStart | RepetitionKind::ToAndFro => {
            let hold = Action::new(Motion::Hold);
            let action = Action { repetition: Some(group.repetition), alternating: group.alternating, ..hold };
            repeated(simple_leg(&group.movement, table, turns), &action, table, turns)
        }
    }
}

/// The performances of a group that goes on from where it ended.
fn performances(group: &Repeated) -> Vec<Movement> {
    let one = match &group.movement {
        Movement::Sequence(parts) => parts.clone(),
        other => vec![other.clone()],
    };
    vec![one; usize::from(group.repetition.times)].concat()
}

/// One leg, performed as often as the action says.
fn repeated(leg: Leg, action: &Action, table: &MovementTable, turns: Turns) -> Vec<Leg> {
    let Some(repetition) = action.repetition else { return vec![leg] };
    let there = leg.path.clone();
    // The hand that alternates starts with the way back.
    let reverse_first = turns.behind(action) && repetition.kind == RepetitionKind::ToAndFro;
    let mut legs = Vec::new();
    for i in 0..repetition.times.max(1) {
        let size = (1.0 + 0.3 * f64::from(repetition.growth.signum())).powi(i.into());
        let again = if i == 0 { 1.0 } else { table.timing.again };
        let sized = |path: &Path| if size == 1.0 { path.clone() } else { Path::Scaled(size, Box::new(path.clone())) };
        let first = legs.len();
        let perform =
            |path: Path, posture: (f64, f64)| Leg { path, posture, duration: leg.duration * again, ..leg.clone() };
        match repetition.kind {
            RepetitionKind::FromStart => {
                legs.push(perform(sized(&there), (0.0, 1.0)));
                let moved = !there.closes() || matches!(leg.end, LegEnd::At(_));
                if i + 1 < repetition.times && moved {
                    let back = leg.duration * again * table.timing.back;
                    legs.push(Leg { end: LegEnd::StartOf(first), posture: (1.0, 0.0), ..change(back) });
                }
            }
            RepetitionKind::Continue => {
                let n = f64::from(repetition.times);
                legs.push(perform(sized(&there), (f64::from(i) / n, f64::from(i + 1) / n)));
            }
            RepetitionKind::ToAndFro => {
                let path = sized(&there);
                let back = Path::Backwards(Box::new(path.clone()));
                let (out, home) = if reverse_first { (back, path) } else { (path, back) };
                legs.push(perform(out, (0.0, 1.0)));
                legs.push(Leg { end: LegEnd::StartOf(first), ..perform(home, (1.0, 0.0)) });
            }
        }
    }
    legs
}

fn leg_of(action: &Action, table: &MovementTable, turns: Turns) -> Leg {
    let duration = duration_of(action, table);
    let (mut wrist, mut wiggle) = (Vec::new(), Vec::new());
    match &action.motion {
        Motion::Wrist(motion, size) => wrist.push(WristPlay {
            motion: *motion,
            amplitude: table.wrist.amplitude(*motion, *size).to_radians(),
            cycles: (duration * table.wrist.frequency).round().max(1.0),
            phase: if turns.behind(action) { 0.5 } else { 0.0 },
        }),
        Motion::Wiggle(digits) => wiggle.push(Wiggle {
            digits: if digits.is_empty() { Digits::FINGERS } else { *digits },
            amplitude: table.wiggle.amplitude.to_radians(),
            cycles: (duration * table.wiggle.frequency).round().max(1.0),
        }),
        Motion::Hold
        | Motion::Change
        | Motion::Return { .. }
        | Motion::Straight { .. }
        | Motion::Arc { .. }
        | Motion::Circle { .. } => {}
    }
    let displaced = match action.motion {
        Motion::Return { key } => LegEnd::AtKey(key),
        _ => LegEnd::Displaced,
    };
    Leg {
        duration,
        path: path_of(&action.motion, table, turns.behind(action)),
        end: action.target.clone().map_or(displaced, LegEnd::At),
        posture: (0.0, 1.0),
        wrist,
        wiggle,
    }
}

/// What goes on at the same time, one after the other or fused, squeezed into one leg.
fn simple_leg(movement: &Movement, table: &MovementTable, turns: Turns) -> Leg {
    let join = |parts: &[Movement], path: fn(Vec<(f64, Path)>) -> Path, duration: fn(&[f64]) -> f64| {
        let legs: Vec<Leg> = parts.iter().map(|p| simple_leg(p, table, turns)).collect();
        let durations: Vec<f64> = legs.iter().map(|l| l.duration).collect();
        let whole = if legs.is_empty() { table.timing.change } else { duration(&durations) };
        let mut joined = change(whole);
        for leg in &legs {
            let longer = if leg.duration > 0.0 { whole / leg.duration } else { 1.0 };
            let stretched = |cycles: f64| (cycles.abs() * longer).round().max(1.0).copysign(cycles);
            joined.wrist.extend(leg.wrist.iter().map(|w| WristPlay { cycles: stretched(w.cycles), ..*w }));
            joined.wiggle.extend(leg.wiggle.iter().map(|w| Wiggle { cycles: stretched(w.cycles), ..*w }));
            if leg.end != LegEnd::Displaced {
                joined.end = leg.end.clone();
            }
        }
        joined.path = path(legs.into_iter().map(|l| (l.duration, l.path)).collect());
        joined
    };
    let longest = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
    match movement {
        Movement::Action(action) => leg_of(action, table, turns),
        Movement::Sequence(parts) => join(parts, Path::Chain, |all| all.iter().sum()),
        Movement::Repeated(group) => join(&performances(group), Path::Chain, |all| all.iter().sum()),
        Movement::Backwards(inner) => {
            let leg = simple_leg(inner, table, turns);
            let end = if leg.end == LegEnd::Displaced { LegEnd::Displaced } else { LegEnd::NextKey };
            Leg { end, ..reversed_in_time(leg) }
        }
        Movement::Together(parts) => join(parts, |p| Path::Sum(p.into_iter().map(|(_, path)| path).collect()), longest),
        Movement::Fused(parts) => join(
            parts,
            |p| Path::Fused(p.into_iter().map(|(_, path)| path).collect()),
            |all| all.iter().sum::<f64>() * 0.7,
        ),
    }
}

/// How long one performance of an action lasts, seconds.
fn duration_of(action: &Action, table: &MovementTable) -> f64 {
    if let Some(stated) = action.duration {
        return stated.0;
    }
    let t = &table.timing;
    let by_length = |metres: f64, normal: f64| t.move_time * (metres / normal).max(1e-3).powf(t.length_exponent);
    let straight = |extent: Extent| by_length(table.straight.metres(extent), table.straight.of(Size::Normal));
    let waves = |overlay: &Option<Overlay>| if overlay.is_some() { t.waves } else { 1.0 };
    let plain = match &action.motion {
        Motion::Hold => t.hold,
        Motion::Change | Motion::Return { .. } => t.change,
        Motion::Straight { extent, overlay, .. } => straight(*extent) * waves(overlay),
        Motion::Arc { extent, depth, overlay, .. } => straight(*extent) * t.arc.of(*depth) * waves(overlay),
        Motion::Circle { extent, turns, .. } => {
            let radius = table.circle_radius;
            let one = by_length(radius.metres(*extent), radius.of(Size::Normal)) * t.circle;
            if *turns <= 1.0 { one * turns.max(0.4) } else { one + (turns - 1.0) * one / t.circle * t.turn }
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
            Manner::Rest | Manner::Halt | Manner::Bouncing | Manner::TowardPinky | Manner::TowardThumb => 1.0,
        })
        .product();
    (plain * manner).max(t.least)
}

fn path_of(motion: &Motion, table: &MovementTable, behind: bool) -> Path {
    match motion {
        Motion::Hold | Motion::Change | Motion::Return { .. } | Motion::Wrist(..) | Motion::Wiggle(_) => Path::Still,
        Motion::Straight { direction, extent, overlay } => {
            let to = direction.vector() * table.straight.metres(*extent);
            with_waves(Path::Straight(to), to, overlay, table)
        }
        Motion::Arc { direction, extent, bulge, depth, overlay } => {
            let chord = direction.vector() * table.straight.metres(*extent);
            let bend = across(bulge.vector(), chord) * chord.length() * table.arc_depth.of(*depth);
            with_waves(Path::Arc { chord, bend }, chord, overlay, table)
        }
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay: _ } => {
            let radius = table.circle_radius.metres(*extent);
            let (top, side) = clock_face(*axis);
            let (top, side) = (top * radius, side * radius);
            let (top, side) = match ellipse {
                None => (top, side),
                Some((ratio, long)) => flattened(top, side, *ratio, *long),
            };
            let half_a_turn = if behind { 4 } else { 0 };
            let start = Clock::new((start.eighths() + half_a_turn) % 8).unwrap_or_default();
            Path::Round {
                top,
                side,
                start: TAU * f64::from(start.eighths()) / 8.0,
                turns: *turns,
                growth: 1.0 + 0.35 * f64::from(growth.signum()),
            }
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
    let wish = if along.y.abs() > along.x.abs() { DVec3::X } else { DVec3::Y };
    let across = across(wish, along) * table.wave_amplitude.of(overlay.size);
    Path::Sum(vec![path, Path::Waves { across, count: table.waves, zigzag: overlay.zigzag }])
}

/// The share of a posture change that is done at a share of a leg's time.
pub fn posture_at(leg: &Leg, share: f64, easing: Easing) -> f64 {
    leg.posture.0 + (leg.posture.1 - leg.posture.0) * easing.weight(share)
}
