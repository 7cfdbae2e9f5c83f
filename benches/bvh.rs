//! Reading and writing BVH against `bvh_anim`, on the same text in the same run.
//!
//! `cargo bench --bench bvh` prints megabytes of text a second and ratios (the best of several rounds, taken in turn in
//! one process, because machines are shared), then divan's table. The text is the sign BOL many times over.

use chereme::format::bvh::{self, Bvh, Options};
use chereme::notation::{Vocabulary, read};
use chereme::synthesis::{Grammar, Options as Signing, synthesize};
use divan::counter::BytesCount;
use divan::{Bencher, black_box};
use std::sync::LazyLock;
use std::time::Instant;

const ROUNDS: usize = 9;
const BYTES: usize = 20_000_000;

static DATA: LazyLock<Bvh> = LazyLock::new(|| {
    let sign = read(include_str!("../lexicon/lsf/bol.sign"), &Vocabulary::builtin(), "lsf").signs.remove(0).sign;
    let signer = chereme::avatar::signer().unwrap();
    let clip = synthesize(&sign, &Grammar::builtin(), &signer, &Signing::default()).unwrap().track.clip;
    let once = bvh::from_clip(&clip, &Options::default()).unwrap();
    let times = BYTES / bvh::print(&once).len() + 1;
    let rows: Vec<f64> = once.rows().flatten().copied().collect();
    Bvh::new(once.joints().to_vec(), once.frame_time(), rows.repeat(times)).unwrap()
});
static TEXT: LazyLock<String> = LazyLock::new(|| bvh::print(&DATA));
static THEIRS: LazyLock<bvh_anim::Bvh> = LazyLock::new(|| bvh_anim::from_bytes(TEXT.as_bytes()).unwrap());

fn read_ours() -> usize {
    black_box(bvh::read(black_box(TEXT.as_bytes())).unwrap());
    TEXT.len()
}

fn read_theirs() -> usize {
    black_box(bvh_anim::from_bytes(black_box(TEXT.as_bytes())).unwrap());
    TEXT.len()
}

fn write_ours() -> usize {
    black_box(bvh::print(black_box(&DATA))).len()
}

/// Two decimals a number, so fewer bytes.
fn write_theirs() -> usize {
    let mut out = Vec::new();
    black_box(&*THEIRS).write_to(&mut out).unwrap();
    black_box(out).len()
}

/// A job's least time, seconds, and the bytes of text it read or wrote, over rounds taken in turn.
fn least(jobs: [fn() -> usize; 4]) -> [(f64, usize); 4] {
    let mut least = [(f64::INFINITY, 0); 4];
    for _ in 0..ROUNDS {
        for (job, least) in jobs.iter().zip(&mut least) {
            let begin = Instant::now();
            let bytes = job();
            *least = (least.0.min(begin.elapsed().as_secs_f64()), bytes);
        }
    }
    least
}

fn report() {
    let (frames, channels) = (DATA.rows().len(), DATA.channel_count());
    println!("{:.1} MB, {frames} frames of {channels} channels", TEXT.len() as f64 / 1e6);
    let _ = LazyLock::force(&THEIRS);
    let times = least([read_ours, read_theirs, write_ours, write_theirs]);
    let numbers = (frames * channels) as f64;
    for ((seconds, bytes), what) in
        times.iter().zip(["chereme read", "bvh_anim read", "chereme write", "bvh_anim write"])
    {
        let (speed, each) = (*bytes as f64 / 1e6 / seconds, seconds * 1e9 / numbers);
        println!("{what:<15} {speed:7.0} MB/s {each:7.1} ns a number");
    }
    println!(
        "ratio: reading {:.2} times bvh_anim, writing {:.2} (in numbers a second)",
        times[1].0 / times[0].0,
        times[3].0 / times[2].0
    );
}

#[divan::bench]
fn reading(bencher: Bencher) {
    bencher.counter(BytesCount::new(TEXT.len())).bench_local(read_ours);
}

#[divan::bench]
fn printing(bencher: Bencher) {
    bencher.counter(BytesCount::new(TEXT.len())).bench_local(write_ours);
}

fn main() {
    report();
    divan::main();
}
