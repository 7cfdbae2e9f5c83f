//! Corpora: how fast segments are indexed and asked for, and motion is searched by example.
//!
//! `cargo bench --bench corpus` prints the times with their ratios, then two tables of cost against size. Long corpora are perturbed copies
//! of short ones: segments with labels drawn from the inventories, and the takes of ../shared with a little noise (without them a made-up
//! wave), one after the other.

use chereme::avatar::SKELETON;
use chereme::corpus::example::{Motion, search};
use chereme::corpus::index::{About, Index};
use chereme::corpus::label::Vocabulary;
use chereme::corpus::query::{Options, Query, parse};
use chereme::corpus::segment::{Component, Segment, Value};
use chereme::diagnostics::Source;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::{HandshapeInventory, Side};
use chereme::time::{Fps, Seconds};
use divan::Bencher;
use std::path::Path;
use std::sync::LazyLock;
use std::time::Instant;

#[allow(dead_code)]
#[path = "../examples/gloss_by_example.rs"]
mod gloss_by_example;

const MANY: usize = 200_000;
/// Frames of an hour at 30 frames a second.
const HOUR: usize = 108_000;
const EXACT: &str = "gloss=gloss-7 hand=right configuration=5|B";
const COMMON: &str = "placement=chest hand=right";
const NEAR: &str = "configuration~5 placement~chest";

static VOCABULARY: LazyLock<Vocabulary> =
    LazyLock::new(|| Vocabulary::builtin(&Skeleton::from_json(SKELETON).unwrap(), None).unwrap());
static SEGMENTS: LazyLock<Vec<Segment>> = LazyLock::new(|| segments(MANY));
static RECORDINGS: LazyLock<Vec<About>> = LazyLock::new(|| (0..MANY / 1000).map(about).collect());
static INDEX: LazyLock<Index> = LazyLock::new(|| Index::build(&RECORDINGS, &SEGMENTS, &VOCABULARY));
static TAKES: LazyLock<Vec<Motion>> = LazyLock::new(takes);

fn about(n: usize) -> About {
    About { name: format!("take {n}"), signer: Some(format!("signer {}", n % 12)), dominant: Some(Side::Right) }
}

/// Numbers that look random and are the same in each run (Steele et al. 2014, SplitMix64).
struct Draw(u64);

impl Draw {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % n as u64) as usize
    }
}

/// Segments of both hands, one sign a second, a thousand a recording, one in twenty values not known.
fn segments(count: usize) -> Vec<Segment> {
    let shapes: Vec<String> = HandshapeInventory::builtin().shapes().iter().map(|s| s.id.clone()).collect();
    let places = ["chest", "forehead", "chin", "cheek", "neutral", "stomach", "nose", "shoulders", "neck", "lips"];
    let sides = ["", " left", " right", " left beside", " right beside"];
    let far = ["", ", touch", ", close"];
    let ways = ["up", "down", "left", "right", "out", "in", "up-left", "up-right", "down-out", "out-left"];
    let mut draw = Draw(5);
    let one = |start: f64, draw: &mut Draw, texts: [String; 4]| {
        texts.map(|label| {
            if draw.below(20) == 0 {
                return Vec::new();
            }
            vec![Value { label, start: Seconds(start), end: Seconds(start + 0.8) }]
        })
    };
    let segment = |i: usize| {
        let start = (i % 1000 / 2) as f64;
        let way = |draw: &mut Draw| ways[draw.below(ways.len())];
        let texts = [
            shapes[draw.below(shapes.len())].clone(),
            format!("{}{}{}", places[draw.below(places.len())], sides[draw.below(5)], far[draw.below(3)]),
            format!("fingers {}, palm {}", way(&mut draw), way(&mut draw)),
            format!("{}{} {}cm", ["", "arc "][draw.below(2)], way(&mut draw), 2 + draw.below(28)),
        ];
        Segment {
            recording: i / 1000,
            side: Some(if i.is_multiple_of(2) { Side::Right } else { Side::Left }),
            start: Seconds(start),
            end: Seconds(start + 0.5 + draw.below(100) as f64 / 100.0),
            gloss: Some(format!("gloss-{}", draw.below(400))),
            values: one(start, &mut draw, texts),
        }
    };
    (0..count).map(segment).collect()
}

fn query(text: &str) -> Query {
    parse(&Source::new("query", text), &VOCABULARY).expect("the queries here are sound").query
}

/// Motion to make long recordings of.
fn takes() -> Vec<Motion> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/mocap/sign_hand_tsl");
    if folder.join("index.tsv").exists() {
        let takes = gloss_by_example::recorded(&folder, &gloss_by_example::options(), |_, number, _| number < 3);
        return takes.into_iter().map(|take| take.motion).collect();
    }
    let wave: Vec<f32> = (0..57 * 600).map(|i| ((i / 57) as f32 * 0.02 * (1 + i % 57) as f32).sin()).collect();
    vec![Motion::new(Fps::new(30.0).unwrap(), 57, &wave).unwrap()]
}

