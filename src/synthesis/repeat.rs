//! Movements performed more than once: from the start, on and on, to and fro; larger or smaller, and moved on.

use super::leg::{Leg, LegEnd, Stand, Turn, whole};
use super::legs::{Layout, MOST_LEGS, Postures, evenly, squeezed};
use super::path::Path;
use super::together::carried;
use crate::phonology::symmetry::Turns;
use crate::phonology::{Repeated, Repetition, RepetitionKind};
use glam::DVec3;

/// Each performance is so much larger or smaller than the one before, until it is so much so in all.
const GROWTH: f64 = 0.3;
const SIZES: (f64, f64) = (0.15, 4.0);

/// How something is performed again.
#[derive(Debug, Clone, Copy)]
pub(super) struct Again {
    how: Option<Repetition>,
    /// This hand is half a cycle behind the other one.
    behind: bool,
}

impl Again {
    pub(super) fn of(how: Option<Repetition>, behind: bool) -> Again {
        Again { how, behind }
    }
}

impl Layout<'_> {
    /// The legs of a group that is performed more than once.
    pub(super) fn of_group(&self, group: &Repeated, at: &Stand) -> Vec<Leg> {
        let behind = self.turns.behind || self.turns.follower && group.alternating;
        let own = Layout { turns: Turns { behind, ..self.turns }, ..*self };
        let again = Again { how: Some(group.repetition), behind };
        self.again(&again, at, &|at| {
            let mut legs = own.legs(&group.movement, at);
            // A single action that repeats itself goes its own way from posture to posture.
            if self.postures == Postures::Evenly && !legs.iter().any(|leg| leg.posture.share.0 > leg.posture.share.1) {
                evenly(&mut legs);
            }
            legs
        })
    }

    /// What is performed once, performed as often as is said. `once` makes one performance from a posture on.
    pub(super) fn again(&self, again: &Again, at: &Stand, once: &dyn Fn(&Stand) -> Vec<Leg>) -> Vec<Leg> {
        let Some(how) = again.how else { return once(at) };
        let times = usize::from(how.times.max(1));
        let all_on = how.shift.map_or(DVec3::ZERO, |s| s.direction.vector() * self.table.straight.of(s.size));
        let mut one = once(at);
        if again.behind && how.kind != RepetitionKind::Continue {
            one = other_end_first(one);
        }
        let closes = squeezed(&one).closes() && !one.iter().any(|leg| leg.end.is_placed());
        let plays = |leg: &Leg| !leg.wrist.is_empty() || !leg.wiggle.is_empty() || leg.path.length(8) > 1e-9;
        let only_posture = !one.iter().any(plays);
        // A way back leads on as well; without one each performance does while it lasts.
        let has_way_back = match how.kind {
            RepetitionKind::ToAndFro => true,
            RepetitionKind::FromStart => !closes,
            RepetitionKind::Continue => false,
        };
        let step = all_on / if has_way_back { times.saturating_sub(1).max(1) } else { times } as f64;
        let mut legs: Vec<Leg> = Vec::new();
        let mut stand = at.clone();
        for i in 0..times {
            if legs.len() > MOST_LEGS {
                break;
            }
            let goes_on = how.kind == RepetitionKind::Continue && self.postures == Postures::AtStops && i > 0;
            let performance = if goes_on { once(&stand) } else { one.clone() };
            let size = (1.0 + GROWTH * f64::from(how.growth.signum())).powi(i as i32).clamp(SIZES.0, SIZES.1);
            let faster = if i == 0 { 1.0 } else { self.table.timing.again };
            let first = legs.len();
            let own = performance.into_iter().map(|leg| {
                let leg = sized(leg, size);
                Leg { duration: leg.duration * faster, end: leg.end.later(first), ..leg }
            });
            legs.extend(own);
            let last = i + 1 == times;
            if !has_way_back && step != DVec3::ZERO {
                carried(&mut legs, first, &Path::Straight(step));
            }
            match how.kind {
                RepetitionKind::FromStart if !last && !closes => {
                    let back = self.way_back(&legs[first..]);
                    let leg = Leg::still(back, self.turn_back(&legs[first..]));
                    legs.push(Leg { end: LegEnd::StartOf(first).off(step), ..leg });
                }
                // Nothing leads back where nothing leads away; the posture does.
                RepetitionKind::FromStart => {
                    let turned = match self.postures {
                        Postures::AtStops => one.iter().any(|leg| leg.posture.changes()),
                        Postures::Evenly => only_posture,
                    };
                    if !last && turned {
                        let back = self.way_back(&legs[first..]);
                        legs.push(Leg::still(back, self.turn_back(&legs[first..])));
                    }
                }
                RepetitionKind::ToAndFro => {
                    let on = if last && times > 1 { DVec3::ZERO } else { step };
                    let home: Vec<Leg> = (first..legs.len())
                        .rev()
                        .map(|n| {
                            let end = LegEnd::StartOf(n).off(if n == first { on } else { DVec3::ZERO });
                            Leg { end, brushing: legs[n].brushing.clone(), ..legs[n].clone().reversed_in_time() }
                        })
                        .collect();
                    legs.extend(home);
                }
                RepetitionKind::Continue => {}
            }
            stand = legs.last().map_or(stand, |leg| leg.posture.end().clone());
        }
        let turns_on = match how.kind {
            RepetitionKind::Continue => true,
            RepetitionKind::FromStart => closes && !only_posture,
            RepetitionKind::ToAndFro => false,
        };
        if turns_on && self.postures == Postures::Evenly {
            evenly(&mut legs);
        }
        legs
    }

    /// How long the way back to the start of a performance takes.
    fn way_back(&self, performance: &[Leg]) -> f64 {
        whole(performance) / performance.len().max(1) as f64 * self.table.timing.back
    }

    /// From the posture at a performance's end back to the one at its start.
    fn turn_back(&self, performance: &[Leg]) -> Turn {
        match (self.postures, performance.first(), performance.last()) {
            (Postures::AtStops, Some(first), Some(last)) => {
                Turn { from: last.posture.end().clone(), to: first.posture.from.clone(), share: (0.0, 1.0) }
            }
            (_, Some(first), Some(last)) => Turn::of_keys(last.posture.share.1, first.posture.share.0),
            (_, None, _) | (_, _, None) => Turn::of_keys(1.0, 0.0),
        }
    }
}

/// A leg larger or smaller.
fn sized(leg: Leg, size: f64) -> Leg {
    if size == 1.0 {
        return leg;
    }
    Leg {
        path: Path::Scaled(size, Box::new(leg.path)),
        wrist: leg
            .wrist
            .into_iter()
            .map(|w| super::leg::WristPlay { amplitude: w.amplitude * size.min(1.8), ..w })
            .collect(),
        ..leg
    }
}

/// The performance of a hand that takes turns with the other: it goes the other way. Ways to places and closed ones stay.
fn other_end_first(legs: Vec<Leg>) -> Vec<Leg> {
    let free = legs.iter().all(|leg| leg.end == LegEnd::Displaced);
    if !free || squeezed(&legs).closes() {
        return legs;
    }
    let postures: Vec<Turn> = legs.iter().map(|leg| leg.posture.clone()).collect();
    let turned = legs.into_iter().rev().map(Leg::reversed_in_time).zip(postures);
    turned.map(|(leg, posture)| Leg { posture, ..leg }).collect()
}
