//! The items of a plan made concrete: each sign's hands planned, before anything is timed or written.

use super::phased::Phased;
use super::plan::{HandPlan, Known, stretch};
use super::stage::Stage;
use super::vary::{Difference, difference};
use crate::diagnostics::Error;
use crate::phonology::{Movement, Sign};
use crate::score::plan::Act;
use glam::DVec3;
use std::ops::Range;

/// A sign of a plan with its hands planned.
#[derive(Debug, Clone)]
pub(super) struct Prepared<'p> {
    /// The number of its item.
    pub item: usize,
    /// The items of the whole sign, of which this is a phase.
    pub group: Range<usize>,
    /// The description.
    pub sign: &'p Sign,
    /// The acting hands, the one that the other depends on first.
    pub hands: Vec<HandPlan>,
    /// What was found out about it: names of places, warnings.
    pub known: Known,
    /// The author has said how long it lasts.
    pub states_its_time: bool,
    /// How much longer than usual the stroke has become so that wrists stay slow.
    grown: f64,
}

/// A stroke becomes at most so long so that wrists stay slow, seconds, or so many times as long as usual.
const SLOWEST_STROKE: (f64, f64) = (4.0, 1.5);

impl Prepared<'_> {
    /// How long the stroke lasts at the description's own speed, seconds.
    pub fn natural(&self) -> f64 {
        self.legs().map(|l| l.leg.duration).sum()
    }

    /// How long an interval of the stroke lasts at the description's own speed, seconds.
    pub fn interval(&self, interval: usize) -> f64 {
        self.legs().filter(|l| l.interval == interval).map(|l| l.leg.duration).sum()
    }

    /// Makes the stroke longer so that wrists stay slow, within bounds.
    pub fn slow_down(&mut self, factor: f64) {
        let natural = self.natural();
        if factor <= 1.0 || natural <= 0.0 {
            return;
        }
        let usual = natural / self.grown;
        let most = (SLOWEST_STROKE.0 * self.sign.speed).max(usual * SLOWEST_STROKE.1);
        let factor = factor.min((most / natural).max(1.0));
        self.grown *= factor;
        self.stretch(factor);
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
pub(super) fn prepare<'p>(stage: &Stage, phased: &'p Phased) -> Result<Vec<Prepared<'p>>, Error> {
    let mut all: Vec<Prepared> = Vec::new();
    // How far the phases of a sign are moved that is placed elsewhere.
    let mut moved = DVec3::ZERO;
    for (item, what) in phased.plan.items.iter().enumerate() {
        let Act::Sign(sign) = &what.act else { continue };
        let named = |e: Error| e.context(&what.gloss);
        let group = phased.group(item);
        let mut known = Known::default();
        // Places that were named in an earlier phase are known in the later ones.
        if let Some(before) = all.last().filter(|before| group.contains(&before.item)) {
            known.referents.clone_from(&before.known.referents);
        }
        let hands = stage.planner().plan(sign, &mut known).map_err(named)?;
        let states_its_time = states_its_time(sign) || phased.states_time(item);
        let mut prepared = Prepared { item, group, sign, hands, known, states_its_time, grown: 1.0 };
        if let Some(relocation) = &sign.relocated {
            let paths = stage.wrist_paths(&prepared);
            if prepared.group.start == item {
                moved = stage.way_to(&mut prepared, &relocation.place, &paths).map_err(named)?;
            }
            stage.relocate(&mut prepared, paths, moved);
        }
        prepared.differ(&difference(stage.options, item));
        all.push(prepared);
    }
    Ok(all)
}

/// Whether the author has said how long the sign or a movement of it lasts.
fn states_its_time(sign: &Sign) -> bool {
    let stated = |movement: &Movement| movement.any_action(&|action| action.duration.is_some());
    sign.duration.is_some() || sign.strong.movement.iter().chain(&sign.weak.movement).any(stated)
}
