//! A sign written as text becomes a track: motion, and tiers that say what each stretch of it is.
//!
//! `cargo run --example text_to_track` prints the tiers.

use chereme::avatar;
use chereme::diagnostics::Error;
use chereme::notation::{Vocabulary, read};
use chereme::synthesis::{Grammar, Options, synthesize};

const TEXT: &str = "sign BOL
  hands          both mirrored
  configuration  round-B
  placement      chest, 24cm away
  orientation    fingers out-left, palm up
  movement       arc up-right 15cm bulging down-right
";

/// The tiers of the sign, one value a line: tier, start and end in seconds, label.
pub fn tiers() -> Result<String, Error> {
    let reading = read(TEXT, &Vocabulary::builtin(), "lsf");
    // Where the text has faults, `reading.diagnostics` says where and how to mend them.
    let sign = &reading.signs.first().ok_or_else(|| Error::new("the text has a fault"))?.sign;
    let track = synthesize(sign, &Grammar::builtin(), &avatar::signer()?, &Options::default())?.track;
    let mut lines = String::new();
    for tier in &track.tiers {
        for value in tier.values() {
            lines += &format!("{:16} {:5.2} {:5.2}  {}\n", tier.name, value.start.0, value.end.0, value.label);
        }
    }
    Ok(lines)
}

fn main() -> Result<(), Error> {
    print!("{}", tiers()?);
    Ok(())
}
