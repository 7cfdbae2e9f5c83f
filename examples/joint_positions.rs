//! A sign as a BVH file, and beside it where every joint is on every frame: what other programs' readings are measured against.
//!
//! `cargo run --example joint_positions -- lexicon/lsf/bol.sign out/bol` writes `out/bol.bvh` and `out/bol.csv`
//! (`frame,joint,x,y,z`, metres, Y up; `RightHandIndex3_end` is the tip). `tools/check_bvh.py` and
//! `tools/shots/bvh.mjs` take the pair. Only the first sign of the file is taken.

use chereme::format::bvh::{self, Options};
use chereme::motion::clip::Clip;
use chereme::notation::{Vocabulary, read};
use chereme::synthesis::{Grammar, Options as Signing, synthesize};
use std::error::Error;
use std::fmt::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [sign, out] = &arguments[..] else {
        return Err("give a .sign file and where to write, without extension".into());
    };
    let reading = read(&std::fs::read_to_string(sign)?, &Vocabulary::builtin(), "lsf");
    let first = reading.signs.first().ok_or("the file has no sign without faults")?;
    let performance = synthesize(&first.sign, &Grammar::builtin(), &chereme::avatar::signer()?, &Signing::default())?;
    let clip = &performance.track.clip;
    std::fs::write(format!("{out}.bvh"), bvh::write(clip, &Options::default())?)?;
    std::fs::write(format!("{out}.csv"), positions(clip)?)?;
    println!("{}: {} frames", first.sign.name, clip.frames().len());
    Ok(())
}

/// A line a joint and frame; joints without children have a second line for their end.
fn positions(clip: &Clip) -> Result<String, Box<dyn Error>> {
    let rig = clip.skeleton();
    let mut csv = "frame,joint,x,y,z\n".to_owned();
    for (frame, pose) in clip.frames().iter().map(|f| f.pose.to_model(rig)).enumerate() {
        for id in rig.ids() {
            let name = &rig[id].name;
            let at = pose.position(id);
            writeln!(csv, "{frame},{name},{:.7},{:.7},{:.7}", at.x, at.y, at.z)?;
            if rig.joints().iter().all(|j| j.parent != Some(id)) {
                let end = pose.point(id, rig[id].tail_model - rig[id].rest_model);
                writeln!(csv, "{frame},{name}_end,{:.7},{:.7},{:.7}", end.x, end.y, end.z)?;
            }
        }
    }
    Ok(csv)
}
