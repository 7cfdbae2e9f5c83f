//! A sign in plain words, one tier a line, each with where it came from: stated, default, symmetry.

use super::print::value;
use super::raise::raise;
use super::syntax::{Content, Value};
use crate::phonology::{Hand, Hands, Manual, Relation, Sign};

/// Explains a sign.
///
/// ```
/// use chereme::notation::{Vocabulary, explain, read};
/// let reading = read("sign BOL\n  configuration flat\n", &Vocabulary::open(), "lsf");
/// assert!(explain(&reading.signs[0].sign).contains("strong hand configuration: flat (stated)"));
/// ```
pub fn explain(sign: &Sign) -> String {
    let mut out = sign.name.clone();
    if !sign.language.is_empty() {
        out.push_str(&format!(", a sign of {}", sign.language));
    }
    let meaning: Vec<String> = sign.meaning.iter().map(|(tag, words)| format!("“{words}” ({tag})")).collect();
    if !meaning.is_empty() {
        out.push_str(&format!(": {}", meaning.join(", ")));
    }
    out.push('\n');
    let mut say = |what: &str, text: &str, from: &str| out.push_str(&format!("  {what}: {text} ({from})\n"));
    say("hands", &hands(sign.hands), if sign.hands == Hands::Strong { "default" } else { "stated" });
    say("postures and movements", &counts(sign.intervals), "counted");
    for hand in [Hand::Strong, Hand::Weak] {
        if !acts(sign.hands, hand) {
            continue;
        }
        let name = if hand == Hand::Strong { "strong" } else { "weak" };
        for (tier, default) in TIERS {
            let (text, from) = match (said(sign, hand, tier), hand, sign.hands) {
                (Some(text), _, _) => (text, "stated"),
                (None, Hand::Weak, Hands::Both(Some(s))) if has(&sign.strong, tier) => {
                    (follows(s.relation).to_owned(), "symmetry")
                }
                (None, _, _) => (default.to_owned(), "default"),
            };
            say(&format!("{name} hand {tier}"), &text, from);
        }
    }
    for line in raise(sign).lines {
        if let Some(Content::Tier(tier)) = line.content
            && matches!(
                tier.value,
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
        {
            say(tier.value.keyword(), &value(&tier.value), "stated");
        }
    }
    if sign.duration.is_none() {
        say("duration", "from the lengths and kinds of the movements", "default");
    }
    out
}

/// The manual tiers and what holds where they are not said.
const TIERS: [(&str, &str); 4] = [
    ("configuration", "relaxed"),
    ("placement", "the neutral place before the chest"),
    ("orientation", "the comfortable one at that place"),
    ("movement", "none of its own"),
];

fn acts(hands: Hands, hand: Hand) -> bool {
    match hands {
        Hands::Strong => hand == Hand::Strong,
        Hands::Weak => hand == Hand::Weak,
        Hands::Both(_) => true,
    }
}

fn hands(hands: Hands) -> String {
    match hands {
        Hands::Strong => "the strong hand alone".to_owned(),
        Hands::Weak => "the weak hand alone".to_owned(),
        Hands::Both(None) => "both, each its own".to_owned(),
        Hands::Both(Some(s)) => {
            let mut text = match s.relation {
                Relation::Mirrored => "both, the weak hand mirrors the strong".to_owned(),
                Relation::Parallel => "both, the weak hand goes with the strong".to_owned(),
            };
            for (on, words) in [
                (s.up_down, ", up and down exchanged"),
                (s.out_in, ", out and in exchanged"),
                (s.alternating, ", half a cycle apart"),
                (s.crossed, ", the arms crossed"),
            ] {
                if on {
                    text.push_str(words);
                }
            }
            text
        }
    }
}

fn counts(intervals: usize) -> String {
    match intervals {
        0 => "1 posture, held".to_owned(),
        1 => "2 postures, 1 movement between".to_owned(),
        n => format!("{} postures, {n} movements between", n + 1),
    }
}

fn follows(relation: Relation) -> &'static str {
    match relation {
        Relation::Mirrored => "mirrors the strong hand",
        Relation::Parallel => "as the strong hand",
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

/// The text of one hand's tier: the sign is reduced to that hand and written.
fn said(sign: &Sign, hand: Hand, tier: &str) -> Option<String> {
    let manual = if hand == Hand::Strong { &sign.strong } else { &sign.weak };
    if !has(manual, tier) {
        return None;
    }
    let alone = Sign { intervals: sign.intervals, strong: manual.clone(), ..Sign::named("") };
    let text = raise(&alone).lines.into_iter().find_map(|line| match line.content {
        Some(Content::Tier(found)) if found.value.keyword() == tier => Some(value(&found.value)),
        _ => None,
    });
    // A movement that only joins keys is not written.
    text.or_else(|| Some("changes from posture to posture".to_owned()))
}