/// So many frames of perturbed copies of the takes.
fn long(frames: usize) -> Motion {
    let mut draw = Draw(7);
    let dims = TAKES[0].dims();
    let mut values = Vec::with_capacity(frames * dims);
    for take in (0..).map(|i| &TAKES[i % TAKES.len()]) {
        for row in 0..take.len() {
            if values.len() == frames * dims {
                return Motion::new(take.fps(), dims, &values).unwrap();
            }
            values.extend(take.row(row).iter().map(|v| v + (draw.below(1001) as f32 - 500.0) * 2e-5));
        }
    }
    unreachable!("the takes never end")
}

/// An example of two seconds.
fn example() -> Motion {
    long(60)
}

/// Least seconds of some runs.
fn least<T>(runs: usize, mut job: impl FnMut() -> T) -> f64 {
    let time = || {
        let begin = Instant::now();
        divan::black_box(job());
        begin.elapsed().as_secs_f64()
    };
    std::iter::repeat_with(time).take(runs).fold(f64::INFINITY, f64::min)
}

/// What [`EXACT`] asks, by reading every segment.
fn scan() -> Vec<usize> {
    let is = |s: &Segment| {
        let shape = |v: &Value| v.label == "5" || v.label == "B";
        s.gloss.as_deref() == Some("gloss-7")
            && s.side == Some(Side::Right)
            && s.of(Component::Configuration).iter().any(shape)
    };
    SEGMENTS.iter().enumerate().filter(|(_, s)| is(s)).map(|(i, _)| i).take(100).collect()
}

fn report() {
    let strict = Options { limit: 100, strict: true };
    let build = least(5, || Index::build(&RECORDINGS, &SEGMENTS, &VOCABULARY));
    println!("index of {MANY} segments: {:.1} ms (aim 100)", build * 1e3);
    let bytes = INDEX.to_bytes();
    let from = least(3, || Index::from_bytes(&bytes, &VOCABULARY).unwrap());
    println!("as bytes: {:.1} MB, read back and indexed in {:.1} ms", bytes.len() as f64 / 1e6, from * 1e3);
    let slow = least(5, scan);
    for text in [EXACT, COMMON] {
        let query = query(text);
        let hits = INDEX.find(&query, &strict).len();
        let quick = least(200, || INDEX.find(&query, &strict));
        println!("{text}: {hits} hits in {:.2} us (aim 20)", quick * 1e6);
        if text == EXACT {
            println!("  reading every segment: {:.0} us, ratio {:.0}", slow * 1e6, slow / quick);
        }
    }
    let near = query(NEAR);
    let ranked = least(20, || INDEX.find(&near, &Options { limit: 20, strict: false }));
    println!("{NEAR}: 20 ranked in {:.2} ms (aim 5)", ranked * 1e3);
    println!(
        "\n{:>8} {:>10} {:>12} {:>14} {:>14}",
        "length", "segments", "index, ms", "near query, ms", "by example, ms"
    );
    for (name, minutes) in [("1 min", 1), ("10 min", 10), ("1 h", 60), ("10 h", 600)] {
        // Two hands, a sign a second.
        let segments = &SEGMENTS[..minutes * 120];
        let build = least(3, || Index::build(&RECORDINGS, segments, &VOCABULARY));
        let index = Index::build(&RECORDINGS, segments, &VOCABULARY);
        let asked = least(5, || index.find(&near, &Options { limit: 20, strict: false }));
        let (example, recording) = (example(), [long(minutes * HOUR / 60)]);
        let found = least(if minutes > 60 { 1 } else { 3 }, || search(&example, &recording, 20).unwrap());
        let count = segments.len();
        println!("{name:>8} {count:>10} {:>12.2} {:>14.3} {:>14.1}", build * 1e3, asked * 1e3, found * 1e3);
    }
}

#[divan::bench(sample_count = 10)]
fn index_200_000_segments() -> Index {
    Index::build(&RECORDINGS, &SEGMENTS, &VOCABULARY)
}

#[divan::bench]
fn exact_query(bencher: Bencher) {
    let query = query(EXACT);
    bencher.bench(|| INDEX.find(&query, &Options { limit: 100, strict: true }));
}

#[divan::bench]
fn near_query(bencher: Bencher) {
    let query = query(NEAR);
    bencher.bench(|| INDEX.find(&query, &Options { limit: 20, strict: false }));
}

#[divan::bench(sample_count = 5)]
fn example_over_an_hour(bencher: Bencher) {
    let (example, recording) = (example(), [long(HOUR)]);
    bencher.bench_local(|| search(&example, &recording, 20).unwrap());
}

fn main() {
    report();
    divan::main();
}
