//! TextGrid: what is written comes back, both text forms and encodings, and what broken ones are told.

use crate::golden;
use crate::tiers::{apart, tier};
use chereme::diagnostics::Severity;
use chereme::diagnostics::render::render;
use chereme::format::text::source_of_bytes;
use chereme::format::textgrid::{Kind, read, write};
use chereme::tier::Tier;
use chereme::time::Seconds;
use proptest::collection::vec;
use proptest::prelude::*;

/// What a TextGrid keeps of a tier: no sources, no values without a label.
fn kept(tier: &Tier) -> Tier {
    let mut kept = Tier::new(tier.name.clone());
    let labelled = tier.values().iter().filter(|v| !v.label.is_empty());
    labelled.for_each(|v| kept.push(v.start, v.end, v.label.clone(), ""));
    kept
}

proptest! {
    #[test]
    fn what_is_written_comes_back(tiers in vec(tier(apart()), 0..5), end in 0.0..9.0f64) {
        let file = write(&tiers, Seconds(end));
        let reading = read(file.as_bytes()).unwrap_or_else(|told| panic!("{file}\n{told:?}"));
        prop_assert_eq!(&reading.warnings, &[]);
        let read_tiers: Vec<Tier> = reading.grid.tiers.iter().map(|t| t.tier.clone()).collect();
        prop_assert_eq!(&read_tiers, &tiers.iter().map(kept).collect::<Vec<_>>());
        prop_assert_eq!(reading.grid.start, Seconds(0.0));
        let last = read_tiers.iter().flat_map(|t| t.values()).map(|v| v.end.0).fold(end, f64::max);
        prop_assert!(reading.grid.end.0 >= last);
        // The short form and UTF-16 say the same.
        let words = |line: &str| line.split_once(" = ").map_or(line.trim().to_owned(), |(_, value)| value.to_owned());
        if !tiers.iter().any(|t| t.name.contains(['\n', '\r', '=']) || t.values().iter().any(|v| v.label.contains(['\n', '\r', '=']))) {
            let short: String = file.lines().filter(|l| !l.contains("]:")).map(|l| words(l) + "\n").collect();
            let short = short.replace("tiers? <exists>", "<exists>").replace("item []:", "");
            prop_assert_eq!(read(short.as_bytes()).unwrap().grid, reading.grid.clone(), "{}", short);
        }
        let little: Vec<u8> = "\u{feff}".encode_utf16().chain(file.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = "\u{feff}".encode_utf16().chain(file.encode_utf16()).flat_map(u16::to_be_bytes).collect();
        prop_assert_eq!(&read(&little).unwrap().grid, &reading.grid);
        prop_assert_eq!(&read(&big).unwrap().grid, &reading.grid);
    }

    /// Whatever tiers there are, Praat's rules are kept: intervals follow one another without gaps.
    #[test]
    fn any_tiers_give_a_grid(tiers in vec(tier(vec((prop_oneof![-1.0..3.0f64, any::<f64>()], prop_oneof![0.0..3.0f64, any::<f64>()]), 0..8)), 0..4)) {
        let file = write(&tiers, Seconds(f64::NAN));
        let reading = read(file.as_bytes()).unwrap_or_else(|told| panic!("{file}\n{told:?}"));
        prop_assert_eq!(reading.warnings, []);
        prop_assert_eq!(reading.grid.tiers.len(), tiers.len());
        let long = file.lines().filter(|l| l.starts_with("            xm"));
        let times: Vec<f64> = long.filter_map(|l| l.split_once("= ")?.1.trim().parse().ok()).collect();
        prop_assert!(times.chunks_exact(2).all(|t| t[0] <= t[1]));
    }

    #[test]
    fn any_bytes_are_read_or_refused(
        bytes in prop_oneof![
            vec(any::<u8>(), 0..100),
            "\"ooTextFile\" \"TextGrid\" 0 9 <exists> [0-3]( \"(IntervalTier|TextTier)\" \"a\" 0 9 [0-3]( [0-9]( [0-9])? \"[a-b!]?\"){0,3}){0,3}".prop_map(String::into_bytes),
        ],
    ) {
        let source = source_of_bytes("a.TextGrid", &bytes);
        match read(&bytes) {
            Ok(reading) => prop_assert!(reading.grid.tiers.iter().all(|t| t.tier.values().iter().all(|v| v.start <= v.end))),
            Err(told) => {
                prop_assert!(told.iter().any(|t| t.severity == Severity::Fault));
                prop_assert!(told.iter().all(|t| !render(t, &source, false).is_empty() && !t.label.is_empty()));
            }
        }
    }
}

#[test]
fn points_overlaps_and_gaps() {
    let mut beats = Tier::new("Beat");
    [0.0, 0.5, 1.0].into_iter().for_each(|t| beats.push(Seconds(t), Seconds(t), if t == 0.5 { "" } else { "x" }, ""));
    let mut over = Tier::new("RH");
    for (start, end, text) in [(0.2, 0.9, "a"), (0.5, 0.5, "b"), (0.5, 1.0, "c"), (1.5, 2.0, "d")] {
        over.push(Seconds(start), Seconds(end), text, "");
    }
    let grid = read(write(&[beats.clone(), over], Seconds(3.0)).as_bytes()).unwrap().grid;
    assert_eq!((grid.tiers[0].kind, &grid.tiers[0].tier), (Kind::Points, &beats));
    assert_eq!((grid.tiers[1].kind, grid.end), (Kind::Intervals, Seconds(3.0)));
    let spans: Vec<_> = grid.tiers[1].tier.values().iter().map(|v| (v.start.0, v.end.0, v.label.as_str())).collect();
    assert_eq!(spans, [(0.2, 0.5, "a"), (0.5, 0.501, "b"), (0.501, 1.0, "c"), (1.5, 2.0, "d")]);
}

#[test]
fn what_praat_takes_for_comments_is_passed_over() {
    let text = "\"ooTextFile short\" ! a \"comment\" 5\n\"TextGrid\"\nfrom 0 to 2.5 seconds\ntiers? <exists> 1 tier:\n\
                class \"IntervalTier\" name \"say \"\"x\"\"\" 0 2.5 with 2 intervals: 0 1 \"\" 1 2.5 \"b\n!c\"";
    let grid = read(text.as_bytes()).unwrap().grid;
    assert_eq!(grid.tiers[0].tier.name, "say \"x\"");
    assert_eq!(grid.tiers[0].tier.values()[0].label, "b\n!c");
    let none = read(b"\"ooTextFile\" \"TextGrid\" 0 1 <absent>").unwrap().grid;
    assert_eq!((none.tiers.len(), none.end), (0, Seconds(1.0)));
    // A count beyond the file costs nothing.
    let many = text.replace("with 2", "with 1000000000000");
    assert_eq!(read(many.as_bytes()).unwrap_err()[0].message, "the file ends too early");
}

/// `UPDATE=1 cargo test` writes the expectations anew.
#[test]
fn each_mistake_has_its_message() {
    golden::beside("textgrid", "TextGrid", 8, |name, bytes| {
        let source = source_of_bytes(name, bytes);
        let told = read(bytes).map_or_else(|told| told, |reading| reading.warnings);
        assert!(!told.is_empty(), "{name}");
        told.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}
