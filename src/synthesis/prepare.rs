//! The items of a plan made concrete: each sign's hands planned, before anything is timed or written.

use super::plan::{HandPlan, stretch};
use super::stage::Stage;
use super::vary::{Difference, difference};
use crate::diagnostics::Error;
use crate::phonology::{Movement, Sign};
use crate::score::plan::{Act, Plan};

/// A sign of a plan with its hands planned.
#[derive(Debug, Clone)]
pub(super) struct Prepared<'p> {
    /// The number of its item.
    pub item: usize,
    /// The description.
    pub sign: &'p Sign,
    /// The acting hands, the one that the other depends on first.
    pub hands: Vec<HandPlan>,
    /// The author has said how long it lasts.
    pub states_its_time: bool,
}

impl Prepared<'_> {
    /// How long the stroke lasts at the description's own speed, seconds.
    pub fn natural(&self) -> f64 {
        self.legs().map(|l| l.leg.duration).sum()
    }

    /// How long an interval of the stroke lasts at the description's own speed, seconds.
    pub fn interval(&self, interval: usize) -> f64 {
        self.legs().filter(|l| l.interval == interval).map(|l| l.leg.duration).sum()
    }

    /// Makes the stroke longer.
    pub fn stretch(&mut self, factor: f64) {
        stretch(&mut self.hands, factor);
    }

    /// Signs it a little otherwise than it is described.
    fn differ(&mut self, by: &Difference) {
        if !self.states_its_time {
            self.stretch(by.stroke);
        }
        // What touches the body or the other hand goes on touching it.
        if !self.hands.iter().any(|h| h.touching || h.on_other_hand) {
            self.hands.iter_mut().for_each(|h| h.shift(by.place));
        }
    }

    /// All hands have the same times, so the first one's legs say them.
    fn legs(&self) -> impl Iterator<Item = &super::plan::PlacedLeg> {
        self.hands.first().map(|h| &h.legs[..]).unwrap_or_default().iter()
    }
}

/// Plans the hands of every sign of a plan.
///
/// # Errors
/// What a sign asks for that cannot be; the message names the gloss.
pub(super) fn prepare<'p>(stage: &Stage, plan: &'p Plan) -> Result<Vec<Prepared<'p>>, Error> {
    let mut all = Vec::new();
    for (item, what) in plan.items.iter().enumerate() {
        if let Act::Sign(sign) = &what.act {
            let hands = stage.planner().plan(sign).map_err(|e| e.context(&what.gloss))?;
            let mut prepared = Prepared { item, sign, hands, states_its_time: states_its_time(sign) };
            if let Some(relocation) = &sign.relocated {
                stage.relocate(&mut prepared, &relocation.place).map_err(|e| e.context(&what.gloss))?;
            }
            prepared.differ(&difference(stage.options, item));
            all.push(prepared);
        }
    }
    Ok(all)
}

/// Whether the author has said how long the sign or a movement of it lasts.
fn states_its_time(sign: &Sign) -> bool {
    let stated = |movement: &Movement| movement.any_action(&|action| action.duration.is_some());
    sign.duration.is_some() || sign.strong.movement.iter().chain(&sign.weak.movement).any(stated)
}
