//! A sign performed several times (Naert et al. 2021, §6: PUNIR twice is TRAVAIL).
//!
//! Where the hands do not end as they began, a way back comes between (the paper's "short slerp between the repeated
//! instances"); its time is the gap. The number counts performances in all. A sign of several
//! phases is performed as a whole. A sign of several phases is performed as a whole.

use super::invert::filled;
use super::{Tables, keys_of, manual_mut, phase, posture, scale};
use crate::diagnostics::Error;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::{
    Action, Hand, Keys, Manual, Motion, Movement, Orientation, Placement, Repeated, Repetition, RepetitionKind, Sign,
};
use crate::time::Seconds;
use glam::DVec3;

/// Each performance is so much larger than the one before where it grows; where it shrinks, the inverse. As a movement
/// of a description repeats (`synthesis::legs`).
const GROWTH: f64 = 1.3;

/// Displacements shorter than this bring a hand back to where it began, metres.
const CLOSED_M: f64 = 1e-3;

/// The sign performed `times` times.
///
/// # Errors
/// No performance at all; more intervals than a sign may have.
///
/// ```
/// use chereme::phonology::movement_table::MovementTable;
/// use chereme::phonology::operator::{Tables, repeated};
/// use chereme::phonology::{LocationInventory, Sign};
/// let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
/// let tables = Tables { locations: &locations, movements: &movements };
/// let sign = Sign::named("A");
/// assert_eq!(repeated(&sign, 1, None, 0, &tables).unwrap(), sign);
/// assert_eq!(repeated(&sign, 3, None, 0, &tables).unwrap().intervals, 2);
/// ```
pub fn repeated(sign: &Sign, times: u8, gap: Option<Seconds>, growth: i8, tables: &Tables) -> Result<Sign, Error> {
    if times == 0 {
        return Err(Error::new("it would not be performed at all: `repeated 2` is two performances"));
    }
    if times == 1 {
        return Ok(sign.clone());
    }
    if !sign.then.is_empty() {
        return phases_repeated(sign, times, growth, tables);
    }
    // What a hand becomes at the end of one performance is undone for the next one.
    let sign = &Sign { strong: posture::at_keys(&sign.strong), weak: posture::at_keys(&sign.weak), ..sign.clone() };
    let n = sign.intervals;
    // A posture has no movement that could end where it began; it is held anew.
    let between = usize::from(gap.is_some() || n == 0 || !closes(sign, tables.movements));
    let (step, performances) = (n + between, usize::from(times));
    let intervals = step * performances - between;
    if intervals > Sign::MOST_INTERVALS {
        return Err(Error::new(format!(
            "repeated {times} times it has {intervals} movements; a sign has {} at most",
            Sign::MOST_INTERVALS
        )));
    }
    let mut made = Sign { intervals, ..sign.clone() };
    for hand in Hand::BOTH {
        let own = super::manual(sign, hand).clone();
        let mut movement = Vec::new();
        for performance in (0..performances).filter(|_| !own.movement.is_empty()) {
            if performance > 0 && between == 1 {
                let motion = if n == 0 { Motion::Hold } else { Motion::Return { key: 0 } };
                let action = Action { duration: gap, ..Action::new(motion) };
                movement.push(Movement::Action(Box::new(action)));
            }
            let offset = performance * step;
            let size = size_of(performance, growth);
            let later = |m: &Movement| {
                let m = returns_later(m, offset, intervals - n - offset, false);
                scale::movement(&m, size, tables.movements)
            };
            movement.extend(own.movement.iter().map(later));
        }
        let again = Again { step, performances, last: n };
        *manual_mut(&mut made, hand) = Manual {
            configuration: again.holding(&own.configuration),
            orientation: again.holding(&again_from_start(&own.orientation)),
            placement: again.at_keys(&own.placement),
            movement,
        };
    }
    if n == 0 {
        let action = Action { duration: gap, ..Action::new(Motion::Hold) };
        let hold = vec![Movement::Action(Box::new(action)); intervals];
        let hand = if sign.hands == crate::phonology::Hands::Weak { Hand::Weak } else { Hand::Strong };
        manual_mut(&mut made, hand).movement = hold;
    }
    let again = Again { step, performances, last: n };
    made.contact = again.at_keys(&sign.contact);
    for (_, values) in &mut made.nonmanual {
        *values = again.holding(values);
    }
    made.duration = sign.duration.map(|d| {
        let gaps = gap.unwrap_or_default().0 * (f64::from(times) - 1.0);
        Seconds(d.0 * f64::from(times) + gaps)
    });
    Ok(made)
}

