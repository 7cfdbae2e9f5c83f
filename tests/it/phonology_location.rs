//! The inventory of locations: the 44 of HamNoSys, look-up, and faults with line and column.

use chereme::diagnostics::Source;
use chereme::phonology::location::{LocationInventory, LocationKind};
use chereme::phonology::{Digit, Distance, HandPart};
use std::collections::HashSet;

/// The location tags of HamNoSys 4 with their code points, by their blocks in the private use area.
const HAMNOSYS: [(&str, u32); 44] = [
    ("hamhead", 0xE040),
    ("hamheadtop", 0xE041),
    ("hamforehead", 0xE042),
    ("hameyebrows", 0xE043),
    ("hameyes", 0xE044),
    ("hamnose", 0xE045),
    ("hamnostrils", 0xE046),
    ("hamear", 0xE047),
    ("hamearlobe", 0xE048),
    ("hamcheek", 0xE049),
    ("hamlips", 0xE04A),
    ("hamtongue", 0xE04B),
    ("hamteeth", 0xE04C),
    ("hamchin", 0xE04D),
    ("hamunderchin", 0xE04E),
    ("hamneck", 0xE04F),
    ("hamshouldertop", 0xE050),
    ("hamshoulders", 0xE051),
    ("hamchest", 0xE052),
    ("hamstomach", 0xE053),
    ("hambelowstomach", 0xE054),
    ("hamneutralspace", 0xE05F),
    ("hamupperarm", 0xE060),
    ("hamelbow", 0xE061),
    ("hamelbowinside", 0xE062),
    ("hamlowerarm", 0xE063),
    ("hamwristback", 0xE064),
    ("hamwristpulse", 0xE065),
    ("hamthumbball", 0xE066),
    ("hampalm", 0xE067),
    ("hamhandback", 0xE068),
    ("hamthumbside", 0xE069),
    ("hampinkyside", 0xE06A),
    ("hamthumb", 0xE070),
    ("hamindexfinger", 0xE071),
    ("hammiddlefinger", 0xE072),
    ("hamringfinger", 0xE073),
    ("hampinky", 0xE074),
    ("hamfingertip", 0xE075),
    ("hamfingernail", 0xE076),
    ("hamfingerpad", 0xE077),
    ("hamfingermidjoint", 0xE078),
    ("hamfingerbase", 0xE079),
    ("hamfingerside", 0xE07A),
];

#[test]
fn all_locations_of_hamnosys_stand_once() {
    let inventory = LocationInventory::builtin();
    assert_eq!(inventory.rows().len(), 44);
    for (tag, code) in HAMNOSYS {
        let row = inventory.by_tag(tag).unwrap_or_else(|| panic!("{tag}"));
        assert_eq!(row.symbol as u32, code, "{tag}");
        assert_eq!(inventory.by_symbol(row.symbol), Some(row));
    }
    let tags: HashSet<&str> = inventory.rows().iter().map(|r| r.tag.as_str()).collect();
    assert_eq!(tags.len(), 44);
}

#[test]
fn every_part_of_hand_and_arm_and_every_digit_has_one_row() {
    let inventory = LocationInventory::builtin();
    let count = |kind| inventory.rows().iter().filter(|r| r.kind == kind).count();
    for part in HandPart::OF_THE_LIMB {
        assert_eq!(count(LocationKind::Limb(part)), 1, "{part:?}");
    }
    for part in HandPart::OF_A_DIGIT {
        assert_eq!(count(LocationKind::Part(part)), 1, "{part:?}");
    }
    for digit in Digit::ALL {
        assert_eq!(count(LocationKind::Digit(digit)), 1, "{digit:?}");
    }
    // The name of a part in text finds its row.
    for part in HandPart::OF_THE_LIMB {
        assert_eq!(inventory.get(part.name()).map(|r| r.kind), Some(LocationKind::Limb(part)));
    }
}

#[test]
fn names_are_found_in_any_case_and_any_unicode_form() {
    let inventory = LocationInventory::builtin();
    for (name, id) in [("CHEST", "chest"), ("Upper-Chest", "shoulders"), ("mouth", "lips"), ("waist", "belowstomach")] {
        assert_eq!(inventory.get(name).map(|r| r.id.as_str()), Some(id), "{name}");
    }
    assert!(inventory.get("elbows").is_none());
    let accented = Source::new("a.ron", table(&[row("épaule", "hamx", "E0FF", "Body", "0.1")]));
    let inventory = LocationInventory::from_source(&accented).unwrap();
    assert!(inventory.get("e\u{301}paule").is_some() && inventory.get("É\u{50}AULE").is_some());
}

