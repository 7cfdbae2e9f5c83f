//! Tiers as ELAN holds them: whole milliseconds, time slots, a tier under its parent, a list of values for a kind.

use super::Vocabulary;
use crate::tier::{Tier, TierValue};
use crate::time::Seconds;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// The kind of tier that other tiers of the same hand hang on.
pub(super) const GLOSS: &str = "Gloss";
/// Kinds that hang on nothing: preparation and retraction lie outside the gloss.
const ROOTS: [&str; 2] = [GLOSS, "Phase"];
/// Later instants are written as this one, in milliseconds (24 days).
const LATEST_MS: f64 = i32::MAX as f64;

/// What is to be written, every name clean and unique, every number given.
pub(super) struct Layout<'a> {
    /// Milliseconds of each time slot, ascending.
    pub slots: Vec<u32>,
    /// In the track's order.
    pub rows: Vec<Row<'a>>,
    /// In the order of their first tiers.
    pub kinds: Vec<Kind<'a>>,
    /// The name of the type of the tiers that say where values came from.
    pub source_kind: String,
}

/// One tier.
pub(super) struct Row<'a> {
    pub name: String,
    /// Its place in `Layout::kinds`.
    pub kind: usize,
    /// The tier that its values lie within.
    pub parent: Option<String>,
    /// The name of the tier with its sources; none where no value has a source.
    pub sources: Option<String>,
    pub annotations: Vec<Annotation<'a>>,
}

/// One value of a tier, from slot to slot (numbers of `Layout::slots`).
pub(super) struct Annotation<'a> {
    pub begin: usize,
    pub end: usize,
    pub label: Cow<'a, str>,
    pub source: Cow<'a, str>,
}

/// What the tiers of both hands with one name have in common; ELAN's tier type ("linguistic type").
pub(super) struct Kind<'a> {
    pub name: String,
    /// Its values lie within those of the gloss tier.
    pub included: bool,
    /// The values that ELAN offers, with their numbers; `None`: any text.
    pub vocabulary: Option<Entries<'a>>,
}

/// Values in the order in which they are offered.
#[derive(Default)]
pub(super) struct Entries<'a> {
    pub values: Vec<Cow<'a, str>>,
    /// The number of each value.
    pub numbers: BTreeMap<Cow<'a, str>, usize>,
}

impl Entries<'_> {
    /// The number of a value that was added.
    pub fn number(&self, value: &str) -> Option<usize> {
        self.numbers.get(value).copied()
    }
}

impl<'a> Entries<'a> {
    fn add(&mut self, value: Cow<'a, str>) {
        if !self.numbers.contains_key(&value) {
            self.numbers.insert(value.clone(), self.values.len());
            self.values.push(value);
        }
    }
}

/// Lays tiers out.
pub(super) fn layout<'a>(tiers: &'a [Tier], vocabularies: &'a [Vocabulary]) -> Layout<'a> {
    let names: Vec<Cow<str>> = tiers.iter().map(|t| clean(&t.name)).collect();
    let spans: Vec<Vec<Span>> = tiers.iter().map(|t| spans(t.values())).collect();
    let gloss_of = |i: usize| {
        let (Some(hand), kind) = hand_and_kind(&names[i]) else { return None };
        (0..tiers.len()).find(|&g| !ROOTS.contains(&kind) && hand_and_kind(&names[g]) == (Some(hand), GLOSS))
    };
    let mut kinds: Vec<Kind> = Vec::new();
    let mut kind_of = Vec::new();
    for (i, tier) in tiers.iter().enumerate() {
        let name = hand_and_kind(&names[i]).1;
        let at = kinds.iter().position(|k| k.name == name).unwrap_or_else(|| {
            kinds.push(Kind { name: name.to_owned(), included: true, vocabulary: offered(name, vocabularies) });
            kinds.len() - 1
        });
        // One tier that does not fit frees all tiers of its kind: a kind has one rule.
        kinds[at].included &= gloss_of(i).is_some_and(|g| spans[i].iter().all(|s| lies_within(*s, &spans[g])));
        if let Some(entries) = &mut kinds[at].vocabulary {
            tier.values().iter().for_each(|v| entries.add(clean(&v.label)));
        }
        kind_of.push(at);
    }

    let mut taken = BTreeSet::new();
    let own: Vec<String> = names.iter().map(|n| unique(n, &mut taken)).collect();
    let (slots, mut places) = slots(&spans);
    let mut rows = Vec::new();
    for (i, tier) in tiers.iter().enumerate() {
        let sourced = tier.values().iter().any(|v| !v.source.is_empty());
        let annotation = |(value, (begin, end)): (&'a TierValue, (usize, usize))| Annotation {
            begin,
            end,
            label: clean(&value.label),
            source: clean(&value.source),
        };
        rows.push(Row {
            name: own[i].clone(),
            kind: kind_of[i],
            parent: gloss_of(i).filter(|_| kinds[kind_of[i]].included).map(|g| own[g].clone()),
            sources: sourced.then(|| unique(&format!("{} Source", own[i]), &mut taken)),
            annotations: tier.values().iter().zip(places.by_ref()).map(annotation).collect(),
        });
    }
    let mut kind_names = kinds.iter().map(|k| k.name.clone()).collect();
    Layout { slots, rows, source_kind: unique("Source", &mut kind_names), kinds }
}

