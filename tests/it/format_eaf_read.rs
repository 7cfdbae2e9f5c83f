//! Reading EAF: what we write comes back, all stereotypes and versions, what broken files are told, real files counted.

use crate::golden;
use crate::shared::{column, shared};
use crate::tiers::{apart, cleaned, label, ms, tier};
use chereme::diagnostics::Severity;
use chereme::diagnostics::render::render;
use chereme::format::eaf::{self, Document, Eaf, Stereotype, Vocabulary, ecv};
use chereme::format::text::source_of_bytes;
use chereme::tier::{Tier, TierValue};
use chereme::time::Seconds;
use proptest::collection::vec;
use proptest::prelude::*;
use std::fmt::Write;

fn document() -> impl Strategy<Value = Document> {
    let vocabulary = (prop_oneof!["Phase", "Gloss", "Brows", "[a-d]"], vec(label(), 0..4));
    let vocabularies = vec(vocabulary.prop_map(|(kind, values)| Vocabulary { kind, values }), 0..3);
    (label(), "[a-z]{0,3}", vocabularies).prop_map(|(participant, language, vocabularies)| Document {
        participant,
        language,
        vocabularies,
    })
}

fn seen(values: &[TierValue]) -> Vec<(u32, u32, String)> {
    values.iter().map(|v| (ms(v.start), ms(v.end), cleaned(&v.label))).collect()
}

/// What is the same in every file that could be read.
fn sound(eaf: &Eaf) {
    for (at, tier) in eaf.tiers.iter().enumerate() {
        assert!(eaf.types.iter().any(|t| t.id == tier.tier_type));
        assert!(tier.tier.values().iter().all(|v| v.start <= v.end && v.start.0.is_finite()));
        assert!(tier.parent.as_ref().is_none_or(|name| eaf.tier(name).is_some()));
        assert!(eaf.tiers[..at].iter().all(|t| t.tier.name != tier.tier.name));
    }
}

proptest! {
    #[test]
    fn what_is_written_comes_back(tiers in vec(tier(apart()), 0..6), document in document()) {
        let reading = eaf::read(eaf::write(&tiers, &document).unwrap().as_bytes()).unwrap();
        prop_assert_eq!(&reading.warnings, &[]);
        let eaf = reading.eaf;
        sound(&eaf);
        prop_assert_eq!((eaf.version.as_str(), eaf.media.len()), ("3.0", 0));
        let mut sources = eaf.tiers[tiers.len()..].iter();
        for (read, tier) in eaf.tiers.iter().zip(&tiers) {
            prop_assert!(read.tier.name.starts_with(&cleaned(&tier.name)));
            prop_assert_eq!(seen(read.tier.values()), seen(tier.values()));
            // Whole milliseconds come back to the bit.
            prop_assert!(read.tier.values().iter().all(|v| v.start.0 == f64::from(ms(v.start)) / 1000.0));
            prop_assert_eq!(&read.participant, &cleaned(&document.participant));
            let gloss = read.parent.as_deref().map(|name| eaf.tier(name).unwrap());
            prop_assert_eq!(read.stereotype, gloss.map(|_| Stereotype::IncludedIn));
            if tier.values().iter().any(|v| !v.source.is_empty()) {
                let theirs = sources.next().unwrap();
                prop_assert_eq!(theirs.parent.as_ref(), Some(&read.tier.name));
                prop_assert_eq!(theirs.stereotype, Some(Stereotype::SymbolicAssociation));
                let expected: Vec<_> =
                    tier.values().iter().map(|v| (ms(v.start), ms(v.end), cleaned(&v.source))).collect();
                prop_assert_eq!(seen(theirs.tier.values()), expected);
            }
        }
        prop_assert!(sources.next().is_none());
    }

    #[test]
    fn any_change_of_a_file_is_read_or_refused(
        file in prop::sample::select(suite()),
        changes in vec((any::<prop::sample::Index>(), any::<u8>(), 0..3u8), 1..4),
    ) {
        let mut bytes = file;
        for (at, byte, how) in changes {
            let at = at.index(bytes.len().max(1)).min(bytes.len().saturating_sub(1));
            match how {
                0 if at < bytes.len() => bytes[at] = byte,
                1 => bytes.truncate(at),
                _ => bytes.insert(at, byte),
            }
        }
        judge(&bytes);
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in vec(any::<u8>(), 0..100)) {
        judge(&bytes);
    }
}