/// How large a performance is, beside the first one.
fn size_of(performance: usize, growth: i8) -> f64 {
    GROWTH.powi(performance as i32 * i32::from(growth.signum()))
}

/// A sign of several phases, all of them performed several times without rest.
fn phases_repeated(sign: &Sign, times: u8, growth: i8, tables: &Tables) -> Result<Sign, Error> {
    let postures = sign.phases().map(|phase| phase.intervals + 1).sum::<usize>() * usize::from(times);
    if postures > Sign::MOST_INTERVALS {
        return Err(Error::new(format!(
            "repeated {times} times it has {postures} postures; a sign has {} at most",
            Sign::MOST_INTERVALS
        )));
    }
    let mut made = sign.clone();
    for performance in 1..usize::from(times) {
        let size = size_of(performance, growth);
        let grown = |own: &Manual| Manual {
            movement: own.movement.iter().map(|m| scale::movement(m, size, tables.movements)).collect(),
            ..own.clone()
        };
        let again = phase::alone(sign).map(|phase| {
            let (strong, weak) = (grown(&phase.strong), grown(&phase.weak));
            Sign { strong, weak, ..phase }
        });
        made.then.extend(again);
    }
    made.duration = sign.duration.map(|d| Seconds(d.0 * f64::from(times)));
    Ok(made)
}

/// Orientations of which each is whole: what the first leaves open would be read as the last one's when it comes again.
fn again_from_start(keys: &Keys<Orientation>) -> Keys<Orientation> {
    if keys.len() < 2 { keys.clone() } else { filled(keys) }
}

/// How performances follow each other on the keys of the result.
struct Again {
    /// Keys from one performance's start to the next one's.
    step: usize,
    performances: usize,
    /// The last key of one performance.
    last: usize,
}

impl Again {
    /// Values that hold until the next one.
    fn holding<T: Clone>(&self, keys: &Keys<T>) -> Keys<T> {
        if keys.len() < 2 {
            return keys.clone();
        }
        let mut all: Vec<(usize, T)> = keys.iter().map(|(key, value)| (key, value.clone())).collect();
        for performance in 1..self.performances {
            let offset = performance * self.step;
            // What holds at the start holds there again.
            all.extend(keys.at(0).map(|value| (offset, value.clone())));
            all.extend(keys.iter().map(|(key, value)| (offset + key, value.clone())));
        }
        keys_of(all)
    }

    /// Values of their own key. One at the start alone is come back to; no value is said twice of a shared key.
    fn at_keys<T: Clone>(&self, keys: &Keys<T>) -> Keys<T> {
        let only_start = keys.len() == 1 && keys.stated(0).is_some();
        if only_start || keys.is_empty() {
            return keys.clone();
        }
        let mut all = Vec::new();
        for performance in 0..self.performances {
            let offset = performance * self.step;
            let shared = self.step == self.last && performance > 0;
            let own = keys.iter().filter(|(key, _)| !(shared && *key == 0));
            all.extend(own.map(|(key, value)| (offset + key, value.clone())));
        }
        keys_of(all)
    }
}

