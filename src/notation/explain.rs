//! A sign in plain words, one tier a line, each with where it came from: stated, default, symmetry; phase by phase.

mod english;
mod english_movement;
mod english_noun;
mod french;
mod french_movement;
mod french_noun;
mod phrases;
mod summary;

use crate::phonology::recombination::Recombination;
use crate::phonology::{Action, Hand, Hands, Keys, LocationInventory, Manual, Motion, Movement, Relation, Sign};
use phrases::Phrases;

/// The language of an explanation.
#[derive(Debug, Clone, Copy)]
pub enum Tongue<'l> {
    /// English.
    English,
    /// French; the inventory has the places' names.
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
            Tongue::English => english::making(from),
            Tongue::French(names) => french::making(from, names),
        };
        out.push_str(&format!("  {}{}{made}\n", p.made_from, p.colon));
    }
    for (number, phase) in sign.phases().enumerate() {
        if !sign.then.is_empty() {
            let stays = if phase.holds_over { p.other_stays } else { "" };
            out.push_str(&format!("  {} {}{stays}{}\n", p.phase[number.min(1)], number + 1, p.colon.trim_end()));
        }
        let mut lines = format!("  {}\n", summary::sentence(phase, &sign.language, tongue));
        explain_phase(phase, tongue, &mut lines);
        if number > 0 {
            times(phase, tongue).into_iter().for_each(|(label, text)| say(&mut lines, p, label, &text, p.stated));
        }
        // Several phases stand under their headings.
        let indent = if sign.then.is_empty() { "" } else { "  " };
        lines.lines().for_each(|line| out.push_str(&format!("{indent}{line}\n")));
    }
    times(sign, tongue).into_iter().for_each(|(label, text)| say(&mut out, p, label, &text, p.stated));
    if sign.duration.is_none() {
        say(&mut out, p, p.duration, p.from_movements, p.default);
    }
    let whole = match tongue {
        Tongue::English => english::whole(sign),
        Tongue::French(names) => french::whole(sign, names),
    };
    whole.into_iter().for_each(|(label, text)| say(&mut out, p, label, &text, p.stated));
    out
}

fn say(out: &mut String, p: &Phrases, what: &str, text: &str, from: &str) {
    out.push_str(&format!("  {what}{}{text} ({from})\n", p.colon));
}

/// The hands and their tiers in a phase, one a line.
fn explain_phase(sign: &Sign, tongue: Tongue, out: &mut String) {
    let p = tongue.phrases();
    say(out, p, p.hands, &hands(sign.hands, p), if sign.hands == Hands::Strong { p.default } else { p.stated });
    say(out, p, p.counts, &counts(sign.intervals, p), p.counted);
    for hand in Hand::BOTH.into_iter().filter(|hand| acts(sign.hands, *hand)) {
        let name = if hand == Hand::Strong { p.strong } else { p.weak };
        for ([label, default], tier) in p.tiers.iter().zip(Tier::ALL) {
            let (text, from) = match (said(sign, hand, tier, tongue), hand, sign.hands) {
                (Some(text), _, _) => (text, p.stated),
                (None, Hand::Weak, Hands::Both(Some(s))) if has(&sign.strong, tier) => {
                    (follows(s.relation, p).to_owned(), p.symmetry)
                }
                (None, _, _) => ((*default).to_owned(), p.default),
            };
            say(out, p, &format!("{name}{label}"), &text, from);
        }
    }
    if !sign.contact.is_empty() {
        let text = match tongue {
            Tongue::English => english::contacts(sign),
            Tongue::French(_) => french::contacts(sign),
        };
        say(out, p, p.contact, &text, p.stated);
    }
}

/// Duration and speed, where they are stated.
fn times(sign: &Sign, tongue: Tongue) -> Vec<(&'static str, String)> {
    match tongue {
        Tongue::English => english::times(sign),
        Tongue::French(_) => french::times(sign),
    }
}

/// A manual tier.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tier {
    Configuration,
    Placement,
    Orientation,
    Movement,
}

impl Tier {
    /// All of them, in the order of [`Phrases::tiers`].
    const ALL: [Tier; 4] = [Tier::Configuration, Tier::Placement, Tier::Orientation, Tier::Movement];
}

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

fn has(manual: &Manual, tier: Tier) -> bool {
    match tier {
        Tier::Configuration => !manual.configuration.is_empty(),
        Tier::Placement => !manual.placement.is_empty(),
        Tier::Orientation => !manual.orientation.is_empty(),
        Tier::Movement => !manual.movement.is_empty(),
    }
}

/// The words of one hand's tier, where it is stated.
fn said(sign: &Sign, hand: Hand, tier: Tier, tongue: Tongue) -> Option<String> {
    let manual = match hand {
        Hand::Strong => &sign.strong,
        Hand::Weak => &sign.weak,
    };
    if !has(manual, tier) {
        return None;
    }
    // What only joins the keys of other tiers.
    if tier == Tier::Movement && manual.movement.iter().all(|m| *m == plain_change()) {
        return Some(tongue.phrases().joins_keys.to_owned());
    }
    Some(match tongue {
        Tongue::English => english::tier(manual, sign.intervals, tier),
        Tongue::French(names) => french::tier(manual, sign.intervals, tier, names),
    })
}

fn plain_change() -> Movement {
    Movement::Action(Box::new(Action::new(Motion::Change)))
}

/// Values at keys; the keys are named where not all of them have a value. `words` are what stands between two values, and what
/// a key is called.
fn keys<T>(values: &Keys<T>, intervals: usize, words: [&str; 2], say: impl Fn(&T) -> String) -> String {
    let [then, posture] = words;
    let everywhere = values.len() == intervals + 1 || values.len() == 1 && values.stated(0).is_some();
    let one = |(key, value)| match everywhere {
        true => say(value),
        false => format!("{} ({posture} {})", say(value), key + 1),
    };
    values.iter().map(one).collect::<Vec<_>>().join(then)
}
