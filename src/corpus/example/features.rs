//! What is compared of a motion: of each hand its shape, where it looks, where it is and how it moves.
//!
//! The four groups are the components of phonology. Each is measured in a unit in which two clearly different values are about 1
//! apart, then weighted: joints and fingertips in the hand's own frame and in hand lengths, so that neither the size of a hand nor its turn
//! counts twice; palm and fingers as directions; the wrist in hand lengths; its velocity in hand lengths a second. A left hand is
//! taken as the right hand that mirrors it.
//!
//! # Conventions
//! Joints have the names of the rig (`RightHand`, `RightHandIndex1`); other joints do not matter, and a hand without a body will
//! do. Hand frame: X toward the thumb's side, Y toward the middle knuckle, Z out of the palm.

use super::Motion;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::pose::ModelPose;
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::{Digit, Side};
use crate::time::{Fps, FrameIndex, Seconds};
use glam::DVec3;

/// The root mean square way of joints and tips, hand lengths, at which two handshapes are clearly different.
const SHAPES_APART: f64 = 0.25;
/// The same for the direction of palm and fingers: a right angle is √2.
const DIRECTIONS_APART: f64 = 1.0;
/// The same for places, hand lengths.
const PLACES_APART: f64 = 1.0;
/// The same for velocities, hand lengths a second.
const VELOCITIES_APART: f64 = 4.0;
/// Velocity is taken over so many frames on both sides: that of neighbouring ones is mostly noise.
const VELOCITY_REACH: usize = 2;
/// The longest motion, frames: ten hours at 60 frames a second.
const MOST_FRAMES: usize = 2_160_000;

/// What the wrist's place is measured from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The middle of the shoulders in each frame, where the clip has them; else as [`Reference::Space`].
    Body,
    /// Where the wrist is at the start: for motions that are laid on each other as a whole.
    Start,
    /// The clip's own space: for recordings of a sensor that did not move.
    Space,
}

/// What counts how much, and how features are taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Frames per second of the features.
    pub fps: Fps,
    /// What places are measured from.
    pub reference: Reference,
    /// The weight of the hand's shape.
    pub configuration: f64,
    /// The weight of palm and fingers.
    pub orientation: f64,
    /// The weight of the place.
    pub placement: f64,
    /// The weight of the velocity.
    pub movement: f64,
}

impl Default for Options {
    /// 30 frames a second, from the body, all components alike.
    fn default() -> Options {
        Options {
            fps: Fps::new(30.0).expect("30 is a frame rate"),
            reference: Reference::Body,
            configuration: 1.0,
            orientation: 1.0,
            placement: 1.0,
            movement: 1.0,
        }
    }
}

/// Numbers a frame of one hand: fifteen points, two directions, place and velocity.
pub const DIMS_A_HAND: usize = SHAPE_DIMS + DIRECTION_DIMS + 3 + 3;
/// Numbers of a hand's shape, the first ones.
pub(super) const SHAPE_DIMS: usize = 45;
/// Numbers of palm and fingers, the next ones; place and velocity follow.
pub(super) const DIRECTION_DIMS: usize = 6;

/// The features of a clip's hands, those of one side after those of another.
///
/// # Errors
/// No side; a joint of the hand that the clip lacks; a hand without length; a clip longer than ten hours; positions that are not finite.
///
/// ```
/// use chereme::corpus::example::features::{DIMS_A_HAND, Options, features_of};
/// use chereme::motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton};
/// use chereme::phonology::Side;
/// use chereme::time::Fps;
/// use std::sync::Arc;
/// let rig = Arc::new(Skeleton::from_json(chereme::avatar::SKELETON).unwrap());
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: Vec::new() };
/// let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(Vec::new()), vec![rest; 61]).unwrap();
/// let motion = features_of(&clip, &[Side::Right], &Options::default()).unwrap();
/// assert_eq!((motion.len(), motion.dims()), (31, DIMS_A_HAND));
/// ```
pub fn features_of(clip: &Clip, sides: &[Side], options: &Options) -> Result<Motion, Error> {
    let count = options.fps.frame_count(clip.duration());
    if sides.is_empty() || count > MOST_FRAMES {
        return Err(Error::new(format!("{} hands over {count} frames cannot be compared", sides.len())));
    }
    let skeleton = clip.skeleton();
    let hands = sides.iter().map(|side| Hand::of(skeleton, *side)).collect::<Result<Vec<Hand>, Error>>()?;
    let shoulders = (skeleton.find("LeftArm"), skeleton.find("RightArm"));
    let posed = |frame: usize| -> Vec<Posed> {
        let pose = clip.frames()[frame].pose.to_model(skeleton);
        let origin = match (options.reference, shoulders) {
            (Reference::Body, (Some(l), Some(r))) => (pose.position(l) + pose.position(r)) / 2.0,
            _ => DVec3::ZERO,
        };
        hands.iter().map(|hand| hand.posed(&pose, origin)).collect()
    };
    let rate = clip.fps().get() / options.fps.get();
    let last = clip.frames().len() - 1;
    let row = |frame: usize| {
        // Between two frames of the clip points go straight.
        let at = (frame as f64 * rate).min(last as f64);
        let (before, w) = (at.floor() as usize, at.fract());
        let here = posed(before);
        if w < 1e-9 {
            return here;
        }
        here.iter().zip(posed(before + 1)).map(|(a, b)| a.between(&b, w)).collect()
    };
    let rows: Vec<Vec<Posed>> = (0..count).map(row).collect();
    let mut values = Vec::with_capacity(count * hands.len() * DIMS_A_HAND);
    for frame in 0..count {
        for hand in 0..hands.len() {
            put(&rows, frame, hand, options, &mut values);
        }
    }
    Motion::new(options.fps, hands.len() * DIMS_A_HAND, &values)
}