/// The values that are offered for a kind of tier, where its vocabulary is given.
fn offered<'a>(kind: &str, vocabularies: &'a [Vocabulary]) -> Option<Entries<'a>> {
    let vocabulary = vocabularies.iter().find(|v| clean(&v.kind) == kind)?;
    let mut entries = Entries::default();
    vocabulary.values.iter().for_each(|value| entries.add(clean(value)));
    Some(entries)
}

/// From and to, in milliseconds; `from < to`.
type Span = (u32, u32);

/// The values of a tier in milliseconds, rounded once, so that what meets in the track meets here.
///
/// ELAN's tiers hold one value at a time, and drop annotations without a length: a value ends where the next begins, an
/// instant (a beat, say) lasts a millisecond, and what it pushes aside begins that much later.
fn spans(values: &[TierValue]) -> Vec<Span> {
    let mut free = 0;
    let starts: Vec<u32> = values.iter().map(|v| milliseconds(v.start)).collect();
    let span = |(i, value): (usize, &TierValue)| {
        let begin = starts[i].max(free);
        let next = starts.get(i + 1).copied().unwrap_or(u32::MAX);
        let end = milliseconds(value.end).min(next).max(begin.saturating_add(1));
        free = end;
        (begin, end)
    };
    values.iter().enumerate().map(span).collect()
}

fn milliseconds(time: Seconds) -> u32 {
    // No number becomes 0.
    (time.0 * 1000.0).round().clamp(0.0, LATEST_MS) as u32
}

/// Whether a span lies within one of these, which follow one another.
fn lies_within(span: Span, parents: &[Span]) -> bool {
    let after = parents.partition_point(|p| p.0 <= span.0);
    after.checked_sub(1).is_some_and(|i| span.1 <= parents[i].1)
}

/// The milliseconds of all slots, and the slots of each span in turn. No slot is shared: in ELAN a shared slot ties
/// annotations together, so that moving the one moves the other, which is what its subdivisions are.
fn slots(spans: &[Vec<Span>]) -> (Vec<u32>, impl Iterator<Item = (usize, usize)>) {
    let ends: Vec<u32> = spans.iter().flatten().flat_map(|s| [s.0, s.1]).collect();
    let mut order: Vec<usize> = (0..ends.len()).collect();
    order.sort_by_key(|&i| ends[i]);
    let mut place = vec![0; ends.len()];
    for (slot, &end) in order.iter().enumerate() {
        place[end] = slot;
    }
    let slots = order.iter().map(|&i| ends[i]).collect();
    let pairs: Vec<_> = place.chunks_exact(2).map(|p| (p[0], p[1])).collect();
    (slots, pairs.into_iter())
}

/// `RH Phase` is the phase of a hand, `Brows` of none.
fn hand_and_kind(name: &str) -> (Option<&str>, &str) {
    match name.split_once(' ') {
        Some((hand @ ("RH" | "LH"), kind)) => (Some(hand), kind),
        _ => (None, name),
    }
}

/// The name, or the name with a number where it is taken.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2..).map(|n| format!("{name} {n}"));
    let free = std::iter::once(name.to_owned()).chain(numbered).find(|n| !taken.contains(n)).unwrap_or_default();
    taken.insert(free.clone());
    free
}

/// The text without characters that XML 1.0 cannot hold, each replaced by U+FFFD.
pub(super) fn clean(text: &str) -> Cow<'_, str> {
    let foreign =
        |c: char| matches!(c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}');
    if text.contains(foreign) { text.replace(foreign, "\u{fffd}").into() } else { text.into() }
}
