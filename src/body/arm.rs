//! An arm of the rig: its joints, the hand's axes, the limits of the wrist.
//!
//! # Conventions
//! At rest (T-pose) the left fingers point to +X, the right to −X, palms face −Y, thumbs +Z. A hand's
//! orientation is the model rotation that takes these rest axes to the fingers' and the palm's directions.
//! Angles are radians; the elbow is a hinge, the forearm turns, the wrist flexes and deviates
//! ([`crate::motion::arm`]).

use crate::diagnostics::Error;
use crate::motion::arm::{ArmAngles, ArmPose, ArmRest};
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{twist_share, unit};
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::Side;
use glam::{DMat3, DQuat, DVec3};

/// The joints and measures of one arm.
#[derive(Debug, Clone)]
pub struct ArmRig {
    /// Which arm.
    pub side: Side,
    /// The clavicle, whose turning lifts or reaches with the shoulder.
    pub clavicle: JointId,
    /// The upper arm, at the shoulder joint.
    pub upper: JointId,
    /// The forearm, at the elbow.
    pub fore: JointId,
    /// The hand, at the wrist.
    pub hand: JointId,
    /// Leaf joints of the forearm, with their share of the forearm's turn.
    pub twists: Vec<(JointId, f64)>,
    /// Directions and axes at rest.
    pub rest: ArmRest,
    /// Metres from shoulder to elbow.
    pub upper_m: f64,
    /// Metres from elbow to wrist.
    pub fore_m: f64,
}

impl ArmRig {
    /// Finds an arm in a skeleton with Mixamo's names.
    ///
    /// # Errors
    /// Names the joint that is missing.
    pub fn new(skeleton: &Skeleton, side: Side) -> Result<ArmRig, Error> {
        let prefix = match side {
            Side::Left => "Left",
            Side::Right => "Right",
        };
        let joint = |name: &str| skeleton.joint(&format!("{prefix}{name}"));
        let (upper, fore, hand) = (joint("Arm")?, joint("ForeArm")?, joint("Hand")?);
        let fore_m = skeleton.offset(hand).length();
        let twists = ["ForeArmTwist1", "ForeArmTwist2"]
            .iter()
            .filter_map(|name| skeleton.find(&format!("{prefix}{name}")))
            .map(|id| (id, skeleton.offset(id).length() / fore_m))
            .collect();
        let rest = match side {
            Side::Left => ArmRest::left(),
            Side::Right => ArmRest::right(),
        };
        let upper_m = skeleton.offset(fore).length();
        Ok(ArmRig { side, clavicle: joint("Shoulder")?, upper, fore, hand, twists, rest, upper_m, fore_m })
    }

    /// Metres from the shoulder to the wrist of the stretched arm: the unit of places in space.
    pub fn length_m(&self) -> f64 {
        self.upper_m + self.fore_m
    }

    /// Clavicle, upper arm, forearm and hand.
    pub fn joints(&self) -> [JointId; 4] {
        [self.clavicle, self.upper, self.fore, self.hand]
    }

    /// Where the stretched fingers point at rest.
    pub fn rest_fingers(&self) -> DVec3 {
        DVec3::X * self.side.sign()
    }

    /// The model rotation of a hand whose fingers and palm look in two directions.
    ///
    /// The palm is projected onto the plane across the fingers; `None` where the two are parallel.
    pub fn hand_rotation(&self, fingers: DVec3, palm: DVec3) -> Option<DQuat> {
        let fingers = fingers.try_normalize()?;
        let palm = (palm - fingers * palm.dot(fingers)).try_normalize()?;
        let frame = |f: DVec3, p: DVec3| DMat3::from_cols(f, p, f.cross(p));
        let rest = frame(self.rest_fingers(), -DVec3::Y);
        Some(DQuat::from_mat3(&(frame(fingers, palm) * rest.transpose())).normalize())
    }

    /// Where fingers and palm of a hand with that model rotation look, unit vectors.
    pub fn fingers_and_palm(&self, rotation: DQuat) -> (DVec3, DVec3) {
        (rotation * self.rest_fingers(), rotation * -DVec3::Y)
    }

