//! From solved positions to rotations: an arm whose elbow is a true hinge.
//!
//! Inverse kinematics gives places of elbow and wrist. The rig wants local rotations, and the roll of the
//! upper arm about its bone is free: it is chosen so that the forearm turns about one fixed axis, as an elbow
//! does. The hand keeps the global rotation asked for (signs keep their orientation when spatialized); what
//! is left between forearm and hand is taken apart as *twist · swing*: the forearm turns about its bone
//! (pronation, supination), then the wrist flexes and deviates.
//!
//! # Conventions
//! The rig rests in a T-pose with palms down and identity rotations, so rest directions are both local and
//! model directions. Flexion of the elbow is 0 when straight and grows as the hand nears the shoulder. The
//! forearm's turn is right-handed about the bone from elbow to wrist, 0 at rest (palm down in the T-pose):
//! on the left arm positive turns pronate, on the right arm they supinate.
//!
//! # What it refuses
//! Rest directions of no length or a hinge along the bone ([`ArmRest::new`]). Where the arm is straight the
//! roll cannot be read from positions: it is kept from the [`ArmHint`].

use super::rotation::{
    direction, frame_to_frame, from_vector, perpendicular, shortest_arc, swing_twist, to_vector, twist_angle, unit,
    unwrap_near,
};
use glam::{DQuat, DVec3};

/// Below this flexion (.1°) the roll is the hint's; from there to [`ROLL_SEEN`] it passes to the positions'.
const ROLL_HIDDEN: f64 = 0.1 * std::f64::consts::PI / 180.0;
/// From this flexion (1°) on the roll is read from the positions alone, and the elbow is a pure hinge.
pub const ROLL_SEEN: f64 = std::f64::consts::PI / 180.0;

/// An arm at rest: directions of bones and axes of joints, unit vectors, checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmRest {
    upper: DVec3,
    fore: DVec3,
    hinge: DVec3,
    wrist_flexion: DVec3,
    wrist_radial: DVec3,
    /// How far the forearm is flexed at rest.
    flexed: f64,
}

impl ArmRest {
    /// An arm at rest. `hinge` is the axis about which the elbow flexes; `wrist_flexion` that about which the
    /// hand turns toward its palm; `wrist_radial` that about which it turns toward the thumb; all right-handed.
    ///
    /// A hinge not perpendicular to the bones is made so. `None` where a vector has no direction, or the hinge
    /// lies along the upper arm.
    ///
    /// ```
    /// use chereme::motion::arm::ArmRest;
    /// use glam::DVec3;
    /// let left = ArmRest::new(DVec3::X, DVec3::X, -DVec3::Y, -DVec3::Z, -DVec3::Y);
    /// assert_eq!(left, Some(ArmRest::left()));
    /// ```
    pub fn new(upper: DVec3, fore: DVec3, hinge: DVec3, wrist_flexion: DVec3, wrist_radial: DVec3) -> Option<ArmRest> {
        let (upper, fore, hinge) = (direction(upper)?, direction(fore)?, direction(hinge)?);
        let normal = upper.cross(fore);
        // Bones that are bent at rest have one hinge only: across both.
        let hinge = if normal.length() > 1e-6 { normal * 1f64.copysign(normal.dot(hinge)) } else { hinge };
        let hinge = hinge - upper * hinge.dot(upper);
        let hinge = if hinge.length() > 1e-9 { direction(hinge)? } else { return None };
        let flexed = upper.cross(fore).dot(hinge).atan2(upper.dot(fore));
        Some(ArmRest {
            upper,
            fore,
            hinge,
            wrist_flexion: perpendicular(direction(wrist_flexion)?, fore),
            wrist_radial: perpendicular(direction(wrist_radial)?, fore),
            flexed,
        })
    }

    /// The left arm of a T-pose with the palm down: the elbow flexes forward (+Z), about −Y.
    ///
    /// ```
    /// assert_eq!(chereme::motion::arm::ArmRest::left().fore(), glam::DVec3::X);
    /// ```
    pub fn left() -> ArmRest {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        ArmRest { upper: x, fore: x, hinge: -y, wrist_flexion: -z, wrist_radial: -y, flexed: 0.0 }
    }

