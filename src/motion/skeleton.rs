//! The rig: joints, their parents and where they rest.
//!
//! # Conventions
//! The rest pose is a T-pose with identity rotations, so a joint's rest placement is a translation
//! from its parent. Parents come before their children.

use crate::diagnostics::Error;
use glam::DVec3;
use serde::Deserialize;
use std::collections::HashMap;

/// The number of a joint in its [`Skeleton`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub u16);

impl JointId {
    /// The joint's position in arrays with one element a joint.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A joint at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Mixamo's name without prefix, such as `LeftForeArm`.
    pub name: String,
    /// The parent; `None` for the root alone.
    pub parent: Option<JointId>,
    /// Position at rest, model space, metres.
    pub rest_model: DVec3,
    /// Where the bone ends at rest (the fingertip, for a last finger joint), model space, metres.
    pub tail_model: DVec3,
}

/// A checked rig: one root, parents before children, names unique, finite positions.
#[derive(Debug, Clone)]
pub struct Skeleton {
    joints: Vec<Joint>,
    by_name: HashMap<String, JointId>,
}

#[derive(Deserialize)]
struct JointRow {
    parent: Option<String>,
    pos: [f64; 3],
    tail: [f64; 3],
}

impl Skeleton {
    /// A rig of joints, in their order: the root first, parents before their children.
    ///
    /// # Errors
    /// No joint, more than `u16` numbers, a name used twice, no root or several, a parent that does not come before, a
    /// position that is not finite.
    ///
    /// ```
    /// use chereme::motion::skeleton::{Joint, JointId, Skeleton};
    /// use glam::DVec3;
    /// let joint = |name: &str, parent| Joint { name: name.into(), parent, rest_model: DVec3::Y, tail_model: DVec3::Y };
    /// assert!(Skeleton::new(vec![joint("Hips", None), joint("Spine", Some(JointId(0)))]).is_ok());
    /// assert!(Skeleton::new(vec![joint("Hips", None), joint("Spine", Some(JointId(1)))]).is_err());
    /// ```
    pub fn new(joints: Vec<Joint>) -> Result<Skeleton, Error> {
        let roots = joints.iter().filter(|j| j.parent.is_none()).count();
        if roots != 1 {
            return Err(Error::new(format!("a skeleton has one root, this one has {roots}")));
        }
        let mut by_name = HashMap::with_capacity(joints.len());
        for (at, joint) in joints.iter().enumerate() {
            let id = next_id(&joints[..at])?;
            if by_name.insert(joint.name.clone(), id).is_some() {
                return Err(Error::new(format!("joint {} is listed twice", joint.name)));
            }
            if joint.parent.is_some_and(|p| p.index() >= at) {
                return Err(Error::new(format!("joint {} comes before its parent", joint.name)));
            }
            if !(joint.rest_model.is_finite() && joint.tail_model.is_finite()) {
                return Err(Error::new(format!("joint {} has a position that is not finite", joint.name)));
            }
        }
        Ok(Skeleton { joints, by_name })
    }

    /// Reads the rig from `avatar.skeleton.json`: `{name: {parent, pos, tail}}`, metres, parents anywhere.
    ///
    /// # Errors
    /// Text that is not such JSON, an unknown or cyclic parent, no root or several, a position that is not finite.
    pub fn from_json(text: &str) -> Result<Skeleton, Error> {
        let rows: OrderedRows =
            serde_json::from_str(text).map_err(|e| Error::new(format!("the skeleton is not as expected: {e}")))?;
        let mut joints: Vec<Joint> = Vec::with_capacity(rows.0.len());
        let mut by_name = HashMap::new();
        let mut left = rows.0;
        // Each pass places the joints whose parents are placed; a pass that places none has met a cycle.
        while !left.is_empty() {
            let before = left.len();
            let mut later = Vec::new();
            for (name, row) in left {
                let parent = match &row.parent {
                    None => None,
                    Some(p) => match by_name.get(p) {
                        Some(&id) => Some(id),
                        None => {
                            later.push((name, row));
                            continue;
                        }
                    },
                };
                let id = next_id(&joints)?;
                by_name.insert(name.clone(), id);
                joints.push(Joint {
                    name,
                    parent,
                    rest_model: DVec3::from(row.pos),
                    tail_model: DVec3::from(row.tail),
                });
            }
            if later.len() == before {
                let (name, row) = &later[0];
                let parent = row.parent.as_deref().unwrap_or_default();
                return Err(Error::new(format!("joint {name} hangs from {parent}, which is unknown or hangs from it")));
            }
            left = later;
        }
        Skeleton::new(joints)
    }

    /// The joints, parents before children.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// How many joints there are.
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// Whether there is no joint (never, for a checked skeleton).
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// A joint by its name.
    pub fn find(&self, name: &str) -> Option<JointId> {
        self.by_name.get(name).copied()
    }

    /// A joint by its name.
    ///
    /// # Errors
    /// Names the joint that the rig lacks.
    pub fn joint(&self, name: &str) -> Result<JointId, Error> {
        self.find(name).ok_or_else(|| Error::new(format!("the rig has no joint {name}")))
    }

    /// All joint numbers, parents before children.
    pub fn ids(&self) -> impl Iterator<Item = JointId> + use<> {
        (0..self.joints.len() as u16).map(JointId)
    }

    /// Translation from the parent at rest (from the origin, for the root), metres.
    pub fn offset(&self, joint: JointId) -> DVec3 {
        let j = &self.joints[joint.index()];
        j.rest_model - j.parent.map_or(DVec3::ZERO, |p| self.joints[p.index()].rest_model)
    }
}

impl std::ops::Index<JointId> for Skeleton {
    type Output = Joint;
    fn index(&self, id: JointId) -> &Joint {
        &self.joints[id.index()]
    }
}

/// The number of the joint after these; their count too is a `u16`.
fn next_id(joints: &[Joint]) -> Result<JointId, Error> {
    u16::try_from(joints.len()).ok().filter(|n| *n < u16::MAX).map(JointId).ok_or_else(|| Error::new("too many joints"))
}

/// A JSON object read in the order it is written, so that joint numbers follow the file.
struct OrderedRows(Vec<(String, JointRow)>);

impl<'de> Deserialize<'de> for OrderedRows {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> serde::de::Visitor<'de> for Visitor {
            type Value = OrderedRows;
            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("an object of joints")
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<OrderedRows, A::Error> {
                let mut rows = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    rows.push(entry);
                }
                Ok(OrderedRows(rows))
            }
        }
        deserializer.deserialize_map(Visitor)
    }
}
