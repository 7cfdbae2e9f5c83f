//! Gloss lines: what they mean, against a small lexicon, and one mistake a file in `tests/suite/gloss`.

use crate::golden;
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::{Lexicon, Vocabulary, source_of_bytes};
use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::operator::{Tables, for_left_hander, repeated};
use chereme::phonology::{Hand, Hands, LocationInventory, Place, Sign, Space};
use chereme::score::gloss::{Handedness, Known, Missing, Reading, Settings, read};
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
    let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
    let tables = Tables { locations: &locations, movements: &movements };
    read(text, &Known { lexicon: &lexicon, vocabulary: &vocabulary, tables }, settings)
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
        Act::Hold(..) | Act::Rest(_) | Act::Captured(_) => "",
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

/// The signs of a line in order.
fn signs(reading: &Reading) -> Vec<&Sign> {
    let sign = |item: &'_ chereme::score::plan::Item| matches!(item.act, Act::Sign(_));
    let all = reading.plan.items.iter().filter(|item| sign(item));
    all.filter_map(|item| if let Act::Sign(sign) = &item.act { Some(&**sign) } else { None }).collect()
}

#[test]
fn operators_change_a_sign_before_it_is_repeated() {
    let line = sound("TOI BOL[with configuration U, slow]++ IX(0.5,1.3,0.6)[with configuration flat]");
    let all = signs(&line);
    assert_eq!(all[1].strong.configuration.at(0).unwrap().base, "U");
    assert_eq!(all[2].strong.configuration.at(0).unwrap().base, "flat");
    assert!(all[1].speed < 1.0 && all[1].intervals > 3);
    assert!(messages("BOL[with configuration flot]")[0].contains("did you mean `flat`"));
    assert!(messages("BOL[invertd]")[0].contains("did you mean `inverted`"));
}

#[test]
fn each_plus_adds_a_performance() {
    let line = sound("BOL TRAVAIL++");
    let all = signs(&line);
    let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
    let tables = Tables { locations: &locations, movements: &movements };
    let once = sound("BOL TRAVAIL");
    assert_eq!(*all[1], repeated(signs(&once)[1], 3, None, 0, &tables).unwrap());
}

#[test]
fn a_sign_in_brackets_is_where_it_was_made_last() {
    let line = sound(
        "MAISON@left BOL@(0.3,1.2,0.4) IX(MAISON) {gaze at referent \"BOL\": TOI} MAISON@right IX(maison) TOI@MAISON",
    );
    let all = signs(&line);
    let cell = |left| Place::Space(Space { left, high: 0, far: 0 });
    let target = |sign: &Sign| sign.strong.placement.at(0).unwrap().place.clone();
    assert_eq!(target(all[2]), Place::Towards(Box::new(cell(1))));
    assert_eq!(target(all[5]), Place::Towards(Box::new(cell(-1))));
    assert_eq!(all[0].relocated.as_ref().unwrap().place, cell(1));
    assert_eq!(all[6].relocated.as_ref().unwrap().place, cell(-1));
    let looked_at = format!("{:?}", line.plan.spans[0].value);
    assert!(looked_at.contains("Point(DVec3(0.3, 1.2, 0.4))"), "{looked_at}");
    assert!(messages("MAISON IX(MAISON)")[0].contains("MAISON@left"));
    assert!(messages("MAISON@left IX(MAISN)")[0].contains("did you mean `MAISON`"));
    // What touches the body stays there.
    assert!(messages("PENSER@left TOI")[0].contains("anchored"));
}

#[test]
fn a_left_handed_signer_points_with_the_left_hand_at_the_same_place() {
    let text = "TOI IX(0.5,1.3,0.6) BOL@left weak(TOI) weak(IX@left) fs(LSF)";
    let right = sound(text);
    let left = reading(text, &Settings { handedness: Handedness::Left, ..Settings::default() });
    for (r, l) in signs(&right).into_iter().zip(signs(&left)) {
        assert_eq!(*l, for_left_hander(r));
        assert_eq!(l.relocated, r.relocated);
    }
    let hands: Vec<Hands> = signs(&left).iter().map(|s| s.hands).collect();
    assert_eq!(hands, [Hands::Weak, Hands::Weak, Hands::Weak, Hands::Strong, Hands::Strong, Hands::Weak]);
    let target = signs(&left)[1].weak.placement.at(0).unwrap().place.clone();
    assert_eq!(format!("{target:?}"), "Towards(Point(DVec3(0.5, 1.3, 0.6)))");
}

#[test]
fn words_are_spelled_letter_by_letter() {
    // Three letters held, two transitions.
    assert_eq!(signs(&sound("TOI fs(lsf)"))[1].intervals, 5);
    assert_eq!(signs(&sound("TOI fs(\"S-F L\")"))[1].intervals, 5);
    let accent = reading("TOI fs(été)", &Settings::default());
    assert!(accent.has_faults(), "there is no T");
    let accent = reading("TOI fs(é)", &Settings::default());
    assert_eq!(
        (accent.has_faults(), accent.diagnostics[0].message.as_str()),
        (false, "spelled without accents: é as E")
    );
    assert_eq!(messages("TOI fs(LXŒL)")[0].split(" / ").next(), Some("the alphabet of `lsf` has no `X`, `Œ`"));
    assert!(messages("fs(LSF)")[0].contains("which alphabet"));
    let missing = Settings { missing: Missing::Fingerspell, ..Settings::default() };
    assert_eq!(signs(&reading("TOI FSL", &missing))[1].intervals, 5);
}

#[test]
fn two_signs_at_the_same_time() {
    let line = sound("TOI & TRAVAIL BOL & IX(0.5,1.3,0.6)");
    let all = signs(&line);
    assert_eq!((all[0].hands, all[1].hands), (Hands::Both(None), Hands::Both(None)));
    let target = format!("{:?}", all[1].weak.placement.at(0).unwrap().place);
    assert_eq!(target, "Towards(Point(DVec3(0.5, 1.3, 0.6)))");
    assert!(messages("TOI & BOL@left")[0].contains("placed as one"));
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
