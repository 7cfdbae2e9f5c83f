//! The items of a line in order: what was signed where is known to those that follow.

use super::lookup::Lookup;
use super::{Known, captured, signed};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::notation::gloss::syntax::{Face, GlossLine, Head, Item, Signed, Site, What};
use crate::notation::lower::nonmanual;
use crate::notation::suggest::nearest;
use crate::phonology::grammar::fold;
use crate::phonology::{Channel, NonManual, NonManualValue, Place, Placement};
use crate::score::plan::{self, Act, Over, Plan};
use crate::time::Seconds;
use glam::DVec3;
use std::ops::Range;

/// A line on its way to a plan.
pub(super) struct Line<'l> {
    pub lookup: &'l Lookup<'l>,
    pub diagnostics: &'l mut Vec<Diagnostic>,
    pub known: &'l Known<'l>,
    text: &'l str,
    plan: Plan,
    /// Glosses that were placed, in order, and where.
    placed: Vec<(String, Place)>,
    /// Glosses that were signed, in order.
    signed: Vec<String>,
}

/// The plan of a line; faults and warnings are added to `diagnostics`.
pub(super) fn lower(
    line: &GlossLine,
    text: &str,
    lookup: &Lookup,
    known: &Known,
    diagnostics: &mut Vec<Diagnostic>,
) -> Plan {
    let plan = Plan::default();
    let mut all = Line { lookup, diagnostics, known, text, plan, placed: Vec::new(), signed: Vec::new() };
    all.items(&line.items);
    all.plan
}

