//! How different two values of a component are: from 0, the same, to 1, nothing alike.
//!
//! Near queries rank by these ([`crate::corpus`]). Hand configurations are compared by where joints and fingertips are,
//! not by angles: half a radian at a knuckle moves the whole finger, the same at a last joint hardly anything. Orientations are compared
//! by the angles between headings, movements by kind, direction, size and repetition. Places need a body and are compared in
//! `corpus`.
//!
//! # Laws
//! Every distance here is symmetric and 0 from a value to itself; those of hands, headings and single courses keep the triangle inequality.
//! Two values that differ in what is not compared (manner, the name of a handshape) are at distance 0.

use super::direction::Heading;
use super::handshape::{FingerAngles, HandAngles, ThumbAngles};
use super::orientation::Orientation;
use glam::DVec3;

/// Lengths of the phalanges, millimetres: index, middle, ring, little finger; then the thumb's three bones (Buryanov & Kotiuk 2010).
const BONES: [[f64; 3]; 5] =
    [[39.8, 22.4, 15.8], [44.6, 26.3, 17.4], [41.4, 25.7, 17.3], [32.7, 18.1, 16.0], [46.2, 31.6, 21.7]];

/// The mean way of the fifteen points that counts as 1, millimetres: a little more than between any two hands of the inventory (W and Y,
/// 88.4 mm; the spread hand and the fist are 81.1 mm apart).
const SPAN: f64 = 89.0;

/// Where the fifteen joints and tips of a generic hand are, for comparing many hands.
///
/// ```
/// use chereme::phonology::distance::HandPoints;
/// use chereme::phonology::handshape::HandshapeInventory;
/// let inventory = HandshapeInventory::builtin();
/// let hand = |name: &str| HandPoints::of(&inventory.find(name, None).unwrap().angles());
/// let (four, five, fist) = (hand("4"), hand("5"), hand("S"));
/// assert!(five.distance(&four) < five.distance(&fist));
/// assert_eq!(five.distance(&five), 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandPoints([DVec3; 15]);

impl HandPoints {
    /// The points of a hand: of each digit the two joints after the first, and the tip, millimetres from the digit's first joint
    /// (toward the thumb's side, toward the fingers, out of the palm).
    pub fn of(angles: &HandAngles) -> HandPoints {
        let mut points = [DVec3::ZERO; 15];
        for (i, finger) in angles.fingers.iter().enumerate() {
            points[3 * i..3 * i + 3].copy_from_slice(&chain(finger_directions(finger, i), BONES[i]));
        }
        points[12..].copy_from_slice(&chain(thumb_directions(&angles.thumb), BONES[4]));
        HandPoints(points)
    }

    /// The mean distance of the fifteen points in units of the farthest two hands of the inventory; at most 1.
    pub fn distance(&self, other: &HandPoints) -> f64 {
        let sum: f64 = self.0.iter().zip(&other.0).map(|(a, b)| a.distance(*b)).sum();
        (sum / (15.0 * SPAN)).min(1.0)
    }
}

/// How different two hand configurations are; see [`HandPoints::distance`].
///
/// ```
/// use chereme::phonology::{HandAngles, distance::configurations};
/// assert_eq!(configurations(&HandAngles::default(), &HandAngles::default()), 0.0);
/// ```
pub fn configurations(a: &HandAngles, b: &HandAngles) -> f64 {
    HandPoints::of(a).distance(&HandPoints::of(b))
}

/// The joints after a chain's first one and its end, from its first joint.
fn chain(directions: [DVec3; 3], lengths: [f64; 3]) -> [DVec3; 3] {
    let mut at = DVec3::ZERO;
    std::array::from_fn(|k| {
        at += directions[k] * lengths[k];
        at
    })
}

/// The directions of a finger's bones: its plane is turned by the abduction, the bones bend in it.
fn finger_directions(f: &FingerAngles, finger: usize) -> [DVec3; 3] {
    // Ring and little finger go away from the middle one to the little finger's side.
    let side = if finger < 2 { f.abduction } else { -f.abduction };
    let straight = DVec3::new(side.sin(), side.cos(), 0.0);
    [f.mcp, f.mcp + f.pip, f.mcp + f.pip + f.dip].map(|bend| straight * bend.cos() + DVec3::Z * bend.sin())
}

/// The directions of the thumb's bones (`phonology::handshape`, Conventions): the pad looks to the little finger's side at no
/// pronation, and the bones bend toward it.
fn thumb_directions(t: &ThumbAngles) -> [DVec3; 3] {
    let along = DVec3::new(t.radial.sin() * t.palmar.cos(), t.radial.cos() * t.palmar.cos(), t.palmar.sin());
    let zero = -DVec3::X + along * along.x;
    let zero = zero.try_normalize().unwrap_or_else(|| along.any_orthonormal_vector());
    let pad = zero * t.pronation.cos() + zero.cross(along) * t.pronation.sin();
    [0.0, t.mcp, t.mcp + t.ip].map(|bend| along * bend.cos() + pad * bend.sin())
}

/// The angle between two headings, as a part of the half turn.
///
/// ```
/// use chereme::phonology::{Direction, distance::headings};
/// assert!((headings(Direction::UP.into(), Direction::DOWN.into()) - 1.0).abs() < 1e-12);
/// assert!((headings(Direction::UP.into(), Direction::OUT.into()) - 0.5).abs() < 1e-12);
/// ```
pub fn headings(a: Heading, b: Heading) -> f64 {
    // The angle of the sine keeps equal headings at exactly 0, where the arc cosine has lost half its digits.
    let (a, b) = (a.vector(), b.vector());
    a.cross(b).length().atan2(a.dot(b)) / std::f64::consts::PI
}