/// The joints of a hand.
struct Hand {
    side: Side,
    wrist: JointId,
    /// The three joints of each digit.
    digits: [[JointId; 3]; 5],
    /// From the last joint of each digit to its tip, rest axes, metres.
    tips: [DVec3; 5],
    /// From the wrist along the middle finger to its tip, metres.
    length: f64,
}

/// A hand in a frame, as a right one, in hand lengths.
#[derive(Debug, Clone, Copy)]
struct Posed {
    /// The second and third joint and the tip of each digit, in the hand's frame.
    points: [DVec3; 15],
    fingers: DVec3,
    palm: DVec3,
    wrist: DVec3,
}

impl Hand {
    fn of(skeleton: &Skeleton, side: Side) -> Result<Hand, Error> {
        let prefix = match side {
            Side::Left => "LeftHand",
            Side::Right => "RightHand",
        };
        let mut digits = [[JointId(0); 3]; 5];
        for (digit, joints) in Digit::ALL.into_iter().zip(&mut digits) {
            let mut title = digit.name().to_owned();
            title[..1].make_ascii_uppercase();
            for (k, joint) in joints.iter_mut().enumerate() {
                *joint = skeleton.joint(&format!("{prefix}{title}{}", k + 1))?;
            }
        }
        let wrist = skeleton.joint(prefix)?;
        let tips = digits.map(|[.., last]| skeleton[last].tail_model - skeleton[last].rest_model);
        let bones = digits[Digit::Middle as usize].map(|joint| skeleton.offset(joint).length());
        let length = bones.iter().sum::<f64>() + tips[Digit::Middle as usize].length();
        if !(length > 1e-6 && length.is_finite()) {
            return Err(Error::new(format!("{prefix} has no length")));
        }
        Ok(Hand { side, wrist, digits, tips, length })
    }

    fn posed(&self, pose: &ModelPose, origin: DVec3) -> Posed {
        // A left hand is mirrored: what follows then makes a right one.
        let right = |v: DVec3| match self.side {
            Side::Left => DVec3::new(-v.x, v.y, v.z),
            Side::Right => v,
        };
        let at = |joint: JointId| right(pose.position(joint));
        let wrist = at(self.wrist);
        let knuckle = |digit: Digit| at(self.digits[digit as usize][0]);
        let fingers = (knuckle(Digit::Middle) - wrist).normalize_or(DVec3::Y);
        let across = knuckle(Digit::Index) - knuckle(Digit::Pinky);
        let thumb_side = (across - fingers * across.dot(fingers)).normalize_or(fingers.any_orthonormal_vector());
        let palm = thumb_side.cross(fingers);
        let points = std::array::from_fn(|i| {
            let (digit, k) = (i / 3, i % 3);
            let [_, second, third] = self.digits[digit];
            let point = match k {
                0 => at(second),
                1 => at(third),
                _ => right(pose.point(third, self.tips[digit])),
            };
            let from = point - wrist;
            DVec3::new(from.dot(thumb_side), from.dot(fingers), from.dot(palm)) / self.length
        });
        Posed { points, fingers, palm, wrist: (wrist - right(origin)) / self.length }
    }
}

impl Posed {
    /// Between two frames.
    fn between(&self, to: &Posed, w: f64) -> Posed {
        Posed {
            points: std::array::from_fn(|i| self.points[i].lerp(to.points[i], w)),
            fingers: self.fingers.lerp(to.fingers, w).normalize_or(self.fingers),
            palm: self.palm.lerp(to.palm, w).normalize_or(self.palm),
            wrist: self.wrist.lerp(to.wrist, w),
        }
    }
}

/// The numbers of a hand in a frame.
fn put(rows: &[Vec<Posed>], frame: usize, hand: usize, options: &Options, values: &mut Vec<f32>) {
    let now = &rows[frame][hand];
    let mut add = |v: DVec3, scale: f64| values.extend((v * scale).to_array().map(|x| x as f32));
    // Several vectors of a group count as their mean square.
    let shape = options.configuration / (SHAPES_APART * 15f64.sqrt());
    now.points.iter().for_each(|point| add(*point, shape));
    let direction = options.orientation / (DIRECTIONS_APART * 2f64.sqrt());
    add(now.fingers, direction);
    add(now.palm, direction);
    let from = if options.reference == Reference::Start { rows[0][hand].wrist } else { DVec3::ZERO };
    add(now.wrist - from, options.placement / PLACES_APART);
    let (before, after) = (frame.saturating_sub(VELOCITY_REACH), (frame + VELOCITY_REACH).min(rows.len() - 1));
    let time = options.fps.time_of(FrameIndex(after)) - options.fps.time_of(FrameIndex(before));
    let way = rows[after][hand].wrist - rows[before][hand].wrist;
    let velocity = if time > Seconds(0.0) { way / time.0 } else { DVec3::ZERO };
    add(velocity, options.movement / VELOCITIES_APART);
}
