//! The lexicon: languages, two hits, layers, letters.

use chereme::diagnostics::Source;
use chereme::notation::lexicon::embedded;
use chereme::notation::{Lexicon, Vocabulary};

fn lexicon(layers: &[&[(&str, &str)]]) -> (Lexicon, Vec<String>) {
    let mut lexicon = Lexicon::default();
    let mut faults = Vec::new();
    for layer in layers {
        let sources = layer.iter().map(|(path, text)| Source::new(*path, *text));
        for checked in lexicon.add(sources, &Vocabulary::open()) {
            faults.extend(checked.diagnostics.iter().map(|d| d.message.clone()));
        }
    }
    (lexicon, faults)
}

#[test]
fn the_language_is_the_folder_or_the_line() {
    let (all, faults) = lexicon(&[&[
        ("lexicon/lsf/bol.sign", "sign BOL\n hands one\n"),
        ("x.sign", "language ase\nsign BOWL\n hands one\n"),
    ]]);
    assert_eq!(faults, [""; 0]);
    assert_eq!(all.find("bol", None).unwrap().sign.language, "lsf");
    assert_eq!(all.find("Bowl", Some("ASE")).unwrap().line, 2);
    assert!(all.find("bowl", Some("lsf")).unwrap_err().to_string().contains("no sign"));
}

#[test]
fn two_hits_are_listed() {
    let (all, faults) = lexicon(&[&[("lsf/a.sign", "sign OK\n hands one"), ("ase/a.sign", "sign ok\n hands one")]]);
    assert_eq!(faults, [""; 0]);
    let told = all.find("OK", None).unwrap_err().to_string();
    assert!(told.contains("lsf/a.sign:1") && told.contains("ase/a.sign:1"), "{told}");
    let (_, faults) = lexicon(&[&[("lsf/a.sign", "sign É\n hands one"), ("lsf/b.sign", "sign e\u{301}\n hands one")]]);
    assert_eq!(faults, ["`é` is described twice"]);
}

#[test]
fn a_later_layer_overrides_entry_by_entry() {
    let (all, faults) = lexicon(&[
        &[("lsf/a.sign", "sign A\n hands one\nsign B\n hands one")],
        &[("mine/lsf/a.sign", "sign a\n hands both")],
    ]);
    assert_eq!(faults, [""; 0]);
    assert_eq!(all.len(), 2);
    assert_eq!(all.find("A", None).unwrap().path, "mine/lsf/a.sign");
    assert_eq!(all.find("B", None).unwrap().layer, 0);
}

#[test]
fn letters_are_signs_of_the_alphabet() {
    let (all, _) = lexicon(&[&[
        ("lsf/alphabet.sign", "sign A\n configuration A\nsign B\n configuration B"),
        ("lsf/bol.sign", "sign BOL\n hands one"),
    ]]);
    assert_eq!(all.letters("lsf").count(), 2);
    assert!(all.letter("a", "lsf").is_some() && all.letter("bol", "lsf").is_none());
}

#[test]
fn unknown_names_get_the_nearest() {
    let (all, _) = lexicon(&[&[("lsf/a.sign", "sign TRAVAIL\n hands one")]]);
    assert!(all.find("TRAVIAL", None).unwrap_err().to_string().contains("did you mean `TRAVAIL`?"));
}

#[test]
fn the_embedded_lexicon_is_sound() {
    let faults: Vec<_> =
        Lexicon::default().add(embedded(), &Vocabulary::builtin()).into_iter().flat_map(|c| c.diagnostics).collect();
    assert_eq!(faults, []);
}
