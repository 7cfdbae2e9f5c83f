//! Signs made from others: expressions with their names looked up, and what their own lines say.

use super::value::{Names, check_palms, orientation};
use super::{Block, Seconds};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::notation::syntax::{self, Expression, Ignored, Value};
use crate::notation::vocabulary::Vocabulary;
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{Keys, Relocation, Sign};
use glam::DVec3;

/// A sign made from others, before those are looked up.
#[derive(Debug, Clone, PartialEq)]
pub struct Derived {
    /// What it is made from; the non-manual lines below it are operators at the end.
    pub from: Recombination,
    /// What its own lines say: name, language, meaning, source, status, note, duration, speed, base.
    pub own: Sign,
    /// Where its name stands.
    pub name_span: Span,
    /// Where the names of the signs that it is made from stand.
    pub names: Vec<Spanned<String>>,
}

/// Operators with their names looked up; what has a fault is left out, and told.
pub(crate) fn operators(
    written: &[syntax::Operator],
    vocabulary: &Vocabulary,
    language: &str,
    faults: &mut Vec<Diagnostic>,
) -> Vec<Operator> {
    let names = Names { vocabulary, language };
    written.iter().filter_map(|one| operator(one, &names, Span::default(), faults)).collect()
}

impl Block<'_> {
    /// A sign made from others.
    pub(super) fn derived(
        &self,
        made: &Expression,
        vocabulary: &Vocabulary,
        language: &str,
        faults: &mut Vec<Diagnostic>,
    ) -> Option<Derived> {
        let name = self.name?;
        let names = Names { vocabulary, language };
        let mut own = Sign { language: language.to_owned(), ..Sign::named(name.value.clone()) };
        self.twice(faults);
        self.header(&mut own);
        let mut found = Vec::new();
        let from = recombination(made, &names, name.span, &mut found, faults);
        let mut more = Vec::new();
        for tier in &self.tiers {
            match &tier.value {
                Value::Meaning(_)
                | Value::Source(_)
                | Value::Status(_)
                | Value::Note(_)
                | Value::Duration(_)
                | Value::Speed(_) => {}
                Value::Base(all) => own.base = names.base(all, faults),
                Value::NonManual(channel, values) => {
                    if let Some(at) = values.iter().find_map(|v| v.at) {
                        faults.push(
                            Diagnostic::fault(at.span, "keys are not named in a sign made from others")
                                .label("here")
                                .hint("give one value, or one for each key"),
                        );
                    }
                    let values = values.iter().filter_map(|v| names.nonmanual(*channel, &v.value, faults));
                    more.push(Operator::NonManual(*channel, spread(values.collect())));
                }
                Value::Hands(_)
                | Value::Configuration(_)
                | Value::Placement(_)
                | Value::Orientation(_)
                | Value::Movement(_)
                | Value::Contact(_)
                | Value::At(_) => faults.push(self.not_below(tier)),
            }
        }
        if let Some(phase) = self.then.first() {
            faults.push(
                Diagnostic::fault(phase.span, "a sign made from others has no phases of its own")
                    .label("here")
                    .hint("describe what follows as a sign, and join them: `= A then B`"),
            );
        }
        let mut from = from?;
        from.operators.extend(more);
        Some(Derived { from, own, name_span: name.span, names: found })
    }

    fn not_below(&self, tier: &syntax::TierLine) -> Diagnostic {
        let word = tier.value.keyword();
        let fault = Diagnostic::fault(tier.keyword.0, format!("`{word}` does not stand below a sign made from others"))
            .label("here");
        match tier.value {
            Value::At(_) => fault.hint("write it as an operator: `= BOL at left`"),
            Value::Hands(_) => fault.hint("`mirrored` makes two hands of one"),
            Value::Contact(_) => fault.hint("describe the sign by its own tiers"),
            _ => fault.hint(format!("write it as an operator: `… with {word} …`")),
        }
    }
}

/// Values at the first keys, one each.
fn spread<T>(values: Vec<T>) -> Keys<T> {
    Keys::new(values.into_iter().enumerate().collect()).unwrap_or_default()
}

fn recombination(
    written: &Expression,
    names: &Names,
    span: Span,
    found: &mut Vec<Spanned<String>>,
    faults: &mut Vec<Diagnostic>,
) -> Option<Recombination> {
    let mut part = |e: &Expression, faults: &mut Vec<Diagnostic>| recombination(e, names, span, found, faults);
    let base = match &written.base {
        syntax::Base::Chain(parts) => {
            Some(Base::Chain(parts.iter().map(|e| part(e, faults)).collect::<Option<Vec<_>>>()?))
        }
        syntax::Base::Hands(strong, weak) => {
            let (strong, weak) = (part(strong, faults), part(weak, faults));
            Some(Base::Hands(Box::new(strong?), Box::new(weak?)))
        }
        syntax::Base::Named(name) => {
            found.push(name.clone());
            Some(Base::Named(name.value.clone()))
        }
        syntax::Base::Spelled(word) => Some(Base::Spelled(word.clone())),
        syntax::Base::Pointing(at) => names.place(at, faults).map(Base::Pointing),
        syntax::Base::WristAt(point) => Some(Base::WristAt(DVec3::from_array(*point))),
    };
    let operators: Vec<Operator> =
        written.operators.iter().filter_map(|one| operator(one, names, span, faults)).collect();
    (operators.len() == written.operators.len()).then_some(Recombination { base: base?, operators })
}

fn operator(written: &syntax::Operator, names: &Names, span: Span, faults: &mut Vec<Diagnostic>) -> Option<Operator> {
    fn all<T, U>(written: &[T], one: impl FnMut(&T) -> Option<U>) -> Option<Keys<U>> {
        written.iter().map(one).collect::<Option<Vec<U>>>().map(spread)
    }
    Some(match written {
        syntax::Operator::Inverted => Operator::Inverted,
        syntax::Operator::InvertedMovement => Operator::InvertedMovement,
        syntax::Operator::Mirrored => Operator::Mirrored,
        syntax::Operator::Swapped => Operator::Swapped,
        syntax::Operator::Reflected => Operator::Reflected,
        syntax::Operator::Repeated { times, gap, growth } => {
            Operator::Repeated { times: *times, gap: gap.map(|gap| Seconds(gap.seconds())), growth: *growth }
        }
        syntax::Operator::Configuration(hand, v) => {
            Operator::Configuration(*hand, all(v, |v| names.configuration(v, faults))?)
        }
        syntax::Operator::Placement(hand, v) => Operator::Placement(*hand, all(v, |v| names.placement(v, faults))?),
        syntax::Operator::Orientation(hand, v) => {
            let before = faults.len();
            let placed = |v: &syntax::Orientation| syntax::Placed { value: v.clone(), at: None, span: Ignored(span) };
            check_palms(&v.iter().map(placed).collect(), faults);
            if faults.len() > before {
                return None;
            }
            Operator::Orientation(*hand, all(v, |v| Some(orientation(v)))?)
        }
        syntax::Operator::Movement(hand, v) => {
            let movements = names.movements(v, span, faults);
            if movements.len() != v.len() {
                return None;
            }
            Operator::Movement(*hand, movements)
        }
        syntax::Operator::NonManual(channel, v) => {
            Operator::NonManual(*channel, all(v, |v| names.nonmanual(*channel, v, faults))?)
        }
        syntax::Operator::At(to) => {
            Operator::At(Relocation { place: names.place(&to.place, faults)?, forced: to.forced })
        }
        syntax::Operator::Speed(factor) => Operator::Speed(*factor),
        syntax::Operator::Size(factor) => Operator::Size(*factor),
    })
}
