//! Signs made from others as text.

use super::movement::movements;
use super::sign_name;
use super::words::{configuration, duration, growth, nonmanual, orientation, place, placement, relocation};
use crate::notation::lex::quote;
use crate::notation::parse::recombination::{HEADS, KEPT_BY_MOVEMENTS};
use crate::notation::syntax::{Base, Expression, NonManual, Operator};
use crate::phonology::Hand;
use crate::phonology::operator::{BIG, FAST, SLOW, SMALL};

/// The right side of `sign NAME = …`.
pub(crate) fn expression(made: &Expression) -> String {
    let base = match &made.base {
        Base::Named(name) => base_name(&name.value),
        Base::Spelled(word) => format!("spelled {}", quote(word)),
        Base::Pointing(at) => format!("pointing at {}", place(at)),
        Base::WristAt([x, y, z]) => format!("wrist at {x} {y} {z}"),
        Base::Chain(parts) => {
            let parts: Vec<String> = parts.iter().map(|p| part(p, matches!(p.base, Base::Chain(_)), true)).collect();
            joined(parts, " then ", made)
        }
        Base::Hands(strong, weak) => {
            let joins = |p: &Expression| matches!(p.base, Base::Chain(_) | Base::Hands(..));
            let parts = vec![part(strong, joins(strong), false), part(weak, joins(weak), false)];
            joined(parts, " & ", made)
        }
    };
    let mut text = base;
    for (i, one) in made.operators.iter().enumerate() {
        let word = operator(one);
        let before = i.checked_sub(1).map(|before| &made.operators[before]);
        // A movement would take these words for its own.
        let of_movement = KEPT_BY_MOVEMENTS.iter().any(|w| word.starts_with(w));
        if of_movement && matches!(before, Some(Operator::Movement(..))) {
            text = format!("( {text} )");
            text.push(' ');
        } else {
            text.push_str(if before.is_some_and(values) { ", " } else { " " });
        }
        text.push_str(&word);
    }
    text
}

/// The operators of a gloss, separated by commas. A movement takes a `fast` after it for its own, so no list that was read has
/// one there.
pub(crate) fn operators(all: &[Operator]) -> String {
    all.iter().map(operator).collect::<Vec<_>>().join(", ")
}

fn base_name(name: &str) -> String {
    let taken = HEADS.iter().chain(&["then", "&"]).any(|w| w.eq_ignore_ascii_case(name));
    if taken { quote(name) } else { sign_name(name) }
}

fn joined(parts: Vec<String>, by: &str, made: &Expression) -> String {
    let text = parts.join(by);
    if made.operators.is_empty() { text } else { format!("( {text} )") }
}

/// A part in brackets where its text would run on. A part with operators after a group is bracketed already.
fn part(made: &Expression, joins: bool, before_then: bool) -> String {
    let open = before_then && ends_open(made);
    let text = expression(made);
    if joins && made.operators.is_empty() || open { format!("( {text} )") } else { text }
}

/// Whether a `then` after it would join one more value.
fn ends_open(made: &Expression) -> bool {
    match (made.operators.last(), &made.base) {
        (Some(last), _) => values(last),
        (None, Base::Hands(_, weak)) => ends_open(weak),
        (None, _) => false,
    }
}

/// Whether an operator has values that go on after `then`.
fn values(operator: &Operator) -> bool {
    match operator {
        Operator::Configuration(..)
        | Operator::Orientation(..)
        | Operator::Placement(..)
        | Operator::Movement(..)
        | Operator::NonManual(..) => true,
        Operator::Inverted
        | Operator::InvertedMovement
        | Operator::Mirrored
        | Operator::Swapped
        | Operator::Reflected
        | Operator::Repeated { .. }
        | Operator::At(_)
        | Operator::Speed(_)
        | Operator::Size(_) => false,
    }
}

/// A non-manual value; its own speed in brackets, so that it is not the sign's.
fn paced(v: &NonManual) -> String {
    if v.pace.is_some() { format!("( {} )", nonmanual(v)) } else { nonmanual(v) }
}

fn operator(operator: &Operator) -> String {
    let with = |hand: &Option<Hand>, tier: &str, values: String| {
        let hand = match hand {
            None => "",
            Some(Hand::Strong) => "strong ",
            Some(Hand::Weak) => "weak ",
        };
        format!("with {hand}{tier} {values}")
    };
    fn all<T>(values: &[T], one: impl Fn(&T) -> String) -> String {
        values.iter().map(one).collect::<Vec<_>>().join(" then ")
    }
    match operator {
        Operator::Inverted => "inverted".into(),
        Operator::InvertedMovement => "inverted movement".into(),
        Operator::Mirrored => "mirrored".into(),
        Operator::Swapped => "swapped".into(),
        Operator::Reflected => "reflected".into(),
        Operator::Repeated { times, gap, growth: g } => {
            let gap = gap.map(|gap| format!(" gap {}", duration(gap))).unwrap_or_default();
            format!("repeated {times}{gap}{}", growth(*g))
        }
        Operator::Configuration(hand, v) => with(hand, "configuration", all(v, configuration)),
        Operator::Orientation(hand, v) => with(hand, "orientation", all(v, orientation)),
        Operator::Placement(hand, v) => with(hand, "placement", all(v, placement)),
        Operator::Movement(hand, v) => with(hand, "movement", movements(v)),
        Operator::NonManual(channel, v) => with(&None, channel.name(), all(v, paced)),
        Operator::At(to) => format!("at {}", relocation(to)),
        Operator::Speed(factor) if *factor == FAST => "fast".into(),
        Operator::Speed(factor) if *factor == SLOW => "slow".into(),
        Operator::Speed(factor) => format!("speed {factor}"),
        Operator::Size(factor) if *factor == BIG => "big".into(),
        Operator::Size(factor) if *factor == SMALL => "small".into(),
        Operator::Size(factor) => format!("size {factor}"),
    }
}
