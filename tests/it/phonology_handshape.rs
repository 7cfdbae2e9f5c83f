//! The handshape inventory: loading, names, changes.

use chereme::diagnostics::Source;
use chereme::phonology::handshape::{HandLimits, HandshapeInventory, NotFound};
use chereme::phonology::{Bend, Configuration, Digit, Digits, HandshapeChange, ThumbPosition};

fn faults(text: &str) -> Vec<(String, (usize, usize))> {
    let source = Source::new("handshapes.ron", text);
    match HandshapeInventory::read(&source) {
        Ok(_) => Vec::new(),
        Err(faults) => faults.into_iter().map(|f| (f.message.clone(), source.line_column(f.span.start))).collect(),
    }
}

fn changed(base: &str, change: HandshapeChange) -> chereme::phonology::HandAngles {
    let configuration = Configuration { changes: vec![change], ..Configuration::named(base) };
    HandshapeInventory::builtin().angles(&configuration, None).expect("a known handshape")
}

/// A sound row with one thing replaced.
fn row_with(from: &str, to: &str) -> String {
    let row = r#"(levels: {"straight": (0, 0, 0)}, handshapes: [
    (
        id: "paddle", aliases: ["XY P"],
        selected: "index middle ring pinky", touches_with: "middle tip",
        flexion: ("straight", "straight", "straight", "5/10/7"), spread: (0, 0, 0, 0),
        thumb: Posture(Out), thumb_table: (52, 8, 10, 0, 0),
    ),
])"#;
    row.replace(from, to)
}

#[test]
fn the_inventory_has_105_handshapes_within_limits() {
    let inventory = HandshapeInventory::builtin();
    assert_eq!(inventory.shapes().len(), 105);
    for shape in inventory.shapes() {
        assert!(HandLimits::ANATOMICAL.hold(&shape.angles()), "{}", shape.id);
        let discomfort = HandLimits::ANATOMICAL.discomfort(&shape.table).to_degrees();
        assert!(discomfort < 120.0, "{} {discomfort}", shape.id);
    }
}

#[test]
fn letters_resolve_in_their_language_first() {
    let inventory = HandshapeInventory::builtin();
    let found = |name: &str, language: Option<&str>| inventory.find(name, language).map(|s| s.id.clone());
    assert_eq!(found("F", Some("lsf")), Ok("F-lsf".to_owned()));
    assert_eq!(found("F", Some("asl")), Ok("F".to_owned()));
    assert_eq!(found("H", Some("lsf")), Ok("K".to_owned()));
    assert_eq!(found("s", None), Ok("fist-s".to_owned()), "one shape in every language");
    assert_eq!(found("lsf m", None), Ok("M-lsf".to_owned()));
    assert!(matches!(found("M", None), Err(NotFound::Ambiguous { ids, .. }) if ids.len() == 2));
    assert!(matches!(found("flat-bb", None), Err(NotFound::Unknown { nearest: Some(n), .. }) if n == "flat-B"));
}

#[test]
fn both_alphabets_are_whole() {
    let inventory = HandshapeInventory::builtin();
    for language in ["asl", "lsf"] {
        for letter in 'A'..='Z' {
            let found = inventory.find(&letter.to_string(), Some(language));
            assert!(found.is_ok(), "{language} {letter}: {found:?}");
            let alias = format!("{} {letter}", language.to_uppercase());
            let shape = found.expect("just seen");
            assert!(shape.aliases.contains(&alias), "{alias} is {}", shape.id);
        }
    }
    // Golden expectation 39.
    let lsf = |l: &str| inventory.find(l, Some("lsf")).map(|s| s.id.clone());
    assert_eq!(lsf("I"), lsf("J"));
    assert_eq!((lsf("H"), lsf("P")), (lsf("K"), lsf("K")));
    assert_eq!(lsf("G"), lsf("Q"));
}