/// The mean of the angles between fingers and between palms, of what both say; `None` where they say nothing in common.
///
/// ```
/// use chereme::phonology::{Direction, Orientation, distance::orientations};
/// let up = Orientation { palm: Some(Direction::UP.into()), ..Orientation::default() };
/// let out = Orientation { fingers: Some(Direction::OUT.into()), ..up };
/// assert_eq!(orientations(&up, &out), Some(0.0));
/// assert_eq!(orientations(&up, &Orientation::default()), None);
/// ```
pub fn orientations(a: &Orientation, b: &Orientation) -> Option<f64> {
    let both = [(a.fingers, b.fingers), (a.palm, b.palm)];
    let (mut sum, mut count) = (0.0, 0);
    for (a, b) in both {
        if let (Some(a), Some(b)) = (a, b) {
            sum += headings(a, b);
            count += 1;
        }
    }
    (count > 0).then(|| sum / f64::from(count))
}

/// What kind of movement a hand makes, as far as it is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CourseKind {
    /// None: the posture is held.
    Hold,
    /// The posture changes, the hand stays.
    Change,
    /// Back to an earlier place.
    Return,
    /// A straight path.
    Straight,
    /// A bent path.
    Arc,
    /// A circle or an ellipse.
    Circle,
    /// The wrist bends to and fro.
    Nod,
    /// The wrist goes from side to side.
    Swing,
    /// The forearm turns.
    Twist,
    /// The hand stirs.
    Stir,
    /// The fingers play.
    Wiggle,
}

impl CourseKind {
    /// Held, along a path, or in the hand.
    fn family(self) -> u8 {
        match self {
            CourseKind::Hold | CourseKind::Change => 0,
            CourseKind::Return | CourseKind::Straight | CourseKind::Arc | CourseKind::Circle => 1,
            CourseKind::Nod | CourseKind::Swing | CourseKind::Twist | CourseKind::Stir | CourseKind::Wiggle => 2,
        }
    }
}

/// One movement of a hand, as far as it is compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// The kind.
    pub kind: CourseKind,
    /// Where to: of an arc its chord, of a circle its axis.
    pub direction: Option<Heading>,
    /// How far, metres, above 0; of a circle its radius.
    pub metres: Option<f64>,
    /// Performances in all, at least 1.
    pub times: u8,
}

/// What part of the whole each way to differ is: kind, direction, size, repetition. Kind and direction tell lexical movements apart;
/// size and number of repetitions vary between performances of one sign.
const WEIGHTS: [f64; 4] = [0.4, 0.4, 0.1, 0.1];
/// Two kinds of one family (straight and arc) differ by this part.
const KINDRED: f64 = 0.5;
/// Sizes that differ by this factor are as different as sizes can be.
const SIZES_APART: f64 = 8.0;

impl Course {
    /// How different two movements are: a weighted sum of the differences of kind, direction, size and repetition.
    ///
    /// A direction that only one of them has counts as a right angle, a size as half the greatest difference.
    ///
    /// ```
    /// use chereme::phonology::{Direction, distance::{Course, CourseKind}};
    /// let up = Course { kind: CourseKind::Straight, direction: Some(Direction::UP.into()), metres: Some(0.1), times: 1 };
    /// let down = Course { direction: Some(Direction::DOWN.into()), ..up };
    /// let bent = Course { kind: CourseKind::Arc, ..up };
    /// assert_eq!(up.distance(&up), 0.0);
    /// assert!(up.distance(&bent) < up.distance(&down));
    /// ```
    pub fn distance(&self, other: &Course) -> f64 {
        let kind = match (self.kind == other.kind, self.kind.family() == other.kind.family()) {
            (true, _) => 0.0,
            (false, true) => KINDRED,
            (false, false) => 1.0,
        };
        let direction = match (self.direction, other.direction) {
            (Some(a), Some(b)) => headings(a, b),
            (None, None) => 0.0,
            _ => 0.5,
        };
        let size = match (self.metres, other.metres) {
            (Some(a), Some(b)) if a > 0.0 && b > 0.0 => ((a.ln() - b.ln()).abs() / SIZES_APART.ln()).min(1.0),
            (None, None) => 0.0,
            _ => 0.5,
        };
        let times = f64::from(u8::from((self.times > 1) != (other.times > 1)));
        WEIGHTS[0] * kind + WEIGHTS[1] * direction + WEIGHTS[2] * size + WEIGHTS[3] * times
    }
}

/// How different two sequences of movements are: the least cost of making one of the other, where a changed movement costs its distance and
/// one left out or put in costs 1, as a part of the longer one's length (Levenshtein 1966, weighted).
///
/// ```
/// use chereme::phonology::distance::{Course, CourseKind, courses};
/// let hold = Course { kind: CourseKind::Hold, direction: None, metres: None, times: 1 };
/// assert_eq!(courses(&[hold], &[hold, hold]), 0.5);
/// ```
pub fn courses(a: &[Course], b: &[Course]) -> f64 {
    let mut row: Vec<f64> = (0..=b.len()).map(|j| j as f64).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = (i + 1) as f64;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + x.distance(y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1.0).min(row[j] + 1.0);
        }
    }
    row[b.len()] / (a.len().max(b.len()).max(1) as f64)
}
