//! Landmarks: the named places of the body and the contact points of the hands, on the avatar's skin.
//!
//! A landmark rests at an offset from one joint and is carried along by it. The table
//! (`grammar/landmarks.ron`) is picked on the mesh by `tools/pick_landmarks.py`, rays cast at the T-pose; it
//! holds the middle and the left, and the right is made here as the exact mirror image.
//!
//! # Conventions
//! Model space, metres; offsets and normals are in the axes of the rest pose (X left, Y up, Z out), which the
//! joints' rotations turn. Normals are unit vectors that point out of the body. *A* is the arm length,
//! shoulder to elbow to wrist.
//!
//! # Distances
//! Touch is 0, close 0.12 A, neutral 0.42 A along the place's normal; extended is where the hand is 0.95 of its
//! reach from the shoulder.

use super::landmark_table::{Point, Table};
use crate::diagnostics::{Error, Source};
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::grammar::read_table;
use crate::phonology::{Digit, Distance, Flank, HandPart, HandPoint, Lateral, Side, Space};
use glam::DVec3;
use std::collections::{BTreeMap, HashMap};

/// How far from the skin `close` is, arm lengths.
pub const CLOSE_ARMS: f64 = 0.12;
/// How far from the skin `neutral` is, arm lengths.
pub const NEUTRAL_ARMS: f64 = 0.42;
/// The part of the reach at which `extended` is.
pub const EXTENDED_REACH: f64 = 0.95;
/// The neutral place from the middle of the shoulders, arm lengths (x left, y up, z out).
pub const NEUTRAL_PLACE_ARMS: DVec3 = DVec3::new(0.0, -0.28, 0.648);
/// One step of the grid of signing space, arm lengths (x left, y up, z out).
pub const SPACE_STEP_ARMS: DVec3 = DVec3::new(0.4, 0.3, 0.25);
/// How far to the side the neutral place's left and right are, arm lengths: half a step of the grid; beside is one and a half.
const NEUTRAL_AT_ARMS: f64 = 0.2;

/// A point on the skin that rides on one joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landmark {
    /// The joint that carries it.
    pub joint: JointId,
    /// Where it is from the joint at rest, metres, rest axes.
    pub offset: DVec3,
    /// Out of the body, rest axes, unit length.
    pub normal: DVec3,
}

impl Landmark {
    /// Where it is in a pose, model space, metres.
    pub fn position(&self, pose: &ModelPose) -> DVec3 {
        pose.point(self.joint, self.offset)
    }

    /// Out of the skin in a pose, model space, unit length.
    pub fn normal(&self, pose: &ModelPose) -> DVec3 {
        pose.rotation(self.joint) * self.normal
    }
}

/// A contact point of a hand or arm: one landmark, or the middle of those of several digits.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPoint {
    parts: Vec<Landmark>,
}

impl ContactPoint {
    /// The middle of landmarks, of which there is at least one.
    pub(crate) fn of(parts: Vec<Landmark>) -> ContactPoint {
        ContactPoint { parts }
    }

    /// The point moved by a vector in its joints' rest axes, metres.
    pub(crate) fn moved(mut self, by: DVec3) -> ContactPoint {
        self.parts.iter_mut().for_each(|part| part.offset += by);
        self
    }

    /// The landmarks whose middle it is; at least one.
    pub fn parts(&self) -> &[Landmark] {
        &self.parts
    }

    /// Where it is in a pose, model space, metres.
    pub fn position(&self, pose: &ModelPose) -> DVec3 {
        self.parts.iter().map(|p| p.position(pose)).sum::<DVec3>() / self.parts.len() as f64
    }

    /// Out of the skin in a pose, model space, unit length: the mean direction of the parts.
    pub fn normal(&self, pose: &ModelPose) -> DVec3 {
        let sum: DVec3 = self.parts.iter().map(|p| p.normal(pose)).sum();
        sum.try_normalize().unwrap_or_else(|| self.parts[0].normal(pose))
    }
}

/// A place of the body with its shifts to the sides.
#[derive(Debug, Clone, Copy)]
struct BodyPlace {
    /// `None` for what comes in two.
    centre: Option<Landmark>,
    /// Left at, left beside, right at, right beside.
    sides: [Landmark; 4],
}

/// The landmarks of one rig.
///
/// ```
/// use chereme::body::landmarks::Landmarks;
/// use chereme::motion::{pose::LocalPose, skeleton::Skeleton};
/// let skeleton = Skeleton::from_json(include_str!("../../assets/avatar.skeleton.json")).unwrap();
/// let landmarks = Landmarks::builtin(&skeleton).unwrap();
/// let rest = LocalPose::rest(&skeleton).to_model(&skeleton);
/// let nose = landmarks.body_place("nose", None).unwrap();
/// assert!(nose.position(&rest).z > 0.15 && nose.normal(&rest).z > 0.9);
/// ```
#[derive(Debug, Clone)]
pub struct Landmarks {
    body: BTreeMap<String, BodyPlace>,
    hand: HashMap<(Side, String), Landmark>,
    arm_length: f64,
    hand_length: f64,
    shoulders: [JointId; 2],
    wrists: [JointId; 2],
    neutral: Landmark,
}

