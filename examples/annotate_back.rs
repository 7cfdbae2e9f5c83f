//! Annotates synthesized signs and tells how much of their descriptions comes back.
//!
//! `cargo run --release --example annotate_back [FOLDER|lexicon|sign names] [--every N] [--top N]` prints a table of shares per component,
//! strict and loose, with and without what the synthesis itself could not do, then the most frequent confusions.

use chereme::avatar;
use chereme::corpus::annotate::{self, Annotator, Coverage};
use chereme::diagnostics::{Error, Source};
use chereme::evaluation::annotation::{Judged, Tally, judge};
use chereme::notation::Lexicon;
use chereme::notation::formats::{Notation, Words, read_any};
use chereme::phonology::Sign;
use chereme::synthesis::{Grammar, Options, synthesize};
use std::time::Instant;

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args().skip(1);
    let (mut what, mut every, mut top, mut only) = ("lexicon".to_owned(), 1, 12, None);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--every" => every = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1),
            "--top" => top = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(12),
            "--only" => only = arguments.next(),
            _ => what = argument,
        }
    }
    let grammar = Grammar::builtin();
    let signs: Vec<Sign> = signs(&what, &grammar)?
        .into_iter()
        .step_by(every)
        .filter(|s| only.as_ref().is_none_or(|o| s.name == *o))
        .collect();
    let signer = avatar::signer()?;
    let annotator = Annotator::new(&signer, &grammar.handshapes, &grammar.locations);
    let (mut tally, mut refused, mut motion, mut spent) = (Tally::default(), 0, 0.0, 0.0);
    for sign in &signs {
        let Ok(performance) = synthesize(sign, &grammar, &signer, &Options::default()) else {
            refused += 1;
            continue;
        };
        let clip = &performance.track.clip;
        let began = Instant::now();
        let annotation = annotator.annotate(clip, Coverage::WHOLE, &annotate::Options::default());
        spent += began.elapsed().as_secs_f64();
        motion += clip.duration().0;
        let judged = judge(sign, &performance, &annotation, &annotator, &grammar, &signer);
        if only.is_some() {
            for (whose, tiers) in [("described", &performance.track.tiers), ("measured", &annotation.tiers())] {
                for tier in tiers.iter() {
                    for v in tier.values() {
                        println!(
                            "{whose:10} {:16} {:5.2} {:5.2}  {}  ({})",
                            tier.name, v.start.0, v.end.0, v.label, v.source
                        );
                    }
                }
            }
            println!("keys {:?}", performance.report.keys);
        }
        tally.add(&judged);
        if std::env::var("SHOW").is_ok() {
            for j in judged.iter().filter(|j| !j.strict) {
                println!(
                    "{:20} {:14} {} -> {}{}",
                    sign.name,
                    j.judged.name(),
                    j.described,
                    j.measured,
                    if j.excepted { " (excepted)" } else { "" }
                );
            }
        }
    }
    println!(
        "{} signs, {refused} refused; {motion:.0} s of motion, {:.0} times as fast as it is signed",
        signs.len(),
        motion / spent
    );
    print(&tally, top);
    Ok(())
}

fn print(tally: &Tally, top: usize) {
    println!(
        "{:14} {:>6} {:>8} {:>8}   {:>6} {:>8} {:>8}",
        "component", "values", "strict", "loose", "exc.", "strict", "loose"
    );
    for judged in Judged::ALL {
        let (with, without) = (tally.share(judged, true), tally.share(judged, false));
        println!(
            "{:14} {:6} {:7.1}% {:7.1}%   {:6} {:7.1}% {:7.1}%",
            judged.name(),
            with.all,
            100.0 * with.strict(),
            100.0 * with.loose(),
            with.all - without.all,
            100.0 * without.strict(),
            100.0 * without.loose()
        );
    }
    for judged in Judged::ALL {
        for c in tally.confusions(judged).iter().take(top) {
            println!("{:14} {:4}  {} -> {}", judged.name(), c.count, c.described, c.measured);
        }
    }
}

/// The signs of a folder, or those of the lexicon.
fn signs(what: &str, grammar: &Grammar) -> Result<Vec<Sign>, Error> {
    if what == "lexicon" {
        return Ok(Lexicon::builtin().entries().map(|entry| entry.sign.clone()).collect());
    }
    let words = Words::of(&grammar.handshapes, &grammar.locations, &grammar.expressions);
    let told = |e: std::io::Error| Error::new(format!("{what}: {e}"));
    let mut paths: Vec<_> =
        std::fs::read_dir(what).map_err(told)?.map(|e| e.map(|e| e.path())).collect::<Result<_, _>>().map_err(told)?;
    paths.sort();
    let mut all = Vec::new();
    for path in paths {
        let name = path.display().to_string();
        let (Some(notation), Ok(text)) = (Notation::of_extension(&name), std::fs::read_to_string(&path)) else {
            continue;
        };
        all.extend(read_any(&Source::new(name, text), notation, &words, "").signs.into_iter().map(|read| read.sign));
    }
    Ok(all)
}
