//! The avatar that comes with the program: its rig, its mesh, its landmarks.

use crate::body::landmarks::Landmarks;
use crate::body::signer::Signer;
use crate::body::skin::{Skin, SkinPart};
use crate::diagnostics::Error;
use crate::format::glb;
use crate::motion::skeleton::Skeleton;
use std::sync::Arc;

/// The avatar as binary glTF: mesh, skin and face morphs (CC0, assets/LICENSE-avatar-CC0.md).
pub const GLB: &[u8] = include_bytes!("../assets/avatar.glb");

/// The rig: joints, parents and rest positions, metres.
pub const SKELETON: &str = include_str!("../assets/avatar.skeleton.json");

/// The avatar as a signer.
///
/// # Errors
/// Only where the embedded files do not fit each other.
///
/// ```
/// let signer = chereme::avatar::signer().unwrap();
/// assert!(signer.morphs.iter().any(|m| m == "mouth-open"));
/// ```
pub fn signer() -> Result<Signer, Error> {
    let skeleton = Skeleton::from_json(SKELETON)?;
    let landmarks = Landmarks::builtin(&skeleton)?;
    Signer::new(Arc::new(skeleton), glb::morph_names(GLB)?, landmarks)
}

/// The avatar's surface, for measuring.
///
/// # Errors
/// Only where the embedded files do not fit each other.
pub fn skin(skeleton: &Skeleton) -> Result<Skin, Error> {
    let model = glb::read::read(GLB)?;
    let joints = model.joints.iter().map(|j| skeleton.joint(&j.name)).collect::<Result<Vec<_>, _>>()?;
    let parts = model.parts.iter().filter(|p| !p.joints.is_empty()).map(|part| SkinPart {
        name: part.material.clone(),
        positions: part.positions.clone(),
        normals: part.normals.clone(),
        triangles: part.triangles.clone(),
        joints: part.joints.iter().map(|four| four.map(|j| joints[usize::from(j)])).collect(),
        weights: part.weights.clone(),
    });
    Skin::new(skeleton, &parts.collect::<Vec<_>>())
}
