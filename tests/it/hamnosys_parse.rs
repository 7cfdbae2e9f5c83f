//! Reading HamNoSys: the grammar, what is read although it is wrong, and the files of people.

use crate::hamnosys_strategies;
use crate::shared::shared;
use chereme::diagnostics::{Diagnostic, Severity, Span};
use chereme::notation::hamnosys::lex::named;
use chereme::notation::hamnosys::parse;
use chereme::notation::hamnosys::print::{Form, print};
use chereme::notation::hamnosys::symbol::Symbol;
use chereme::notation::hamnosys::syntax::{Sign, Timing};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::collections::BTreeMap;

/// The tags of each `hamnosys_manual` of a SiGML file, by a simple scan.
fn tags(text: &str) -> Vec<Vec<&str>> {
    let manuals =
        text.split("<hamnosys_manual").skip(1).map(|part| part.split("</hamnosys_manual>").next().unwrap_or(""));
    manuals
        .map(|manual| {
            let elements = manual.split('<').skip(1).filter(|e| !e.starts_with(['/', '!', '?']));
            elements.map(|e| e.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("")).collect()
        })
        .collect()
}

/// Reads a list of tags as SiGML's reader will; spans count tags.
fn read(tags: &[&str]) -> (bool, Vec<Diagnostic>) {
    let (mut tokens, mut diagnostics) = (Vec::new(), Vec::new());
    for (i, tag) in tags.iter().enumerate() {
        let (token, wrong) = named(tag, Span::new(i, i + 1));
        tokens.extend(token);
        diagnostics.extend(wrong);
    }
    let end = Span::new(tags.len(), tags.len());
    let (phases, more) = parse::phases(&tokens, end);
    diagnostics.extend(more);
    let faulty = diagnostics.iter().any(|d| d.severity == Severity::Fault);
    (phases.is_some() && !faulty, diagnostics)
}

#[test]
fn the_files_of_people_are_read() {
    let Some(folder) = shared("data/lexica/isl") else { return };
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let (mut good, mut warned, mut count) = (0, 0, 0);
    let mut reasons: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut warnings: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in files.iter().filter(|p| p.extension().is_some_and(|e| e == "sigml")) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let bytes = std::fs::read(path).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        if !text.contains("<hamnosys_manual") {
            continue;
        }
        count += 1;
        let mut all = true;
        let mut some_warned = false;
        for sign in tags(&text) {
            let (ok, diagnostics) = read(&sign);
            all &= ok;
            some_warned |= !diagnostics.is_empty();
            for d in diagnostics {
                let place = format!(
                    "{name}: {} >>{}<< {}",
                    sign[..d.span.start.min(sign.len())].join(" "),
                    sign[d.span.start.min(sign.len())..d.span.end.min(sign.len())].join(" "),
                    sign[d.span.end.min(sign.len())..].join(" ")
                );
                let list = if d.severity == Severity::Fault { &mut reasons } else { &mut warnings };
                list.entry(d.message).or_default().push(place.replace("ham", ""));
            }
        }
        good += usize::from(all);
        warned += usize::from(all && some_warned);
    }
    println!("{good} of {count} read, {warned} of them with warnings");
    for (what, list) in [("fault", reasons), ("warning", warnings)] {
        for (reason, places) in list {
            println!("{what}: {} × {reason}", places.len());
            for place in places {
                println!("      {place}");
            }
        }
    }
    assert!(good * 100 >= count * 97, "{good} of {count}");
}

/// Whatever the symbols can say is read as it was written, as names and as characters.
#[test]
fn what_is_printed_is_read_as_the_same() {
    let law = || {
        let config = ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() };
        TestRunner::new(config).run(&hamnosys_strategies::phases(), |phases| {
            let (gloss, nonmanual, span) = (None, Vec::new(), Default::default());
            let sign = Sign { gloss, timing: Timing::default(), nonmanual, phases, span };
            for form in [Form::Names, Form::Unicode] {
                // What only gestural SiGML says is refused, each in words.
                match print(&sign, form) {
                    Ok(text) => {
                        let (again, told) = parse::sign(&text);
                        prop_assert!(told.iter().all(|d| d.severity != Severity::Fault), "{text}\n{told:?}");
                        prop_assert_eq!(again.as_ref(), Some(&sign), "{}\n{:?}", text, told);
                    }
                    Err(unsaid) => prop_assert!(unsaid.iter().all(|reason| reason.contains("HamNoSys"))),
                }
            }
            Ok(())
        })
    };
    // Trees of trees of strategies are large values: more than a test's stack holds.
    let run = std::thread::Builder::new().stack_size(64 << 20).spawn(law).expect("a thread");
    run.join().expect("no panic").unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn every_symbol_has_a_tag_and_a_character() {
    let mut seen = std::collections::BTreeSet::new();
    for symbol in Symbol::all() {
        assert_eq!(Symbol::of_tag(symbol.tag()), Some(symbol), "{}", symbol.tag());
        assert_eq!(Symbol::of_char(symbol.char()), Some(symbol), "{}", symbol.tag());
        assert!(seen.insert(symbol.char()), "{}", symbol.tag());
    }
    assert!(seen.len() >= 209, "{}", seen.len());
}

#[test]
fn an_unknown_name_is_told_with_line_and_column() {
    let text = "hamflathand,\n hamextfingeru,hamnonsense,hampalmd";
    let (_, told) = parse::sign(text);
    let source = chereme::diagnostics::Source::new("x.ham", text);
    let at: Vec<_> = told.iter().map(|d| source.line_column(d.span.start)).collect();
    assert_eq!(at, [(2, 16)], "{told:?}");
    assert!(told[0].message.contains("hamnonsense"));
}