    /// The right arm of a T-pose with the palm down: the elbow flexes forward (+Z), about +Y.
    ///
    /// ```
    /// assert_eq!(chereme::motion::arm::ArmRest::right().fore(), -glam::DVec3::X);
    /// ```
    pub fn right() -> ArmRest {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        ArmRest { upper: -x, fore: -x, hinge: y, wrist_flexion: z, wrist_radial: y, flexed: 0.0 }
    }

    /// From elbow to wrist at rest: the axis of pronation.
    pub fn fore(&self) -> DVec3 {
        self.fore
    }

    /// The hand's local rotation for a turn of the forearm, a flexion and a radial deviation of the wrist (radians):
    /// the inverse of what [`orient`] reads.
    ///
    /// ```
    /// use chereme::motion::arm::{ArmRest, orient};
    /// use glam::{DQuat, DVec3};
    /// let rest = ArmRest::left();
    /// let arm = [DVec3::ZERO, DVec3::X * 0.3, DVec3::new(0.3, 0.0, 0.25)];
    /// let straight = orient(&rest, DQuat::IDENTITY, arm, DQuat::IDENTITY, None);
    /// let hand = straight.upper * straight.fore * rest.hand(0.4, -0.3, 0.1);
    /// let angles = orient(&rest, DQuat::IDENTITY, arm, hand, None).angles;
    /// assert!((angles.twist - 0.4).abs() + (angles.flexion + 0.3).abs() + (angles.radial - 0.1).abs() < 1e-9);
    /// ```
    pub fn hand(&self, twist: f64, flexion: f64, radial: f64) -> DQuat {
        let swing = from_vector(self.wrist_flexion * flexion + self.wrist_radial * radial);
        unit(DQuat::from_axis_angle(self.fore, twist) * swing)
    }

    /// The angles of a hand's local rotation: the inverse of [`ArmRest::hand`]. Those of the elbow are none of its business: 0.
    ///
    /// ```
    /// use chereme::motion::arm::ArmRest;
    /// let rest = ArmRest::right();
    /// let angles = rest.angles(rest.hand(0.4, -0.3, 0.1));
    /// assert!((angles.twist - 0.4).abs() + (angles.flexion + 0.3).abs() + (angles.radial - 0.1).abs() < 1e-9);
    /// ```
    pub fn angles(&self, hand: DQuat) -> ArmAngles {
        let twist = swing_twist(hand, self.fore).twist;
        self.angles_of(twist, unit(twist.conjugate() * hand))
    }

    /// The angles of a hand's local rotation, taken apart already.
    fn angles_of(&self, twist: DQuat, swing: DQuat) -> ArmAngles {
        let bent = to_vector(swing);
        ArmAngles {
            elbow: 0.0,
            twist: twist_angle(twist, self.fore),
            flexion: bent.dot(self.wrist_flexion),
            radial: bent.dot(self.wrist_radial),
        }
    }

    /// The axis about which the elbow flexes, in the upper arm's rest axes.
    pub fn hinge(&self) -> DVec3 {
        self.hinge
    }
}

/// What the frame before left behind, for the roll of a straight arm and the side of a turned hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmHint {
    /// The elbow's axis, model space.
    pub hinge_model: DVec3,
    /// The forearm's turn, radians.
    pub twist: f64,
}

/// The angles of an arm, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmAngles {
    /// Flexion of the elbow: 0 is straight, never negative.
    pub elbow: f64,
    /// Turn of the forearm about its bone, from rest; nearest to the hint's, so it may pass ±π.
    pub twist: f64,
    /// Of the wrist, toward the palm.
    pub flexion: f64,
    /// Of the wrist, toward the thumb.
    pub radial: f64,
}

/// Local rotations of an arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmPose {
    /// Of the upper arm, relative to its parent.
    pub upper: DQuat,
    /// Of the forearm, relative to the upper arm: a turn about the hinge.
    pub fore: DQuat,
    /// Of the hand, relative to the forearm: `hand_twist · hand_swing`.
    pub hand: DQuat,
    /// The forearm's part of `hand`: pronation and supination.
    pub hand_twist: DQuat,
    /// The wrist's part of `hand`: flexion and deviation.
    pub hand_swing: DQuat,
    /// The angles, to be judged against limits.
    pub angles: ArmAngles,
    /// The elbow's axis, model space.
    pub hinge_model: DVec3,
}

