//! An arm carried to another place: the rotations after inverse kinematics, from those before.
//!
//! An arm that moves already keeps what is its own: the roll of its bones, the plane of its elbow, whatever its joints
//! do that a hinge would not. So nothing is made anew from positions, as [`super::arm`] does for a described sign:
//! each bone is turned on from where it was.
//!
//! The arm is first turned as a whole, the short way about, until its wrist looks toward the target; then FABRIK
//! stretches or bends it in the plane that its elbow then has. The elbow's swivel about the line from shoulder to wrist
//! is thereby kept, and follows the target without a jump. (From the source's own pose FABRIK would keep the plane of
//! shoulder, elbow and target, which turns over where the target passes the elbow.)
//!
//! # Conventions
//! Model space, metres. No limits: the paper has none (Naert et al. 2021, §4.1).

use super::arm::seen_or;
use super::fabrik::{Options, Pole};
use super::reach::reach;
use super::rotation::{direction, frame_to_frame, perpendicular, shortest_arc, unit};
use glam::{DQuat, DVec3};

/// FABRIK stops this near to the target, metres: what is left must not tremble from frame to frame.
const TOLERANCE_M: f64 = 1e-7;

/// An arm in model space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedArm {
    /// Shoulder, elbow, wrist, metres.
    pub joints: [DVec3; 3],
    /// The upper arm's rotation.
    pub upper: DQuat,
    /// The forearm's rotation.
    pub fore: DQuat,
    /// The axis about which the elbow flexes; what the bones of a bent arm show is believed before it.
    pub hinge: DVec3,
}

/// The arm with its wrist on the target or as near as the bones let it, and the metres that are left.
///
/// A target too far stretches the arm straight toward it, one too near folds it. An arm that stands on the target
/// already is returned as it is.
///
/// ```
/// use chereme::motion::carry::{PlacedArm, carried};
/// use glam::{DQuat, DVec3};
/// let joints = [DVec3::ZERO, DVec3::X * 0.3, DVec3::new(0.3, 0.0, 0.25)];
/// // A T-pose's left arm with its forearm turned forward, about −Y.
/// let fore = DQuat::from_rotation_y(-std::f64::consts::FRAC_PI_2);
/// let arm = PlacedArm { joints, upper: DQuat::IDENTITY, fore, hinge: -DVec3::Y };
/// let (moved, residual_m) = carried(&arm, DVec3::new(0.2, 0.2, 0.2));
/// assert!(residual_m < 1e-6);
/// assert!((moved.joints[1] - moved.upper * DVec3::X * 0.3).length() < 1e-6);
/// let (stretched, residual_m) = carried(&arm, DVec3::Z);
/// assert!((residual_m - 0.45).abs() < 1e-9 && (stretched.joints[2] - DVec3::Z * 0.55).length() < 1e-9);
/// ```
pub fn carried(arm: &PlacedArm, target: DVec3) -> (PlacedArm, f64) {
    let [shoulder, elbow, wrist] = arm.joints;
    let bones = direction(elbow - shoulder).zip(direction(wrist - elbow));
    let Some((upper, fore)) = bones.filter(|_| wrist != target) else {
        return (*arm, wrist.distance(target).min(f64::MAX));
    };
    let hinge = seen_or(upper, fore, || perpendicular(arm.hinge, upper));
    let turn = shortest_arc(wrist - shoulder, target - shoulder, hinge);
    let turned = [shoulder, shoulder + turn * (elbow - shoulder), shoulder + turn * (wrist - shoulder)];
    let hinge_after = turn * hinge;
    // The forearm flexes about the hinge, so the elbow stands out on the other side of the line to the wrist.
    let toward = direction(target - shoulder).unwrap_or(turn * upper).cross(hinge_after);
    let options = Options { tolerance_m: TOLERANCE_M, pole: Pole::Always(toward), ..Options::default() };
    let solved = reach(turned, target, &options);
    let [_, elbow_after, wrist_after] = solved.joints;
    let bone = |from: DVec3, to: DVec3, before: DVec3, rotation: DQuat| {
        let after = direction(to - from).unwrap_or(turn * before);
        let side = |axis: DVec3, hinge: DVec3| (axis, perpendicular(hinge, axis));
        unit(frame_to_frame(side(before, hinge), side(after, hinge_after)) * rotation)
    };
    let moved = PlacedArm {
        joints: solved.joints,
        upper: bone(shoulder, elbow_after, upper, arm.upper),
        fore: bone(elbow_after, wrist_after, fore, arm.fore),
        hinge: hinge_after,
    };
    (moved, solved.residual_m)
}
