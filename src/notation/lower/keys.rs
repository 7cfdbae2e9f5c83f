//! Counting keys and intervals, and putting values at their keys.
//!
//! N movements make N intervals and N + 1 keys; without a movement, n values make n − 1 intervals. One value
//! spreads, N + 1 stand at one key each, any other count must say where its values stand.

use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::notation::syntax::{Key, Values};
use crate::phonology::{Keys, Sign};

/// What the tiers say of the number of intervals.
#[derive(Default)]
pub(super) struct Tally {
    /// The number of intervals, once settled.
    pub intervals: usize,
    /// Whether a line could not be read: then the count may be wrong, and nothing is said of it.
    incomplete: bool,
    /// The tier that counts: its count, name and place.
    counted: Option<(usize, &'static str, Span)>,
    moves: bool,
    tiers: Vec<TierCount>,
}

struct TierCount {
    count: usize,
    placed: Vec<Option<Spanned<Key>>>,
    name: &'static str,
    span: Span,
}

impl Tally {
    /// Nothing counted yet; `incomplete` where a line of the sign could not be read.
    pub(super) fn new(incomplete: bool) -> Tally {
        Tally { incomplete, ..Tally::default() }
    }

    /// A movement tier.
    pub(super) fn movements(&mut self, count: usize, span: Span, faults: &mut Vec<Diagnostic>) {
        match self.counted {
            None => {
                self.counted = Some((count, "movement", span));
                self.moves = true;
            }
            Some((first, _, there)) if first != count && !self.incomplete => faults.push(
                Diagnostic::fault(span, format!("the hands have {first} and {count} movements"))
                    .label(format!("{count} here"))
                    .related(there, format!("{first} here"))
                    .hint("give both hands as many; `hold` fills an interval in which a hand stays"),
            ),
            Some(_) => {}
        }
    }

    /// A tier of values at keys.
    pub(super) fn keys<T>(&mut self, tier: Option<(&Values<T>, Span)>, name: &'static str) {
        if let Some((values, span)) = tier {
            let placed = values.iter().map(|v| v.at).collect();
            self.tiers.push(TierCount { count: values.len(), placed, name, span });
        }
    }

    /// The number of intervals; `None` where it is beyond all measure.
    pub(super) fn settle(mut self, faults: &mut Vec<Diagnostic>) -> Option<Tally> {
        if self.counted.is_none() {
            let all = self.tiers.iter().filter(|t| t.count > 1 && t.placed.iter().all(Option::is_none));
            if let Some(first) = all.clone().next() {
                self.counted = Some((first.count - 1, first.name, first.span));
            }
        }
        let counted = self.counted.map_or(0, |(n, _, _)| n);
        // Keys that are named stretch a sign without movements.
        let named = self.tiers.iter().flat_map(|t| t.placed.iter().flatten()).map(|key| match key.value {
            Key::Start => 0,
            Key::Middle => 2,
            Key::End => 1,
            Key::Number(n) => n.saturating_sub(1),
        });
        self.intervals = if self.counted.is_some() { counted } else { named.max().unwrap_or(0) };
        if self.intervals > Sign::MOST_INTERVALS {
            let (_, name, span) = self.counted.unwrap_or((0, "", Span::default()));
            faults.push(
                Diagnostic::fault(span, format!("this {name} has more than {} parts", Sign::MOST_INTERVALS))
                    .label("here")
                    .hint("a sign this long is several signs"),
            );
            return None;
        }
        for tier in &self.tiers {
            if !self.incomplete
                && tier.placed.iter().all(Option::is_none)
                && tier.count != 1
                && tier.count != self.intervals + 1
            {
                faults.push(self.miscounted(tier));
            }
        }
        Some(self)
    }

    fn miscounted(&self, tier: &TierCount) -> Diagnostic {
        let (n, keys) = (tier.count, self.intervals + 1);
        let Some((_, other, span)) = self.counted else {
            return Diagnostic::fault(tier.span, format!("{} has {n} values, the sign has {keys} keys", tier.name));
        };
        let there = if self.moves { self.intervals } else { keys };
        let unit = |count: usize, moves: bool| match (count, moves) {
            (1, true) => "1 movement".to_owned(),
            (n, true) => format!("{n} movements"),
            (n, false) => format!("{n} values"),
        };
        let message = if self.moves {
            format!(
                "{} has {n} values, but {} make{} {keys} keys",
                tier.name,
                unit(there, true),
                if there == 1 { "s" } else { "" }
            )
        } else {
            format!("{} has {n} values and {other} has {there}", tier.name)
        };
        let expected = if keys == 1 { "1 value".to_owned() } else { format!("1 or {keys} values") };
        Diagnostic::fault(tier.span, message)
            .label(format!("{n} values here, expected {expected}"))
            .related(span, unit(there, self.moves))
            .hint("join one movement for each change by `then`, or say where the values stand: `at start`, `at middle`, `at end`, `at key 2`")
    }

    /// The key of a value that says where it stands.
    fn key(&self, at: Spanned<Key>, faults: &mut Vec<Diagnostic>) -> Option<usize> {
        let last = self.intervals;
        match at.value {
            Key::Start => Some(0),
            Key::End => Some(last),
            Key::Middle if last > 0 && last.is_multiple_of(2) => Some(last / 2),
            Key::Number(n) if n >= 1 && n <= last + 1 => Some(n - 1),
            Key::Middle | Key::Number(_) if self.incomplete => None,
            Key::Middle => {
                let made = if last == 1 { "1 movement has".to_owned() } else { format!("{last} movements have") };
                faults.push(
                    Diagnostic::fault(at.span, "this sign has no middle key")
                        .label(format!("{made} {} keys", last + 1))
                        .hint("two movements have a key between them; or give the key by its number: `at key 2`"),
                );
                None
            }
            Key::Number(n) => {
                faults.push(
                    Diagnostic::fault(at.span, format!("there is no key {n}"))
                        .label(format!("keys go from 1 to {}", last + 1))
                        .hint("each movement adds a key after it"),
                );
                None
            }
        }
    }
}

/// A tier's values at their keys, each made by `make`; what cannot be made is left out, with its fault told.
pub(super) fn place<T, U>(
    (values, _): (&Values<T>, Span),
    tally: &Tally,
    faults: &mut Vec<Diagnostic>,
    make: impl Fn(&T, &mut Vec<Diagnostic>) -> Option<U>,
) -> Keys<U> {
    let named = values.iter().any(|v| v.at.is_some());
    let mut out: Vec<(usize, U)> = Vec::with_capacity(values.len());
    for (i, value) in values.iter().enumerate() {
        let made = make(&value.value, faults);
        let key = match value.at {
            Some(at) => tally.key(at, faults),
            None if !named || i == 0 => Some(i),
            None => {
                faults.push(
                    Diagnostic::fault(value.span.0, "where does this value stand?")
                        .label("a key is missing")
                        .hint("once a value says where it stands, all after the first must: `at middle`, `at end`, `at key 2`"),
                );
                None
            }
        };
        let (Some(made), Some(key)) = (made, key) else { continue };
        if let Some((last, _)) = out.last()
            && *last >= key
        {
            faults.push(
                Diagnostic::fault(value.span.0, "the keys of these values do not rise")
                    .label(format!("stands at key {}, after key {}", key + 1, last + 1))
                    .hint("values are written in the order of their keys"),
            );
            continue;
        }
        out.push((key, made));
    }
    // They rise: checked one by one above.
    Keys::new(out).unwrap_or_default()
}