#[test]
fn unmarked_distances_are_touch_on_the_face_and_neutral_on_the_trunk() {
    let inventory = LocationInventory::builtin();
    let unmarked = |id: &str| inventory.get(id).map(|r| r.unmarked);
    for id in ["forehead", "nose", "cheek", "lips", "chin", "ear", "palm", "tip"] {
        assert_eq!(unmarked(id), Some(Distance::Touch), "{id}");
    }
    for id in ["shoulders", "chest", "stomach", "belowstomach"] {
        assert_eq!(unmarked(id), Some(Distance::Neutral), "{id}");
    }
    assert_eq!(unmarked("eyes"), Some(Distance::Close));
    assert!(inventory.rows().iter().all(|r| r.unmarked != Distance::Unmarked));
}

#[test]
fn rows_of_another_table_override_and_add() {
    let base = LocationInventory::builtin();
    let text =
        table(&[row("chest", "hamchest", "E052", "Body", "0.3"), row("temple", "hamtemple", "F000", "Body", "0.1")]);
    let mine = LocationInventory::from_source(&Source::new("mine.ron", text)).unwrap();
    let both = base.overridden_by(&mine).unwrap();
    assert_eq!(both.rows().len(), 45);
    assert_eq!(both.get("chest").map(|r| r.half_width_arms), Some(0.3));
    assert!(both.get("temple").is_some());
    let clash = table(&[row("mouth", "hammouth", "F000", "Body", "0.1")]);
    let clash = LocationInventory::from_source(&Source::new("clash.ron", clash)).unwrap();
    let faults = base.overridden_by(&clash).unwrap_err();
    assert_eq!(faults, ["\"mouth\" names both the place lips and the place mouth"]);
}

fn row(id: &str, tag: &str, code: &str, kind: &str, width: &str) -> String {
    format!(
        "        (id: \"{id}\", hamnosys: (\"{tag}\", \"{code}\"), kind: {kind}, unmarked: Touch, half_width: {width}),"
    )
}

fn table(rows: &[String]) -> String {
    format!("(\n    locations: [\n{}\n    ],\n)\n", rows.join("\n"))
}

/// The faults of a table of rows as `line:column message`.
fn faults(rows: &[String]) -> Vec<String> {
    let source = Source::new("bad.ron", table(rows));
    let found = LocationInventory::from_source(&source).expect_err("the table is faulty");
    let line = |d: &chereme::diagnostics::Diagnostic| {
        let (line, column) = source.line_column(d.span.start);
        format!("{line}:{column} {}", d.message)
    };
    found.iter().map(line).collect()
}

#[test]
fn faults_name_line_and_column_all_at_once() {
    let good = row("a", "hama", "F000", "Body", "0.1");
    let found = faults(&[
        good.clone(),
        row("A", "hamb", "F001", "Body", "0.1"),
        row("c", "hama", "G", "Limb(\"wing\")", "-1.0"),
    ]);
    let column = |needle: &str, row: &str| row.find(needle).expect("in the row") + 2;
    let third = row("c", "hama", "G", "Limb(\"wing\")", "-1.0");
    assert_eq!(
        found,
        [
            format!("4:{} the name \"A\" stands twice", column("\"A\"", &row("A", "hamb", "F001", "Body", "0.1"))),
            format!("5:{} the HamNoSys tag \"hama\" stands twice", column("\"hama\"", &third)),
            format!("5:{} \"G\" is not a hexadecimal code point such as E052", column("\"G\"", &third)),
            format!("5:{} \"wing\" is not a part of the hand or arm", column("\"wing\"", &third)),
            format!("5:{} the half-width of c is -1, not a width in arm lengths", column("\"c\"", &third)),
        ]
    );
    let unknown = faults(&[good.replace("paired", "").replace("unmarked: Touch", "unmarked: Far")]);
    assert!(unknown.len() == 1 && unknown[0].starts_with("3:"), "{unknown:?}");
    let blank = faults(&[row("two words", "hama", "F000", "Body", "0.1")]);
    assert_eq!(blank, ["3:15 \"two words\" cannot be a name: names are one word"]);
}
