//! EAF files: well formed whatever the labels, every value there at its time, ELAN's rules kept.

use crate::signing::{perform, signs_of};
use crate::tiers::{apart, cleaned, label, ms, tier};
use chereme::format::eaf::{Document, Vocabulary, write};
use chereme::tier::Tier;
use chereme::time::Seconds;
use chereme::track::PHASES;
use proptest::collection::vec;
use proptest::prelude::*;
use roxmltree::Node;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// An annotation as a reader sees it, with the text of the annotation that refers to it.
#[derive(Debug, Clone, PartialEq)]
struct Seen {
    begin: u32,
    end: u32,
    label: String,
    source: Option<String>,
}

/// A tier with its parent's name.
#[derive(Debug)]
struct SeenTier {
    name: String,
    parent: Option<String>,
    values: Vec<Seen>,
}

fn named<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.descendants().filter(move |n| n.has_tag_name(name))
}

/// Reads a file back and checks what ELAN asks of every file.
fn read(file: &str) -> Vec<SeenTier> {
    let document = roxmltree::Document::parse(file).unwrap_or_else(|e| panic!("{e}\n{file}"));
    let root = document.root_element();
    let mut ids = BTreeSet::new();
    let all = ["TIME_SLOT_ID", "ANNOTATION_ID", "LANG_ID", "STEREOTYPE"];
    for id in root.descendants().flat_map(|n| all.into_iter().filter_map(move |a| n.attribute(a))) {
        assert!(ids.insert(id), "{id} twice");
        assert!(id.chars().all(|c| c.is_ascii_alphanumeric() || "-_".contains(c)) && !id.starts_with(char::is_numeric));
    }
    let slots: Vec<(&str, u32)> = named(root, "TIME_SLOT")
        .map(|s| (s.attribute("TIME_SLOT_ID").unwrap(), s.attribute("TIME_VALUE").unwrap().parse().unwrap()))
        .collect();
    assert!(slots.is_sorted_by_key(|s| s.1), "slots ascend");
    let times: BTreeMap<&str, u32> = slots.iter().copied().collect();
    let types: BTreeMap<&str, Node> =
        named(root, "LINGUISTIC_TYPE").map(|t| (t.attribute("LINGUISTIC_TYPE_ID").unwrap(), t)).collect();

    let mut place = BTreeMap::new();
    let mut tiers: Vec<SeenTier> = Vec::new();
    for node in named(root, "TIER") {
        let name = node.attribute("TIER_ID").unwrap().to_owned();
        assert!(tiers.iter().all(|t| t.name != name), "{name} twice");
        let kind = types[node.attribute("LINGUISTIC_TYPE_REF").unwrap()];
        let constraint = kind.attribute("CONSTRAINTS");
        let parent = node.attribute("PARENT_REF").map(str::to_owned);
        assert_eq!(parent.is_some(), constraint.is_some(), "{name}");
        let text = |n: Node| named(n, "ANNOTATION_VALUE").next().unwrap().text().unwrap_or_default().to_owned();
        for annotation in named(node, "REF_ANNOTATION") {
            assert_eq!(constraint, Some("Symbolic_Association"));
            let (tier, value): (usize, usize) = place[annotation.attribute("ANNOTATION_REF").unwrap()];
            assert_eq!(Some(&tiers[tier].name), parent.as_ref());
            let source = &mut tiers[tier].values[value].source;
            assert!(source.replace(text(annotation)).is_none(), "two sources");
        }
        if constraint == Some("Symbolic_Association") {
            continue;
        }
        let mut values = Vec::new();
        for annotation in named(node, "ALIGNABLE_ANNOTATION") {
            let time = |attribute| times[annotation.attribute(attribute).unwrap()];
            let (begin, end) = (time("TIME_SLOT_REF1"), time("TIME_SLOT_REF2"));
            assert!(begin < end, "{name} at {begin}");
            place.insert(annotation.attribute("ANNOTATION_ID").unwrap().to_owned(), (tiers.len(), values.len()));
            if let Some(vocabulary) = kind.attribute("CONTROLLED_VOCABULARY_REF") {
                let offered = named(root, "CONTROLLED_VOCABULARY").find(|v| v.attribute("CV_ID") == Some(vocabulary));
                let entry = named(offered.unwrap(), "CV_ENTRY_ML")
                    .find(|e| e.attribute("CVE_ID") == annotation.attribute("CVE_REF"))
                    .unwrap();
                assert_eq!(entry.first_element_child().unwrap().text().unwrap_or_default(), text(annotation));
            }
            values.push(Seen { begin, end, label: text(annotation), source: None });
        }
        assert!(values.windows(2).all(|w| w[0].end <= w[1].begin), "{name} overlaps");
        assert_eq!(parent.is_some(), constraint == Some("Included_In"));
        tiers.push(SeenTier { name, parent, values });
    }
    for (tier, name) in tiers.iter().filter_map(|t| Some((t, t.parent.as_ref()?))) {
        let parent = tiers.iter().find(|t| t.name == *name).expect("the parent is there");
        assert_eq!(parent.parent, None);
        let inside = |v: &Seen| parent.values.iter().any(|p| p.begin <= v.begin && v.end <= p.end);
        assert!(tier.values.iter().all(inside), "{} leaves {name}", tier.name);
    }
    tiers
}

