//! Where fingers and palm look at the keys.

use super::Checking;
use super::finding::{Finding, Kind};
use super::key::Key;
use crate::phonology::Place;
use glam::DVec3;

const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// How far fingers or palm may look away from where they are said to.
const OFF: f64 = 5.0 * DEGREE;
/// How far a measured turn may differ from what the report admits and still be the same.
const SAME: f64 = 2.0 * DEGREE;
/// A palm within this of the fingers' direction (the sine of it) says nothing.
const ALONG: f64 = 0.2;

impl Checking<'_> {
    /// Fingers and palm that look elsewhere than the key says.
    pub(super) fn turns(&self, key: &Key) -> Vec<Finding> {
        let Some(said) = key.said.orientation.stated(key.number).filter(|said| !said.along_path) else {
            return Vec::new();
        };
        // A hand that points is turned to what it points at.
        let points = key.said.placement.at(key.number).is_some_and(|p| matches!(p.place, Place::Towards(_)));
        if points {
            return Vec::new();
        }
        let rig = self.signer.arm(key.side);
        let (fingers, palm) = rig.fingers_and_palm(key.body.rotation(rig.hand));
        let mut off: Vec<(f64, &str)> = Vec::new();
        let wanted = said.fingers.map(|heading| heading.vector());
        off.extend(wanted.map(|wanted| (fingers.angle_between(wanted), "fingers")));
        if let Some(heading) = said.palm {
            // The palm is meant across the fingers: those that are said, else those that there are.
            let along = wanted.unwrap_or(fingers);
            let across = |v: DVec3| v - along * v.dot(along);
            let (is, should) = (across(palm), across(heading.vector()));
            if is.length() > ALONG && should.length() > ALONG {
                off.push((is.angle_between(should), "palm"));
            }
        }
        let admitted = self.performance.report.tilt + SAME;
        let finding = |(measured, which): (f64, &str)| Finding {
            kind: if measured <= admitted { Kind::BeyondWrist } else { Kind::Orientation },
            side: Some(key.side),
            time: key.time,
            measured,
            bound: OFF,
            what: format!("{which} {}", key.name()),
        };
        off.into_iter().filter(|(angle, _)| *angle > OFF).map(finding).collect()
    }
}
