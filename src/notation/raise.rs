//! What a sign means to what one would write: [`Sign`] → [`super::syntax`].

mod movement;

use super::syntax::{
    self, ContactKind, Content, Duration, File, Ignored, Key, Length, Line, NonManualWhat, OtherHand, Placed, TierLine,
    Value, Values,
};
use crate::diagnostics::{Span, Spanned};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{
    Action, Attested, Configuration, Contact, Distance, Hand, Hands, Keys, Manual, Motion, Movement, NonManual,
    NonManualValue, Orientation, Place, Placement, Sign, Sited,
};
pub(crate) use movement::movement;

/// A sign as text.
///
/// ```
/// use chereme::notation::{Vocabulary, read, write};
/// let text = "language lsf\n\nsign BOL\n  hands          both mirrored\n  movement       up-right 15cm\n";
/// let sign = &read(text, &Vocabulary::open(), "").signs[0].sign;
/// assert_eq!(write(sign), text);
/// ```
pub fn write(sign: &Sign) -> String {
    super::print(&raise(sign))
}

/// A sign made from others as text.
///
/// ```
/// use chereme::notation::write_derived;
/// use chereme::phonology::operator::Operator;
/// use chereme::phonology::recombination::{Base, Recombination};
/// let from = Recombination { base: Base::Named("CLAIR".into()), operators: vec![Operator::Inverted] };
/// assert_eq!(write_derived("FONCÉ", &from), "sign FONCÉ = CLAIR inverted\n");
/// ```
pub fn write_derived(name: &str, from: &Recombination) -> String {
    let content = Content::Sign(plain(name.to_owned()), Some(expression(from)));
    super::print(&File { lines: vec![line(content)] })
}

/// What one would write to say this sign: the shortest form, each tier on its line.
pub fn raise(sign: &Sign) -> File {
    let mut lines = Vec::new();
    if !sign.language.is_empty() {
        lines.push(line(Content::Language(plain(sign.language.clone()))));
    }
    lines.push(line(Content::Sign(plain(sign.name.clone()), None)));
    tiers(sign, &mut lines);
    for phase in &sign.then {
        let other = if phase.holds_over { OtherHand::Stays } else { OtherHand::Free };
        lines.push(line(Content::Then(other)));
        tiers(phase, &mut lines);
    }
    File { lines }
}

/// The tiers of a sign or of one of its phases.
fn tiers(sign: &Sign, lines: &mut Vec<Line>) {
    let n = sign.intervals;
    let mut say = |hand: Option<Hand>, value: Value| {
        lines.push(line(Content::Tier(TierLine { hand, keyword: Ignored::default(), value })));
    };
    if !sign.meaning.is_empty() {
        say(None, Value::Meaning(sign.meaning.clone()));
    }
    if let Some(text) = &sign.source {
        say(None, Value::Source(text.clone()));
    }
    if let Some(text) = &sign.status {
        say(None, Value::Status(text.clone()));
    }
    if let Some(text) = &sign.note {
        say(None, Value::Note(text.clone()));
    }
    if sign.hands != Hands::Strong {
        say(None, Value::Hands(sign.hands));
    }
    let implied = movement_is_implied(sign);
    let tier = |value: fn(&Manual, usize) -> Option<Value>| {
        let (strong, weak) = (value(&sign.strong, n), value(&sign.weak, n));
        share(sign.hands, strong, weak)
    };
    let all = [
        tier(|m, n| keys(&m.configuration, n, configuration).map(Value::Configuration)),
        tier(|m, n| keys(&m.placement, n, placement).map(Value::Placement)),
        tier(|m, n| keys(&m.orientation, n, orientation).map(Value::Orientation)),
    ];
    for (hand, value) in all.into_iter().flatten() {
        say(hand, value);
    }
    let moves =
        |m: &Manual| (!m.movement.is_empty()).then(|| Value::Movement(m.movement.iter().map(movement).collect()));
    let (strong, mut weak) = (moves(&sign.strong), moves(&sign.weak));
    let acting = if sign.hands == Hands::Weak { weak.take() } else { strong };
    // Stated nowhere, the keys of a sign are joined by plain changes.
    let nowhere = acting.is_none() && weak.is_none() && n > 0;
    let acting = acting.or(nowhere.then(|| Value::Movement(vec![movement(&change()); n])));
    if let (Some(value), false) = (acting, implied) {
        say(None, value);
    }
    if let Some(value) = weak {
        say(Some(Hand::Weak), value);
    }
    if let Some(values) = keys(&sign.contact, n, |v| contact(*v)) {
        say(None, Value::Contact(values));
    }
    for (channel, values) in &sign.nonmanual {
        if let Some(values) = keys(values, n, nonmanual) {
            say(None, Value::NonManual(*channel, values));
        }
    }
    if let Some(long) = sign.duration {
        say(None, Value::Duration(duration(long.0)));
    }
    if sign.speed != 1.0 {
        say(None, Value::Speed(sign.speed));
    }
    if !sign.base.is_empty() {
        let attested = |a: &Attested| syntax::Attested {
            configuration: configuration(&a.configuration),
            meaning: a.meaning.clone(),
        };
        say(None, Value::Base(sign.base.iter().map(attested).collect()));
    }
    if let Some(to) = &sign.relocated {
        say(None, Value::At(syntax::Relocation { place: place(&to.place), forced: to.forced }));
    }
}

