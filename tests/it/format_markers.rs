//! Positions of markers: real recordings, missing markers, and what broken files are told.

use crate::golden;
use crate::shared::shared;
use chereme::diagnostics::Severity;
use chereme::diagnostics::render::render;
use chereme::format::markers::{HAND_POINTS, Markers, read};
use chereme::format::text::source_of_bytes;
use glam::DVec3;
use proptest::collection::vec;
use proptest::prelude::*;

/// A Qualisys file of these frames.
fn qualisys(names: &[String], frames: &[Vec<Option<DVec3>>], numbered: bool, zeros: bool) -> String {
    let mut text = format!(
        "NO_OF_FRAMES\t{}\r\nNO_OF_MARKERS\t{}\r\nFREQUENCY\t120\r\nMARKER_NAMES\t{}\r\n",
        frames.len(),
        names.len(),
        names.join("\t")
    );
    if numbered {
        let heads: Vec<String> = names.iter().map(|n| format!("{n} X\t{n} Y\t{n} Z")).collect();
        text += &format!("Frame\tTime\t{}\r\n", heads.join("\t"));
    }
    for (i, frame) in frames.iter().enumerate() {
        let missing = if zeros { "0.000\t0.000\t0.000" } else { "\t\t" };
        let cells = frame.iter().map(|p| p.map_or(missing.to_owned(), |p| format!("{}\t{}\t{}", p.x, p.y, p.z)));
        let cells: Vec<String> = cells.collect();
        let before = if numbered { format!("{}\t{}\t", i + 1, i as f64 / 120.0) } else { String::new() };
        text += &format!("{before}{}\r\n", cells.join("\t"));
    }
    text
}

fn frames(markers: &Markers) -> Vec<Vec<Option<DVec3>>> {
    markers.frames().map(<[_]>::to_vec).collect()
}

proptest! {
    #[test]
    fn frames_come_back(
        (names, frames_of) in (1..6usize).prop_flat_map(|n| (
            vec("[a-z_]{1,8}", n),
            vec(vec(proptest::option::of((-1e3..1e3f64, -1e3..1e3f64, 0.1..1e3f64).prop_map(DVec3::from)), n), 1..6),
        )),
        zeros in any::<bool>(),
    ) {
        for numbered in [true, false] {
            let text = qualisys(&names, &frames_of, numbered, zeros);
            let reading = read(text.as_bytes()).unwrap_or_else(|told| panic!("{text}\n{told:?}"));
            prop_assert_eq!(reading.warnings, []);
            prop_assert_eq!(reading.markers.names(), &names[..]);
            prop_assert_eq!(reading.markers.rate().unwrap().get(), 120.0);
            prop_assert_eq!(frames(&reading.markers), frames_of.clone(), "{}", text);
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused(
        bytes in prop_oneof![
            vec(any::<u8>(), 0..100),
            "(NO_OF_FRAMES\t[0-9x]\n)?(FREQUENCY\t[0-9]{0,4}\n)?(MARKER_NAMES\ta(\tb)?\n)?(Frame\tTime\n)?([0-9.\\-]{0,3}[\t\n,\"]){0,30}".prop_map(String::into_bytes),
        ],
    ) {
        let source = source_of_bytes("a.tsv", &bytes);
        match read(&bytes) {
            Ok(reading) => {
                prop_assert!(reading.markers.frames().flatten().flatten().all(|p| p.is_finite()));
                prop_assert!(!reading.markers.names().is_empty());
            }
            Err(told) => {
                prop_assert!(told.iter().any(|t| t.severity == Severity::Fault));
                prop_assert!(told.iter().all(|t| !render(t, &source, false).is_empty() && !t.label.is_empty()));
            }
        }
    }
}

#[test]
fn real_recordings_are_read_whole() {
    let Some(folder) = shared("data/mocap/hand_points") else { return };
    let glove = read(&std::fs::read(folder.join("dfki_glove_recording.tsv")).unwrap()).unwrap();
    assert_eq!(glove.warnings, []);
    let glove = glove.markers;
    assert_eq!((glove.names().len(), glove.frames().len(), glove.rate().unwrap().get()), (21, 6000, 100.0));
    assert_eq!(glove.names()[0], "hand_top");
    // The first row: hand_top at the numbers after frame and time.
    let text = std::fs::read_to_string(folder.join("dfki_glove_recording.tsv")).unwrap();
    let row: Vec<&str> = text.lines().nth(12).unwrap().split('\t').collect();
    let number = |i: usize| row[i].parse::<f64>().unwrap();
    assert_eq!(glove.frames().next().unwrap()[0], Some(DVec3::new(number(2), number(3), number(4))));
    let last = glove.find("pillow_right").unwrap();
    let place = DVec3::new(number(62), number(63), number(64));
    assert_eq!(glove.frames().next().unwrap()[last].unwrap_or(DVec3::ZERO), place);

    let hand = read(&std::fs::read(folder.join("dex_human_right_21x3.csv")).unwrap()).unwrap();
    assert_eq!(hand.warnings, []);
    let hand = hand.markers;
    assert_eq!((hand.frames().len(), hand.rate()), (621, None));
    assert_eq!(hand.names(), HAND_POINTS);
    let first = hand.frames().next().unwrap();
    assert_eq!(first[0], Some(DVec3::ZERO));
    assert_eq!(first[1], Some(DVec3::new(0.00978, 0.03104, 0.01965)));
    // Bones of a hand: every point within 25 cm of the wrist.
    assert!(hand.frames().flatten().all(|p| p.unwrap().length() < 0.25));
}

/// `UPDATE=1 cargo test` writes the expectations anew.
#[test]
fn each_mistake_has_its_message() {
    golden::beside("markers", "tsv", 9, |name, bytes| {
        let source = source_of_bytes(name, bytes);
        let told = read(bytes).map_or_else(|told| told, |reading| reading.warnings);
        assert!(!told.is_empty(), "{name}");
        told.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}
