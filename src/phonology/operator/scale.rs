//! Faster and slower, larger and smaller.

use super::{Tables, phase};
use crate::diagnostics::Error;
use crate::phonology::movement_table::{BySize, MovementTable};
use crate::phonology::{Action, Extent, Manual, Motion, Movement, Repetition, Shift, Sign, Size};

/// `fast`: a sign in 0.7 of its time, a difference that signers make for emphasis and hurry.
pub const FAST: f64 = 1.4;
/// `slow`: its inverse, rounded.
pub const SLOW: f64 = 0.7;
/// `big`: clearly larger, and still within reach for signs of the lexicon (paths up to 22 cm).
pub const BIG: f64 = 1.4;
/// `small`: its inverse, rounded.
pub const SMALL: f64 = 0.7;
/// The factors of size that are accepted.
pub const SIZES: std::ops::RangeInclusive<f64> = 0.1..=5.0;

/// From these factors on a movement of the wrist, which has three sizes only, becomes one size smaller or larger.
const STEP: (f64, f64) = (0.8, 1.25);

pub(super) fn speed(sign: &Sign, factor: f64) -> Result<Sign, Error> {
    let speed = sign.speed * factor;
    if !Sign::SPEEDS.contains(&speed) {
        return Err(Error::new(format!("its speed would be {speed}; speeds lie between 0.05 and 20")));
    }
    Ok(Sign { speed, ..sign.clone() })
}

/// Every path so many times as large; places that are reached stay.
pub(super) fn size(sign: &Sign, factor: f64, tables: &Tables) -> Result<Sign, Error> {
    if !SIZES.contains(&factor) {
        return Err(Error::new(format!("a size of {factor} does not lie between 0.1 and 5")));
    }
    let hand = |own: &Manual| Manual {
        movement: own.movement.iter().map(|m| movement(m, factor, tables.movements)).collect(),
        ..own.clone()
    };
    Ok(phase::each(sign, |phase| Sign { strong: hand(&phase.strong), weak: hand(&phase.weak), ..phase.clone() }))
}

/// A movement so many times as large.
pub(super) fn movement(of: &Movement, factor: f64, table: &MovementTable) -> Movement {
    if factor == 1.0 {
        return of.clone();
    }
    let again = |r: Repetition| repetition(r, factor);
    of.map_actions(&|action| {
        let (motion, repetition) = (motion(&action.motion, factor, table), action.repetition.map(again));
        Action { motion, repetition, ..action.clone() }
    })
    .map_repetitions(&again)
}

/// How far a repetition leads on has three sizes only.
fn repetition(of: Repetition, factor: f64) -> Repetition {
    Repetition { shift: of.shift.map(|s| Shift { size: stepped(s.size, factor), ..s }), ..of }
}

fn motion(of: &Motion, factor: f64, table: &MovementTable) -> Motion {
    let longer = |extent: Extent, sizes: BySize| Extent::Metres(sizes.metres(extent) * factor);
    match of.clone() {
        Motion::Straight { direction, extent, overlay } => {
            Motion::Straight { direction, extent: longer(extent, table.straight), overlay }
        }
        Motion::Arc { direction, extent, bulge, depth, overlay } => {
            Motion::Arc { direction, extent: longer(extent, table.straight), bulge, depth, overlay }
        }
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => {
            Motion::Circle { axis, extent: longer(extent, table.circle_radius), start, turns, ellipse, growth, overlay }
        }
        Motion::Wrist(wrist, size) => Motion::Wrist(wrist, stepped(size, factor)),
        other @ (Motion::Hold | Motion::Change | Motion::Return { .. } | Motion::Wiggle(_)) => other,
    }
}

fn stepped(size: Size, factor: f64) -> Size {
    match size {
        Size::Normal | Size::Small if factor >= STEP.1 => {
            if size == Size::Small {
                Size::Normal
            } else {
                Size::Large
            }
        }
        Size::Normal | Size::Large if factor <= STEP.0 => {
            if size == Size::Large {
                Size::Normal
            } else {
                Size::Small
            }
        }
        Size::Small | Size::Normal | Size::Large => size,
    }
}
