//! Our motion on strangers' rigs: the rows of their own BVH files, their own GLB files.

use crate::shared::shared;
use crate::signing::{sign, world};
use chereme::body::retarget::names::recognise;
use chereme::body::retarget::{Axes, Humanoid, Mode, Options, propose_axes, retarget, to_theirs};
use chereme::format::bvh::{self, Axis, Bvh, Channel, Joint};
use chereme::format::glb;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::motion::rotation::angle_between;
use chereme::time::{Fps, Seconds};
use glam::DVec3;
use proptest::prelude::*;

fn axes() -> impl Strategy<Value = Vec<Channel>> {
    let rotations = [Axis::X, Axis::Y, Axis::Z].map(Channel::Rotation).to_vec();
    Just(rotations).prop_shuffle()
}

proptest! {
    #[test]
    fn rows_in_any_order_of_channels_turn_joints_the_same(
        channels in prop::collection::vec(axes(), 4),
        angles in prop::collection::vec(-170.0f64..170.0, 24),
        locked in any::<bool>(),
    ) {
        let joints: Vec<Joint> = channels.iter().enumerate().map(|(i, rotations)| {
            let positions = [Axis::Z, Axis::X, Axis::Y].map(Channel::Position).to_vec();
            let channels = if i == 0 { [positions, rotations.clone()].concat() } else { rotations.clone() };
            Joint { name: format!("j{i}"), parent: i.checked_sub(1), offset: DVec3::new(1.0, 2.0, i as f64), channels, end_sites: vec![] }
        }).collect();
        let mut values: Vec<f64> = Vec::new();
        for row in angles.chunks(12) {
            values.extend([3.0, 1.0, 2.0]);
            // The middle angle of the second joint at a right angle: gimbal lock.
            values.extend(row.iter().enumerate().map(|(i, a)| if locked && i == 4 { 90.0f64.copysign(*a) } else { *a }));
        }
        let file = Bvh::new(joints, Seconds(0.02), values).unwrap();
        let clip = bvh::to_clip(&file, &bvh::ClipOptions::default()).unwrap().clip;
        let again = bvh::onto(&file, &clip, 0.01).unwrap();
        let back = bvh::to_clip(&again, &bvh::ClipOptions::default()).unwrap().clip;
        for (a, b) in clip.frames().iter().zip(back.frames()) {
            prop_assert!(a.pose.root_model.distance(b.pose.root_model) < 1e-9);
            for (p, q) in a.pose.rotations.iter().zip(&b.pose.rotations) {
                prop_assert!(angle_between(*p, *q) < 1e-6);
            }
        }
    }
}

fn bol() -> Clip {
    let text = "sign X\n hands both mirrored\n configuration round-B\n placement chest, neutral distance\n orientation fingers out-left, palm up\n movement arc up-right 15cm\n";
    let world = world();
    chereme::synthesis::synthesize(&sign(text), &world.grammar, &world.signer, &Default::default()).unwrap().track.clip
}

#[test]
fn a_sign_goes_onto_captured_skeletons_and_comes_back() {
    let Some(folder) = shared("data/mocap") else { return };
    let signer = &world().signer;
    let clip = bol();
    for file in [
        "sign_body/create_db_m.bvh",
        "sign_body/ISL_Thanks_final.bvh",
        "cmu_dance/05_02.bvh",
        "bvh_oddities/makehuman__zombieWalk1.bvh",
    ] {
        let bytes = std::fs::read(folder.join(file)).unwrap();
        let theirs = bvh::read(&bytes).unwrap().bvh;
        let metres_per_unit = bvh::propose_unit(&theirs).map_or(0.01, |unit| unit.metres_per_unit);
        let options = bvh::ClipOptions { metres_per_unit, roots: bvh::Roots::First };
        let moved = bvh::to_clip(&theirs, &options).unwrap().clip;
        let joints = recognise(moved.skeleton()).joints;
        let found = propose_axes(&moved, &joints);
        let humanoid = Humanoid::new(moved.skeleton(), &joints, found, signer).unwrap();
        let rows = bvh::onto(&theirs, &to_theirs(&clip, &humanoid, signer).unwrap(), metres_per_unit).unwrap();
        assert_eq!(rows.joints(), theirs.joints(), "{file}");
        let read = bvh::read(bvh::print(&rows).as_bytes()).unwrap().bvh;
        let again = bvh::to_clip(&read, &options).unwrap().clip;
        let rest = clip.frames()[0].pose.clone();
        let back =
            retarget(&again, &humanoid, signer, &Options { mode: Mode::Directions, skip_frames: 0, rest }).unwrap();
        for (was, is) in clip.frames().iter().zip(back.clip.frames()).step_by(7) {
            let (was, is) = (was.pose.to_model(&signer.skeleton), is.pose.to_model(&signer.skeleton));
            for (bone, end) in [
                ("LeftArm", "LeftForeArm"),
                ("RightForeArm", "RightHand"),
                ("RightHandIndex1", "RightHandIndex2"),
                ("LeftHandPinky2", "LeftHandPinky3"),
            ] {
                let [bone, end] = [bone, end].map(|name| signer.skeleton.joint(name).unwrap());
                let way = |m: &chereme::motion::pose::ModelPose| m.position(end) - m.position(bone);
                assert!(way(&was).angle_between(way(&is)) < 0.035, "{file}: {:?}", signer.skeleton[bone].name);
            }
        }
    }
}

