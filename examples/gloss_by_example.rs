//! How well a take's gloss is found by example: every take of a folder against all others, whole motion on whole motion.
//!
//! `cargo run --release --example gloss_by_example -- ../shared/data/mocap/sign_hand_tsl`
//!
//! The folder has BVH files of single hands and an `index.tsv` with the columns file, gloss, take and hand. Takes are in
//! millimetres, in the space of a sensor that did not move. Three takes in a row (0–2, 3–5, ...) are of one session: by far most takes have their
//! nearest of the same gloss there. Settings were chosen on every other session alone; the rest is the test.

use chereme::corpus::example::Motion;
use chereme::corpus::example::components::Components;
use chereme::corpus::example::features::{Options, Reference, features_of};
use chereme::corpus::example::neighbours::{Guess, Take, leave_one_group_out, leave_one_out};
use chereme::format::bvh::{ClipOptions, read, to_clip};
use chereme::phonology::Side;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// The features of the takes here: places in the sensor's space.
pub fn options() -> Options {
    Options { reference: Reference::Space, ..Options::default() }
}

/// A file of the folder.
pub struct Recorded {
    /// The gloss of the index.
    pub gloss: String,
    /// The number of the performance.
    pub take: usize,
    /// Whose hand it is.
    pub side: Side,
    /// Its features.
    pub motion: Motion,
}

impl Recorded {
    /// For comparison with others.
    pub fn as_take(&self) -> Take {
        Take {
            gloss: self.gloss.clone(),
            group: format!("{} {}", self.gloss, self.take),
            side: self.side,
            components: Components::of(&self.motion).expect("features are those of a hand"),
        }
    }

    /// Whether it is of the sessions on which settings were chosen.
    fn is_for_choosing(&self) -> bool {
        (self.take / 3).is_multiple_of(2)
    }
}

/// The files of a folder that `wanted` (gloss, number among the rows of its gloss, hand) picks.
pub fn recorded(folder: &Path, options: &Options, wanted: impl Fn(&str, usize, Side) -> bool) -> Vec<Recorded> {
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
        let take = take.parse().expect("takes are numbers");
        found.push(Recorded { gloss: gloss.to_owned(), take, side, motion });
    }
    found
}

/// The share of takes whose gloss is among the first `n`.
pub fn share(guesses: &[Guess], n: usize) -> f64 {
    guesses.iter().filter(|guess| guess.place.is_some_and(|place| place < n)).count() as f64 / guesses.len() as f64
}

fn print_shares(name: &str, guesses: &[Guess]) {
    let shares = [1, 5].map(|n| format!("top-{n} {:.1} %", 100.0 * share(guesses, n))).join(", ");
    println!("{name:<44} {:4}: {shares}", guesses.len());
}

/// Leave-one-out within a choice of files, hand by hand and performance by performance.
fn measure(name: &str, files: &[Recorded], wanted: impl Fn(&Recorded) -> bool) {
    let takes: Vec<Take> = files.iter().filter(|file| wanted(file)).map(Recorded::as_take).collect();
    print_shares(&format!("{name}, a hand"), &leave_one_out(&takes));
    print_shares(&format!("{name}, a performance"), &leave_one_group_out(&takes));
}

fn main() {
    let Some(folder) = std::env::args().nth(1) else {
        eprintln!("which folder?");
        std::process::exit(2);
    };
    let begin = Instant::now();
    let files = recorded(Path::new(&folder), &options(), |_, _, _| true);
    println!("{} files read in {:.1} s", files.len(), begin.elapsed().as_secs_f64());
    measure("sessions on which settings were chosen", &files, Recorded::is_for_choosing);
    measure("the other sessions", &files, |file| !file.is_for_choosing());
    let takes: Vec<Take> = files.iter().map(Recorded::as_take).collect();
    let begin = Instant::now();
    let guesses = leave_one_out(&takes);
    let time = begin.elapsed().as_secs_f64();
    print_shares("all, a hand", &guesses);
    for (name, side) in [("right", Side::Right), ("left", Side::Left)] {
        let of_side = guesses.iter().zip(&takes).filter(|(_, take)| take.side == side).map(|(guess, _)| guess.clone());
        print_shares(&format!("  of them {name} hands"), &of_side.collect::<Vec<_>>());
    }
    print_shares("all, a performance", &leave_one_group_out(&takes));
    // How much of it is the rest of the same session? Glosses of a session from all other sessions alone.
    let grouped: Vec<Take> =
        files.iter().map(|file| Take { group: format!("session {}", file.take / 3), ..file.as_take() }).collect();
    print_shares("all, a hand, own session left out", &leave_one_out(&grouped));
    println!("all compared in {time:.1} s");
    print_worst(&guesses);
}

/// The glosses that are found least, and what they are taken for.
fn print_worst(guesses: &[Guess]) {
    let mut glosses: BTreeMap<&str, (usize, usize, BTreeMap<&str, usize>)> = BTreeMap::new();
    for guess in guesses {
        let (all, right, others) = glosses.entry(&guess.gloss).or_default();
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