/// A movement whose ways back go to keys of its own performance. Keys inside `backwards` count from the end.
fn returns_later(movement: &Movement, before: usize, after: usize, backwards: bool) -> Movement {
    let all = |parts: &[Movement]| parts.iter().map(|m| returns_later(m, before, after, backwards)).collect();
    match movement {
        Movement::Action(action) => {
            let mut action = action.clone();
            if let Motion::Return { key } = &mut action.motion {
                *key += if backwards { after } else { before };
            }
            Movement::Action(action)
        }
        Movement::Sequence(parts) => Movement::Sequence(all(parts)),
        Movement::Together(parts) => Movement::Together(all(parts)),
        Movement::Fused(parts) => Movement::Fused(all(parts)),
        Movement::Repeated(r) => Movement::Repeated(Box::new(Repeated {
            movement: returns_later(&r.movement, before, after, backwards),
            ..(**r).clone()
        })),
        Movement::Backwards(inner) => Movement::Backwards(Box::new(returns_later(inner, before, after, !backwards))),
    }
}

/// A movement whose ways back go to keys so much later.
pub(super) fn moved(movement: &Movement, by: usize) -> Movement {
    returns_later(movement, by, 0, false)
}

/// Whether the hands end as they began: shapes, orientations and places.
fn closes(sign: &Sign, table: &MovementTable) -> bool {
    let n = sign.intervals;
    let hand = |own: &Manual| {
        let posture =
            own.configuration.at(0) == own.configuration.at(n) && own.orientation.at(0) == own.orientation.at(n);
        posture && returns(own, n, table)
    };
    hand(&sign.strong) && hand(&sign.weak) && sign.contact.stated(0) == sign.contact.stated(n)
}

fn returns(own: &Manual, n: usize, table: &MovementTable) -> bool {
    let start: Option<&Placement> = own.placement.stated(0);
    if let Some(end) = own.placement.stated(n) {
        return start == Some(end);
    }
    // Places on the way break the sum.
    if own.placement.iter().any(|(key, _)| key > 0) {
        return false;
    }
    let whole: Option<DVec3> = own.movement.iter().map(|m| displacement(m, table)).sum();
    whole.is_some_and(|way| way.length() < CLOSED_M)
}

/// How far a movement leads, model space, metres; `None` where a place or a key says so.
fn displacement(movement: &Movement, table: &MovementTable) -> Option<DVec3> {
    match movement {
        Movement::Action(action) => {
            if action.target.is_some() {
                return None;
            }
            let one = way(&action.motion, table)?;
            action.repetition.map_or(Some(one), |r| again_and_again(one, r))
        }
        Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => {
            parts.iter().map(|m| displacement(m, table)).sum()
        }
        Movement::Repeated(r) => displacement(&r.movement, table).and_then(|one| again_and_again(one, r.repetition)),
        Movement::Backwards(inner) => displacement(inner, table).map(|way| -way),
    }
}

/// How far all performances of a way lead.
fn again_and_again(one: DVec3, r: Repetition) -> Option<DVec3> {
    if r.shift.is_some() {
        return None;
    }
    if r.growth != 0 {
        return (one.length() < CLOSED_M).then_some(DVec3::ZERO);
    }
    Some(match r.kind {
        RepetitionKind::FromStart => one,
        RepetitionKind::Continue => one * f64::from(r.times),
        RepetitionKind::ToAndFro => DVec3::ZERO,
    })
}

fn way(motion: &Motion, table: &MovementTable) -> Option<DVec3> {
    match motion {
        Motion::Hold | Motion::Change | Motion::Wrist(..) | Motion::Wiggle(_) => Some(DVec3::ZERO),
        Motion::Return { .. } => None,
        Motion::Straight { direction, extent, .. } | Motion::Arc { direction, extent, .. } => {
            Some(direction.vector() * table.straight.metres(*extent))
        }
        Motion::Circle { turns, growth, .. } => (turns.fract() == 0.0 && *growth == 0).then_some(DVec3::ZERO),
    }
}
