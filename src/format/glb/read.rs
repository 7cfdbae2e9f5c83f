//! An avatar's mesh, skin and face morphs as plain data.

use super::accessor::Arrays;
use super::container::Container;
use super::document::{Document, Primitive};
use crate::diagnostics::Error;
use glam::{DMat4, DVec3};
use serde::Deserialize;

/// What an avatar's file holds of body and face, at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbModel {
    /// The joints of the skin, in its order: the numbers in [`GlbPart::joints`] count these.
    pub joints: Vec<GlbJoint>,
    /// The surface, one part for each material of each mesh.
    pub parts: Vec<GlbPart>,
}

/// A joint of the skin.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbJoint {
    /// The joint's name, such as `LeftForeArm`.
    pub name: String,
    /// The parent among [`GlbModel::joints`]; `None` where the node above is no joint.
    pub parent: Option<usize>,
    /// Translation from the parent at rest, metres.
    pub translation: DVec3,
    /// From model space at rest to the joint's own space.
    pub inverse_bind: DMat4,
}

/// One primitive: triangles of one material. All arrays with one element a vertex are of one length.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbPart {
    /// The mesh's name, such as `Body`.
    pub mesh: String,
    /// The material's name, such as `hands`; empty where it has none.
    pub material: String,
    /// Vertices at rest, model space, metres.
    pub positions: Vec<DVec3>,
    /// Normals at rest, model space, as stored (unit length in a sound file); empty where the file has none.
    pub normals: Vec<DVec3>,
    /// Three vertices each, counter-clockwise seen from outside; every number is below `positions.len()`.
    pub triangles: Vec<[u32; 3]>,
    /// Up to four joints a vertex (numbers in [`GlbModel::joints`]); empty where the part has no skin.
    pub joints: Vec<[u16; 4]>,
    /// The joints' shares of a vertex, as stored (their sum is 1 in a sound file); empty where the part has no skin.
    pub weights: Vec<[f64; 4]>,
    /// The face morphs that move this part.
    pub morphs: Vec<GlbMorph>,
}

/// A morph of one part: what its weight 1 adds to the vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbMorph {
    /// The morph's name, such as `mouth-open`; `morph N` where the file names none.
    pub name: String,
    /// Vertex and displacement (model space at rest, metres), for the vertices that move.
    pub moved: Vec<(u32, DVec3)>,
}

impl GlbModel {
    /// The parts of one material, such as `hands`.
    pub fn parts_of<'a>(&'a self, material: &'a str) -> impl Iterator<Item = &'a GlbPart> {
        self.parts.iter().filter(move |p| p.material == material)
    }

    /// The number of a joint by its name.
    pub fn joint(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|j| j.name == name)
    }
}

/// Reads the model out of a GLB file.
///
/// # Errors
/// Bytes that are no GLB 2 file, arrays that reach outside it, triangles or skin that point at
/// vertices or joints that are not there, more than one skin, primitives that are not triangle lists.
///
/// ```
/// use chereme::format::glb::read;
/// let model = read::read(include_bytes!("../../../assets/avatar.glb")).unwrap();
/// let hands = model.parts_of("hands").next().unwrap();
/// assert_eq!(hands.positions.len(), hands.weights.len());
/// assert!(read::read(b"glTF").is_err());
/// ```
pub fn read(bytes: &[u8]) -> Result<GlbModel, Error> {
    let container = Container::parse(bytes)?;
    let document = Document::deserialize(&container.json)
        .map_err(|e| Error::new(format!("the GLB file's JSON is not glTF as expected: {e}")))?;
    let mut arrays = Arrays::new(&document, container.bin);
    let mut skin = None;
    for node in document.nodes.iter().filter(|n| n.mesh.is_some()) {
        match (skin, node.skin) {
            (_, None) => {}
            (None, found) => skin = found,
            (Some(a), Some(b)) if a == b => {}
            (Some(_), Some(_)) => return Err(Error::new("the GLB file has several skins, and one is expected")),
        }
    }
    let joints = skin.map_or(Ok(Vec::new()), |skin| joints(&document, &mut arrays, skin))?;
    let mut parts = Vec::new();
    for node in &document.nodes {
        let Some(mesh) = node.mesh else { continue };
        let mesh = document.meshes.get(mesh).ok_or_else(|| Error::new(format!("the GLB file has no mesh {mesh}")))?;
        for primitive in &mesh.primitives {
            let skinned = node.skin.map(|_| joints.len());
            let mut part = part(&document, &mut arrays, primitive, skinned, &mesh.extras.target_names)
                .map_err(|e| e.context(format_args!("mesh {}", mesh.name)))?;
            part.mesh.clone_from(&mesh.name);
            parts.push(part);
        }
    }
    Ok(GlbModel { joints, parts })
}

