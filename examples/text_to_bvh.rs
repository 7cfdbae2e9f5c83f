//! A sign written as text becomes a BVH file, for Blender and other programs that open captured motion.
//!
//! `cargo run --example text_to_bvh > moi.bvh`

use chereme::avatar;
use chereme::diagnostics::Error;
use chereme::format::bvh;
use chereme::notation::{Vocabulary, read};
use chereme::synthesis::{Grammar, Options, synthesize};

const TEXT: &str = "sign MOI
  configuration  index
  placement      chest, touch, with index tip
  orientation    fingers in-left, palm down
";

/// The text of the BVH file, in centimetres.
pub fn bvh_text() -> Result<String, Error> {
    let reading = read(TEXT, &Vocabulary::builtin(), "lsf");
    let sign = &reading.signs.first().ok_or_else(|| Error::new("the text has a fault"))?.sign;
    let track = synthesize(sign, &Grammar::builtin(), &avatar::signer()?, &Options::default())?.track;
    bvh::write(&track.clip, &bvh::Options::default())
}

fn main() -> Result<(), Error> {
    print!("{}", bvh_text()?);
    Ok(())
}
