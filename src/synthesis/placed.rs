//! How far legs lead, where their paths alone say it.

use super::anchor::Anchor;
use super::leg::{Leg, LegEnd};
use super::posture::Site;
use glam::DVec3;

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
pub(super) fn way_of(legs: &[Leg]) -> Option<DVec3> {
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
            LegEnd::Rebound(_) => at,
            LegEnd::Off(end, by) => match **end {
                LegEnd::NextKey => return Some(there - *by),
                LegEnd::StartOf(earlier) => *starts.get(earlier)? + *by,
                _ => return None,
            },
            LegEnd::At(_) | LegEnd::Meeting(_) | LegEnd::AtKey(_) => return None,
        };
    }
    Some(at)
}
