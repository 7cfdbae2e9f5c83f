//! From tiers to segments: one for each gloss of a hand, with the values that overlap it.
//!
//! Phonological values may begin before their gloss and end after it (transitions included), and a corpus has hands
//! whose glosses nobody wrote: what a segment then is follows the phases of the hand, else the whole recording.

use super::segment::{Component, Segment, Value};
use crate::phonology::Side;
use crate::tier::{Tier, TierValue};
use crate::time::Seconds;

/// The shortest overlap that counts, seconds: ends that meet do not overlap, and times are read with rounding.
const LEAST_OVERLAP: f64 = 1e-6;

/// The segments of a recording's tiers, in the order of their starts, the right hand first.
///
/// Tiers are named as synthesis names them: `RH` or `LH`, then Gloss, Phase, Configuration, Placement, Orientation or Movement; letter case
/// does not matter, the first of a name counts. A gloss of a hand is a segment, with every value that overlaps it, whole and
/// in time order. A gloss without length is one at an instant and has the values that hold there. A `Gloss` tier without a hand
/// holds for the hands that have no gloss tier of their own but have values there; where neither hand has any, for a segment
/// without a side. A hand with values and no gloss has a segment a stroke of its Phase tier; without strokes, one over everything.
/// Labels that say nothing (`""`, `?`) are left out: the value is not known.
///
/// ```
/// use chereme::corpus::{cut::segments, segment::Component};
/// use chereme::tier::Tier;
/// use chereme::time::Seconds;
/// let mut gloss = Tier::new("RH Gloss");
/// gloss.push(Seconds(1.0), Seconds(2.0), "BOL", "");
/// let mut shape = Tier::new("RH Configuration");
/// shape.push(Seconds(0.8), Seconds(1.5), "round-B", "");
/// let found = segments(0, &[gloss, shape]);
/// assert_eq!(found[0].gloss.as_deref(), Some("BOL"));
/// assert_eq!(found[0].of(Component::Configuration)[0].label, "round-B");
/// ```
pub fn segments(recording: usize, tiers: &[Tier]) -> Vec<Segment> {
    let mut found = Vec::new();
    let hands = [Side::Right, Side::Left].map(|side| HandTiers::of(side, tiers));
    let shared: &[TierValue] = find(tiers, "Gloss").map_or(&[], Tier::values);
    for hand in &hands {
        match hand.gloss {
            Some(gloss) => found.extend(gloss.values().iter().map(|g| hand.segment(recording, span(g), name(g)))),
            None if shared.is_empty() => found.extend(hand.without_gloss(recording)),
            None => {
                let own = shared.iter().map(|g| hand.segment(recording, span(g), name(g)));
                found.extend(own.filter(|s| s.values.iter().any(|v| !v.is_empty())));
            }
        }
    }
    if hands.iter().any(|hand| hand.gloss.is_none()) {
        let held =
            |g: &TierValue| found.iter().any(|s| s.start < g.end && g.start < s.end || span(g) == (s.start, s.end));
        let alone: Vec<Segment> = shared
            .iter()
            .filter(|g| !held(g))
            .map(|g| Segment { recording, start: g.start, end: g.end, gloss: name(g), ..Segment::default() })
            .collect();
        found.extend(alone);
    }
    found.sort_by(|a, b| a.start.0.total_cmp(&b.start.0));
    found
}

/// The tiers of one hand.
struct HandTiers<'a> {
    side: Side,
    gloss: Option<&'a Tier>,
    phase: Option<&'a Tier>,
    components: [Option<&'a Tier>; 4],
}

impl<'a> HandTiers<'a> {
    fn of(side: Side, tiers: &'a [Tier]) -> HandTiers<'a> {
        let prefix = match side {
            Side::Right => "RH",
            Side::Left => "LH",
        };
        let named = |title: &str| find(tiers, &format!("{prefix} {title}"));
        HandTiers {
            side,
            gloss: named("Gloss"),
            phase: named("Phase"),
            components: Component::ALL.map(|component| named(component.title())),
        }
    }

    /// What the hand does from one instant to another.
    fn segment(&self, recording: usize, (start, end): (Seconds, Seconds), gloss: Option<String>) -> Segment {
        let values = self.components.map(|tier| tier.map(|t| overlapping(t, start, end)).unwrap_or_default());
        Segment { recording, side: Some(self.side), start, end, gloss, values }
    }

    /// A segment a stroke, else one over everything, of a hand that has any values.
    fn without_gloss(&self, recording: usize) -> Vec<Segment> {
        let values = self.components.iter().flatten().flat_map(|tier| tier.values());
        let values: Vec<&TierValue> = values.filter(|v| says_something(&v.label)).collect();
        let strokes: Vec<&TierValue> = self
            .phase
            .iter()
            .flat_map(|tier| tier.values())
            .filter(|phase| phase.label.trim().eq_ignore_ascii_case("stroke"))
            .collect();
        let Some(start) = values.iter().map(|v| v.start.0).min_by(f64::total_cmp) else { return Vec::new() };
        if strokes.is_empty() {
            let end = values.iter().map(|v| v.end.0).fold(start, f64::max);
            return vec![self.segment(recording, (Seconds(start), Seconds(end)), None)];
        }
        strokes.into_iter().map(|stroke| self.segment(recording, span(stroke), None)).collect()
    }
}

fn span(value: &TierValue) -> (Seconds, Seconds) {
    (value.start, value.end)
}

fn name(gloss: &TierValue) -> Option<String> {
    let label = gloss.label.trim();
    says_something(label).then(|| label.to_owned())
}

/// Whether a label is a value, rather than the mark that there is none.
pub(super) fn says_something(label: &str) -> bool {
    !matches!(label.trim(), "" | "?")
}

fn find<'a>(tiers: &'a [Tier], name: &str) -> Option<&'a Tier> {
    tiers.iter().find(|tier| tier.name.trim().eq_ignore_ascii_case(name))
}

/// The values of a tier that overlap a stretch, in time order.
fn overlapping(tier: &Tier, start: Seconds, end: Seconds) -> Vec<Value> {
    // A stretch, or a value, without length is an instant: it overlaps what holds then.
    let meets = |v: &TierValue| {
        let overlap = v.end.0.min(end.0) - v.start.0.max(start.0);
        overlap > LEAST_OVERLAP
            || (overlap >= 0.0 && (end.0 - start.0 <= LEAST_OVERLAP || v.end.0 - v.start.0 <= LEAST_OVERLAP))
    };
    let values = tier.values().iter().filter(|v| says_something(&v.label) && meets(v));
    values.map(|v| Value { label: v.label.trim().to_owned(), start: v.start, end: v.end }).collect()
}

/// The value that holds longest within a segment, the earlier of two that hold as long: for those who need one only.
///
/// ```
/// use chereme::corpus::{cut::longest, segment::{Segment, Value}};
/// use chereme::time::Seconds;
/// let value = |label: &str, a, b| Value { label: label.into(), start: Seconds(a), end: Seconds(b) };
/// let segment = Segment { end: Seconds(1.0), ..Segment::default() };
/// let values = [value("S", -5.0, 0.3), value("5", 0.3, 1.0)];
/// assert_eq!(longest(&segment, &values).unwrap().label, "5");
/// ```
pub fn longest<'a>(segment: &Segment, values: &'a [Value]) -> Option<&'a Value> {
    let share = |v: &Value| v.end.0.min(segment.end.0) - v.start.0.max(segment.start.0);
    values.iter().rev().max_by(|a, b| share(a).total_cmp(&share(b)))
}
