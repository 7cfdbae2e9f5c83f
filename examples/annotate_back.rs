//! Annotates synthesized signs and tells how much of their descriptions comes back.
//!
//! `cargo run --release --example annotate_back [lexicon|FOLDER] [--every N] [--top N] [--wrong] [--only NAME] [--fps N]
//! [--noise DEGREES]` prints a table of shares per component, strict and loose, with and without what the synthesis itself could not
//! do, then the most frequent confusions; `--wrong` every value that is not strictly right, `--only` one sign with all tiers, described
//! and measured; `--noise` turns every joint of every frame at random by so much, as recordings do.

use chereme::avatar;
use chereme::corpus::annotate::{self, Annotator, Coverage};
use chereme::diagnostics::{Error, Source};
use chereme::evaluation::annotation::{Judged, Tally, judge, six_places};
use chereme::motion::clip::Clip;
use chereme::notation::Lexicon;
use chereme::notation::formats::{Notation, Words, read_any};
use chereme::phonology::Sign;
use chereme::synthesis::{Grammar, Options, synthesize};
use chereme::tier::Tier;
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use std::time::Instant;

/// What the command line asks for.
struct Asked {
    what: String,
    every: usize,
    top: usize,
    wrong: bool,
    only: Option<String>,
    fps: f64,
    noise: f64,
}

impl Asked {
    fn read() -> Asked {
        let mut asked =
            Asked { what: "lexicon".to_owned(), every: 1, top: 12, wrong: false, only: None, fps: 60.0, noise: 0.0 };
        let mut arguments = std::env::args().skip(1);
        let number = |text: Option<String>| text.and_then(|n| n.parse().ok());
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--every" => asked.every = number(arguments.next()).unwrap_or(1).max(1),
                "--top" => asked.top = number(arguments.next()).unwrap_or(12),
                "--wrong" => asked.wrong = true,
                "--fps" => asked.fps = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(60.0),
                "--noise" => asked.noise = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(0.0),
                "--only" => asked.only = arguments.next(),
                _ => asked.what = argument,
            }
        }
        asked
    }
}

fn main() -> Result<(), Error> {
    let asked = Asked::read();
    let (grammar, signer) = (Grammar::builtin(), avatar::signer()?);
    let named = |sign: &Sign| asked.only.as_ref().is_none_or(|only| sign.name == *only);
    let signs: Vec<Sign> = signs(&asked.what, &grammar)?.into_iter().step_by(asked.every).filter(named).collect();
    let annotator = Annotator::new(&signer, &grammar.handshapes, &grammar.locations);
    let (mut tally, mut refused, mut motion, mut spent) = (Tally::default(), 0, 0.0, 0.0);
    let fps = Fps::new(asked.fps).ok_or_else(|| Error::new("the frame rate is no number of frames"))?;
    for sign in &signs {
        let Ok(performance) = synthesize(sign, &grammar, &signer, &Options { fps, ..Options::default() }) else {
            refused += 1;
            continue;
        };
        let clip = &shaken(&performance.track.clip, asked.noise);
        let began = Instant::now();
        let annotation = annotator.annotate(clip, Coverage::WHOLE, &annotate::Options::default());
        spent += began.elapsed().as_secs_f64();
        motion += clip.duration().0;
        let judged = judge(sign, &performance, &annotation, &annotator, &grammar, &signer);
        if asked.only.is_some() {
            show("described", &performance.track.tiers);
            show("measured", &annotation.tiers());
        }
        for j in judged.iter().filter(|j| asked.wrong && !j.strict) {
            let why = if j.excepted { " (excepted)" } else { "" };
            println!("{:20} {:14} {} -> {}{why}", sign.name, j.judged.name(), j.described, j.measured);
        }
        tally.add(&judged);
    }
    let times = motion / spent;
    println!(
        "{} signs, {refused} refused; {motion:.0} s of motion, {times:.0} times as fast as it is signed",
        signs.len()
    );
    print(&tally, asked.top);
    if let Ok(bol) = Lexicon::builtin().find("BOL", Some("lsf")) {
        let right = six_places(&bol.sign, &annotator, &grammar, &signer)?;
        let right = right.iter().zip(chereme::evaluation::annotation::SIX_PLACES).filter(|(a, b)| **a == Some(*b));
        println!("BOL at six places: {} named from the motion", right.count());
    }
    Ok(())
}

/// A clip with every joint turned about a random axis in every frame, evenly up to so many degrees about each axis.
fn shaken(clip: &Clip, degrees: f64) -> Clip {
    let mut seed = 1u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) as f64 / f64::from(1u32 << 30) - 1.0) * degrees.to_radians()
    };
    let mut frames = clip.frames().to_vec();
    for rotation in frames.iter_mut().flat_map(|frame| &mut frame.pose.rotations) {
        *rotation = DQuat::from_scaled_axis(DVec3::new(noise(), noise(), noise())) * *rotation;
    }
    let noisy = Clip::new(clip.skeleton().clone(), clip.fps(), clip.morphs().clone(), frames);
    if degrees > 0.0 { noisy.unwrap_or_else(|| clip.clone()) } else { clip.clone() }
}

fn show(whose: &str, tiers: &[Tier]) {
    for tier in tiers {
        for v in tier.values() {
            println!("{whose:10} {:16} {:5.2} {:5.2}  {}  ({})", tier.name, v.start.0, v.end.0, v.label, v.source);
        }
    }
}

fn print(tally: &Tally, top: usize) {
    println!("component      values   strict    loose     exc.   strict    loose (without exceptions)");
    for judged in Judged::ALL {
        let (with, without) = (tally.share(judged, true), tally.share(judged, false));
        let [a, b, c, d] = [with.strict(), with.loose(), without.strict(), without.loose()].map(|share| 100.0 * share);
        let (name, all, left) = (judged.name(), with.all, with.all - without.all);
        println!("{name:14} {all:6} {a:7.1}% {b:7.1}%   {left:6} {c:7.1}% {d:7.1}%");
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
    let files = std::fs::read_dir(what).map_err(told)?;
    let mut paths: Vec<_> = files.map(|file| file.map(|f| f.path())).collect::<Result<_, _>>().map_err(told)?;
    paths.sort();
    let mut all = Vec::new();
    for path in paths {
        let name = path.display().to_string();
        let Some(notation) = Notation::of_extension(&name) else { continue };
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let reading = read_any(&Source::new(name, text), notation, &words, "");
        all.extend(reading.signs.into_iter().map(|read| read.sign));
    }
    Ok(all)
}
