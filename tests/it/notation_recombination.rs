//! Signs made from other signs: text and back, and names over files and layers.

use crate::strategies::{Words, recombination};
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::lexicon::Checked;
use chereme::notation::{Lexicon, Vocabulary, parse, print, read, write_derived};
use chereme::phonology::LocationInventory;
use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::operator::Tables;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_reads_back(from in recombination(Words::any())) {
        let text = write_derived("X", &from);
        let reading = read(&text, &Vocabulary::open(), "");
        let source = Source::new("random.sign", text.clone());
        let faults: Vec<String> = reading.diagnostics.iter().map(|d| render(d, &source, false)).collect();
        prop_assert!(faults.is_empty(), "{}\n{text}", faults.join("\n"));
        prop_assert_eq!(&reading.derived[0].from, &from, "{}", text);
        prop_assert_eq!(print(&reading.file), text.clone());
        prop_assert_eq!(print(&parse(&text).0), text);
    }
}

/// A lexicon of layers of files, and what is said of them.
fn lexicon(layers: &[&[(&str, &str)]]) -> (Lexicon, Vec<Checked>) {
    let vocabulary = Vocabulary::builtin();
    let mut lexicon = Lexicon::default();
    let mut checked = Vec::new();
    for layer in layers {
        checked.extend(lexicon.add(layer.iter().map(|(path, text)| Source::new(*path, *text)), &vocabulary));
    }
    let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
    lexicon.link(&Tables { locations: &locations, movements: &movements }, &mut checked);
    (lexicon, checked)
}

fn messages(checked: &[Checked]) -> Vec<String> {
    checked.iter().flat_map(|c| c.diagnostics.iter().map(|d| d.message.clone())).collect()
}

const BASE: &str = "sign CLAIR\n  meaning en \"light\"\n  source \"a page\"\n  configuration flat-O then 5\n  placement chest\n  movement up 10cm\n";

#[test]
fn signs_are_made_over_files_and_layers() {
    let (lexicon, checked) = lexicon(&[
        &[("lsf/a.sign", "sign FONCÉ = CLAIR inverted\n"), ("lsf/b.sign", BASE)],
        &[
            ("x/lsf/c.sign", "sign NOIR = FONCÉ inverted, fast\n  meaning en \"black\"\n"),
            ("asl/d.sign", "sign CLAIR\n  movement left\n"),
        ],
    ]);
    assert_eq!(messages(&checked), Vec::<String>::new());
    let dark = &lexicon.find("foncé", None).unwrap().sign;
    // What it means is not what its base means; where it comes from is said.
    assert_eq!((dark.meaning.len(), dark.language.as_str()), (0, "lsf"));
    assert_eq!(dark.source.as_deref(), Some("CLAIR inverted; CLAIR: a page"));
    assert_eq!(dark.strong.configuration.at(0).unwrap().base, "5");
    let black = &lexicon.find("NOIR", None).unwrap().sign;
    assert_eq!((black.speed, black.meaning[0].1.as_str()), (1.4, "black"));
    assert_eq!(black.strong, lexicon.find("CLAIR", Some("lsf")).unwrap().sign.strong);
    assert_eq!(checked.iter().map(|c| c.signs).sum::<usize>(), 4);
}

#[test]
fn a_later_layer_replaces_what_signs_are_made_from() {
    let (lexicon, _) = lexicon(&[
        &[("lsf/a.sign", BASE), ("lsf/b.sign", "sign FONCÉ = CLAIR inverted\n")],
        &[("x/lsf/a.sign", "sign CLAIR\n  configuration 1 then 2\n  movement up\n")],
    ]);
    assert_eq!(lexicon.find("FONCÉ", None).unwrap().sign.strong.configuration.at(0).unwrap().base, "2");
}

#[test]
fn circles_and_unknown_names_name_every_step() {
    let (lexicon, checked) = lexicon(&[&[
        ("lsf/a.sign", "sign A = B inverted\n"),
        ("lsf/b.sign", "\nsign B = A swapped\n"),
        ("lsf/c.sign", "sign C = CLAIRE inverted\nsign CLAIR\n  movement up\nsign D = C mirrored\n"),
    ]]);
    assert!(lexicon.find("A", None).is_err() && lexicon.find("D", None).is_err());
    let all = messages(&checked);
    assert!(all.iter().any(|m| m.contains("A (lsf/a.sign:1) → B (lsf/b.sign:2) → A (lsf/a.sign:1)")), "{all:?}");
    assert!(all.iter().any(|m| m == "there is no sign `CLAIRE`"), "{all:?}");
    assert!(all.iter().any(|m| m.contains("C (lsf/c.sign:1) has a fault")), "{all:?}");
    let hints: Vec<_> = checked.iter().flat_map(|c| &c.diagnostics).map(|d| format!("{d:?}")).collect();
    assert!(hints.iter().any(|h| h.contains("did you mean `CLAIR`?")), "{hints:?}");
}

#[test]
fn a_long_row_of_signs_is_refused_and_a_deep_text_survived() {
    let rows: String = (0..60).map(|i| format!("sign S{i} = S{} inverted\n", i + 1)).collect();
    let (_, checked) = lexicon(&[&[("lsf/a.sign", &rows)]]);
    assert!(messages(&checked).iter().any(|m| m.contains("made from each other") || m.contains("no sign")));
    let deep = format!("sign A = {}B\n", "( ".repeat(50_000));
    assert!(read(&deep, &Vocabulary::open(), "").has_faults());
}

#[test]
fn words_are_spelled_with_the_letters_of_the_language() {
    let letters = "sign O\n  configuration O\n  placement chest, 20cm away\nsign K\n  configuration K\n";
    let (lexicon, checked) = lexicon(&[&[
        ("lsf/alphabet.sign", letters),
        ("lsf/a.sign", "sign OK = spelled \"ok\"\nsign KO = spelled KOX\n"),
    ]]);
    let ok = &lexicon.find("OK", None).unwrap().sign;
    assert_eq!((ok.intervals, ok.strong.configuration.at(1).unwrap().base.as_str()), (1, "K"));
    assert_eq!(messages(&checked), ["the alphabet of lsf has no letter X"]);
}

#[test]
fn operators_that_do_not_fit_are_faults_of_their_sign() {
    let (_, checked) = lexicon(&[&[
        ("lsf/a.sign", BASE),
        ("lsf/b.sign", "sign X = CLAIR with configuration 1 then 2 then 3\nsign Y = CLAIR with weak configuration 1\n"),
        ("lsf/c.sign", "sign P\n  placement forehead, touch\nsign Z = P at left\n"),
    ]]);
    let all = messages(&checked).join("\n");
    assert!(all.contains("configuration is given 3 values, but it has 2 keys"), "{all}");
    assert!(all.contains("the weak hand does not act in it"), "{all}");
    assert!(all.contains("it is anchored on the body (forehead)"), "{all}");
}
