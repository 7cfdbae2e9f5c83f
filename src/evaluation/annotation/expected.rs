//! What a described movement is, as kinds and directions in order.

use crate::phonology::movement_table::MovementTable;
use crate::phonology::symmetry::Turns;
use crate::phonology::{Action, Motion, Movement, WristMotion};
use crate::synthesis::legs::lay_out;
use glam::DVec3;

/// One movement by its kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Primitive {
    /// A straight way, with waves or without.
    Straight { along: DVec3, waves: bool },
    /// A bent way.
    Arc { along: DVec3 },
    /// Round an axis; the turns.
    Circle { axis: DVec3, turns: f64 },
    /// Somewhere on a way of any shape: what is blended has its own.
    Any { along: DVec3 },
    /// A way to a place that is said elsewhere.
    Led,
    /// The wrist to and fro.
    Wrist(WristMotion),
    /// Fingers that play.
    Wiggle,
    /// The posture changes.
    Change,
    /// Nothing.
    Hold,
}

/// The primitives of a movement with the performances of each. `signs` reflects its directions.
pub(super) fn primitives(movement: &Movement, signs: DVec3, table: &MovementTable) -> Vec<(Primitive, u8)> {
    match movement {
        Movement::Action(action) => vec![(of_action(action, signs), action.repetition.map_or(1, |r| r.times))],
        Movement::Sequence(parts) => parts.iter().flat_map(|m| primitives(m, signs, table)).collect(),
        Movement::Together(parts) => {
            let all: Vec<_> = parts.iter().map(|m| primitives(m, signs, table)).collect();
            // The way, if there is one; else the first that does something.
            let is_way = |p: &Vec<(Primitive, u8)>| p.iter().any(|(p, _)| p.is_way());
            let does =
                |p: &Vec<(Primitive, u8)>| p.iter().any(|(p, _)| !matches!(p, Primitive::Hold | Primitive::Change));
            let chosen = all.iter().find(|p| is_way(p)).or_else(|| all.iter().find(|p| does(p))).or(all.first());
            chosen.cloned().unwrap_or_default()
        }
        Movement::Fused(_) => {
            let along: DVec3 = lay_out(movement, table, Turns::default()).iter().map(|leg| leg.path.end()).sum();
            vec![(Primitive::Any { along: along * signs }, 1)]
        }
        Movement::Repeated(group) => {
            let inner = primitives(&group.movement, signs, table);
            inner.into_iter().map(|(p, n)| (p, n.saturating_mul(group.repetition.times))).collect()
        }
        Movement::Backwards(inner) => {
            let mut all = primitives(inner, signs, table);
            all.reverse();
            all.into_iter().map(|(p, n)| (p.backwards(), n)).collect()
        }
    }
}

fn of_action(action: &Action, signs: DVec3) -> Primitive {
    let led = action.target.is_some() || action.becoming.as_ref().is_some_and(|b| b.contact.is_some());
    match &action.motion {
        Motion::Hold if !led => Primitive::Hold,
        Motion::Change if !led => Primitive::Change,
        Motion::Hold | Motion::Change | Motion::Return { .. } => Primitive::Led,
        Motion::Straight { direction, overlay, .. } => {
            Primitive::Straight { along: direction.vector() * signs, waves: overlay.is_some() }
        }
        Motion::Arc { direction, .. } => Primitive::Arc { along: direction.vector() * signs },
        // An axis is no way: a mirror turns round what goes round.
        Motion::Circle { axis, turns, .. } => {
            Primitive::Circle { axis: axis.vector() * signs * (signs.x * signs.y * signs.z), turns: *turns }
        }
        Motion::Wrist(motion, _) => Primitive::Wrist(*motion),
        Motion::Wiggle(_) => Primitive::Wiggle,
    }
}

impl Primitive {
    /// Whether the hand goes somewhere.
    pub fn is_way(&self) -> bool {
        matches!(
            self,
            Primitive::Straight { .. }
                | Primitive::Arc { .. }
                | Primitive::Circle { .. }
                | Primitive::Any { .. }
                | Primitive::Led
        )
    }

    fn backwards(self) -> Primitive {
        match self {
            Primitive::Straight { along, waves } => Primitive::Straight { along: -along, waves },
            Primitive::Arc { along } => Primitive::Arc { along: -along },
            Primitive::Circle { axis, turns } => Primitive::Circle { axis: -axis, turns },
            Primitive::Any { along } => Primitive::Any { along: -along },
            Primitive::Led | Primitive::Wrist(_) | Primitive::Wiggle | Primitive::Change | Primitive::Hold => self,
        }
    }
}