impl ArmPose {
    /// What the next frame needs to go on without a jump.
    pub fn hint(&self) -> ArmHint {
        ArmHint { hinge_model: self.hinge_model, twist: self.angles.twist }
    }
}

/// The rotations that put elbow and wrist where they are and the hand as asked.
///
/// `arm` is shoulder, elbow and wrist in model space; `parent` the model rotation of the clavicle, `hand` the
/// wanted model rotation of the hand.
///
/// ```
/// use chereme::motion::arm::{ArmRest, orient};
/// use glam::{DQuat, DVec3};
/// // The left forearm points forward: the elbow is flexed by a right angle.
/// let arm = [DVec3::ZERO, DVec3::X * 0.3, DVec3::new(0.3, 0.0, 0.25)];
/// let pose = orient(&ArmRest::left(), DQuat::IDENTITY, arm, DQuat::IDENTITY, None);
/// assert!((pose.angles.elbow - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// let forearm = pose.upper * pose.fore;
/// assert!((forearm * DVec3::X - DVec3::Z).length() < 1e-12);
/// ```
pub fn orient(rest: &ArmRest, parent: DQuat, arm: [DVec3; 3], hand: DQuat, hint: Option<ArmHint>) -> ArmPose {
    let [shoulder, elbow, wrist] = arm;
    let (parent, hand) = (unit(parent), unit(hand));
    let upper = direction(elbow - shoulder).unwrap_or(parent * rest.upper);
    let fore = direction(wrist - elbow).unwrap_or(upper);
    let hinge_model = hinge(rest, parent, upper, fore, hint);

    let upper_model = frame_to_frame((rest.upper, rest.hinge), (upper, hinge_model));
    let elbow_angle = 2.0 * (fore - upper).length().atan2((fore + upper).length());
    let bend = DQuat::from_axis_angle(rest.hinge, elbow_angle - rest.flexed);
    // Exact where the roll was hinted: a turn of less than ROLL_SEEN, none elsewhere.
    let correction = shortest_arc(upper_model * (bend * rest.fore), fore, hinge_model);
    let fore_model = unit(correction * upper_model * bend);
    let hand_local = unit(fore_model.conjugate() * hand);

    let hand_twist = swing_twist(hand_local, rest.fore).twist;
    let hand_swing = unit(hand_twist.conjugate() * hand_local);
    let angles = rest.angles_of(hand_twist, hand_swing);
    let twist = hint.map_or(angles.twist, |h| unwrap_near(h.twist, angles.twist));
    ArmPose {
        upper: unit(parent.conjugate() * upper_model),
        fore: unit(upper_model.conjugate() * fore_model),
        hand: hand_local,
        hand_twist,
        hand_swing,
        angles: ArmAngles { elbow: elbow_angle, twist, ..angles },
        hinge_model,
    }
}

/// The elbow's axis in model space: across both bones, or the hint's where they are in line.
fn hinge(rest: &ArmRest, parent: DQuat, upper: DVec3, fore: DVec3, hint: Option<ArmHint>) -> DVec3 {
    seen_or(upper, fore, || match hint.and_then(|h| direction(h.hinge_model)) {
        Some(previous) => perpendicular(previous, upper),
        // Without a past, the roll of the least rotation from rest.
        None => {
            let at_rest = parent * rest.upper;
            let swing = shortest_arc(at_rest, upper, parent * rest.hinge);
            perpendicular(swing * (parent * rest.hinge), upper)
        }
    })
}

/// The unit vector across two bones; as they come in line it passes to the `kept` one, which is perpendicular to
/// the first of them.
pub(super) fn seen_or(upper: DVec3, fore: DVec3, kept: impl FnOnce() -> DVec3) -> DVec3 {
    let normal = upper.cross(fore);
    let seen = normal.length();
    let weight = ((seen - ROLL_HIDDEN.sin()) / (ROLL_SEEN.sin() - ROLL_HIDDEN.sin())).clamp(0.0, 1.0);
    if weight == 1.0 {
        return normal / seen;
    }
    let kept = kept();
    if weight == 0.0 {
        return kept;
    }
    let angle = kept.cross(normal).dot(upper).atan2(kept.dot(normal));
    DQuat::from_axis_angle(upper, angle * weight) * kept
}
