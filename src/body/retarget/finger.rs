//! Three bones of a digit turned so that they look where they should.
//!
//! A finger of the rig spreads about the back of the hand and flexes about one axis; so the plane in which it bends is
//! looked for first, and what bones do besides (a camera's noise, another hand's build) is left to the least turn.

use crate::motion::rotation::{direction, frame_to_frame, perpendicular, shortest_arc, unit};
use crate::phonology::Side;
use glam::{DQuat, DVec3};

/// Where the middle bone is bent by less than the first of these (radians) its plane says nothing, from the second on all.
const PLANE_SEEN: [f64; 2] = [0.1, 0.3];
/// The plane is turned about the first bone from where spreading alone puts it by no more than this, radians.
const PLANE_TURNED: f64 = 0.45;

/// Model rotations of three bones of a finger that point along `along`; `rest` are their directions at rest, `hand` the
/// hand's model rotation.
pub(super) fn finger(side: Side, hand: DQuat, rest: [DVec3; 3], along: [DVec3; 3]) -> [DQuat; 3] {
    // About this axis a finger at rest flexes, to the palm.
    let hinge_rest = perpendicular(-DVec3::Z * side.sign(), rest[0]);
    let spread = unit(hand * spread(side, rest[0], hand.conjugate() * along[0]));
    let kept = perpendicular(spread * hinge_rest, along[0]);
    let axis = hinge(along[0], along[1], kept);
    let first = frame_to_frame((rest[0], hinge_rest), (along[0], axis));
    let [_, second, third] = chain(first, rest, along);
    [first, second, third]
}

/// Model rotations of three bones, each turned from the one before by the least turn.
pub(super) fn chain(first: DQuat, rest: [DVec3; 3], along: [DVec3; 3]) -> [DQuat; 3] {
    let next = |before: DQuat, i: usize| unit(shortest_arc(before * rest[i], along[i], before * DVec3::Y) * before);
    let second = next(first, 1);
    [first, second, next(second, 2)]
}

/// The turn about the back of the hand that brings a finger's plane over a direction in the hand's axes; a finger that points
/// out of the palm is not spread.
fn spread(side: Side, rest: DVec3, along: DVec3) -> DQuat {
    let along = DVec3::new(along.x * side.sign(), along.y, along.z);
    let rest = DVec3::new(rest.x * side.sign(), rest.y, rest.z);
    let level = along.x.hypot(along.z);
    let sure = ((level - 0.2) / 0.3).clamp(0.0, 1.0);
    // Bent past a right angle, it points back.
    let back = if along.x < 0.0 { -1.0 } else { 1.0 };
    let turn = (-along.z * back).atan2(along.x * back) - (-rest.z).atan2(rest.x);
    DQuat::from_rotation_y(turn * sure * side.sign())
}

/// The axis about which the second bone is bent from the first, as far as it is seen and near the kept one.
fn hinge(first: DVec3, second: DVec3, kept: DVec3) -> DVec3 {
    let Some(seen) = direction(first.cross(second)) else { return kept };
    let seen = if seen.dot(kept) < 0.0 { -seen } else { seen };
    let bent = first.angle_between(second);
    let weight = ((bent - PLANE_SEEN[0]) / (PLANE_SEEN[1] - PLANE_SEEN[0])).clamp(0.0, 1.0);
    let turn = kept.cross(seen).dot(first).atan2(kept.dot(seen)).clamp(-PLANE_TURNED, PLANE_TURNED);
    DQuat::from_axis_angle(first, turn * weight) * kept
}
