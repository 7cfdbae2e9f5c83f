//! An avatar with a motion of its own: the file that goes to 3D programs and into the viewer.
//!
//! The avatar's file is kept as it is (meshes, materials, morphs, extensions such as `VRMC_vrm`); one
//! animation is added, and animations that were there are left out.

use super::container::Container;
use super::samples::Samples;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::track::Track;
use serde_json::{Map, Value, json};

/// The avatar's GLB with the track's motion as its only animation.
///
/// Joints and morphs are matched by name. Rotations are keyed on every frame, as f32, with the
/// signs of neighbouring quaternions chosen so that interpolation takes the short way; a joint that
/// does not turn has one key, a joint at rest none. Times are in seconds from the clip's start.
///
/// # Errors
/// An avatar that is no GLB file, that lacks a joint or morph which the clip moves, or whose
/// joints are turned or scaled at rest (the clip's rotations are relative to an unturned T-pose).
///
/// ```
/// # use chereme::{format::glb, motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton}, time::Fps, track::Track};
/// # use std::sync::Arc;
/// let rig = Arc::new(Skeleton::from_json(include_str!("../../../assets/avatar.skeleton.json")).unwrap());
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(vec![]), vec![rest.clone(), rest]).unwrap();
/// let bytes = glb::write(include_bytes!("../../../assets/avatar.glb"), &Track { clip, tiers: vec![] }).unwrap();
/// assert!(bytes.starts_with(b"glTF"));
/// ```
pub fn write(avatar: &[u8], track: &Track) -> Result<Vec<u8>, Error> {
    write_all(avatar, &[("signing", track)])
}

/// The avatar's GLB with several motions, each an animation of its name; as [`write()`] otherwise.
///
/// # Errors
/// Those of [`write()`].
///
/// ```
/// use chereme::{avatar, format::glb, motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton}, time::Fps, track::Track};
/// let rig = Skeleton::from_json(avatar::SKELETON).unwrap();
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig.into(), Fps::DEFAULT, vec![].into(), vec![rest.clone(), rest]).unwrap();
/// let track = Track { clip, tiers: vec![] };
/// let both = glb::write_all(avatar::GLB, &[("a", &track), ("b", &track)]).unwrap();
/// assert!(String::from_utf8_lossy(&both).contains(r#""name":"b""#));
/// ```
pub fn write_all(avatar: &[u8], tracks: &[(&str, &Track)]) -> Result<Vec<u8>, Error> {
    let Container { mut json, bin } = Container::parse(avatar)?;
    let nodes = json["nodes"].as_array().cloned().unwrap_or_default();
    let mut samples = Samples::new(&json, bin);
    let mut animations = Vec::with_capacity(tracks.len());
    for (name, track) in tracks {
        let mut animation = Animation::default();
        samples.begin();
        rotations(&track.clip, &nodes, &mut samples, &mut animation)?;
        weights(&track.clip, &json, &nodes, &mut samples, &mut animation)?;
        root_translation(&track.clip, &nodes, &mut samples, &mut animation)?;
        animations.push(json!({ "name": name, "channels": animation.channels, "samplers": animation.samplers }));
    }
    let bin = samples.finish(&mut json);
    let document = json.as_object_mut().ok_or_else(|| Error::new("the GLB file's JSON is not an object"))?;
    document.insert("animations".into(), Value::Array(animations));
    document["asset"]["generator"] = json!(concat!("Chereme ", env!("CARGO_PKG_VERSION")));
    lift_skinned_meshes(document);
    Container { json, bin: &bin }.to_bytes()
}

/// Channels and samplers in the making.
#[derive(Default)]
struct Animation {
    channels: Vec<Value>,
    samplers: Vec<Value>,
}

impl Animation {
    fn channel(&mut self, node: usize, path: &str, input: usize, output: usize) {
        let sampler = self.samplers.len();
        self.samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
        self.channels.push(json!({ "sampler": sampler, "target": { "node": node, "path": path } }));
    }
}

/// The node of a joint; it must rest unturned, or the clip's rotations would mean something else.
fn node_of(nodes: &[Value], name: &str) -> Result<usize, Error> {
    let at = nodes.iter().position(|n| n["name"] == name);
    let at = at.ok_or_else(|| Error::new(format!("the avatar has no joint {name}, which the motion moves")))?;
    let is = |key: &str, rest: &[f64]| {
        let value =
            nodes[at].get(key).map(|v| v.as_array().map(|a| a.iter().filter_map(Value::as_f64).collect::<Vec<_>>()));
        value.is_none_or(|v| v.as_deref() == Some(rest))
    };
    if !is("rotation", &[0.0, 0.0, 0.0, 1.0]) || !is("scale", &[1.0; 3]) || nodes[at].get("matrix").is_some() {
        return Err(Error::new(format!("the avatar's joint {name} is turned or scaled at rest")));
    }
    Ok(at)
}

fn times(clip: &Clip, frames: &[usize]) -> Vec<f32> {
    frames.iter().map(|&i| (i as f64 / clip.fps().get()) as f32).collect()
}