impl Line<'_> {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            let span = item.span.0;
            let act = match &item.what {
                What::Signed(one) => match captured::of(self, one) {
                    Some(captured) => captured.map(|captured| Act::Captured(Box::new(captured))),
                    None => signed::sign(self, one).map(|sign| Act::Sign(Box::new(sign))),
                },
                What::Together(strong, weak) => {
                    signed::together(self, strong, weak).map(|sign| Act::Sign(Box::new(sign)))
                }
                What::Pause(pause) => self.held(span).then(|| Act::Hold(None, Some(Seconds(pause.seconds())))),
                What::Hold(hand, long) => {
                    let hand = hand.map(|hand| self.lookup.settings.handedness.hand(hand));
                    self.held(span).then(|| Act::Hold(hand, long.map(|l| Seconds(l.seconds()))))
                }
                What::Rest(long) => Some(Act::Rest(long.map(|l| Seconds(l.seconds())))),
                What::Face(face) => {
                    // Braces nest only as deep as the parser lets them.
                    self.face(face);
                    None
                }
            };
            let gloss = self.text.get(span.start..span.end).unwrap_or_default().to_owned();
            self.plan.items.extend(act.map(|act| plan::Item { gloss, act, span: Some(span) }));
            self.note(&item.what);
        }
    }

    /// Whether there is a posture to hold; a fault where nothing was signed yet.
    fn held(&mut self, span: Span) -> bool {
        let begun = !self.signed.is_empty();
        if !begun {
            self.diagnostics.push(
                Diagnostic::fault(span, "there is no posture to hold yet")
                    .label("nothing was signed before this")
                    .hint("`<REST 1s>` waits in the neutral pose"),
            );
        }
        begun
    }

    /// Keeps in mind what was signed, and where.
    fn note(&mut self, what: &What) {
        let signs: &[&Signed] = match what {
            What::Signed(one) => &[one],
            What::Together(strong, weak) => &[strong, weak],
            What::Pause(_) | What::Hold(..) | What::Rest(_) | What::Face(_) => &[],
        };
        for signed in signs {
            let name = match &signed.head.value {
                Head::Gloss(name) | Head::Spelled(name) => name.clone(),
                Head::Taken(taken) => taken.take.clone(),
                Head::Pointing(_) | Head::Wrist(_) => String::new(),
            };
            if let Some(Ok(place)) = signed.site.as_ref().map(|site| self.resolve(&site.value)) {
                self.placed.push((name.clone(), place));
            }
            self.signed.push(name);
        }
    }

    /// The place that a site means; a fault where no sign of that gloss was placed before.
    pub(super) fn place(&mut self, site: &Spanned<Site>) -> Option<Place> {
        match self.resolve(&site.value) {
            Ok(place) => Some(place),
            Err(name) => {
                let fault = Diagnostic::fault(site.span, format!("nothing was signed at `{name}`"));
                let known = self.placed.iter().map(|(n, _)| n.as_str());
                let steps = crate::notation::parse::placement::STEPS.map(|(word, _)| word);
                let signed = self.signed.iter().any(|s| fold(s) == fold(name));
                self.diagnostics.push(match nearest(name, known.chain(steps)) {
                    _ if signed => fault
                        .label("this sign was not placed")
                        .hint(format!("say where it is made: `{name}@left … IX({name})`")),
                    Some(near) => fault.label("unknown place").hint(format!("did you mean `{near}`?")),
                    None => fault
                        .label("unknown place")
                        .hint("a place is `left`, `right-high`, `far` …, `(0.3,1.2,0.4)` in metres, or a sign placed before: `MAISON@left … IX(MAISON)`"),
                });
                None
            }
        }
    }

    fn resolve<'s>(&self, site: &'s Site) -> Result<Place, &'s str> {
        match site {
            Site::Space(cell) => Ok(Place::Space(*cell)),
            Site::Point(at) => Ok(Place::Point(DVec3::from_array(*at))),
            Site::Referent(name) => {
                let last = self.placed.iter().rev().find(|(placed, _)| fold(placed) == fold(name));
                last.map(|(_, place)| place.clone()).ok_or(name)
            }
        }
    }

    fn face(&mut self, face: &Face) {
        let (start, outer) = (self.plan.items.len(), self.plan.spans.len());
        self.items(&face.items);
        let whole = start..self.plan.items.len();
        let mut own = Vec::new();
        for (channel, written) in &face.values {
            let value = nonmanual(channel.value, written, self.known.vocabulary, self.diagnostics);
            let Some(value) = value.and_then(|value| self.looked_at(value, channel)) else { continue };
            let inner = self.plan.spans[outer..].iter().filter(|over| over.channel == channel.value);
            let over = |items| Over { items, channel: channel.value, value: value.clone() };
            own.extend(without(whole.clone(), inner.map(|over| over.items.clone())).into_iter().map(over));
        }
        self.plan.spans.splice(outer..outer, own);
    }

    /// A gaze at a sign that was placed before looks there.
    fn looked_at(&mut self, value: NonManual, channel: &Spanned<Channel>) -> Option<NonManual> {
        let meant = match value.value {
            NonManualValue::At(Placement { place: Place::Referent(name), .. }) => {
                let place = self.place(&Spanned::new(Site::Referent(name), channel.span))?;
                NonManualValue::At(Placement::at(place))
            }
            NonManualValue::Sequence(parts) => NonManualValue::Sequence(self.all_looked_at(parts, channel)?),
            NonManualValue::Together(parts) => NonManualValue::Together(self.all_looked_at(parts, channel)?),
            other @ (NonManualValue::Named(_)
            | NonManualValue::Towards(_)
            | NonManualValue::At(_)
            | NonManualValue::Mouthing(_)) => other,
        };
        Some(NonManual { value: meant, ..value })
    }

    fn all_looked_at(&mut self, parts: Vec<NonManual>, channel: &Spanned<Channel>) -> Option<Vec<NonManual>> {
        parts.into_iter().map(|part| self.looked_at(part, channel)).collect()
    }
}

/// What is left of a range without some others, which do not overlap.
fn without(whole: Range<usize>, others: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    let mut others: Vec<_> = others.collect();
    others.sort_by_key(|range| range.start);
    let mut left = Vec::new();
    let mut from = whole.start;
    for other in others {
        left.push(from..other.start);
        from = other.end;
    }
    left.push(from..whole.end);
    left.retain(|range| !range.is_empty());
    left
}