#[test]
fn a_glb_rig_that_is_turned_at_rest_moves_as_ours() {
    let signer = &world().signer;
    let rig = glb::Rig::read(chereme::avatar::GLB).unwrap();
    let joints = recognise(rig.skeleton()).joints;
    let humanoid = Humanoid::new(rig.skeleton(), &joints, Axes::OURS, signer).unwrap();
    let clip = bol();
    let bytes = rig.write(chereme::avatar::GLB, &to_theirs(&clip, &humanoid, signer).unwrap()).unwrap();
    assert!(bytes.starts_with(b"glTF") && bytes.len() > chereme::avatar::GLB.len() / 2);
    let again = glb::Rig::read(&bytes).unwrap();
    assert_eq!(again.skeleton().joints(), rig.skeleton().joints());
    // Bytes that are no rig.
    for cut in [0, 4, 12, 20, 100, 1000] {
        assert!(glb::Rig::read(&chereme::avatar::GLB[..cut]).is_err());
    }
    let still = Frame { pose: LocalPose::rest(&signer.skeleton), weights: vec![] };
    let other = Clip::new(signer.skeleton.clone(), Fps::DEFAULT, Default::default(), vec![still]).unwrap();
    let fits = other.skeleton().len() == rig.skeleton().len();
    assert!(fits || rig.write(chereme::avatar::GLB, &other).is_err());
}

/// A GLB file of its JSON.
fn glb_of(json: &str) -> Vec<u8> {
    let json = format!("{json:width$}", width = json.len().next_multiple_of(4));
    let length = json.len() as u32;
    [&b"glTF"[..], &2u32.to_le_bytes(), &(length + 20).to_le_bytes(), &length.to_le_bytes(), b"JSON", json.as_bytes()]
        .concat()
}

/// What fuzzing found, made small.
#[test]
fn rigs_without_buffers_scaled_to_nothing_or_too_far_away_do_no_harm() {
    let nodes = |scale: &str| {
        format!(
            r#""nodes":[{{"name":"a","children":[1],"scale":{scale}}},{{"translation":[1,0,0]}}],"skins":[{{"joints":[0,1]}}]"#
        )
    };
    for (buffers, scale) in [("[]", "[1,1,1]"), ("[0]", "[0,0,0]"), ("{}", "[0,2,1]"), ("[{}]", "[1e-320,1,1]")] {
        let file = glb_of(&format!(r#"{{"buffers":{buffers},{}}}"#, nodes(scale)));
        let rig = glb::Rig::read(&file).unwrap();
        let rest = Frame { pose: LocalPose::rest(rig.skeleton()), weights: vec![] };
        let clip = Clip::new(rig.skeleton().clone(), Fps::DEFAULT, Default::default(), vec![rest]).unwrap();
        let written = rig.write(&file, &clip).unwrap();
        assert_eq!(glb::Rig::read(&written).unwrap().skeleton().joints(), rig.skeleton().joints());
        let json = u32::from_le_bytes(*written[12..].first_chunk().unwrap()) as usize;
        let (numbers, _) = written[28 + json..].as_chunks::<4>();
        assert!(numbers.len() > 11 && numbers.iter().all(|n| f32::from_le_bytes(*n).is_finite()), "{buffers} {scale}");
    }
    assert!(glb::Rig::read(&glb_of(&format!("{{{}}}", nodes("[1e300,1,1]")))).is_err());
}
