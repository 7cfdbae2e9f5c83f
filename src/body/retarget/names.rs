//! Joint names of other rigs: which of ours each one is.

use crate::motion::skeleton::Skeleton;
use std::collections::BTreeMap;
use std::sync::LazyLock;

static OURS: LazyLock<Option<Skeleton>> =
    LazyLock::new(|| Skeleton::from_json(include_str!("../../../assets/avatar.skeleton.json")).ok());

/// What was recognised in a file's joint names.
#[derive(Debug, Clone, PartialEq)]
pub struct Recognised {
    /// Whose names they are.
    pub convention: &'static str,
    /// Our joint's name to the file's.
    pub joints: BTreeMap<String, String>,
    /// The file's names that are none of ours.
    pub unknown: Vec<String>,
}

/// Mixamo's names, with and without their prefix.
pub fn recognise<'a>(names: impl Iterator<Item = &'a str>) -> Recognised {
    let mut found = Recognised { convention: "Mixamo", joints: BTreeMap::new(), unknown: Vec::new() };
    for name in names {
        let ours = name.trim_start_matches("mixamorig").trim_start_matches(':');
        let known = OURS.as_ref().is_some_and(|rig| rig.find(ours).is_some());
        if known && !found.joints.contains_key(ours) {
            found.joints.insert(ours.to_owned(), name.to_owned());
        } else {
            found.unknown.push(name.to_owned());
        }
    }
    found
}
