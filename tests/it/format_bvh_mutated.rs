//! Odd BVH files with something changed in them: read right or refused, never wrong.

use crate::format_bvh::{agrees_with_bvh_anim, can_be_compared, files};
use crate::shared::shared;
use chereme::diagnostics::Severity;
use chereme::format::bvh::{self, Bvh};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::panic::catch_unwind;

/// Something that goes wrong with a file; places are parts of its length or of the count of its lines.
#[derive(Debug, Clone)]
enum Mutation {
    Byte(f64, u8),
    /// The next digit becomes another, or a sign, a point or a blank.
    Digit(f64, u8),
    WithoutLine(f64),
    LineTwice(f64),
    LinesExchanged(f64),
    CutOff(f64),
    /// Another number after one of these words.
    Count(&'static str, f64, &'static str),
    /// A word of a line becomes another.
    Word(f64, f64, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    // Half of all places are near the beginning, where the hierarchy is.
    let place = || prop_oneof![0.0..1.0f64, 0.0..0.1f64];
    let count = prop_oneof![Just("Frames:"), Just("CHANNELS"), Just("OFFSET"), Just("Time:")];
    let numbers = vec!["0", "1", "3", "6", "-1", "2.5", "9999999999999999999", "nan", "1e999", "x", ""];
    let words = vec![
        "nan", "1e400", "-", "{", "}", "0x10", "1,5", "JOINT", "End Site", "MOTION", "1_0", "--1", "7.", ".5", "1e2",
    ];
    prop_oneof![
        1 => (place(), any::<u8>()).prop_map(|(at, byte)| Mutation::Byte(at, byte)),
        6 => (place(), prop_oneof![4 => "[0-9]", 1 => "[ .\n-]"]).prop_map(|(at, c)| Mutation::Digit(at, c.as_bytes()[0])),
        1 => place().prop_map(Mutation::WithoutLine),
        1 => place().prop_map(Mutation::LineTwice),
        1 => place().prop_map(Mutation::LinesExchanged),
        1 => place().prop_map(Mutation::CutOff),
        1 => (count, place(), prop::sample::select(numbers))
            .prop_map(|(word, at, number)| Mutation::Count(word, at, number)),
        1 => (place(), 0.0..1.0f64, prop::sample::select(words)).prop_map(|(at, word, with)| Mutation::Word(at, word, with)),
    ]
}

fn part(of: usize, at: f64) -> usize {
    ((of as f64 * at) as usize).min(of.saturating_sub(1))
}

fn mutated(bytes: &[u8], mutation: &Mutation) -> Vec<u8> {
    let mut lines: Vec<Vec<u8>> = bytes.split_inclusive(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
    let line = |at: f64| part(lines.len(), at);
    match *mutation {
        Mutation::Byte(at, byte) => {
            let at = part(bytes.len(), at);
            let mut bytes = bytes.to_vec();
            bytes[at] = byte;
            return bytes;
        }
        Mutation::Digit(at, byte) => {
            let at = part(bytes.len(), at);
            let mut bytes = bytes.to_vec();
            if let Some(digit) = bytes[at..].iter_mut().find(|b| b.is_ascii_digit()) {
                *digit = byte;
            }
            return bytes;
        }
        Mutation::CutOff(at) => return bytes[..part(bytes.len(), at)].to_vec(),
        Mutation::WithoutLine(at) => drop(lines.remove(line(at))),
        Mutation::LineTwice(at) => {
            let at = line(at);
            lines.insert(at, lines[at].clone());
        }
        Mutation::LinesExchanged(at) => {
            let at = line(at);
            let next = (at + 1).min(lines.len() - 1);
            lines.swap(at, next);
        }
        Mutation::Count(word, at, number) => {
            let has = |line: &Vec<u8>| String::from_utf8_lossy(line).contains(word);
            let places: Vec<usize> = (0..lines.len()).filter(|&i| has(&lines[i])).collect();
            if let Some(&i) = places.get(part(places.len(), at)) {
                let text = String::from_utf8_lossy(&lines[i]).into_owned();
                let (before, after) = text.split_once(word).unwrap();
                let rest = after.trim_start().split_once(' ').map_or("\n", |(_, rest)| rest);
                lines[i] = format!("{before}{word} {number} {rest}").into_bytes();
            }
        }
        Mutation::Word(at, word, with) => {
            let at = line(at);
            let text = String::from_utf8_lossy(&lines[at]).into_owned();
            let words: Vec<&str> = text.split_whitespace().collect();
            if let Some(found) = words.get(part(words.len(), word)) {
                lines[at] = text.replacen(found, with, 1).into_bytes();
            }
        }
    }
    lines.concat()
}

/// What came of a mutated file.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord, Clone, Copy)]
enum Outcome {
    Refused,
    /// It says the same as before.
    Same,
    /// `bvh_anim` reads the same.
    Agreed,
    /// Nobody can be asked; it keeps its promises, and comes back from what is printed of it.
    Sound,
}

fn judge(name: &str, original: Option<&Bvh>, bytes: &[u8]) -> Outcome {
    let reading = match bvh::read(bytes) {
        Ok(reading) => reading,
        Err(told) => {
            assert!(told.iter().any(|t| t.severity == Severity::Fault && !t.label.is_empty()), "{name}");
            return Outcome::Refused;
        }
    };
    let ours = &reading.bvh;
    let values = || ours.rows().flatten().copied();
    assert!(Bvh::new(ours.joints().to_vec(), ours.frame_time(), values().collect()).as_ref() == Ok(ours), "{name}");
    let text = bvh::print(ours);
    let again = bvh::read(text.as_bytes()).unwrap_or_else(|told| panic!("{name}: {told:?}"));
    assert!(bvh::print(&again.bvh) == text, "{name}: what is printed reads as something else");
    if original == Some(ours) {
        return Outcome::Same;
    }
    // Its names end at a blank; its numbers have 32 bits, and its times nanoseconds.
    let fit = ours.joints().iter().all(|joint| !joint.name.contains(char::is_whitespace))
        && values().all(|v| v.abs() < 1e30)
        && (1e-8..1e6).contains(&ours.frame_time().0);
    if !(can_be_compared(&reading) && fit) {
        return Outcome::Sound;
    }
    match catch_unwind(|| bvh_anim::from_bytes(bytes).is_ok()) {
        Ok(true) => {
            agrees_with_bvh_anim(name, bytes, ours);
            Outcome::Agreed
        }
        _ => Outcome::Sound,
    }
}

#[test]
fn changed_odd_files_are_read_right_or_refused() {
    let Some(folder) = shared("data/mocap/bvh_oddities") else { return };
    let all: Vec<(String, Vec<u8>)> = files(&folder)
        .iter()
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(path).unwrap()))
        // One file of each oddity is enough of the large ones.
        .filter(|(_, bytes)| bytes.len() < 100_000)
        .collect();
    assert!(all.len() >= 13, "{} files", all.len());
    let rounds = if std::env::var("CI").as_deref() == Ok("true") { 120 } else { 40 };
    let mut runner = TestRunner::deterministic();
    let mut counts = std::collections::BTreeMap::new();
    for (name, bytes) in &all {
        let original = bvh::read(bytes).ok().map(|reading| reading.bvh);
        for _ in 0..rounds {
            let mutations = vec(mutation(), 1..3).new_tree(&mut runner).unwrap().current();
            let changed =
                mutations.iter().fold(
                    bytes.clone(),
                    |bytes, mutation| {
                        if bytes.is_empty() { bytes } else { mutated(&bytes, mutation) }
                    },
                );
            let outcome = judge(&format!("{name} with {mutations:?}"), original.as_ref(), &changed);
            *counts.entry(outcome).or_insert(0) += 1;
        }
    }
    println!("{counts:?}");
    let count = |outcome| counts.get(&outcome).copied().unwrap_or(0);
    assert!(count(Outcome::Refused) > 50 && count(Outcome::Agreed) > 10 && count(Outcome::Same) > 10, "{counts:?}");
}
