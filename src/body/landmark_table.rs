//! The rows of `grammar/landmarks.ron` as they are written: the middle and the left of each landmark.

use super::landmarks::Landmark;
use crate::diagnostics::Error;
use crate::motion::skeleton::Skeleton;
use crate::phonology::Side;
use glam::DVec3;
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Table {
    pub(super) body: BTreeMap<String, PlaceRow>,
    pub(super) hand: BTreeMap<String, Point>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaceRow {
    #[serde(default)]
    pub(super) centre: Option<Point>,
    pub(super) at: Point,
    pub(super) beside: Point,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Point {
    joint: String,
    offset: (f64, f64, f64),
    normal: (f64, f64, f64),
}

impl Point {
    /// The landmark on a rig; on the right it is the mirror image in the plane x = 0.
    pub(super) fn on(&self, skeleton: &Skeleton, side: Side) -> Result<Landmark, Error> {
        let name = match (side, self.joint.strip_prefix("Left")) {
            (Side::Right, Some(rest)) => format!("Right{rest}"),
            _ => self.joint.clone(),
        };
        let mirror = DVec3::new(side.sign(), 1.0, 1.0);
        let offset = DVec3::from(self.offset) * mirror;
        let normal =
            DVec3::from(self.normal).try_normalize().ok_or_else(|| Error::new("the normal has no direction"))?;
        if !offset.is_finite() {
            return Err(Error::new("the offset is not finite"));
        }
        Ok(Landmark { joint: skeleton.joint(&name)?, offset, normal: normal * mirror })
    }
}