fn judge(bytes: &[u8]) {
    let source = source_of_bytes("a.eaf", bytes);
    match eaf::read(bytes) {
        Ok(reading) => {
            sound(&reading.eaf);
            reading.warnings.iter().for_each(|w| drop(render(w, &source, false)));
        }
        Err(told) => {
            assert!(told.iter().any(|t| t.severity == Severity::Fault));
            assert!(told.iter().all(|t| !render(t, &source, false).is_empty() && !t.label.is_empty()));
        }
    }
    let _ = ecv::read(bytes);
}

fn suite() -> Vec<Vec<u8>> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/eaf");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    files.iter().filter(|p| p.extension().is_some_and(|e| e == "eaf")).map(|p| std::fs::read(p).unwrap()).collect()
}

/// What a file says, as text.
fn dump(eaf: &Eaf) -> String {
    let mut out = format!("version {}\n", eaf.version);
    for media in &eaf.media {
        writeln!(out, "media {} from {} s", media.url, media.origin.0).unwrap();
    }
    for vocabulary in &eaf.vocabularies {
        let words = |e: &eaf::Entry| e.values.iter().map(|v| v.text.clone()).collect::<Vec<_>>().join(" = ");
        let all: Vec<String> = vocabulary.entries.iter().map(words).collect();
        writeln!(out, "vocabulary {} ({}): {}", vocabulary.id, vocabulary.description, all.join(", ")).unwrap();
    }
    for tier in &eaf.tiers {
        let hangs = tier.stereotype.map_or(String::new(), |s| format!(" {}", s.word()));
        let of = tier.parent.as_ref().map_or(String::new(), |p| format!(" of {p}"));
        let who = [&tier.participant, &tier.annotator].map(|who| if who.is_empty() { "-" } else { who }).join(" by ");
        let language = tier.language.as_deref().unwrap_or("-");
        writeln!(out, "{}:{hangs}{of}, {who}, in {language}", tier.tier.name).unwrap();
        for v in tier.tier.values() {
            writeln!(out, "  {:.3} {:.3} {} ({})", v.start.0, v.end.0, v.label, v.source).unwrap();
        }
    }
    out
}

/// `UPDATE=1 cargo test` writes the expectations anew.
#[test]
fn files_of_all_versions_and_their_mistakes() {
    golden::beside("eaf", "eaf", 25, |name, bytes| {
        let source = source_of_bytes(name, bytes);
        let (said, told) = match eaf::read(bytes) {
            Ok(reading) => (dump(&reading.eaf), reading.warnings),
            Err(told) => (String::new(), told),
        };
        said + "\n" + &told.iter().map(|d| render(d, &source, false) + "\n\n").collect::<String>()
    });
}

#[test]
fn an_external_vocabulary_gives_texts() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/eaf");
    let file = std::fs::read(folder.join("an-external-vocabulary.eaf")).unwrap();
    let (theirs, warnings) = ecv::read(&std::fs::read(folder.join("phases.ecv")).unwrap()).unwrap();
    assert_eq!(warnings, []);
    let mut asked = Vec::new();
    let reading = eaf::read_with(&file, |url| {
        asked.push(url.to_owned());
        Some(theirs.clone())
    })
    .unwrap();
    assert_eq!(asked, ["file:///phases.ecv"]);
    assert_eq!(reading.warnings, []);
    let labels: Vec<&str> = reading.eaf.tiers[0].tier.values().iter().map(|v| v.label.as_str()).collect();
    assert_eq!(labels, ["stroke", "hold"]);
    assert_eq!(reading.eaf.vocabularies[0].entries.len(), 2);
    let others = eaf::read_with(&file, |_| Some(vec![])).unwrap();
    assert!(others.warnings.iter().any(|w| w.message == "file:///phases.ecv has no vocabulary `phases`"));
    assert!(ecv::read(&file).unwrap_err()[0].message.contains("is not the beginning of an ECV file"));
}

