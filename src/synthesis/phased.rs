//! Signs of several phases: each phase is an item of its own while a plan is signed, and one sign for everyone else.
//!
//! The phases follow each other as signs of a line do. For who measures or schedules a plan, the sign's stroke lasts
//! from its first phase's start to its last one's end, what lies between included.

use super::schedule::{Lasting, Measured, Phases, Schedule, Times};
use crate::phonology::Sign;
use crate::score::plan::{Act, Item, Over, Plan};
use crate::time::Seconds;
use std::borrow::Cow;
use std::ops::Range;

/// A plan with an item a phase.
#[derive(Debug, Clone)]
pub(super) struct Phased<'p> {
    /// The plan; signs in it have one phase.
    pub plan: Cow<'p, Plan>,
    /// The items of each item of the plan that it was made of.
    pub groups: Vec<Range<usize>>,
    /// How long a sign of several phases lasts that says it.
    stated: Vec<Option<Seconds>>,
}

impl<'p> Phased<'p> {
    pub(super) fn of(plan: &'p Plan) -> Phased<'p> {
        let several = |item: &Item| matches!(&item.act, Act::Sign(sign) if !sign.then.is_empty());
        if !plan.items.iter().any(several) {
            let groups = (0..plan.items.len()).map(|i| i..i + 1).collect();
            return Phased { plan: Cow::Borrowed(plan), groups, stated: vec![None; plan.items.len()] };
        }
        let (mut items, mut groups, mut stated) = (Vec::new(), Vec::new(), Vec::new());
        for item in &plan.items {
            let first = items.len();
            let mut lasts = None;
            match &item.act {
                Act::Sign(sign) if !sign.then.is_empty() => {
                    lasts = sign.duration.map(|d| Seconds(d.0 / sign.speed));
                    let acts = sign.phases().map(|phase| Act::Sign(Box::new(alone(phase, sign))));
                    items.extend(acts.map(|act| Item { act, ..item.clone() }));
                }
                Act::Sign(_) | Act::Hold(..) | Act::Rest(_) | Act::Captured(_) => items.push(item.clone()),
            }
            groups.push(first..items.len());
            stated.push(lasts);
        }
        let spans = plan.spans.iter().map(|over| {
            let start = groups.get(over.items.start).map_or(items.len(), |g| g.start);
            let end = over.items.end.checked_sub(1).and_then(|last| groups.get(last)).map_or(start, |g| g.end);
            Over { items: start..end.max(start), ..over.clone() }
        });
        let spans = spans.collect();
        Phased { plan: Cow::Owned(Plan { items, spans }), groups, stated }
    }

    /// The items of the sign that an item belongs to.
    pub(super) fn group(&self, item: usize) -> Range<usize> {
        self.groups.iter().find(|group| group.contains(&item)).cloned().unwrap_or(item..item + 1)
    }

    /// Whether the author has said how long the sign lasts that an item is a phase of.
    pub(super) fn states_time(&self, item: usize) -> bool {
        self.groups.iter().zip(&self.stated).any(|(group, stated)| group.contains(&item) && stated.is_some())
    }

    /// Makes signs of several phases last as long as they say, from the first key to the last, at a speed.
    pub(super) fn keep_stated(&self, measured: &mut Measured, speed: f64) {
        for (group, stated) in self.groups.iter().zip(&self.stated) {
            let Some(stated) = stated.filter(|s| s.0.is_finite()) else { continue };
            let items = &mut measured.items[group.clone()];
            let whole = inside(items).usual.0;
            if whole <= 0.0 {
                continue;
            }
            let factor = stated.0.clamp(0.01, 1200.0) / speed / whole;
            let count = items.len();
            for (n, phases) in items.iter_mut().enumerate() {
                let longer = |lasting: &mut Lasting| lasting.usual = lasting.usual * factor;
                longer(&mut phases.stroke);
                if n > 0 {
                    longer(&mut phases.transition);
                }
                if n + 1 < count {
                    longer(&mut phases.hold);
                }
            }
        }
    }

    /// What the signs of the plan take that this was made of.
    pub(super) fn merged(&self, measured: Measured) -> Measured {
        let items = self.groups.iter().map(|group| match &measured.items[group.clone()] {
            [only] => *only,
            [] => Phases::default(),
            items @ [first, .., last] => {
                Phases { transition: first.transition, stroke: inside(items), hold: last.hold }
            }
        });
        Measured { items: items.collect(), ..measured }
    }

    /// When the signs of the plan are signed that this was made of.
    pub(super) fn times(&self, items: &[Times]) -> Vec<Times> {
        let whole = |group: &Range<usize>| match &items[group.clone()] {
            [] => Times::default(),
            [only] => *only,
            [first, .., last] => Times { stroke: first.stroke, ..*last },
        };
        self.groups.iter().map(whole).collect()
    }

    /// The times of the phases, where those of whole signs were given: as they usually are to each other.
    pub(super) fn schedule(&self, given: &Schedule, usual: &Measured) -> Schedule {
        let mut items = Vec::with_capacity(usual.items.len());
        for (group, times) in self.groups.iter().zip(&given.items) {
            let phases = &usual.items[group.clone()];
            let whole = inside(phases).usual.0;
            let share = if whole > 0.0 { (times.stroke_end - times.stroke).0 / whole } else { 0.0 };
            let mut at = times.stroke;
            for (n, phase) in phases.iter().enumerate() {
                let stroke = if n == 0 { at } else { at + phase.transition.usual * share };
                let stroke_end = stroke + phase.stroke.usual * share;
                at = stroke_end + phase.hold.usual * share;
                items.push(Times { stroke, stroke_end, hold_end: at });
            }
            if let Some(last) = items.last_mut().filter(|_| !phases.is_empty()) {
                // What is added up differs from what was given in the last digits.
                last.stroke = Seconds(last.stroke.0.min(times.stroke_end.0));
                (last.stroke_end, last.hold_end) = (times.stroke_end, times.hold_end);
            }
        }
        Schedule { items, ..given.clone() }
    }
}

/// From the first key of several phases to the last one.
fn inside(items: &[Phases]) -> Lasting {
    let count = items.len();
    let mut whole = Lasting::default();
    for (n, phases) in items.iter().enumerate() {
        let before = if n > 0 { phases.transition } else { Lasting::default() };
        let after = if n + 1 < count { phases.hold } else { Lasting::default() };
        for part in [before, phases.stroke, after] {
            whole = Lasting { usual: whole.usual + part.usual, least: whole.least + part.least };
        }
    }
    whole
}

/// A phase as a sign of its own, named and as fast as the whole.
fn alone(phase: &Sign, whole: &Sign) -> Sign {
    let first = std::ptr::eq(phase, whole);
    let (slowest, fastest) = (*Sign::SPEEDS.start(), *Sign::SPEEDS.end());
    Sign {
        name: whole.name.clone(),
        language: whole.language.clone(),
        speed: if first { phase.speed } else { (phase.speed * whole.speed).clamp(slowest, fastest) },
        duration: phase.duration.filter(|_| !first),
        relocated: whole.relocated.clone(),
        then: Vec::new(),
        ..phase.clone()
    }
}
