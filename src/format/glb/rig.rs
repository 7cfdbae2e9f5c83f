//! Anybody's rig in a GLB file: its joints as a skeleton, and its file with a motion of that skeleton.
//!
//! A file's joints may be turned and scaled at rest. The skeleton that is made of them rests with identity rotations where they stand; the
//! way back is kept here.

use super::container::Container;
use super::samples::Samples;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::skeleton::{Joint, JointId, Skeleton};
use glam::{DMat4, DQuat, DVec3};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::Arc;

/// More nodes than this no rig has.
const MOST_NODES: usize = 10_000;

/// A file's joints.
#[derive(Debug, Clone)]
pub struct Rig {
    skeleton: Arc<Skeleton>,
    /// The node of each joint.
    nodes: Vec<usize>,
    /// Each joint's model rotation at rest.
    rest: Vec<DQuat>,
}

impl Rig {
    /// Reads the joints of a file: those of its first skin, with the nodes between and above them.
    ///
    /// # Errors
    /// Bytes that are no GLB file; no skin; joints that hang together in a circle, from several roots, or from nowhere.
    ///
    /// ```
    /// use chereme::format::glb;
    /// let rig = glb::Rig::read(chereme::avatar::GLB).unwrap();
    /// assert!(rig.skeleton().find("LeftForeArm").is_some());
    /// ```
    pub fn read(bytes: &[u8]) -> Result<Rig, Error> {
        let Container { json, .. } = Container::parse(bytes)?;
        let nodes = json["nodes"].as_array().map(Vec::as_slice).unwrap_or_default();
        if nodes.len() > MOST_NODES {
            return Err(Error::new(format!("the GLB file has {} nodes; a rig has up to {MOST_NODES}", nodes.len())));
        }
        let parents = parents(nodes)?;
        let joints = json["skins"][0]["joints"].as_array().map(Vec::as_slice).unwrap_or_default();
        let number = |v: &Value| v.as_u64().map(|n| n as usize).filter(|n| *n < nodes.len());
        let joints: Option<Vec<usize>> = joints.iter().map(number).collect();
        let joints = joints.filter(|joints| !joints.is_empty());
        let joints = joints.ok_or_else(|| Error::new("the GLB file has no skin, so no joints to move"))?;
        // Everything above a joint, up to the node under which all joints hang.
        let mut used: BTreeSet<usize> = BTreeSet::new();
        for joint in &joints {
            used.extend(line_up(*joint, &parents)?);
        }
        let roots: Vec<usize> = used.iter().copied().filter(|node| parents[*node].is_none()).collect();
        let [root] = roots[..] else {
            return Err(Error::new(format!("the joints hang from {} roots; one is expected", roots.len())));
        };
        Rig::of(nodes, &parents, &used, root)
    }

    fn of(nodes: &[Value], parents: &[Option<usize>], used: &BTreeSet<usize>, root: usize) -> Result<Rig, Error> {
        // Parents before children.
        let mut order = vec![root];
        let mut at = 0;
        while at < order.len() {
            let node = order[at];
            order.extend(used.iter().copied().filter(|child| parents[*child] == Some(node)));
            at += 1;
        }
        let mut models: Vec<DMat4> = Vec::with_capacity(order.len());
        let mut joints: Vec<Joint> = Vec::with_capacity(order.len());
        for node in &order {
            let parent = parents[*node].and_then(|parent| order.iter().position(|n| *n == parent));
            let model = parent.map_or(DMat4::IDENTITY, |p| models[p]) * local(&nodes[*node])?;
            let named = nodes[*node]["name"].as_str().unwrap_or("node").to_owned();
            let taken = joints.iter().any(|joint: &Joint| joint.name == named);
            let name = if taken { format!("{named} (node {node})") } else { named };
            let rest_model = model.transform_point3(DVec3::ZERO);
            if !rest_model.as_vec3().is_finite() {
                return Err(Error::new(format!("joint {name} stands farther away than a GLB file can say")));
            }
            let parent = parent.map(|p| JointId(p as u16));
            joints.push(Joint { name, parent, rest_model, tail_model: rest_model });
            models.push(model);
        }
        for at in (1..joints.len()).rev() {
            if let Some(parent) = joints[at].parent {
                joints[parent.index()].tail_model = joints[at].rest_model;
            }
        }
        // A joint that is scaled to nothing has no rotation of its own: it is turned as its parent is.
        let mut rest: Vec<DQuat> = Vec::with_capacity(models.len());
        for (model, joint) in models.iter().zip(&joints) {
            let own = model.to_scale_rotation_translation().1;
            let above = joint.parent.map_or(DQuat::IDENTITY, |parent| rest[parent.index()]);
            rest.push(if own.is_finite() && own.length() > 0.5 { own.normalize() } else { above });
        }
        Ok(Rig { skeleton: Arc::new(Skeleton::new(joints)?), nodes: order, rest })
    }

    /// The joints as a skeleton that rests with identity rotations, metres.
    pub fn skeleton(&self) -> &Arc<Skeleton> {
        &self.skeleton
    }

