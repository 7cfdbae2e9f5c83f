//! Published lexica: signs a second read and signed, on one core, and the memory that it takes.
//!
//! `cargo bench --bench hamnosys` reads the SiGML of ../shared/data/lexica (or of the folder in `CHEREME_SHARED`); where that is absent
//! it takes our own LSF signs, written as SiGML. The oracle of the same run is the plain XML reader (`roxmltree`) on the same texts: what
//! reading costs beside it. Against the field's reference engine only its published speed can be set: 600 signs a second
//! read, 40 signed (facts/peers-and-hamnosys.md).

use chereme::diagnostics::Source;
use chereme::notation::formats::{Form, Notation, Words, read_any, write_any};
use chereme::phonology::Sign;
use chereme::synthesis::{Grammar, Options, synthesize};
use chereme::time::Fps;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::Instant;

const ROUNDS: usize = 7;
/// The reference engine: signs a second read and signed.
const REFERENCE: [f64; 2] = [600.0, 40.0];

fn main() {
    let words = Words::default();
    for (name, sources) in lexica(&words) {
        let read = |source: &Source| read_any(black_box(source), Notation::SiGml, &words, "");
        let signs: Vec<Sign> = sources.iter().flat_map(|s| read(s).signs).map(|s| s.sign).collect();
        let reading = best(|| sources.iter().for_each(|s| drop(black_box(read(s)))));
        let parsing =
            best(|| sources.iter().for_each(|s| drop(black_box(roxmltree::Document::parse(black_box(&s.text))))));
        let each = |seconds: f64| signs.len() as f64 / seconds;
        println!("{name}: {} signs of {} files", signs.len(), sources.len());
        println!(
            "  read      {:8.0} signs/s, {:.1} µs a sign, {:.2} times the XML alone, {:.0} times the reference engine",
            each(reading),
            reading / signs.len() as f64 * 1e6,
            reading / parsing,
            each(reading) / REFERENCE[0]
        );
        let (grammar, signer) = (Grammar::builtin(), chereme::avatar::signer().expect("the avatar"));
        let options = Options { fps: Fps::new(30.0).expect("a rate"), ..Options::default() };
        let before = resident();
        let mut frames = 0;
        let signing = best(|| {
            frames = 0;
            for sign in &signs {
                let performance = black_box(synthesize(black_box(sign), &grammar, &signer, &options));
                frames += performance.map_or(0, |p| p.track.clip.frames().len());
            }
        });
        println!(
            "  signed    {:8.0} signs/s at 30 fps, {:.2} ms a sign, {:.1} µs a frame, {:.0} times the reference engine",
            each(signing),
            signing / signs.len() as f64 * 1e3,
            signing / frames as f64 * 1e6,
            each(signing) / REFERENCE[1]
        );
        println!("  memory    {:.1} MB more after {ROUNDS} rounds than before", (resident() - before) / 1e6);
    }
}

/// The SiGML lexica that are there, by name.
fn lexica(words: &Words) -> Vec<(String, Vec<Source>)> {
    let shared = std::env::var_os("CHEREME_SHARED").map_or_else(|| PathBuf::from("../shared"), PathBuf::from);
    let of = |name: &str| {
        let mut paths: Vec<PathBuf> = std::fs::read_dir(shared.join("data/lexica").join(name))
            .ok()?
            .filter_map(|e| Some(e.ok()?.path()))
            .collect();
        paths.retain(|path| path.extension().is_some_and(|e| e == "sigml"));
        paths.sort();
        let source =
            |path: PathBuf| Some(Source::new(path.display().to_string(), std::fs::read_to_string(&path).ok()?));
        Some((name.to_owned(), paths.into_iter().filter_map(source).collect()))
    };
    let found: Vec<(String, Vec<Source>)> = ["ngt", "isl"].into_iter().filter_map(of).collect();
    if !found.is_empty() {
        return found;
    }
    let lexicon = chereme::notation::Lexicon::builtin();
    let written: Vec<Source> = lexicon
        .entries()
        .map(|entry| write_any(&[&entry.sign], Form::SiGml, words).text)
        .filter(|text| !text.is_empty())
        .map(|text| Source::new("own.sigml", text))
        .collect();
    vec![("our own signs (../shared is absent)".to_owned(), written)]
}

/// The least time of several rounds, seconds.
fn best(mut job: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let begin = Instant::now();
        job();
        least = least.min(begin.elapsed().as_secs_f64());
    }
    least
}

/// The memory that this process holds, bytes; 0 where the system does not tell.
fn resident() -> f64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    text.split_whitespace().nth(1).and_then(|pages| pages.parse::<f64>().ok()).unwrap_or(0.0) * 4096.0
}
