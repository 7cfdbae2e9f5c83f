//! Rigs in GLB files: any bytes are read or refused; what is read is written with a motion that rests, and read again as the
//! same. What does not begin as a GLB file is taken for the JSON in one.
#![no_main]

use chereme::format::glb::Rig;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::time::Fps;
use libfuzzer_sys::fuzz_target;
use std::sync::Arc;

fuzz_target!(|bytes: &[u8]| {
    let file = if bytes.starts_with(b"glTF") { bytes.to_vec() } else { wrapped(bytes) };
    let Ok(rig) = Rig::read(&file) else { return };
    let skeleton = rig.skeleton();
    let rest = Frame { pose: LocalPose::rest(skeleton), weights: vec![] };
    let clip = Clip::new(skeleton.clone(), Fps::DEFAULT, Arc::new(vec![]), vec![rest.clone(), rest]);
    let Ok(written) = rig.write(&file, &clip.expect("the frames are the skeleton's")) else { return };
    let again = Rig::read(&written).unwrap_or_else(|told| panic!("{told}"));
    assert_eq!(again.skeleton().joints(), skeleton.joints());
    if !bytes.starts_with(b"glTF") {
        // The JSON's length stands at 12; all numbers behind it are the motion's.
        let json = written[12..].first_chunk::<4>().map_or(0, |length| u32::from_le_bytes(*length) as usize);
        let (numbers, _) = written[28 + json..].as_chunks::<4>();
        assert!(numbers.iter().all(|number| f32::from_le_bytes(*number).is_finite()));
    }
});

/// A GLB file of its JSON.
fn wrapped(json: &[u8]) -> Vec<u8> {
    let mut json = json.to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = json.len() as u32;
    let head = [*b"glTF", 2u32.to_le_bytes(), (length + 20).to_le_bytes(), length.to_le_bytes(), *b"JSON"].concat();
    [head, json].concat()
}