    /// The file with a motion of its joints as its only animation.
    ///
    /// # Errors
    /// Another file than was read; a clip of another skeleton.
    pub fn write(&self, bytes: &[u8], clip: &Clip) -> Result<Vec<u8>, Error> {
        let Container { mut json, bin } = Container::parse(bytes)?;
        let count = json["nodes"].as_array().map_or(0, Vec::len);
        if self.nodes.iter().any(|node| *node >= count) || clip.skeleton().len() != self.nodes.len() {
            return Err(Error::new("the motion is not one of the file's joints"));
        }
        let mut samples = Samples::new(&json, bin);
        let times: Vec<f32> = (0..clip.frames().len()).map(|i| (i as f64 / clip.fps().get()) as f32).collect();
        let input = samples.times(&times);
        let (mut channels, mut samplers) = (Vec::new(), Vec::new());
        let mut channel = |node: usize, path: &str, output: usize| {
            channels.push(json!({ "sampler": samplers.len(), "target": { "node": node, "path": path } }));
            samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
        };
        let models: Vec<_> = clip.frames().iter().map(|frame| frame.pose.to_model(&self.skeleton)).collect();
        for joint in self.skeleton.ids() {
            let mut keys: Vec<[f32; 4]> = Vec::with_capacity(models.len());
            for model in &models {
                let turned = |id: JointId| model.rotation(id) * self.rest[id.index()];
                let above = self.skeleton[joint].parent.map_or(DQuat::IDENTITY, turned);
                let q = (above.conjugate() * turned(joint)).normalize().as_quat().to_array();
                let before = keys.last().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
                let same = q.iter().zip(before).map(|(a, b)| a * b).sum::<f32>() >= 0.0;
                keys.push(if same { q } else { q.map(|x| -x) });
            }
            channel(self.nodes[joint.index()], "rotation", samples.push(keys.as_flattened(), "VEC4"));
        }
        let place = |frame: &Frame| frame.pose.root_model.as_vec3().to_array();
        let places: Vec<[f32; 3]> = clip.frames().iter().map(place).collect();
        channel(self.nodes[0], "translation", samples.push(places.as_flattened(), "VEC3"));
        let bin = samples.finish(&mut json);
        let document = json.as_object_mut().ok_or_else(|| Error::new("the GLB file's JSON is not an object"))?;
        let animation = json!([{ "name": "signing", "channels": channels, "samplers": samplers }]);
        document.insert("animations".into(), animation);
        Container { json, bin: &bin }.to_bytes()
    }
}

/// The parent of each node.
fn parents(nodes: &[Value]) -> Result<Vec<Option<usize>>, Error> {
    let mut parents = vec![None; nodes.len()];
    for (at, node) in nodes.iter().enumerate() {
        for child in node["children"].as_array().map(Vec::as_slice).unwrap_or_default() {
            let child = child.as_u64().map(|n| n as usize).filter(|n| *n < nodes.len());
            let child = child.ok_or_else(|| Error::new(format!("node {at} has a child that is not there")))?;
            if parents[child].replace(at).is_some() {
                return Err(Error::new(format!("node {child} hangs from two nodes")));
            }
        }
    }
    Ok(parents)
}

/// A node and all above it.
fn line_up(node: usize, parents: &[Option<usize>]) -> Result<Vec<usize>, Error> {
    let mut line = vec![node];
    while let Some(above) = parents[line[line.len() - 1]] {
        if line.len() > parents.len() {
            return Err(Error::new("the nodes of the GLB file hang together in a circle"));
        }
        line.push(above);
    }
    Ok(line)
}

/// A node's own transformation.
fn local(node: &Value) -> Result<DMat4, Error> {
    let numbers = |key: &str, count: usize| -> Result<Option<Vec<f64>>, Error> {
        let Some(value) = node.get(key) else { return Ok(None) };
        let all: Option<Vec<f64>> = value.as_array().map(|a| a.iter().filter_map(Value::as_f64).collect());
        let all = all.filter(|all| all.len() == count && all.iter().all(|v| v.is_finite()));
        all.map(Some).ok_or_else(|| Error::new(format!("a node's {key} is not {count} numbers")))
    };
    if let Some(m) = numbers("matrix", 16)? {
        let mut columns = [0.0; 16];
        columns.copy_from_slice(&m);
        return Ok(DMat4::from_cols_array(&columns));
    }
    let translation = numbers("translation", 3)?.map_or(DVec3::ZERO, |t| DVec3::from_slice(&t));
    let scale = numbers("scale", 3)?.map_or(DVec3::ONE, |s| DVec3::from_slice(&s));
    let rotation = numbers("rotation", 4)?.map_or(DQuat::IDENTITY, |q| DQuat::from_slice(&q));
    let rotation = if rotation.length() > 1e-9 { rotation.normalize() } else { DQuat::IDENTITY };
    Ok(DMat4::from_scale_rotation_translation(scale, rotation, translation))
}
