//! When annotations are: time slots, slots without a time, and annotations that take their parents' time.

use super::annotations::{Annotations, Place, RawTier};
use super::element::{Node, attribute, named, required};
use super::head::twice;
use crate::diagnostics::xml::short;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::eaf::Stereotype;
use crate::format::told::Told;
use std::collections::{BTreeSet, HashMap};

/// From and to, in the file's unit.
pub(super) type Times = (u64, u64);

/// The time slots, in the file's order, which is their order in time.
pub(super) struct Slots<'a> {
    times: Vec<Option<u64>>,
    ids: Vec<(&'a str, Span)>,
    places: HashMap<&'a str, usize>,
}

impl<'a> Slots<'a> {
    pub fn read(root: Node<'a>, told: &mut Told) -> Slots<'a> {
        let mut slots = Slots { times: Vec::new(), ids: Vec::new(), places: HashMap::new() };
        for node in named(root, "TIME_ORDER").flat_map(|order| named(order, "TIME_SLOT")) {
            let Some((id, span)) = required(node, "TIME_SLOT_ID", told) else { continue };
            if slots.places.insert(id, slots.times.len()).is_some() {
                told.say(twice("time slot", id, span));
            }
            slots.ids.push((id, span));
            slots.times.push(attribute(node, "TIME_VALUE").map(|(value, span)| {
                // The schema's unsignedInt.
                value.trim().parse::<u32>().map(u64::from).unwrap_or_else(|_| {
                    let fault = Diagnostic::fault(span, format!("`{}` is no time", short(value)));
                    let hint = "times are milliseconds from 0 on, without a point";
                    told.say(fault.label("expected a whole number below 4294967296").hint(hint));
                    slots.times.iter().rev().find_map(|time| *time).unwrap_or(0)
                })
            }));
        }
        slots
    }

    /// The slots that an annotation names.
    pub fn of(&self, node: Node<'a>, told: &mut Told) -> Place {
        let mut slot = |name| {
            let (id, span) = required(node, name, told)?;
            let found = self.places.get(id).copied();
            if found.is_none() {
                let fault = Diagnostic::fault(span, format!("there is no time slot `{}`", short(id)));
                told.say(fault.label("unknown").hint("each time slot is a TIME_SLOT in TIME_ORDER"));
            }
            found
        };
        match (slot("TIME_SLOT_REF1"), slot("TIME_SLOT_REF2")) {
            (Some(begin), Some(end)) => Place::Slots(begin, end),
            _ => Place::Nowhere,
        }
    }

    /// Gives the slots among `used` (in order, each once) that have no time one between their neighbours.
    ///
    /// As ELAN's `TimeProposer`: even steps of whole milliseconds, rounded down.
    fn spread(&mut self, used: &[usize], told: &mut Told) {
        let mut at = 0;
        while at < used.len() {
            if self.times[used[at]].is_some() {
                at += 1;
                continue;
            }
            let end = (at..used.len()).find(|&i| self.times[used[i]].is_some());
            let before = at.checked_sub(1).and_then(|i| self.times[used[i]]);
            let (Some(end), Some(begin)) = (end, before) else {
                let (id, span) = self.ids[used[at]];
                let message = format!("the time slot `{}` has no time", short(id));
                let fault = Diagnostic::fault(span, message).label("and no neighbour on one side has one");
                told.say(fault.hint("slots without TIME_VALUE lie between two with one, on the same tier"));
                at = end.unwrap_or(used.len());
                continue;
            };
            let whole = self.times[used[end]].unwrap_or(begin).saturating_sub(begin);
            let step = whole / (end - at + 1) as u64;
            for (i, slot) in used[at..end].iter().enumerate() {
                self.times[*slot] = Some(begin + step * (i as u64 + 1));
            }
            at = end;
        }
    }
}

/// The times of all annotations; `None` where a fault was told.
pub(super) fn times(
    tiers: &[RawTier<'_>],
    annotations: &Annotations<'_>,
    slots: &mut Slots<'_>,
    told: &mut Told,
) -> Vec<Option<Times>> {
    let mut times = vec![None; annotations.len()];
    for at in parents_first(tiers, told) {
        let of_slots = |i| match annotations.get(i).place {
            Place::Slots(begin, end) => Some((i, begin, end)),
            _ => None,
        };
        let aligned: Vec<_> = annotations.of(at).filter_map(of_slots).collect();
        let mut used: Vec<usize> = aligned.iter().flat_map(|&(_, begin, end)| [begin, end]).collect();
        used.sort_unstable();
        used.dedup();
        slots.spread(&used, told);
        for (i, begin, end) in aligned {
            if let (Some(begin), Some(end)) = (slots.times[begin], slots.times[end]) {
                times[i] = checked(begin, end, annotations, i, told);
            }
        }
        let of_parent = |i| match annotations.get(i).place {
            Place::Below(parent, previous) => Some(Child { parent, at: i, previous }),
            _ => None,
        };
        let mut children: Vec<Child> = annotations.of(at).filter_map(of_parent).collect();
        children.sort_by_key(|child| child.parent);
        for group in children.chunk_by(|a, b| a.parent == b.parent) {
            let Some(parent) = times[group[0].parent] else { continue };
            match tiers[at].stereotype {
                Some(Stereotype::SymbolicSubdivision) => divide(parent, group, annotations, &mut times, told),
                _ => group.iter().for_each(|child| times[child.at] = Some(parent)),
            }
        }
    }
    times
}

fn checked(begin: u64, end: u64, annotations: &Annotations<'_>, i: usize, told: &mut Told) -> Option<Times> {
    let annotation = annotations.get(i);
    let id = short(annotation.id);
    if end < begin {
        let message = format!("the annotation `{id}` ends ({end}) before it begins ({begin})");
        let fault = Diagnostic::fault(annotation.span, message).label("expected an end after the beginning");
        told.say(fault.hint("are its two time slots exchanged?"));
        return None;
    }
    if begin == end {
        let warning = Diagnostic::warning(annotation.span, format!("the annotation `{id}` has no length"));
        told.say(warning.label("ELAN leaves it out"));
    }
    Some((begin, end))
}

/// An annotation that divides its parent.
struct Child {
    parent: usize,
    at: usize,
    previous: Option<usize>,
}

/// Gives the children of one parent even shares of its time, in the order of their chain.
fn divide(
    (begin, end): Times,
    group: &[Child],
    annotations: &Annotations<'_>,
    times: &mut [Option<Times>],
    told: &mut Told,
) {
    let mut after: HashMap<Option<usize>, usize> = HashMap::with_capacity(group.len());
    for child in group {
        if after.insert(child.previous, child.at).is_some() {
            let annotation = annotations.get(child.at);
            let message = match child.previous {
                Some(previous) => format!("two annotations follow `{}`", short(annotations.get(previous).id)),
                None => format!("two annotations come first below `{}`", short(annotations.get(child.parent).id)),
            };
            let fault = Diagnostic::fault(annotation.span, message).label("the second one");
            told.say(fault.hint("each annotation but the first names the one before in PREVIOUS_ANNOTATION"));
            return;
        }
    }
    let mut chain = Vec::with_capacity(group.len());
    let mut next = after.get(&None);
    // Each was put in once and has one before it, so this comes to an end.
    while let Some(&at) = next {
        chain.push(at);
        next = after.get(&Some(at));
    }
    if chain.len() < group.len() {
        let chain: BTreeSet<usize> = chain.into_iter().collect();
        let lost = group.iter().find(|child| !chain.contains(&child.at)).unwrap_or(&group[0]);
        let annotation = annotations.get(lost.at);
        let message = format!("no first annotation leads to `{}`", short(annotation.id));
        let fault = Diagnostic::fault(annotation.span, message).label("does not follow the others");
        told.say(fault.hint("do annotations name one another as PREVIOUS_ANNOTATION, in a circle?"));
        return;
    }
    let (whole, count) = (end - begin, chain.len() as u64);
    for (i, at) in chain.into_iter().enumerate() {
        let share = |i: u64| begin + whole * i / count;
        times[at] = Some((share(i as u64), share(i as u64 + 1)));
    }
}

/// The places of the tiers, parents before what hangs on them; tiers in a circle are told and left out.
fn parents_first(tiers: &[RawTier<'_>], told: &mut Told) -> Vec<usize> {
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); tiers.len()];
    let mut order = Vec::with_capacity(tiers.len());
    for (at, tier) in tiers.iter().enumerate() {
        match tier.parent_at {
            Some(parent) => below[parent].push(at),
            // An unknown parent was told; its tier's own annotations may still be looked at.
            None => order.push(at),
        }
    }
    let mut done = 0;
    while let Some(&at) = order.get(done) {
        order.append(&mut below[at]);
        done += 1;
    }
    let mut reached = vec![false; tiers.len()];
    order.iter().for_each(|&at| reached[at] = true);
    let circle = reached.iter().position(|reached| !reached);
    if let Some((at, (parent, span))) = circle.and_then(|at| Some((at, tiers[at].parent?))) {
        let message = format!("the tier `{}` hangs on `{}`, and that on it", short(tiers[at].name), short(parent));
        told.say(Diagnostic::fault(span, message).label("parents in a circle").hint("one of them hangs on nothing"));
    }
    order
}
