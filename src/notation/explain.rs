//! A sign in plain words, one tier a line, each with where it came from: stated, default, symmetry.
//!
//! In English the values stand as they are written in a sign, in French they are said in words.

mod french;
mod french_movement;
mod phrases;

use super::print::{expression, value};
use super::raise::raise;
use super::syntax::{Content, Value};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{Hand, Hands, LocationInventory, Manual, Relation, Sign};
use phrases::Phrases;

/// The language of an explanation.
#[derive(Debug, Clone, Copy)]
pub enum Tongue<'l> {
    /// Values are as they are written in a sign.
    English,
    /// Values are said in words; the inventory has the places' names.
    French(&'l LocationInventory),
}

/// Explains a sign in English.
///
/// ```
/// use chereme::notation::{Vocabulary, explain, read};
/// let reading = read("sign BOL\n  configuration flat\n", &Vocabulary::open(), "lsf");
/// assert!(explain(&reading.signs[0].sign).contains("strong hand configuration: flat (stated)"));
/// ```
pub fn explain(sign: &Sign) -> String {
    explain_in(sign, None, Tongue::English)
}

/// Explains a sign in English that is made from others: a sentence of how it is made, then the whole sign.
///
/// ```
/// use chereme::notation::explain_derived;
/// use chereme::phonology::operator::Operator;
/// use chereme::phonology::recombination::{Base, Recombination};
/// use chereme::phonology::Sign;
/// let from = Recombination { base: Base::Named("CLAIR".into()), operators: vec![Operator::Inverted] };
/// assert!(explain_derived(&Sign::named("FONCÉ"), &from).contains("made from: CLAIR, played backwards"));
/// ```
pub fn explain_derived(sign: &Sign, from: &Recombination) -> String {
    explain_in(sign, Some(from), Tongue::English)
}

/// Explains a sign, and how it is made where it is made from others.
///
/// ```
/// use chereme::notation::{Tongue, Vocabulary, explain_in, read};
/// use chereme::phonology::LocationInventory;
/// let reading = read("sign BOL\n  placement chest, 24cm away\n", &Vocabulary::builtin(), "lsf");
/// let names = LocationInventory::builtin();
/// let said = explain_in(&reading.signs[0].sign, None, Tongue::French(&names));
/// assert!(said.contains("la main dominante, emplacement : à 24 cm de la poitrine (selon le texte)"));
/// ```
pub fn explain_in(sign: &Sign, from: Option<&Recombination>, tongue: Tongue) -> String {
    let p = tongue.phrases();
    let mut out = sign.name.clone();
    if !sign.language.is_empty() {
        out.push_str(&format!("{}{}", p.of, sign.language));
    }
    let [open, close] = p.quotes;
    let meaning: Vec<String> =
        sign.meaning.iter().map(|(tag, words)| format!("{open}{words}{close} ({tag})")).collect();
    if !meaning.is_empty() {
        out.push_str(&format!("{}{}", p.colon, meaning.join(", ")));
    }
    out.push('\n');
    if let Some(from) = from {
        let made = match tongue {
            Tongue::English => making(from),
            Tongue::French(names) => french::making(from, names),
        };
        out.push_str(&format!("  {}{}{made}\n", p.made_from, p.colon));
    }
    let mut say = |what: &str, text: &str, from: &str| out.push_str(&format!("  {what}{}{text} ({from})\n", p.colon));
    say(p.hands, &hands(sign.hands, p), if sign.hands == Hands::Strong { p.default } else { p.stated });
    say(p.counts, &counts(sign.intervals, p), p.counted);
    for hand in Hand::BOTH {
        if !acts(sign.hands, hand) {
            continue;
        }
        let name = if hand == Hand::Strong { p.strong } else { p.weak };
        for (number, ([label, default], tier)) in p.tiers.iter().zip(TIERS).enumerate() {
            let text = match tongue {
                Tongue::English => said(sign, hand, tier),
                Tongue::French(names) => said_in_french(sign, hand, number, names),
            };
            let (text, from) = match (text, hand, sign.hands) {
                // A movement that only joins keys is not written.
                (Some(text), _, _) if text.is_empty() => (p.joins_keys.to_owned(), p.stated),
                (Some(text), _, _) => (text, p.stated),
                (None, Hand::Weak, Hands::Both(Some(s))) if has(&sign.strong, tier) => {
                    (follows(s.relation, p).to_owned(), p.symmetry)
                }
                (None, _, _) => ((*default).to_owned(), p.default),
            };
            say(&format!("{name}{label}"), &text, from);
        }
    }
    let whole = match tongue {
        Tongue::English => whole(sign),
        Tongue::French(names) => french::whole(sign, names),
    };
    for (label, text) in whole {
        say(label, &text, p.stated);
    }
    if sign.duration.is_none() {
        say(p.duration, p.from_movements, p.default);
    }
    out
}

/// The tiers of the whole sign as they are written.
fn whole(sign: &Sign) -> Vec<(&'static str, String)> {
    let tiers = raise(sign).lines.into_iter().filter_map(|line| match line.content {
        Some(Content::Tier(tier)) => Some(tier.value),
        _ => None,
    });
    let of_the_sign = |v: &Value| {
        matches!(
            v,
            Value::Contact(_)
                | Value::NonManual(..)
                | Value::Duration(_)
                | Value::Speed(_)
                | Value::Base(_)
                | Value::At(_)
                | Value::Source(_)
                | Value::Status(_)
                | Value::Note(_)
        )
    };
    tiers.filter(of_the_sign).map(|v| (v.keyword(), value(&v))).collect()
}