/// What one would write for a sign made from others.
pub(crate) fn expression(of: &Recombination) -> syntax::Expression {
    let base = match &of.base {
        Base::Named(name) => syntax::Base::Named(plain(name.clone())),
        Base::Spelled(word) => syntax::Base::Spelled(word.clone()),
        Base::Pointing(at) => syntax::Base::Pointing(place(at)),
        Base::WristAt(point) => syntax::Base::WristAt(point.to_array()),
        Base::Chain(parts) => syntax::Base::Chain(parts.iter().map(expression).collect()),
        Base::Hands(strong, weak) => syntax::Base::Hands(Box::new(expression(strong)), Box::new(expression(weak))),
    };
    syntax::Expression { base, operators: of.operators.iter().map(operator).collect() }
}

fn operator(v: &Operator) -> syntax::Operator {
    fn all<T, U>(keys: &Keys<T>, one: impl Fn(&T) -> U) -> Vec<U> {
        keys.iter().map(|(_, value)| one(value)).collect()
    }
    match v {
        Operator::Inverted => syntax::Operator::Inverted,
        Operator::InvertedMovement => syntax::Operator::InvertedMovement,
        Operator::Mirrored => syntax::Operator::Mirrored,
        Operator::Swapped => syntax::Operator::Swapped,
        Operator::Reflected => syntax::Operator::Reflected,
        Operator::Repeated { times, gap, growth } => {
            syntax::Operator::Repeated { times: *times, gap: gap.map(|gap| duration(gap.0)), growth: *growth }
        }
        Operator::Configuration(hand, v) => syntax::Operator::Configuration(*hand, all(v, configuration)),
        Operator::Orientation(hand, v) => syntax::Operator::Orientation(*hand, all(v, orientation)),
        Operator::Placement(hand, v) => syntax::Operator::Placement(*hand, all(v, placement)),
        Operator::Movement(hand, v) => syntax::Operator::Movement(*hand, v.iter().map(movement).collect()),
        Operator::NonManual(channel, v) => syntax::Operator::NonManual(*channel, all(v, nonmanual)),
        Operator::At(to) => syntax::Operator::At(syntax::Relocation { place: place(&to.place), forced: to.forced }),
        Operator::Speed(factor) => syntax::Operator::Speed(*factor),
        Operator::Size(factor) => syntax::Operator::Size(*factor),
    }
}

fn line(content: Content) -> Line {
    Line { content: Some(content), comment: None, span: Ignored::default() }
}

fn plain<T>(value: T) -> Spanned<T> {
    Spanned::new(value, Span::default())
}

/// Which prefixes say a tier of both hands.
fn share(hands: Hands, strong: Option<Value>, weak: Option<Value>) -> Vec<(Option<Hand>, Value)> {
    match hands {
        Hands::Strong => strong.map(|v| (None, v)).into_iter().collect(),
        Hands::Weak => weak.map(|v| (None, v)).into_iter().collect(),
        Hands::Both(None) if strong == weak => strong.map(|v| (None, v)).into_iter().collect(),
        Hands::Both(None) => {
            let strong = strong.map(|v| (Some(Hand::Strong), v));
            strong.into_iter().chain(weak.map(|v| (Some(Hand::Weak), v))).collect()
        }
        Hands::Both(Some(_)) => {
            let strong = strong.map(|v| (None, v));
            strong.into_iter().chain(weak.map(|v| (Some(Hand::Weak), v))).collect()
        }
    }
}

fn change() -> Movement {
    Movement::Action(Box::new(Action::new(Motion::Change)))
}

/// Whether the movement is only what joins the keys of another tier, so that it need not be said.
fn movement_is_implied(sign: &Sign) -> bool {
    let (acting, other) = match sign.hands {
        Hands::Weak => (&sign.weak, &sign.strong),
        Hands::Strong | Hands::Both(_) => (&sign.strong, &sign.weak),
    };
    let plain = other.movement.is_empty()
        && acting.movement.len() == sign.intervals
        && acting.movement.iter().all(|m| *m == change());
    let full = |count: usize| count == sign.intervals + 1;
    let manual = |m: &Manual| full(m.configuration.len()) || full(m.placement.len()) || full(m.orientation.len());
    sign.intervals > 0
        && plain
        && (manual(acting)
            || manual(other)
            || full(sign.contact.len())
            || sign.nonmanual.iter().any(|(_, keys)| full(keys.len())))
}