/// Long chains of references cost no stack, and time in proportion.
#[test]
fn depth_and_counts_cost_no_more_than_their_text() {
    let n = 20_000;
    let mut text = String::from(
        "<ANNOTATION_DOCUMENT FORMAT=\"3.0\"><HEADER/><TIME_ORDER><TIME_SLOT TIME_SLOT_ID=\"t1\" TIME_VALUE=\"0\"/><TIME_SLOT TIME_SLOT_ID=\"t2\" TIME_VALUE=\"20000\"/></TIME_ORDER>\
         <TIER TIER_ID=\"0\" LINGUISTIC_TYPE_REF=\"g\"><ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID=\"a0\" TIME_SLOT_REF1=\"t1\" TIME_SLOT_REF2=\"t2\"/></ANNOTATION></TIER>",
    );
    for i in 1..n {
        // Tiers below one another, the last first.
        let at = n - i;
        write!(text, "<TIER TIER_ID=\"{at}\" PARENT_REF=\"{}\" LINGUISTIC_TYPE_REF=\"m\"><ANNOTATION><REF_ANNOTATION ANNOTATION_ID=\"a{at}\" ANNOTATION_REF=\"a{}\"/></ANNOTATION></TIER>", at - 1, at - 1).unwrap();
    }
    text += "<TIER TIER_ID=\"parts\" PARENT_REF=\"0\" LINGUISTIC_TYPE_REF=\"p\">";
    for i in 0..n {
        let at = n - i;
        let previous = if at == 1 { String::new() } else { format!(" PREVIOUS_ANNOTATION=\"p{}\"", at - 1) };
        write!(
            text,
            "<ANNOTATION><REF_ANNOTATION ANNOTATION_ID=\"p{at}\" ANNOTATION_REF=\"a0\"{previous}/></ANNOTATION>"
        )
        .unwrap();
    }
    text += "</TIER><LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"g\"/><LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"m\" CONSTRAINTS=\"Symbolic_Association\"/>\
             <LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"p\" CONSTRAINTS=\"Symbolic_Subdivision\"/></ANNOTATION_DOCUMENT>";
    let eaf = eaf::read(text.as_bytes()).unwrap().eaf;
    assert_eq!(eaf.tiers[1].tier.values()[0].end, Seconds(20.0));
    let parts = eaf.tier("parts").unwrap().tier.values();
    assert!(parts.iter().enumerate().all(|(i, v)| v.start == Seconds(i as f64 / 1000.0)));
    // All in a circle, and all of one name.
    let circle = text.replace("<TIER TIER_ID=\"0\"", "<TIER TIER_ID=\"0\" PARENT_REF=\"19999\"");
    assert!(eaf::read(circle.as_bytes()).unwrap_err()[0].message.contains("hangs on"));
    let same = text.replace("TIER_ID=\"1", "TIER_ID=\"x\" X=\"");
    assert!(eaf::read(same.as_bytes()).unwrap_err().len() < 220);
}

/// Tiers and annotations, as the manifest counts them, and as many as the file has elements.
#[test]
fn real_files_are_read_whole() {
    let Some(folder) = shared("data/mocap/elan") else { return };
    let mut described = column(&folder.join("../MANIFEST.tsv"), "file").into_iter().filter(|p| p.starts_with("elan/"));
    assert_eq!(described.by_ref().count(), 3);
    for (name, tiers, annotations) in
        [("elan-example1.eaf", 11, 315), ("pympi_sample_3.0.eaf", 6, 8778), ("speach_test.eaf", 5, 43)]
    {
        let bytes = std::fs::read(folder.join(name)).unwrap();
        let reading = eaf::read(&bytes).unwrap_or_else(|told| panic!("{name}: {told:?}"));
        sound(&reading.eaf);
        let counted: usize = reading.eaf.tiers.iter().map(|t| t.tier.values().len()).sum();
        let written = String::from_utf8_lossy(&bytes).matches("<ANNOTATION>").count();
        assert_eq!((reading.eaf.tiers.len(), counted), (tiers, annotations), "{name}");
        assert_eq!(counted, written, "{name}");
        // Everything is under its parent.
        for tier in &reading.eaf.tiers {
            let Some(parent) = tier.parent.as_deref().and_then(|p| reading.eaf.tier(p)) else { continue };
            let inside = |v: &TierValue| parent.tier.values().iter().any(|p| p.start <= v.start && v.end <= p.end);
            assert!(tier.tier.values().iter().all(inside), "{name}: {} leaves its parent", tier.tier.name);
        }
    }
}

/// What is read can be written again: times to the millisecond, every label.
#[test]
fn a_real_file_comes_back_through_our_writer() {
    let Some(folder) = shared("data/mocap/elan") else { return };
    let eaf = eaf::read(&std::fs::read(folder.join("speach_test.eaf")).unwrap()).unwrap().eaf;
    let tiers: Vec<Tier> = eaf.tiers.iter().map(|t| t.tier.clone()).collect();
    let again = eaf::read(eaf::write(&tiers, &Document::default()).unwrap().as_bytes()).unwrap().eaf;
    for (a, b) in tiers.iter().zip(&again.tiers) {
        assert_eq!(seen(a.values()), seen(b.tier.values()));
    }
}
