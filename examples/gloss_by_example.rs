//! How well a take's gloss is found by example: every take of a folder against all others, whole motion on whole motion.
//!
//! `cargo run --release --example gloss_by_example -- ../shared/data/mocap/sign_hand_tsl [shape orientation place movement]`
//!
//! The folder has BVH files of single hands and an `index.tsv` with the columns file, gloss, take and hand. Takes are in
//! millimetres, in the space of a sensor that did not move.

use chereme::corpus::example::features::{Options, Reference, features_of};
use chereme::corpus::example::neighbours::{Guess, Take, leave_one_out};
use chereme::format::bvh::{ClipOptions, read, to_clip};
use chereme::phonology::Side;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// The features of the takes here: places in the sensor's space.
pub fn options() -> Options {
    Options { reference: Reference::Space, ..Options::default() }
}

/// Frames farther than this part of a take from their own place are not laid on each other.
pub const BAND: f64 = 0.25;

/// The takes of a folder that `wanted` (gloss, number among the rows of its gloss, hand) picks.
pub fn takes(folder: &Path, options: &Options, wanted: impl Fn(&str, usize, Side) -> bool) -> Vec<Take> {
    let table = std::fs::read_to_string(folder.join("index.tsv")).expect("the folder has an index.tsv");
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found = Vec::new();
    for row in table.lines().skip(1).map(|line| line.split('\t').collect::<Vec<_>>()) {
        let [file, gloss, take, hand, ..] = row[..] else { continue };
        let number = counts.entry(gloss).or_default();
        *number += 1;
        let side = if hand == "left" { Side::Left } else { Side::Right };
        if !wanted(gloss, *number - 1, side) {
            continue;
        }
        let bytes = std::fs::read(folder.join(file)).expect("the files of the index are there");
        let bvh = read(&bytes).unwrap_or_else(|faults| panic!("{file}: {}", faults[0].message)).bvh;
        let unit = ClipOptions { metres_per_unit: 0.001, ..ClipOptions::default() };
        let clip = to_clip(&bvh, &unit).unwrap_or_else(|error| panic!("{file}: {error}")).clip;
        let motion = features_of(&clip, &[side], options).unwrap_or_else(|error| panic!("{file}: {error}"));
        found.push(Take { gloss: gloss.to_owned(), group: format!("{gloss} {take}"), motion });
    }
    found
}

/// The share of takes whose gloss is among the first `n`.
pub fn share(guesses: &[Guess], n: usize) -> f64 {
    guesses.iter().filter(|guess| guess.place.is_some_and(|place| place < n)).count() as f64 / guesses.len() as f64
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((folder, weights)) = arguments.split_first() else {
        eprintln!("which folder?");
        std::process::exit(2);
    };
    let mut options = options();
    let weights: Vec<f64> = weights.iter().map(|w| w.parse().expect("a weight is a number")).collect();
    if let [configuration, orientation, placement, movement] = weights[..] {
        options = Options { configuration, orientation, placement, movement, ..options };
    }
    let begin = Instant::now();
    let takes = takes(Path::new(folder), &options, |_, _, _| true);
    let read = begin.elapsed().as_secs_f64();
    let guesses = leave_one_out(&takes, BAND);
    println!("{} takes read in {read:.1} s, compared in {:.1} s", takes.len(), begin.elapsed().as_secs_f64() - read);
    let shares = |guesses: &[Guess]| [1, 5].map(|n| format!("top-{n} {:.1} %", 100.0 * share(guesses, n))).join(", ");
    println!("all hands: {}", shares(&guesses));
    // A left hand of this set is the weak one of a sign of two hands; there are few of each.
    let right = self::takes(Path::new(folder), &options, |_, _, side| side == Side::Right);
    println!("{} right hands among themselves: {}", right.len(), shares(&leave_one_out(&right, BAND)));
    let mut glosses: BTreeMap<&str, (usize, usize, BTreeMap<&str, usize>)> = BTreeMap::new();
    for (take, guess) in takes.iter().zip(&guesses) {
        let (all, right, others) = glosses.entry(&take.gloss).or_default();
        *all += 1;
        match (guess.place, guess.ranked.first()) {
            (Some(0), _) => *right += 1,
            (_, Some((first, _))) => *others.entry(first).or_default() += 1,
            (_, None) => {}
        }
    }
    let mut worst: Vec<_> = glosses.into_iter().collect();
    worst.sort_by(|a, b| (a.1.1 * b.1.0).cmp(&(b.1.1 * a.1.0)).then(a.0.cmp(b.0)));
    for (gloss, (all, right, others)) in worst.iter().take(10) {
        let taken = others.iter().map(|(other, n)| format!("{other} {n}")).collect::<Vec<_>>().join(", ");
        println!("{gloss:<14} {right:3} of {all:3}  taken for {taken}");
    }
}
