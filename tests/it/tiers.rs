//! Tiers of any names, values and texts, for the readers and writers of annotations.

use chereme::tier::Tier;
use chereme::time::Seconds;
use proptest::collection::vec;
use proptest::prelude::*;

/// A text of any characters, often one that a format has a use for.
pub fn label() -> impl Strategy<Value = String> {
    prop_oneof!["[a-d]", any::<String>(), "[\\x00-\\x20<>&\"'\u{fffe}\u{ffff}\\]é]{0,6}"]
}

/// The name of a tier, often one of ours.
pub fn name() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => (prop_oneof!["RH", "LH"], prop_oneof!["Gloss", "Phase", "Configuration", "Source"]).prop_map(|(h, k)| format!("{h} {k}")),
        1 => prop_oneof![Just("Brows".to_owned()), Just("Source".into()), Just("RH Gloss Source".into())],
        1 => label(),
    ]
}

/// A tier with values from and to these seconds.
pub fn tier(values: impl Strategy<Value = Vec<(f64, f64)>>) -> impl Strategy<Value = Tier> {
    (name(), values, vec((label(), label()), 8)).prop_map(|(name, values, texts)| {
        let mut tier = Tier::new(name);
        for ((start, end), (label, source)) in values.into_iter().zip(texts) {
            tier.push(Seconds(start), Seconds(end), label, source);
        }
        tier
    })
}

/// Values that follow one another, each at least 2 ms long.
pub fn apart() -> impl Strategy<Value = Vec<(f64, f64)>> {
    vec((0.0f64..0.5, 0.002f64..0.5), 0..8).prop_map(|steps| {
        let mut at = 0.0;
        let next = |(gap, length): (f64, f64)| {
            // Every second gap or so is none.
            let start = at + if gap < 0.25 { 0.0 } else { gap };
            at = start + length;
            (start, at)
        };
        steps.into_iter().map(next).collect()
    })
}

/// What a text is after XML, which holds no control characters.
pub fn cleaned(text: &str) -> String {
    text.chars()
        .map(|c| if (c < ' ' && !"\t\n\r".contains(c)) || "\u{fffe}\u{ffff}".contains(c) { '\u{fffd}' } else { c })
        .collect()
}

/// Whole milliseconds.
pub fn ms(seconds: Seconds) -> u32 {
    (seconds.0 * 1000.0).round() as u32
}
