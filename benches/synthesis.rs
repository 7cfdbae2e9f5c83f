//! A sign, from its parsed description to a clip of 60 frames a second; and the whole program, start to end.
//!
//! `cargo bench --bench synthesis`. Beside each sign stands the time a frame; the program's line is the best of
//! many runs of `render`, the process included. Machines are shared: read the ratios and the fastest column.

use chereme::notation::Lexicon;
use chereme::phonology::Sign;
use chereme::synthesis::{Grammar, Options, synthesize};
use divan::{Bencher, black_box};
use std::process::Command;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

static GRAMMAR: LazyLock<Grammar> = LazyLock::new(Grammar::builtin);
static SIGNER: LazyLock<chereme::body::signer::Signer> = LazyLock::new(|| chereme::avatar::signer().unwrap());

static LEXICON: LazyLock<Lexicon> = LazyLock::new(Lexicon::builtin);

const SIGNS: [&str; 4] = ["PENSER", "BOL", "ESCARGOT", "DODO"];

fn sign(name: &str) -> &'static Sign {
    &LEXICON.find(name, Some("lsf")).expect("a sign of the lexicon").sign
}

#[divan::bench(args = ["PENSER", "BOL", "ESCARGOT", "DODO"])]
fn sign_to_clip(bencher: Bencher, name: &str) {
    let sign = sign(name);
    let clip = || synthesize(black_box(sign), &GRAMMAR, &SIGNER, &Options::default()).unwrap();
    bencher.bench_local(clip);
}

/// The best of many, so that a busy machine says little.
fn best(rounds: usize, mut work: impl FnMut()) -> Duration {
    let one = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..rounds).map(|_| one(&mut work)).min().unwrap_or_default()
}

fn main() {
    for name in SIGNS {
        let sign = sign(name);
        let frames = synthesize(sign, &GRAMMAR, &SIGNER, &Options::default()).unwrap().track.clip.frames().len();
        let time = best(400, || {
            black_box(synthesize(black_box(sign), &GRAMMAR, &SIGNER, &Options::default()).unwrap());
        });
        let (whole, frame) = (time.as_secs_f64() * 1e3, time.as_secs_f64() * 1e6 / frames as f64);
        println!("{name}: {whole:.3} ms a sign, {frames} frames, {frame:.2} µs a frame");
    }
    let all: Vec<&Sign> = LEXICON.entries().filter(|e| e.sign.language == "lsf").map(|e| &e.sign).collect();
    let time = best(10, || {
        for sign in &all {
            black_box(synthesize(black_box(sign), &GRAMMAR, &SIGNER, &Options::default()).unwrap());
        }
    });
    let (clips, each) = (all.len() as f64 / time.as_secs_f64(), time.as_secs_f64() * 1e3 / all.len() as f64);
    println!(
        "lexicon/lsf, {} signs and letters: {clips:.0} clips a second, {each:.2} ms a sign, on one core",
        all.len()
    );
    let out = std::env::temp_dir().join(format!("chereme-bench-{}.glb", std::process::id()));
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chereme"));
        command.args(arguments).arg(&out).stderr(std::process::Stdio::null());
        best(20, || assert!(command.status().is_ok_and(|s| s.success())))
    };
    let render = run(&["render", "--quiet", "--force", "lexicon/lsf/bol.sign", "-o"]);
    println!("chereme render lexicon/lsf/bol.sign -o bol.glb, the whole process: {:.1} ms", render.as_secs_f64() * 1e3);
    let _ = std::fs::remove_file(out);
    divan::main();
}
