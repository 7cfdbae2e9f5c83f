//! Repetition: moves that come again are one movement, performed more than once.

use crate::phonology::{Action, Motion, Movement, Repeated, Repetition, RepetitionKind};
use glam::DVec3;

/// A movement on the way to be told, frames.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    pub from: usize,
    pub to: usize,
    pub movement: Movement,
    /// Its way ([`super::shape::Drawn::chord`]); zero where it has none.
    pub chord: DVec3,
    pub off: f64,
}

/// The cosine of the greatest angle between two performances of one movement: 40°.
const ALIKE: f64 = 0.766;
/// How much longer a performance may be than another.
const LONGER: f64 = 2.5;

impl Part {
    fn kind(&self) -> usize {
        match &self.movement {
            Movement::Action(action) => match action.motion {
                Motion::Straight { .. } | Motion::Arc { .. } => 1,
                Motion::Circle { .. } => 2,
                Motion::Wrist(..) => 3,
                Motion::Wiggle(_) => 4,
                Motion::Hold | Motion::Change | Motion::Return { .. } => 5,
            },
            _ => 6,
        }
    }

    fn alike(&self, other: &Part, sign: f64) -> bool {
        let (a, b) = (self.chord.length(), other.chord.length());
        self.kind() == other.kind()
            && matches!(self.kind(), 1 | 2)
            && sign * self.chord.dot(other.chord) > ALIKE * a * b
            && a < LONGER * b
            && b < LONGER * a
    }

    fn again(&self, other: &Part) -> bool {
        self.alike(other, 1.0)
    }

    fn back(&self, other: &Part) -> bool {
        self.kind() == 1 && self.alike(other, -1.0)
    }
}

/// Joins moves that come again.
pub(super) fn joined(parts: Vec<Part>) -> Vec<Part> {
    let mut out: Vec<Part> = Vec::new();
    let mut rest = &parts[..];
    while let Some(first) = rest.first() {
        let (taken, part) =
            to_and_fro(rest).or_else(|| again(rest)).or_else(|| group(rest)).unwrap_or_else(|| (1, first.clone()));
        out.push(part);
        rest = &rest[taken..];
    }
    out
}

fn spanning(parts: &[Part], movement: Movement) -> Part {
    let (first, last) = (&parts[0], &parts[parts.len() - 1]);
    let off = parts.iter().map(|p| p.off).sum::<f64>() / parts.len() as f64;
    Part { from: first.from, to: last.to, movement, chord: first.chord, off }
}

fn repeated(movement: &Movement, kind: RepetitionKind, times: usize) -> Movement {
    let repetition = Repetition::new(kind, times.min(usize::from(u8::MAX)) as u8);
    match movement {
        Movement::Action(action) => {
            Movement::Action(Box::new(Action { repetition: Some(repetition), ..(**action).clone() }))
        }
        other => Movement::Repeated(Box::new(Repeated { movement: other.clone(), repetition, alternating: false })),
    }
}

/// There and back again, at least there, back, there.
fn to_and_fro(parts: &[Part]) -> Option<(usize, Part)> {
    let mut taken = 1;
    while taken < parts.len()
        && parts[taken - 1].back(&parts[taken])
        && taken.checked_sub(2).is_none_or(|b| parts[b].again(&parts[taken]))
    {
        taken += 1;
    }
    if taken < 3 {
        return None;
    }
    let (kind, times) = match taken % 2 {
        1 => (RepetitionKind::FromStart, taken.div_ceil(2)),
        _ => (RepetitionKind::ToAndFro, taken / 2),
    };
    Some((taken, spanning(&parts[..taken], repeated(&parts[0].movement, kind, times))))
}

/// The same again, and again.
fn again(parts: &[Part]) -> Option<(usize, Part)> {
    let taken = 1 + parts.windows(2).take_while(|w| w[0].again(&w[1])).count();
    if taken < 2 {
        return None;
    }
    let kind = if parts[0].kind() == 2 { RepetitionKind::FromStart } else { RepetitionKind::Continue };
    Some((taken, spanning(&parts[..taken], repeated(&parts[0].movement, kind, taken))))
}

/// Several moves that come again together; a way back before the next performance belongs to it.
fn group(parts: &[Part]) -> Option<(usize, Part)> {
    (2..=4).find_map(|period| {
        let alike = (period..parts.len()).take_while(|i| parts[*i].again(&parts[i - period])).count();
        let times = (alike + period + 1) / period;
        (alike + 1 >= period && alike > 0 && times >= 2).then(|| {
            let taken = (alike + period).min(times * period);
            // Where the last performance lacks its last move, that one led back.
            let own = if taken % period == 0 { period } else { period - 1 };
            let once: Vec<Movement> = parts[..own].iter().map(|p| p.movement.clone()).collect();
            let once = if once.len() == 1 { once[0].clone() } else { Movement::Sequence(once) };
            (taken, spanning(&parts[..taken], repeated(&once, RepetitionKind::FromStart, times)))
        })
    })
}
