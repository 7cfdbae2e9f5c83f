//! GLB writing: what is written is a sound file, keeps the avatar, and has the motion of the clip.

use chereme::format::glb;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::time::Fps;
use chereme::track::Track;
use glam::{DQuat, DVec3};
use serde_json::Value;
use std::sync::Arc;

pub const AVATAR: &[u8] = include_bytes!("../../assets/avatar.glb");

/// Two seconds: the right arm turns once round, its index stays bent, the mouth opens and stays open.
pub fn track() -> Track {
    let rig = Arc::new(Skeleton::from_json(include_str!("../../assets/avatar.skeleton.json")).unwrap());
    let (arm, index) = (rig.joint("RightArm").unwrap(), rig.joint("RightHandIndex1").unwrap());
    let frames = (0..=120).map(|i| {
        let t = f64::from(i) / 120.0;
        let mut pose = LocalPose::rest(&rig);
        pose.set(arm, DQuat::from_rotation_z(t * std::f64::consts::TAU));
        pose.set(index, DQuat::from_rotation_z(0.8));
        Frame { pose, weights: vec![(i as f32 / 20.0).min(1.0)] }
    });
    let frames = frames.collect();
    let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(vec!["mouth-open".into()]), frames).unwrap();
    Track { clip, tiers: Vec::new() }
}

/// The JSON and the binary chunk, taken apart the slow obvious way.
fn apart(bytes: &[u8]) -> (Value, &[u8]) {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    (serde_json::from_slice(&bytes[20..20 + length]).unwrap(), &bytes[28 + length..])
}

/// The numbers of an accessor without stride.
fn numbers(json: &Value, bin: &[u8], accessor: &Value) -> Vec<f32> {
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let start = (view["byteOffset"].as_u64().unwrap() + accessor["byteOffset"].as_u64().unwrap_or(0)) as usize;
    let width = match accessor["type"].as_str().unwrap() {
        "VEC4" => 4,
        "VEC3" => 3,
        _ => 1,
    };
    let count = accessor["count"].as_u64().unwrap() as usize * width;
    bin[start..start + 4 * count].chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
}

/// Key times and values of a node's channel.
fn keys(json: &Value, bin: &[u8], node: &str, path: &str) -> Option<(Vec<f32>, Vec<f32>)> {
    let node = json["nodes"].as_array().unwrap().iter().position(|n| n["name"] == node).unwrap();
    let animation = &json["animations"][0];
    let channels = animation["channels"].as_array().unwrap();
    let channel = channels.iter().find(|c| c["target"]["node"] == node && c["target"]["path"] == path)?;
    let sampler = &animation["samplers"][channel["sampler"].as_u64().unwrap() as usize];
    Some((numbers(json, bin, &sampler["input"]), numbers(json, bin, &sampler["output"])))
}

#[test]
fn the_avatar_is_kept() {
    let written = glb::write(AVATAR, &track()).unwrap();
    assert_eq!(glb::read::read(&written).unwrap(), glb::read::read(AVATAR).unwrap());
    let (before, after) = (apart(AVATAR).0, apart(&written).0);
    assert_eq!(before["extensions"], after["extensions"]);
    assert_eq!(before["materials"], after["materials"]);
    assert_eq!(glb::write(AVATAR, &track()).unwrap(), written, "same input, same bytes");
}

#[test]
fn moving_joints_are_keyed_each_frame_still_ones_once_resting_ones_never() {
    let written = glb::write(AVATAR, &track()).unwrap();
    let (json, bin) = apart(&written);
    let (times, turns) = keys(&json, bin, "RightArm", "rotation").unwrap();
    assert_eq!(times.len(), 121);
    assert!((times[120] - 2.0).abs() < 1e-6);
    for pair in turns.as_chunks::<4>().0.windows(2) {
        let dot: f32 = pair[0].iter().zip(pair[1]).map(|(a, b)| a * b).sum();
        assert!(dot > 0.0, "neighbouring quaternions lie on one side");
    }
    assert_eq!(keys(&json, bin, "RightHandIndex1", "rotation").unwrap().0, [0.0]);
    assert!(keys(&json, bin, "LeftArm", "rotation").is_none());
    assert!(keys(&json, bin, "Hips", "translation").is_none());
}

#[test]
fn a_held_mouth_has_no_keys_inside_the_hold() {
    let written = glb::write(AVATAR, &track()).unwrap();
    let (json, bin) = apart(&written);
    let (times, weights) = keys(&json, bin, "Face", "weights").unwrap();
    assert_eq!(times.len(), 22, "21 keys while it opens, one at the end");
    let targets = weights.len() / times.len();
    assert_eq!(targets, json["meshes"][0]["extras"]["targetNames"].as_array().unwrap().len());
    assert_eq!(weights[21 * targets..].iter().sum::<f32>(), 1.0);
}

#[test]
fn times_say_their_least_and_greatest() {
    let written = glb::write(AVATAR, &track()).unwrap();
    let json = apart(&written).0;
    for sampler in json["animations"][0]["samplers"].as_array().unwrap() {
        let input = &json["accessors"][sampler["input"].as_u64().unwrap() as usize];
        assert_eq!(input["min"][0], 0.0);
        assert!(input["max"][0].is_number());
    }
}

#[test]
fn skinned_meshes_are_roots() {
    let json = apart(&glb::write(AVATAR, &track()).unwrap()).0;
    let roots = json["scenes"][0]["nodes"].as_array().unwrap();
    for (i, node) in json["nodes"].as_array().unwrap().iter().enumerate() {
        assert!(node.get("skin").is_none() || roots.contains(&Value::from(i)));
    }
}

#[test]
fn a_signer_standing_elsewhere_has_one_key_and_a_morph_unknown_is_refused() {
    let mut track = track();
    let mut frames = track.clip.frames().to_vec();
    frames.iter_mut().for_each(|f| f.pose.root_model += DVec3::X);
    let rig = track.clip.skeleton().clone();
    track.clip = Clip::new(rig.clone(), Fps::DEFAULT, track.clip.morphs().clone(), frames.clone()).unwrap();
    let written = glb::write(AVATAR, &track).unwrap();
    let (json, bin) = apart(&written);
    assert_eq!(keys(&json, bin, "Hips", "translation").unwrap().0, [0.0]);

    track.clip = Clip::new(rig, Fps::DEFAULT, Arc::new(vec!["third-eye".into()]), frames).unwrap();
    assert!(glb::write(AVATAR, &track).unwrap_err().to_string().contains("third-eye"));
}

#[test]
fn a_pose_held_lasts_as_long_as_the_clip() {
    let mut track = track();
    let held = track.clip.frames()[30].clone();
    let rig = track.clip.skeleton().clone();
    track.clip = Clip::new(rig, Fps::DEFAULT, track.clip.morphs().clone(), vec![held; 61]).unwrap();
    let written = glb::write(AVATAR, &track).unwrap();
    let (json, bin) = apart(&written);
    assert_eq!(keys(&json, bin, "RightArm", "rotation").unwrap().0, [0.0]);
    assert_eq!(keys(&json, bin, "Hips", "translation").unwrap().0, [0.0, 1.0]);
}