fn rotations(clip: &Clip, nodes: &[Value], samples: &mut Samples, animation: &mut Animation) -> Result<(), Error> {
    let every: Vec<usize> = (0..clip.frames().len()).collect();
    for id in clip.skeleton().ids() {
        let mut keys: Vec<[f32; 4]> = Vec::with_capacity(every.len());
        for frame in clip.frames() {
            let q = frame.pose.rotation(id).normalize().as_quat().normalize().to_array();
            let before = keys.last().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
            let same_side = q.iter().zip(before).map(|(a, b)| a * b).sum::<f32>() >= 0.0;
            keys.push(if same_side { q } else { q.map(|x| -x) });
        }
        let still = keys.iter().all(|k| k.iter().zip(keys[0]).all(|(a, b)| (a - b).abs() < 1e-6));
        if still && keys[0][..3].iter().all(|x| x.abs() < 1e-6) {
            continue; // at rest throughout
        }
        let name = &clip.skeleton()[id].name;
        let node = node_of(nodes, name)?;
        let used = if still { &every[..1] } else { &every[..] };
        let input = samples.times(&times(clip, used));
        let output = samples.push(keys[..used.len()].as_flattened(), "VEC4");
        animation.channel(node, "rotation", input, output);
    }
    Ok(())
}

/// Keys the root's position. It also keeps a motion that stands still as long as it is: glTF has no
/// other word for an animation's duration than its last key, and no empty animation.
fn root_translation(
    clip: &Clip,
    nodes: &[Value],
    samples: &mut Samples,
    animation: &mut Animation,
) -> Result<(), Error> {
    let place = |i: usize| clip.frames()[i].pose.root_model;
    let last = clip.frames().len() - 1;
    let rest = clip.skeleton().joints()[0].rest_model;
    let still = (0..=last).all(|i| place(i).distance(place(0)) < 1e-7);
    let frames: Vec<usize> = match (still, samples.last_time() > 0.0) {
        (true, true) if place(0).distance(rest) < 1e-7 => return Ok(()),
        (true, true) => vec![0],
        (true, false) if last > 0 => vec![0, last],
        _ => (0..=last).collect(),
    };
    let node = node_of(nodes, &clip.skeleton().joints()[0].name)?;
    let places: Vec<[f32; 3]> = frames.iter().map(|&i| place(i).as_vec3().to_array()).collect();
    let input = samples.times(&times(clip, &frames));
    let output = samples.push(places.as_flattened(), "VEC3");
    animation.channel(node, "translation", input, output);
    Ok(())
}

/// Keys the morph weights of every mesh that has morphs; frames inside a hold have no key.
fn weights(
    clip: &Clip,
    json: &Value,
    nodes: &[Value],
    samples: &mut Samples,
    animation: &mut Animation,
) -> Result<(), Error> {
    let mut found = vec![false; clip.morphs().len()];
    for (node, described) in nodes.iter().enumerate() {
        let Some(mesh) = described["mesh"].as_u64() else { continue };
        let Some(targets) = json["meshes"][mesh as usize]["extras"]["targetNames"].as_array() else { continue };
        let sources: Vec<Option<usize>> =
            targets.iter().map(|t| clip.morphs().iter().position(|m| *t == json!(m))).collect();
        sources.iter().flatten().for_each(|&s| found[s] = true);
        let row = |frame: usize| sources.iter().map(move |s| s.map_or(0.0, |s| clip.frames()[frame].weights[s]));
        let same = |a: usize, b: usize| row(a).eq(row(b));
        let last = clip.frames().len() - 1;
        let mut frames: Vec<usize> =
            (0..=last).filter(|&i| i == 0 || i == last || !same(i, i - 1) || !same(i, i + 1)).collect();
        if frames.len() == 2 && same(0, last) {
            if row(0).all(|w| w == 0.0) {
                continue; // the face is at rest throughout
            }
            frames.truncate(1);
        }
        let values: Vec<f32> = frames.iter().flat_map(|&i| row(i)).collect();
        let input = samples.times(&times(clip, &frames));
        let output = samples.push(&values, "SCALAR");
        animation.channel(node, "weights", input, output);
    }
    for (name, _) in clip.morphs().iter().zip(found).filter(|(_, found)| !found) {
        let index = clip.morphs().iter().position(|m| m == name);
        if clip.frames().iter().any(|f| index.is_some_and(|i| f.weights[i] != 0.0)) {
            return Err(Error::new(format!("the avatar has no face morph {name}, which the motion moves")));
        }
    }
    Ok(())
}

/// Makes skinned meshes roots of the scene, as glTF advises: a node above them does not move them.
fn lift_skinned_meshes(document: &mut Map<String, Value>) {
    let Some(nodes) = document.get_mut("nodes").and_then(Value::as_array_mut) else { return };
    let skinned: Vec<Value> =
        nodes.iter().enumerate().filter(|(_, n)| n.get("skin").is_some()).map(|(i, _)| json!(i)).collect();
    let mut lifted = Vec::new();
    for node in nodes {
        let Some(children) = node.get_mut("children").and_then(Value::as_array_mut) else { continue };
        let (up, stay): (Vec<Value>, Vec<Value>) = children.drain(..).partition(|c| skinned.contains(c));
        lifted.extend(up);
        *children = stay;
        if children.is_empty() {
            node.as_object_mut().map(|n| n.remove("children"));
        }
    }
    let scene = document.get("scene").and_then(Value::as_u64).unwrap_or(0) as usize;
    let roots = document.get_mut("scenes").and_then(|s| s.get_mut(scene)).and_then(|s| s.get_mut("nodes"));
    if let Some(roots) = roots.and_then(Value::as_array_mut) {
        roots.extend(lifted);
    }
}
