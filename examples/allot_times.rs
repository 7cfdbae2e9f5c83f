//! Signs at times that come from outside, such as those of a song: what a plan takes is measured, its schedule is
//! changed, and the motion is made at the new times.
//!
//! `cargo run --example allot_times` prints when each stroke begins, before and after.

use chereme::avatar;
use chereme::diagnostics::Error;
use chereme::notation::{Vocabulary, read};
use chereme::score::plan::Plan;
use chereme::synthesis::{Grammar, Options, measure, render};
use chereme::time::Seconds;

const TEXT: &str =
    "sign ONE\n  configuration 1\n  movement up 10cm\n\nsign TWO\n  configuration V\n  movement left 10cm\n";

/// The strokes' beginnings in seconds: as they come, then on the beats of a song of 60 beats a minute.
pub fn strokes() -> Result<String, Error> {
    let signs = read(TEXT, &Vocabulary::builtin(), "").signs.into_iter().map(|s| s.sign);
    let plan = Plan { items: signs.flat_map(|sign| Plan::of(sign).items).collect(), spans: Vec::new() };
    let (grammar, signer, options) = (Grammar::builtin(), avatar::signer()?, Options::default());
    let usual = measure(&plan, &grammar, &signer, &options)?.schedule();
    let mut on_beats = usual.clone();
    for (beat, times) in on_beats.items.iter_mut().enumerate() {
        times.stroke = Seconds(1.0 + beat as f64);
        times.stroke_end = times.stroke + Seconds(0.4);
        times.hold_end = times.stroke + Seconds(0.6);
    }
    (on_beats.retracted, on_beats.end) = (Seconds(3.0), Seconds(3.2));
    let report = render(&plan, &on_beats, &grammar, &signer, &options)?.report;
    let pairs = usual.items.iter().zip(&report.items);
    Ok(pairs.map(|(before, after)| format!("{:5.2} {:5.2}\n", before.stroke.0, after.stroke.0)).collect())
}

fn main() -> Result<(), Error> {
    print!("{}", strokes()?);
    Ok(())
}