#[test]
fn changes_do_what_they_say() {
    let inventory = HandshapeInventory::builtin();
    let plain = |id: &str| inventory.find(id, None).expect("a known handshape").angles();
    let out = changed("U", HandshapeChange::Thumb(ThumbPosition::Out));
    // The row that was solved for it closes the other fingers a little differently.
    assert!(
        out.fingers
            .iter()
            .zip(plain("U").fingers)
            .all(|(a, b)| (a.mcp - b.mcp).abs() < 0.15 && (a.pip - b.pip).abs() < 0.1)
    );
    assert!(out.thumb.radial > 0.8, "{out:?}");
    let hooked = changed("U", HandshapeChange::Bend(Digits::of([Digit::Index]), Bend::Hooked));
    assert!(hooked.fingers[0].pip > 1.3 && hooked.fingers[1].pip < 0.3);
    let selected = changed("V", HandshapeChange::Bend(Digits::NONE, Bend::Bent));
    assert!(selected.fingers[0].mcp > 1.1 && selected.fingers[1].mcp > 1.1);
    assert!(selected.fingers[0].abduction.abs() < 0.1, "a bent finger loses its spread");
    assert!(changed("flat", HandshapeChange::Spread(true)).fingers[3].abduction > 0.3);
    assert!(changed("5", HandshapeChange::Spread(false)).fingers[3].abduction.abs() < 1e-9);
    let crossed = changed("U", HandshapeChange::Cross(Digit::Index, Digit::Middle));
    assert!(crossed.fingers[0].abduction < -0.1 && crossed.fingers[1].abduction > 0.1);
    let between = changed("fist-s", HandshapeChange::ThumbBetween(Digit::Index, Digit::Middle));
    assert_eq!(between.thumb, plain("T").thumb);
}

#[test]
fn between_is_halfway() {
    let inventory = HandshapeInventory::builtin();
    let configuration = Configuration::halfway("flat", "fist-s");
    let half = inventory.angles(&configuration, None).expect("known handshapes");
    let [a, b] = ["flat", "fist-s"].map(|id| inventory.find(id, None).expect("a known handshape").angles());
    assert!((half.fingers[1].pip - (a.fingers[1].pip + b.fingers[1].pip) / 2.0).abs() < 1e-12);
}

#[test]
fn every_change_keeps_within_limits() {
    let inventory = HandshapeInventory::builtin();
    let mut changes: Vec<HandshapeChange> = ThumbPosition::ALL.map(HandshapeChange::Thumb).to_vec();
    let sets = [Digits::NONE, Digits::FINGERS, Digits::of([Digit::Thumb, Digit::Ring])];
    changes.extend(sets.iter().flat_map(|d| Bend::ALL.map(|b| HandshapeChange::Bend(*d, b))));
    for pair in Digit::FINGERS.windows(2) {
        changes.push(HandshapeChange::Cross(pair[0], pair[1]));
        changes.push(HandshapeChange::Cross(pair[1], pair[0]));
        changes.push(HandshapeChange::ThumbBetween(pair[0], pair[1]));
    }
    for shape in inventory.shapes() {
        for change in &changes {
            let configuration = Configuration { changes: vec![*change, *change], ..Configuration::named(&shape.id) };
            let hand = inventory.angles(&configuration, None).expect("a known handshape");
            assert!(HandLimits::ANATOMICAL.hold(&hand), "{} {change:?}", shape.id);
        }
    }
}

#[test]
fn a_sound_row_loads_and_overrides() {
    assert_eq!(faults(&row_with("", "")), []);
    let text = row_with("paddle", "B").replace("XY P", "XY B");
    let inventory = HandshapeInventory::builtin().overridden(&Source::new("mine.ron", text)).expect("a sound row");
    assert_eq!(inventory.shapes().len(), 105);
    let shape = inventory.find("B", None).expect("the new row");
    assert_eq!(shape.aliases, ["XY B"]);
}

#[test]
fn faults_of_a_table_say_where_and_what() {
    let cases = [
        (row_with("5/10/7", "wavy"), "there is no flexion `wavy`", (5, 55)),
        (row_with("5/10/7", "5/10/170"), "beyond a hand's limits", (3, 13)),
        (row_with("middle tip", "middle top"), "`middle top` is not a point of a hand", (4, 63)),
        (row_with("index middle ring", "index finger ring"), "`finger` is not a digit", (4, 25)),
        (row_with("XY P\"]", "XY P\"], colour: 3"), "colour", (3, 42)),
    ];
    for (text, message, _at) in &cases {
        let found = faults(text);
        assert_eq!(found.len(), 1, "{message}: {found:?}");
        assert!(found[0].0.contains(message), "{found:?}");
        assert!(found[0].1.0 >= 3, "{found:?}");
    }
    assert_eq!(faults(&cases[0].0)[0].1, cases[0].2);
}

#[test]
fn names_given_twice_are_faults() {
    let one = row_with("", "");
    let second = &one[one.find("    (\n").expect("a row")..one.rfind("])").expect("the end")];
    let twice = faults(&one.replace("])", &format!("{second}])")));
    assert!(twice[0].0.contains("`paddle` is given twice"), "{twice:?}");
    let alias = faults(&one.replace("])", &format!("{}])", second.replace("paddle", "oar"))));
    assert!(alias.iter().any(|f| f.0.contains("`XY P` is a name of `paddle` as well")), "{alias:?}");
}
