//! Gloss lines: what they mean, against a small lexicon, and one mistake a file in `tests/suite/gloss`.

use crate::golden;
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::lexicon::embedded;
use chereme::notation::{Lexicon, Vocabulary, source_of_bytes};
use chereme::phonology::{Hand, Place, Space};
use chereme::score::gloss::{Handedness, Missing, Reading, Settings, read};
use chereme::score::plan::Act;
use chereme::time::Seconds;

/// A lexicon of a few signs in two languages.
const SIGNS: [(&str, &str); 4] = [
    (
        "lexicon/lsf/a.sign",
        "sign MAISON\n hands both mirrored\n placement chest, 24cm away\n\nsign CHIEN\n movement up 10cm\n\nsign TOI\n movement out 10cm\n\
         \n\nsign BOL\n configuration round-B\n placement chest, 24cm away\n movement arc up-right 15cm\n\nsign PENSER\n placement forehead, touch\n\
         sign NOM\n hands one\n sign QUOI\n hands one\n sign TRAVAIL\n movement up 5cm\n sign BONJOUR\n movement out 5cm\n",
    ),
    (
        "lexicon/lsf/alphabet.sign",
        "sign L\n configuration L\n\nsign S\n configuration fist-s\n\nsign F\n configuration F\n\nsign E\n configuration fist-s\n",
    ),
    ("lexicon/asl/a.sign", "sign BOWL\n movement up 10cm\n\nsign CHIEN\n movement down 10cm\n"),
    ("lexicon/bsl/a.sign", "sign CHIEN\n movement left 10cm\n"),
];

fn reading(text: &str, settings: &Settings) -> Reading {
    let vocabulary = Vocabulary::builtin();
    let mut lexicon = Lexicon::default();
    let checked = lexicon.add(SIGNS.map(|(path, text)| Source::new(path, text)), &vocabulary);
    assert!(checked.iter().all(|c| c.diagnostics.is_empty()), "{checked:?}");
    read(text, &lexicon, &vocabulary, settings)
}

fn sound(text: &str) -> Reading {
    let reading = reading(text, &Settings::default());
    let source = Source::new("line", text);
    let told: Vec<String> = reading.diagnostics.iter().map(|d| render(d, &source, false)).collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
    reading
}

fn messages(text: &str) -> Vec<String> {
    let all = reading(text, &Settings::default()).diagnostics;
    all.into_iter().map(|d| format!("{} / {}", d.message, d.hints.join(" / "))).collect()
}

#[test]
fn the_language_is_the_one_that_knows_most() {
    let line = sound("MAISON CHIEN");
    assert_eq!(line.language, "lsf");
    let Act::Sign(dog) = &line.plan.items[1].act else { panic!() };
    assert_eq!(dog.language, "lsf");
    // With a language, names of others are found where it has none.
    let settings = Settings { language: Some("bsl".into()), ..Settings::default() };
    let line = reading("CHIEN bowl", &settings);
    assert_eq!(line.diagnostics, []);
    let languages = line.plan.items.iter().map(|item| match &item.act {
        Act::Sign(sign) => sign.language.as_str(),
        Act::Hold(..) | Act::Rest(_) => "",
    });
    assert_eq!(languages.collect::<Vec<_>>(), ["bsl", "asl"]);
    let told = messages("CHIEN");
    assert!(told[0].contains("several languages") && told[0].contains("asl, bsl, lsf"), "{told:?}");
}

#[test]
fn pauses_and_holds() {
    let line = sound("MAISON, CHIEN. TOI// <HOLD 0.8s> <HOLD weak> <REST> <REST 500ms>");
    let holds: Vec<_> =
        line.plan.items.iter().filter(|i| !matches!(i.act, Act::Sign(_))).map(|i| i.act.clone()).collect();
    assert_eq!(
        holds,
        [
            Act::Hold(None, Some(Seconds(0.2))),
            Act::Hold(None, Some(Seconds(0.5))),
            Act::Hold(None, Some(Seconds(0.5))),
            Act::Hold(None, Some(Seconds(0.8))),
            Act::Hold(Some(Hand::Weak), None),
            Act::Rest(None),
            Act::Rest(Some(Seconds(0.5))),
        ]
    );
    let left = Settings { handedness: Handedness::Left, ..Settings::default() };
    assert_eq!(reading("MAISON <HOLD weak>", &left).plan.items[1].act, Act::Hold(Some(Hand::Strong), None));
    assert!(messages("<HOLD> MAISON")[0].contains("no posture"));
}

#[test]
fn items_keep_their_text() {
    let text = "MAISON@left {brows up: TOI++} fs(LSF)";
    for item in sound(text).plan.items {
        let span = item.span.unwrap();
        assert_eq!(item.gloss, text[span.start..span.end]);
    }
}

#[test]
fn the_inner_value_of_a_channel_holds_within_its_braces() {
    let line = sound("TOI {brows raised, head shake: TOI {brows furrowed: CHIEN} TOI} TOI");
    let spans: Vec<_> =
        line.plan.spans.iter().map(|s| (s.items.clone(), s.channel.name(), format!("{:?}", s.value.value))).collect();
    let named = |name: &str| format!("Named({name:?})");
    assert_eq!(
        spans,
        [
            (1..2, "brows", named("raised")),
            (3..4, "brows", named("raised")),
            (1..4, "head", named("shake")),
            (2..3, "brows", named("furrowed")),
        ]
    );
}

#[test]
fn unknown_glosses_are_told_with_the_nearest() {
    assert_eq!(messages("MAISN TOI"), ["there is no sign `MAISN` / did you mean `MAISON`?"]);
    assert!(messages("MAISON?")[0].contains("{brows raised: MAISON}"));
    assert!(messages("{brows raised head shake: TOI}")[0].contains("`raised, head shake`"));
    let skip = Settings { missing: Missing::Skip, ..Settings::default() };
    let line = reading("TOI WXYZ CHIEN", &skip);
    assert!(!line.has_faults() && line.plan.items.len() == 2 && line.diagnostics.len() == 1);
}

#[test]
fn each_mistake_has_its_message() {
    golden::beside("gloss", "gloss", 35, |name, bytes| {
        let (source, _) = source_of_bytes(name, bytes);
        let faults = reading(source.text.trim_end(), &Settings::default()).diagnostics;
        assert!(!faults.is_empty(), "{name} has no fault");
        faults.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}
