//! Legs with their ends: where each one starts and where it leads.

use super::anchor::Anchor;
use super::legs::{Leg, LegEnd, change, lay_out};
use super::plan::{PlacedLeg, Planner};
use super::posture::Site;
use super::side_of;
use crate::diagnostics::Error;
use crate::phonology::symmetry::Resolved;
use crate::phonology::{Hand, Sign};
use glam::DVec3;

impl Planner<'_> {
    /// The legs of every interval, reflected where the hand follows the other one.
    pub(super) fn intervals(&self, sign: &Sign, said: &Resolved) -> Vec<Vec<Leg>> {
        let table = &self.grammar.movements;
        let reflected = |mut leg: Leg| {
            leg.path = leg.path.reflected(said.signs);
            leg.end = leg.end.reflected(said.signs);
            leg
        };
        (0..sign.intervals)
            .map(|interval| match said.movement.get(interval) {
                Some(movement) => lay_out(movement, table, said.turns).into_iter().map(reflected).collect(),
                None => vec![change(table.timing.change)],
            })
            .collect()
    }

    /// The legs of a hand with their ends, from `start` on.
    pub(super) fn legs(
        &self,
        sign: &Sign,
        hand: Hand,
        intervals: &[Vec<Leg>],
        sites: &[Site],
        start: &Anchor,
        on_other_hand: &mut bool,
    ) -> Result<Vec<PlacedLeg>, Error> {
        let side = side_of(hand);
        let mut placed: Vec<PlacedLeg> = Vec::new();
        // Where the hand is at each key that it has come to.
        let mut been = vec![start.clone()];
        let mut at = start.clone();
        let derived = going_back(intervals, sites, 0).is_some();
        for (interval, legs) in intervals.iter().enumerate() {
            let first = placed.len();
            // To and fro, with only a later place said: the hand began there too, so its way out does not lead there.
            let unsaid = derived && sites[..=interval].iter().all(|site| site.anchor.is_none());
            let returns = unsaid && way_of(legs) == Some(DVec3::ZERO);
            for leg in legs {
                let from = at;
                let stated = sites[interval + 1].anchor.as_ref().filter(|_| leg.posture.1 >= 1.0 && !returns);
                let displaced = || from.clone().moved(leg.path.end());
                let (end, by) = match &leg.end {
                    LegEnd::Off(end, by) => (&**end, *by),
                    end => (end, DVec3::ZERO),
                };
                let to = match (end, stated) {
                    (LegEnd::At(placement), _) => self.anchor(placement, sign, side, false, on_other_hand)?,
                    (LegEnd::StartOf(n), _) => placed[first + n].from.clone(),
                    (LegEnd::AtKey(key), _) => been.get(*key).cloned().unwrap_or_else(displaced),
                    (LegEnd::Displaced, Some(anchor)) => anchor.clone(),
                    (LegEnd::NextKey, _) => going_back(intervals, sites, interval + 1).unwrap_or_else(displaced),
                    (LegEnd::Displaced | LegEnd::Off(..), _) => displaced(),
                };
                let to = to.moved(by);
                at = to.clone();
                placed.push(PlacedLeg { leg: leg.clone(), interval, from, to });
            }
            been.push(at.clone());
        }
        Ok(placed)
    }
}

/// Where a hand is at a key: as the key says, else going back along the movements from the next key that says it;
/// `None` where none does, or a movement between has no way of its own.
pub(super) fn going_back(intervals: &[Vec<Leg>], sites: &[Site], key: usize) -> Option<Anchor> {
    let mut way = DVec3::ZERO;
    for (site, legs) in sites.iter().zip(intervals.iter().map(Some).chain([None])).skip(key) {
        if let Some(anchor) = &site.anchor {
            return Some(anchor.clone().moved(-way));
        }
        way += way_of(legs?)?;
    }
    None
}

/// How far an interval leads, where the paths of its legs alone say it.
fn way_of(legs: &[Leg]) -> Option<DVec3> {
    let (mut starts, mut at) = (Vec::with_capacity(legs.len()), DVec3::ZERO);
    for leg in legs {
        starts.push(at);
        let there = at + leg.path.end();
        at = match &leg.end {
            LegEnd::Displaced => there,
            LegEnd::StartOf(earlier) => *starts.get(*earlier)?,
            // Backwards from a place, without a path that says how far.
            LegEnd::NextKey | LegEnd::Off(..) if leg.path.closes() => return None,
            // The interval's own end, where the legs after it lead as well.
            LegEnd::NextKey => return Some(there),
            LegEnd::Off(end, by) if **end == LegEnd::NextKey => return Some(there - *by),
            LegEnd::At(_) | LegEnd::AtKey(_) | LegEnd::Off(..) => return None,
        };
    }
    Some(at)
}