impl Landmarks {
    /// The landmarks of the program's avatar, on its rig.
    ///
    /// # Errors
    /// Names the joint that the rig lacks.
    pub fn builtin(skeleton: &Skeleton) -> Result<Landmarks, Error> {
        Landmarks::from_source(&Landmarks::builtin_source(), skeleton)
    }

    /// The text of the table that comes with the program.
    pub fn builtin_source() -> Source {
        Source::new("grammar/landmarks.ron", include_str!("../../grammar/landmarks.ron"))
    }

    /// Reads a table of landmarks for a rig.
    ///
    /// # Errors
    /// Text that is not such a table (with line and column), a joint that the rig lacks (with the landmark), a
    /// number that is not finite, a normal without a direction.
    pub fn from_source(source: &Source, skeleton: &Skeleton) -> Result<Landmarks, Error> {
        let table: Table = read_table(source).map_err(|fault| {
            let (line, column) = source.line_column(fault.span.start);
            Error::new(format!("{}:{line}:{column}: {}", source.name, fault.message))
        })?;
        let mut body = BTreeMap::new();
        for (name, row) in &table.body {
            let put =
                |point: &Point, side: Side| point.on(skeleton, side).map_err(|e| e.context(format!("landmark {name}")));
            let centre = row.centre.as_ref().map(|point| put(point, Side::Left)).transpose()?;
            let sides = [
                put(&row.at, Side::Left)?,
                put(&row.beside, Side::Left)?,
                put(&row.at, Side::Right)?,
                put(&row.beside, Side::Right)?,
            ];
            body.insert(name.clone(), BodyPlace { centre, sides });
        }
        let mut hand = HashMap::new();
        for (name, point) in &table.hand {
            for side in [Side::Left, Side::Right] {
                let landmark = point.on(skeleton, side).map_err(|e| e.context(format!("landmark {name}")))?;
                hand.insert((side, name.clone()), landmark);
            }
        }
        Landmarks::measured(skeleton, body, hand)
    }

    /// Adds what follows from the skeleton alone: lengths, shoulders, the neutral place.
    fn measured(
        skeleton: &Skeleton,
        body: BTreeMap<String, BodyPlace>,
        hand: HashMap<(Side, String), Landmark>,
    ) -> Result<Landmarks, Error> {
        let at = |name: &str| skeleton.joint(name).map(|id| skeleton[id].rest_model);
        let (shoulder, elbow, wrist) = (at("LeftArm")?, at("LeftForeArm")?, at("LeftHand")?);
        let arm_length = shoulder.distance(elbow) + elbow.distance(wrist);
        let rest = LocalPose::rest(skeleton).to_model(skeleton);
        let tip = hand
            .get(&(Side::Left, "middle tip".to_string()))
            .ok_or_else(|| Error::new("there is no landmark \"middle tip\""))?;
        let hand_length = wrist.distance(tip.position(&rest));
        let shoulders = [skeleton.joint("LeftArm")?, skeleton.joint("RightArm")?];
        let wrists = [skeleton.joint("LeftHand")?, skeleton.joint("RightHand")?];
        let middle = (skeleton[shoulders[0]].rest_model + skeleton[shoulders[1]].rest_model) / 2.0;
        let joint = skeleton.joint("Spine2")?;
        let offset = middle + NEUTRAL_PLACE_ARMS * arm_length - skeleton[joint].rest_model;
        let neutral = Landmark { joint, offset, normal: DVec3::Z };
        Ok(Landmarks { body, hand, arm_length, hand_length, shoulders, wrists, neutral })
    }

    /// The landmark of a place of the body, or of the neutral place, by its id in the inventory of locations.
    ///
    /// A side of a place that comes in two chooses which; of any other it shifts along the skin: by half of the region's
    /// half-width, or beside it by one and a half. The neutral place is carried by the upper spine.
    ///
    /// # Errors
    /// No landmark of that id; a place that comes in two without a side.
    pub fn body_place(&self, id: &str, lateral: Option<Lateral>) -> Result<Landmark, Error> {
        if id == "neutral" {
            let shift = lateral.map_or(0.0, |l| l.side.sign() * if l.beside { 3.0 } else { 1.0 } * NEUTRAL_AT_ARMS);
            return Ok(Landmark { offset: self.neutral.offset + DVec3::X * shift * self.arm_length, ..self.neutral });
        }
        let place = self.body.get(id).ok_or_else(|| Error::new(format!("there is no landmark for the place {id}")))?;
        match lateral {
            None => place.centre.ok_or_else(|| Error::new(format!("{id} comes in two: say left or right"))),
            Some(Lateral { side, beside }) => {
                let first = if side == Side::Left { 0 } else { 2 };
                Ok(place.sides[first + usize::from(beside)])
            }
        }
    }