fn document() -> impl Strategy<Value = Document> {
    let vocabulary = (prop_oneof!["Phase", "Gloss", "Brows", "[a-d]"], vec(label(), 0..4));
    let vocabularies = vec(vocabulary.prop_map(|(kind, values)| Vocabulary { kind, values }), 0..3);
    (label(), label(), vocabularies).prop_map(|(participant, language, vocabularies)| Document {
        participant,
        language,
        vocabularies,
    })
}

proptest! {
    #[test]
    fn any_tiers_give_a_file_that_holds_them(
        tiers in vec(tier(vec((prop_oneof![0.0f64..3.0, any::<f64>()], prop_oneof![0.0f64..3.0, any::<f64>()]), 0..8)), 0..8),
        document in document(),
    ) {
        let seen = read(&write(&tiers, &document).unwrap());
        prop_assert_eq!(seen.len(), tiers.len());
        for (seen, tier) in seen.iter().zip(&tiers) {
            prop_assert!(seen.name.starts_with(&cleaned(&tier.name)));
            let labels: Vec<String> = tier.values().iter().map(|v| cleaned(&v.label)).collect();
            prop_assert_eq!(seen.values.iter().map(|v| v.label.clone()).collect::<Vec<_>>(), labels);
        }
    }

    #[test]
    fn values_one_after_the_other_come_back_at_their_milliseconds(tiers in vec(tier(apart()), 0..6)) {
        let seen = read(&write(&tiers, &Document::default()).unwrap());
        for (seen, tier) in seen.iter().zip(&tiers) {
            let sourced = tier.values().iter().any(|v| !v.source.is_empty());
            let expected: Vec<Seen> = tier.values().iter().map(|v| Seen {
                begin: ms(v.start),
                end: ms(v.end),
                label: cleaned(&v.label),
                source: sourced.then(|| cleaned(&v.source)),
            }).collect();
            prop_assert_eq!(&seen.values, &expected);
        }
    }
}

#[test]
fn overlaps_are_cut_and_instants_last_a_millisecond() {
    let mut tier = Tier::new("Beat");
    for (start, end) in [(0.0, 0.9), (0.5, 0.5), (0.5, 1.0), (2.0, 2.0)] {
        tier.push(Seconds(start), Seconds(end), "x", "");
    }
    let seen = read(&write(&[tier], &Document::default()).unwrap());
    let spans: Vec<_> = seen[0].values.iter().map(|v| (v.begin, v.end)).collect();
    assert_eq!(spans, [(0, 500), (500, 501), (501, 1000), (2000, 2001)]);
    assert_eq!(seen[0].values[0].source, None);
}

#[test]
fn a_sign_has_its_tiers_under_its_glosses() {
    for sign in signs_of("lsf").iter().filter(|s| ["BOL", "PENSER", "LSF"].contains(&s.name.as_str())) {
        let track = perform(sign).track;
        let seen = read(&write(&track.tiers, &Document::default()).unwrap());
        assert_eq!(seen.len(), track.tiers.len());
        for tier in &seen {
            let parent = match tier.name.split_once(' ') {
                Some((hand, "Configuration" | "Placement" | "Orientation" | "Movement")) => {
                    Some(format!("{hand} Gloss"))
                }
                _ => None,
            };
            assert_eq!(tier.parent, parent, "{} of {}", tier.name, sign.name);
            if tier.name.ends_with("Phase") {
                assert!(tier.values.iter().all(|v| PHASES.contains(&v.label.as_str())));
            }
        }
    }
}

/// `UPDATE=1 cargo test` writes the expectation anew.
#[test]
fn a_file_as_it_is_written() {
    let mut gloss = Tier::new("RH Gloss");
    gloss.push(Seconds(0.3), Seconds(1.2), "BOL", "description");
    let mut shape = Tier::new("RH Configuration");
    shape.push(Seconds(0.3), Seconds(0.7004), "round-B", "description");
    shape.push(Seconds(0.7004), Seconds(1.2), "B & <flat>", "description, by symmetry");
    let vocabularies = vec![Vocabulary { kind: "Configuration".into(), values: vec!["A".into(), "round-B".into()] }];
    let document = Document { participant: "avatar".into(), language: "lsf".into(), vocabularies };
    let file = write(&[gloss, shape], &document).unwrap().replace(env!("CARGO_PKG_VERSION"), "VERSION");
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/format/tiers.eaf");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::create_dir_all(beside.parent().unwrap()).unwrap();
        std::fs::write(&beside, &file).unwrap();
    }
    assert_eq!(file, std::fs::read_to_string(&beside).unwrap());
}