    /// Writes a solved arm into a pose: upper arm, forearm, hand, and the forearm's skin by its share of the turn.
    pub fn write(&self, arm: &ArmPose, pose: &mut LocalPose) {
        pose.set(self.upper, arm.upper);
        pose.set(self.fore, arm.fore);
        pose.set(self.hand, arm.hand);
        self.write_twist(arm.angles.twist, pose);
    }

    /// Turns the forearm's skin joints by their share of the forearm's turn (radians).
    pub fn write_twist(&self, twist: f64, pose: &mut LocalPose) {
        for (joint, share) in &self.twists {
            pose.set(*joint, twist_share(self.rest.fore(), twist, *share));
        }
    }

    /// Turns the forearm's skin joints further, by their share of a change of the forearm's turn (radians).
    pub fn add_twist(&self, change: f64, pose: &mut LocalPose) {
        for (joint, share) in &self.twists {
            pose.set(*joint, unit(twist_share(self.rest.fore(), change, *share) * pose.rotation(*joint)));
        }
    }
}

/// How far a wrist goes: facts/phonology.md §1 (AAOS), radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WristLimits {
    /// Toward the palm.
    pub flexion: f64,
    /// Toward the back of the hand.
    pub extension: f64,
    /// Toward the thumb.
    pub radial: f64,
    /// Toward the little finger.
    pub ulnar: f64,
    /// The forearm's turn to either side of the middle.
    pub twist: f64,
}

impl WristLimits {
    /// The limits of a healthy wrist.
    pub const ANATOMICAL: WristLimits = WristLimits {
        flexion: 75.0 * DEGREE,
        extension: 70.0 * DEGREE,
        radial: 20.0 * DEGREE,
        ulnar: 35.0 * DEGREE,
        twist: 85.0 * DEGREE,
    };

    /// Every limit multiplied by a share, for the range that is comfortable.
    pub fn scaled(self, share: f64) -> WristLimits {
        WristLimits {
            flexion: self.flexion * share,
            extension: self.extension * share,
            radial: self.radial * share,
            ulnar: self.ulnar * share,
            twist: self.twist * share,
        }
    }

    /// How far the angles lie outside, squared and summed, radians².
    pub fn excess(&self, angles: &ArmAngles) -> f64 {
        let over = |value: f64, least: f64, greatest: f64| (value - value.clamp(least, greatest)).powi(2);
        over(angles.flexion, -self.extension, self.flexion)
            + over(angles.radial, -self.ulnar, self.radial)
            + over(angles.twist, -self.twist, self.twist)
    }

    /// The limit most exceeded, in words: what would have to bend how far, degrees.
    pub fn complaint(&self, angles: &ArmAngles) -> Option<String> {
        let ways = [
            (angles.flexion - self.flexion, "bend to the palm", angles.flexion, self.flexion),
            (-angles.flexion - self.extension, "bend to the back of the hand", -angles.flexion, self.extension),
            (angles.radial - self.radial, "bend to the thumb", angles.radial, self.radial),
            (-angles.radial - self.ulnar, "bend to the little finger", -angles.radial, self.ulnar),
            (angles.twist.abs() - self.twist, "turn with the forearm", angles.twist.abs(), self.twist),
        ];
        let (over, way, wanted, limit) = ways.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
        let degrees = |angle: f64| angle.to_degrees().round();
        (over > 1e-6).then(|| format!("the wrist would {way} {}°, it goes to {}°", degrees(wanted), degrees(limit)))
    }

    /// The nearest angles inside: turn, flexion and radial deviation, radians.
    pub fn clamp(&self, angles: &ArmAngles) -> (f64, f64, f64) {
        (
            angles.twist.clamp(-self.twist, self.twist),
            angles.flexion.clamp(-self.extension, self.flexion),
            angles.radial.clamp(-self.ulnar, self.radial),
        )
    }
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;