    /// The contact point of a hand or arm.
    ///
    /// A part with no face named is where it is touched: the side of a finger on the thumb's side (of the little finger on the outer side),
    /// the upper arm on its outer face, the lower arm on its back. Several digits mean their middle. The wrist is the joint
    /// itself; it has no skin, and its normal is that of the hand's back.
    ///
    /// A face that the table lacks is the part itself. Halfway to a second point is the middle of both.
    ///
    /// # Errors
    /// Names the landmark that the table lacks.
    pub fn hand_point(&self, side: Side, point: HandPoint) -> Result<ContactPoint, Error> {
        let first = self.spot(side, point.first())?;
        let Some(second) = point.second() else { return Ok(ContactPoint { parts: first }) };
        let second = self.spot(side, second)?;
        // Each counts half, however many digits it is the middle of.
        let (a, b) = (first.len(), second.len());
        let parts = first.into_iter().flat_map(|l| vec![l; b]).chain(second.into_iter().flat_map(|l| vec![l; a]));
        Ok(ContactPoint { parts: parts.collect() })
    }

    /// The landmarks of a point that lies halfway to no other.
    fn spot(&self, side: Side, point: HandPoint) -> Result<Vec<Landmark>, Error> {
        if point.part() == HandPart::Wrist {
            let joint = self.wrists[usize::from(side == Side::Right)];
            return Ok(vec![Landmark { joint, offset: DVec3::ZERO, normal: DVec3::Y }]);
        }
        let one = |digit: Option<Digit>| {
            let named = |flank| self.hand.get(&(side, landmark_name(digit, point.part(), flank))).copied();
            named(point.flank()).or_else(|| named(None)).ok_or_else(|| {
                let name = landmark_name(digit, point.part(), point.flank());
                Error::new(format!("there is no landmark for the hand's point \"{name}\""))
            })
        };
        if point.part().needs_digit() {
            point.digits().iter().map(|digit| one(Some(digit))).collect()
        } else {
            Ok(vec![one(None)?])
        }
    }

    /// A point of the signing space, carried by the upper spine; `arms` is from the middle of the shoulders, arm lengths
    /// (x left, y up, z out). Its normal points away from the signer.
    pub fn before(&self, arms: DVec3) -> Landmark {
        Landmark { offset: self.neutral.offset + (arms - NEUTRAL_PLACE_ARMS) * self.arm_length, ..self.neutral }
    }

    /// The ids of the places of the body that have a landmark, sorted.
    pub fn body_ids(&self) -> impl Iterator<Item = &str> {
        self.body.keys().map(String::as_str)
    }

    /// Shoulder to elbow to wrist, metres: the unit A.
    pub fn arm_length(&self) -> f64 {
        self.arm_length
    }

    /// Wrist to the tip of the middle finger, metres.
    pub fn hand_length(&self) -> f64 {
        self.hand_length
    }

    /// The joint of a shoulder (the upper arm's).
    pub fn shoulder(&self, side: Side) -> JointId {
        self.shoulders[usize::from(side == Side::Right)]
    }

    /// The middle of a cell of signing space, carried by the upper spine; its normal points away from the signer.
    ///
    /// The middle cell is the neutral place, chest height at mid distance.
    pub fn space(&self, cell: Space) -> Landmark {
        let steps = DVec3::new(cell.left.into(), cell.high.into(), cell.far.into());
        Landmark { offset: self.neutral.offset + steps * SPACE_STEP_ARMS * self.arm_length, ..self.neutral }
    }

    /// How far from the skin a distance is, metres along the place's normal.
    ///
    /// `unmarked` is the inventory's distance for the place, `from` the place and its normal (model space), `shoulder` the acting shoulder
    /// (model space, metres), `reach` how far from the shoulder the acting point can be, metres: the arm length for the wrist.
    /// `Extended` is where the ray leaves the sphere of 0.95 of the reach, and 0 where the place itself lies outside.
    pub fn metres(
        &self,
        distance: Distance,
        unmarked: Distance,
        from: (DVec3, DVec3),
        shoulder: DVec3,
        reach: f64,
    ) -> f64 {
        match distance {
            // An inventory never says "unmarked"; touch keeps the function total.
            Distance::Unmarked if unmarked == Distance::Unmarked => 0.0,
            Distance::Unmarked => self.metres(unmarked, Distance::Touch, from, shoulder, reach),
            Distance::Touch => 0.0,
            Distance::Close => CLOSE_ARMS * self.arm_length,
            Distance::Neutral => NEUTRAL_ARMS * self.arm_length,
            Distance::Metres(metres) => metres,
            Distance::Extended => {
                let (from, along) = (from.0 - shoulder, from.1);
                let (b, c) = (from.dot(along), from.length_squared() - (EXTENDED_REACH * reach).powi(2));
                let root = b * b - c;
                if root < 0.0 { 0.0 } else { (root.sqrt() - b).max(0.0) }
            }
        }
    }
}

/// The name of a hand's landmark in the table: face, digit, part.
fn landmark_name(digit: Option<Digit>, part: HandPart, flank: Option<Flank>) -> String {
    let words = [flank.map(Flank::name), digit.map(Digit::name), Some(part.name())];
    words.into_iter().flatten().collect::<Vec<_>>().join(" ")
}