fn joints(document: &Document, arrays: &mut Arrays, skin: usize) -> Result<Vec<GlbJoint>, Error> {
    let skin = document.skins.get(skin).ok_or_else(|| Error::new(format!("the GLB file has no skin {skin}")))?;
    let count = skin.joints.len();
    let binds = match skin.inverse_bind_matrices {
        None => vec![DMat4::IDENTITY; count],
        Some(index) => arrays.elements::<16>(index, "MAT4", count)?.iter().map(DMat4::from_cols_array).collect(),
    };
    let mut joint_of_node = vec![None; document.nodes.len()];
    for (joint, &node) in skin.joints.iter().enumerate() {
        *joint_of_node.get_mut(node).ok_or_else(|| Error::new(format!("the GLB file has no node {node}")))? =
            Some(joint);
    }
    let mut parents = vec![None; count];
    for (above, node) in document.nodes.iter().enumerate() {
        for child in node.children.iter().filter_map(|&c| joint_of_node.get(c).copied().flatten()) {
            parents[child] = joint_of_node[above];
        }
    }
    let place = |((&node, inverse_bind), parent): ((&usize, DMat4), Option<usize>)| GlbJoint {
        name: document.nodes[node].name.clone(),
        parent,
        translation: DVec3::from(document.nodes[node].translation),
        inverse_bind,
    };
    Ok(skin.joints.iter().zip(binds).zip(parents).map(place).collect())
}

/// Reads one primitive; `joints` is the number of the skin's joints where the mesh has a skin.
fn part(
    document: &Document,
    arrays: &mut Arrays,
    primitive: &Primitive,
    joints: Option<usize>,
    morph_names: &[String],
) -> Result<GlbPart, Error> {
    const TRIANGLES: u32 = 4;
    if primitive.mode.unwrap_or(TRIANGLES) != TRIANGLES {
        return Err(Error::new("a primitive is not a list of triangles"));
    }
    let position = primitive.attributes.position.ok_or_else(|| Error::new("a primitive has no positions"))?;
    let count = arrays.count(position)?;
    let vectors = |elements: Vec<[f64; 3]>| -> Vec<DVec3> { elements.into_iter().map(DVec3::from).collect() };
    let positions = vectors(arrays.elements(position, "VEC3", count)?);
    let normals = match primitive.attributes.normal {
        Some(index) => vectors(arrays.elements(index, "VEC3", count)?),
        None => Vec::new(),
    };
    let corners: Vec<u32> = match primitive.indices {
        Some(index) => {
            let length = arrays.count(index)?;
            arrays.elements::<1>(index, "SCALAR", length)?.into_iter().map(|[n]| n as u32).collect()
        }
        None => (0..count as u32).collect(),
    };
    if !corners.len().is_multiple_of(3) || corners.iter().any(|&c| c as usize >= count) {
        return Err(Error::new("a triangle has no third corner, or a corner that is no vertex"));
    }
    let (mut of, mut weights) = (Vec::new(), Vec::new());
    if let (Some(known), Some(j), Some(w)) = (joints, primitive.attributes.joints, primitive.attributes.weights) {
        let numbers = arrays.elements::<4>(j, "VEC4", count)?;
        if numbers.iter().flatten().any(|&n| n < 0.0 || n >= known as f64) {
            return Err(Error::new("a vertex hangs on a joint that the skin does not have"));
        }
        of = numbers.into_iter().map(|four| four.map(|n| n as u16)).collect();
        weights = arrays.elements::<4>(w, "VEC4", count)?;
    }
    let mut morphs = Vec::new();
    for (number, target) in primitive.targets.iter().enumerate() {
        let name = morph_names.get(number).cloned().unwrap_or_else(|| format!("morph {number}"));
        let deltas = target.position.map_or(Ok(Vec::new()), |index| arrays.elements::<3>(index, "VEC3", count))?;
        let numbered = deltas.into_iter().enumerate().map(|(v, d)| (v as u32, DVec3::from(d)));
        morphs.push(GlbMorph { name, moved: numbered.filter(|(_, d)| *d != DVec3::ZERO).collect() });
    }
    let material =
        primitive.material.and_then(|m| document.materials.get(m)).map_or_else(String::new, |m| m.name.clone());
    let triangles = corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    Ok(GlbPart { mesh: String::new(), material, positions, normals, triangles, joints: of, weights, morphs })
}

/// The names of the face morphs, without reading any mesh: those of the first mesh that names its targets.
///
/// # Errors
/// Bytes that are no GLB file. A file without morphs has no names.
pub fn morph_names(bytes: &[u8]) -> Result<Vec<String>, Error> {
    let Container { json, .. } = Container::parse(bytes)?;
    let named = json["meshes"].as_array().into_iter().flatten().find_map(|m| m["extras"]["targetNames"].as_array());
    Ok(named.into_iter().flatten().filter_map(|n| n.as_str().map(str::to_string)).collect())
}