/// Values at keys: bare where one spreads or each key has one, else with their keys.
fn keys<T, U>(keys: &Keys<T>, intervals: usize, value: impl Fn(&T) -> U) -> Option<Values<U>> {
    if keys.is_empty() {
        return None;
    }
    let spreads = keys.len() == 1 && keys.stated(0).is_some();
    let named = !(spreads || keys.len() == intervals + 1);
    let at = |key: usize| match key {
        0 => Key::Start,
        k if k == intervals => Key::End,
        k if 2 * k == intervals => Key::Middle,
        k => Key::Number(k + 1),
    };
    let placed = keys.iter().map(|(key, v)| Placed {
        value: value(v),
        at: named.then(|| plain(at(key))),
        span: Ignored::default(),
    });
    Some(placed.collect())
}

fn configuration(v: &Configuration) -> syntax::Configuration {
    syntax::Configuration {
        base: plain(v.base.clone()),
        between: v.between.as_ref().map(|b| {
            let (first, changes) = (b.first.clone(), b.changes.clone());
            Box::new(syntax::Between { first, second: plain(b.second.clone()), changes })
        }),
        changes: v.changes.clone(),
    }
}

fn place(v: &Place) -> syntax::Place {
    match v {
        Place::Body(name) => syntax::Place::Named(plain(name.clone())),
        Place::OtherHand(point) => syntax::Place::OtherHand(*point),
        Place::Space(cell) => syntax::Place::Space(*cell),
        Place::Point(at) => syntax::Place::Point(at.to_array()),
        Place::Between(a, b) => syntax::Place::Between(Box::new(sited(a)), Box::new(sited(b))),
        Place::Referent(name) => syntax::Place::Referent(name.clone()),
        Place::Towards(at) => syntax::Place::Towards(Box::new(place(at))),
    }
}

fn sited(v: &Sited) -> syntax::Sited {
    syntax::Sited { place: place(&v.place), side: v.lateral.map(|l| (l.side, l.beside)) }
}

/// A placement as one would write it.
pub(crate) fn placement(v: &Placement) -> syntax::Placement {
    syntax::Placement {
        behind: v.behind,
        place: place(&v.place),
        side: v.lateral.map(|l| (l.side, l.beside)),
        distance: match v.distance {
            Distance::Unmarked => None,
            Distance::Touch => Some(syntax::Distance::Touch),
            Distance::Close => Some(syntax::Distance::Close),
            Distance::Neutral => Some(syntax::Distance::Neutral),
            Distance::Extended => Some(syntax::Distance::Extended),
            Distance::Metres(far) => Some(syntax::Distance::Length(Length::from_metres(far))),
        },
        with: v.with,
        offset: v.offset.map(|(way, far)| (way, Length::from_metres(far))),
    }
}

fn orientation(v: &Orientation) -> syntax::Orientation {
    syntax::Orientation { fingers: v.fingers.map(plain), palm: v.palm.map(plain), along_path: v.along_path }
}

fn duration(seconds: f64) -> Duration {
    Duration { number: seconds, milliseconds: false }
}

fn contact(v: Contact) -> syntax::Contact {
    use crate::phonology::ContactKind as Meant;
    let kind = match v.kind {
        Meant::Touch => ContactKind::Touches,
        Meant::Close => ContactKind::CloseTo,
        Meant::Crossed => ContactKind::Crosses,
        Meant::Interlocked => ContactKind::Interlocks,
        Meant::Metres(far) => ContactKind::LengthFrom(Length::from_metres(far)),
    };
    syntax::Contact { strong: v.strong, kind, weak: v.weak }
}

fn nonmanual(v: &NonManual) -> syntax::NonManual {
    let what = match &v.value {
        NonManualValue::Named(name) => NonManualWhat::Named(plain(name.clone())),
        NonManualValue::Towards(heading) => NonManualWhat::Towards(*heading),
        NonManualValue::At(place) => NonManualWhat::At(Box::new(placement(place))),
        NonManualValue::Mouthing(sounds) => NonManualWhat::Mouthing(sounds.clone()),
        NonManualValue::Sequence(parts) => NonManualWhat::Sequence(parts.iter().map(nonmanual).collect()),
        NonManualValue::Together(parts) => NonManualWhat::Together(parts.iter().map(nonmanual).collect()),
    };
    syntax::NonManual { what, amount: v.amount, pace: (v.pace != 1.0).then_some(v.pace) }
}
