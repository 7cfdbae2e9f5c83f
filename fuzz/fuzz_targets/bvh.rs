//! BVH: any bytes are read or refused; what is read is printed and read again as the same, and goes onto our rig where its
//! joints are a body's or a hand's.
#![no_main]

use chereme::body::retarget::names::recognise;
use chereme::body::retarget::{Humanoid, Mode, Options, propose_axes, retarget};
use chereme::body::signer::Signer;
use chereme::diagnostics::render::render;
use chereme::format::bvh;
use chereme::motion::clip::Clip;
use chereme::motion::pose::LocalPose;
use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;

static SIGNER: LazyLock<Signer> = LazyLock::new(|| chereme::avatar::signer().expect("it is ours"));

/// More cost time and show nothing new.
const MOST_FRAMES: usize = 200;
const MOST_JOINTS: usize = 300;

fuzz_target!(|bytes: &[u8]| match bvh::read(bytes) {
    Ok(reading) => {
        let text = bvh::print(&reading.bvh);
        let again = bvh::read(text.as_bytes()).unwrap_or_else(|told| panic!("{told:?}\n{text}"));
        assert_eq!(bvh::print(&again.bvh), text);
        assert_eq!(again.bvh.rows().len(), reading.bvh.rows().len());
        let unit = bvh::propose_unit(&reading.bvh).map_or(0.01, |unit| unit.metres_per_unit);
        let options = bvh::ClipOptions { metres_per_unit: unit, roots: bvh::Roots::First };
        if let Ok(converted) = bvh::to_clip(&reading.bvh, &options) {
            onto_us(&converted.clip);
        }
    }
    Err(told) => {
        let source = bvh::source_of_bytes("fuzz.bvh", bytes);
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
    }
});

fn onto_us(clip: &Clip) {
    all_finite(clip);
    if clip.frames().len() > MOST_FRAMES || clip.skeleton().len() > MOST_JOINTS {
        return;
    }
    let known = recognise(clip.skeleton());
    for theirs in known.joints.values().chain(&known.unknown) {
        assert!(clip.skeleton().find(theirs).is_some(), "{theirs}");
    }
    let axes = propose_axes(clip, &known.joints);
    let Ok(humanoid) = Humanoid::new(clip.skeleton(), &known.joints, axes, &SIGNER) else { return };
    for mode in [Mode::Directions, Mode::Contacts] {
        let options = Options { mode, skip_frames: 0, rest: LocalPose::rest(&SIGNER.skeleton) };
        let Ok(ours) = retarget(clip, &humanoid, &SIGNER, &options) else { continue };
        assert_eq!(ours.clip.frames().len(), clip.frames().len());
        all_finite(&ours.clip);
        assert!(ours.report.worst().is_finite(), "{:?}", ours.report);
    }
}

fn all_finite(clip: &Clip) {
    for (at, frame) in clip.frames().iter().enumerate() {
        let model = frame.pose.to_model(clip.skeleton());
        for (joint, (place, turn)) in clip.skeleton().joints().iter().zip(model.positions.iter().zip(&model.rotations))
        {
            assert!(place.is_finite() && (turn.length() - 1.0).abs() < 1e-6, "{at} {}: {place} {turn}", joint.name);
        }
    }
}