/// How a sign is made, in plain words.
fn making(from: &Recombination) -> String {
    let part = |p: &Recombination| match (&p.base, p.operators.is_empty()) {
        (Base::Named(_) | Base::Spelled(_), true) => making(p),
        _ => format!("({})", making(p)),
    };
    let mut text = match &from.base {
        Base::Named(name) => name.clone(),
        Base::Spelled(word) => format!("the letters of {word}, from shape to shape"),
        Base::Pointing(_) | Base::WristAt(_) => {
            expression(&super::raise::expression(&Recombination { base: from.base.clone(), operators: Vec::new() }))
        }
        Base::Chain(parts) => parts.iter().map(part).collect::<Vec<_>>().join(", then "),
        Base::Hands(strong, weak) => {
            format!("{} on the strong hand and {} on the weak hand", part(strong), part(weak))
        }
    };
    for operator in &from.operators {
        text.push_str(", ");
        text.push_str(&doing(operator));
    }
    text
}

fn doing(operator: &Operator) -> String {
    // As it is written, without the base that stands before it.
    let written = || {
        let alone = Recombination { base: Base::Named("x".into()), operators: vec![operator.clone()] };
        expression(&super::raise::expression(&alone)).trim_start_matches("x ").to_owned()
    };
    match operator {
        Operator::Inverted => "played backwards".into(),
        Operator::InvertedMovement => "its path played backwards, the hands shaped and turned as before".into(),
        Operator::Mirrored => "one hand copied onto the other, mirrored".into(),
        Operator::Swapped => "the hands exchanged".into(),
        Operator::Reflected => "its mirror image, face and gaze included".into(),
        Operator::Repeated { times, growth, .. } => {
            let grows = match growth.signum() {
                1 => ", larger each time",
                -1 => ", smaller each time",
                _ => "",
            };
            format!("performed {times} times in all{grows}")
        }
        Operator::Configuration(..)
        | Operator::Orientation(..)
        | Operator::Placement(..)
        | Operator::Movement(..)
        | Operator::NonManual(..) => written(),
        Operator::At(_) => format!("moved {}", written()),
        Operator::Speed(factor) => format!("{factor} times as fast"),
        Operator::Size(factor) => format!("its paths {factor} times as large"),
    }
}

/// The manual tiers, as they are written.
const TIERS: [&str; 4] = ["configuration", "placement", "orientation", "movement"];

fn acts(hands: Hands, hand: Hand) -> bool {
    match hands {
        Hands::Strong => hand == Hand::Strong,
        Hands::Weak => hand == Hand::Weak,
        Hands::Both(_) => true,
    }
}

fn hands(hands: Hands, p: &Phrases) -> String {
    match hands {
        Hands::Strong => p.strong_alone.to_owned(),
        Hands::Weak => p.weak_alone.to_owned(),
        Hands::Both(None) => p.each_its_own.to_owned(),
        Hands::Both(Some(s)) => {
            let relation = match s.relation {
                Relation::Mirrored => p.both_mirrored,
                Relation::Parallel => p.both_parallel,
            };
            let on = [s.up_down, s.out_in, s.alternating, s.crossed];
            let more = p.exchanged.iter().zip(on).filter(|(_, on)| *on).map(|(words, _)| *words);
            std::iter::once(relation).chain(more).collect()
        }
    }
}

fn counts(intervals: usize, p: &Phrases) -> String {
    match intervals {
        0 => p.held.to_owned(),
        1 => format!("2{}1{}", p.postures, p.movement_between),
        n => format!("{}{}{n}{}", n + 1, p.postures, p.movements_between),
    }
}

fn follows(relation: Relation, p: &Phrases) -> &'static str {
    match relation {
        Relation::Mirrored => p.mirrors,
        Relation::Parallel => p.goes_along,
    }
}

fn has(manual: &Manual, tier: &str) -> bool {
    match tier {
        "configuration" => !manual.configuration.is_empty(),
        "placement" => !manual.placement.is_empty(),
        "orientation" => !manual.orientation.is_empty(),
        _ => !manual.movement.is_empty(),
    }
}

/// The text of one hand's tier, where it is stated: the sign is reduced to that hand and written. Empty where a movement
/// only joins keys, which is not written.
fn said(sign: &Sign, hand: Hand, tier: &str) -> Option<String> {
    let manual = of_hand(sign, hand);
    if !has(manual, tier) {
        return None;
    }
    let alone = Sign { intervals: sign.intervals, strong: manual.clone(), ..Sign::named("") };
    let text = raise(&alone).lines.into_iter().find_map(|line| match line.content {
        Some(Content::Tier(found)) if found.value.keyword() == tier => Some(value(&found.value)),
        _ => None,
    });
    Some(text.unwrap_or_default())
}

/// One hand's tier in French, where it is stated.
fn said_in_french(sign: &Sign, hand: Hand, number: usize, names: &LocationInventory) -> Option<String> {
    let manual = of_hand(sign, hand);
    has(manual, TIERS[number]).then(|| french::tier(manual, sign.intervals, number, names))
}

fn of_hand(sign: &Sign, hand: Hand) -> &Manual {
    match hand {
        Hand::Strong => &sign.strong,
        Hand::Weak => &sign.weak,
    }
}
