//! How long the phases of a plan usually last: transitions by the way that the hands have to go, strokes by their
//! movements, holds by what follows.
//!
//! Between two signs there is no rest: a hand goes from where it was to where the next sign needs it, and a hand that
//! had nothing to do meanwhile has prepared already. Signs inside a line are held more briefly than the last one.

use super::plan::HandPlan;
use super::prepare::Prepared;
use super::schedule::{Lasting, Measured, Phases};
use super::stage::Stage;
use super::vary::difference;
use crate::phonology::{Hand, Side};
use crate::score::plan::{Act, Plan};
use crate::time::Seconds;
use glam::DVec3;

/// How much longer than usual the ways of a plan last, so that wrists stay slow: one factor an item, one for the way
/// back to rest.
#[derive(Debug, Clone)]
pub(super) struct Slower {
    pub ways: Vec<f64>,
    pub retraction: f64,
}

impl Slower {
    /// As long as usual, but for what one performance differs from another.
    pub(super) fn usual(stage: &Stage, items: usize) -> Slower {
        let ways = (0..items).map(|item| difference(stage.options, item).way).collect();
        Slower { ways, retraction: 1.0 }
    }
}

/// Where a hand was last, and since when it has been free.
#[derive(Debug, Clone, Copy)]
struct Left {
    place: DVec3,
    free_from: f64,
}

/// Lays out the phases. Least times are left at the usual ones; only motion tells them.
pub(super) fn lay_out(stage: &Stage, plan: &Plan, prepared: &[Prepared], slower: &Slower) -> Measured {
    let timing = &stage.grammar.movements.timing;
    let speed = stage.options.speed;
    let still = timing.still / speed;
    let mut at = still;
    let mut left: [Option<Left>; 2] = [None; 2];
    let mut items = Vec::with_capacity(plan.items.len());
    let mut signs = prepared.iter();
    for (i, item) in plan.items.iter().enumerate() {
        let slow = slower.ways[i];
        let mut ended: &[HandPlan] = &[];
        let phases = match &item.act {
            Act::Sign(sign) => {
                let own = signs.next();
                let hands = own.map(|p| &p.hands[..]).unwrap_or_default();
                let slow = slow / sign.speed;
                let ways = hands.iter().map(|h| coming(stage, h, left[h.side as usize], at) * slow);
                let least = if left.iter().any(Option::is_some) { timing.between_least } else { 0.0 };
                let transition = ways.fold(least / speed, f64::max);
                let last = !plan.items[i + 1..].iter().any(|next| matches!(next.act, Act::Sign(_)))
                    || matches!(plan.items.get(i + 1).map(|next| &next.act), Some(Act::Rest(_)));
                let pace = speed * sign.speed;
                let stroke = own.map_or(0.0, Prepared::natural) / pace;
                let (moving, unmoving) = match last {
                    true => (timing.final_hold, timing.posture),
                    false => (timing.inner_hold, timing.inner_posture),
                };
                let hold = if sign.intervals == 0 { unmoving } else { moving } / pace;
                // A short sign is held longer at its end.
                let least_sign = if last { timing.least_sign } else { timing.least_inner } / pace;
                ended = hands;
                of(transition, stroke, hold.max(least_sign - stroke))
            }
            // Captured signs are put in afterwards ([`super::captured`]).
            Act::Hold(Some(_), _) | Act::Captured(_) => of(0.0, 0.0, 0.0),
            Act::Hold(None, time) => of(0.0, 0.0, time.map_or(timing.hold, |t| t.0) / speed),
            Act::Rest(time) => {
                let ways = [Side::Left, Side::Right].map(|side| leaving(stage, side, left[side as usize], at) * slow);
                of(ways[0].max(ways[1]), 0.0, time.map_or(timing.hold, |t| t.0) / speed)
            }
        };
        at += phases.usual().0;
        match &item.act {
            Act::Sign(sign) => {
                for hand in ended {
                    left[hand.side as usize] = Some(Left { place: end_place(stage, hand), free_from: at });
                }
                // The other hand stays as it was.
                if sign.holds_over {
                    left.iter_mut().flatten().for_each(|was| was.free_from = at);
                }
            }
            // The posture that is held by a sign's hands goes on to the end of the hold.
            Act::Hold(hand, _) => {
                for (side, was) in [Side::Left, Side::Right].into_iter().zip(&mut left) {
                    let held = hand.is_none_or(|h: Hand| super::side_of(h) == side);
                    if let Some(was) = was.as_mut().filter(|_| held) {
                        was.free_from = at;
                    }
                }
            }
            Act::Rest(_) | Act::Captured(_) => left = [None; 2],
        }
        items.push(phases);
    }
    let back = [Side::Left, Side::Right].map(|side| leaving(stage, side, left[side as usize], at));
    let retraction = back[0].max(back[1]) * slower.retraction;
    Measured { still: Seconds(still), items, retraction: lasting(retraction) }
}

fn lasting(seconds: f64) -> Lasting {
    Lasting { usual: Seconds(seconds), least: Seconds(seconds) }
}

fn of(transition: f64, stroke: f64, hold: f64) -> Phases {
    Phases { transition: lasting(transition), stroke: lasting(stroke), hold: lasting(hold) }
}

/// How long a hand needs to a stroke, less the time that it has been free since `at` is the end of the item before.
fn coming(stage: &Stage, hand: &HandPlan, left: Option<Left>, at: f64) -> f64 {
    match left {
        None => to_rest(stage, hand.side, start_place(stage, hand)),
        Some(left) => {
            let least = stage.grammar.movements.timing.between_least;
            way(stage, start_place(stage, hand).distance(left.place), least) - (at - left.free_from)
        }
    }
}

/// How long a hand still needs back to the neutral pose; nothing for one that is there.
fn leaving(stage: &Stage, side: Side, left: Option<Left>, at: f64) -> f64 {
    left.map_or(0.0, |left| (to_rest(stage, side, left.place) - (at - left.free_from)).max(0.0))
}

/// Seconds between the neutral pose and a place.
pub(super) fn to_rest(stage: &Stage, side: Side, place: DVec3) -> f64 {
    way(stage, stage.neutral_wrist(side).distance(place), stage.grammar.movements.timing.transition_least)
}

/// Seconds that a hand takes for a way of so many metres; `least` seconds at the usual speed.
fn way(stage: &Stage, metres: f64, least: f64) -> f64 {
    let usual = metres.min(LONGEST_WAY) / stage.grammar.movements.timing.transition_speed;
    usual.max(least) / stage.options.speed
}

/// Longer ways are not longer in time, metres.
const LONGEST_WAY: f64 = 1.2;

/// Where a stroke starts with the body neutral, model space, metres.
pub(super) fn start_place(stage: &Stage, hand: &HandPlan) -> DVec3 {
    hand.start.position(&stage.neutral_model)
}

/// Where a stroke ends with the body neutral, model space, metres.
pub(super) fn end_place(stage: &Stage, hand: &HandPlan) -> DVec3 {
    hand.legs.last().map_or(&hand.start, |l| &l.to).position(&stage.neutral_model)
}
