//! Measuring a pose in phonological terms: the form of a hand, where fingers and palm look, which handshape it is.
//!
//! # Conventions
//! A form is fifteen points of a hand in its own axes, those of the left hand at rest (+X along the stretched fingers, +Y out of its
//! back, +Z to the thumb's side), from the wrist, metres. The right hand's is mirrored, so that forms of both hands compare.
//! Distances between forms are millimetres of skin-deep points, because a degree at a knuckle moves a finger farther than one at
//! the last joint.

use super::signer::Signer;
use crate::motion::pose::LocalPose;
use crate::phonology::handshape::{HandAngles, HandshapeInventory};
use crate::phonology::{Digit, HandPoint, Side};
use glam::{DQuat, DVec3};

/// The points of a form: for each digit, from thumb to little finger, its second and third joint and its end.
pub const FORM_POINTS: usize = 15;

/// How far two tips may be apart so that two shapes are still the same, metres (4 mm).
pub const SAME_TIP_M: f64 = 4e-3;

/// The form of a hand: its digits as points in the hand's axes, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandForm(pub [DVec3; FORM_POINTS]);

impl HandForm {
    /// The form of a hand in a pose.
    ///
    /// ```
    /// use chereme::body::measure::HandForm;
    /// use chereme::motion::pose::LocalPose;
    /// use chereme::phonology::Side;
    /// let signer = chereme::avatar::signer().unwrap();
    /// let rest = LocalPose::rest(&signer.skeleton);
    /// let [left, right] = [Side::Left, Side::Right].map(|side| HandForm::of(&signer, side, &rest));
    /// assert!(left.tips_apart(&right) < 1e-6);
    /// ```
    pub fn of(signer: &Signer, side: Side, pose: &LocalPose) -> HandForm {
        let (hand, skeleton) = (signer.hand(side), &signer.skeleton);
        let mut points = [DVec3::ZERO; FORM_POINTS];
        let mirror = DVec3::new(side.sign(), 1.0, 1.0);
        for (three, digit) in points.chunks_exact_mut(3).zip(Digit::ALL) {
            let joints = hand.of_digit(digit);
            let (mut at, mut turned) = (DVec3::ZERO, DQuat::IDENTITY);
            for (n, joint) in joints.into_iter().enumerate() {
                at += turned * skeleton.offset(joint);
                turned *= pose.rotation(joint);
                if n > 0 {
                    three[n - 1] = at * mirror;
                }
            }
            let last = &skeleton[joints[2]];
            three[2] = (at + turned * (last.tail_model - last.rest_model)) * mirror;
        }
        HandForm(points)
    }

    /// The form of a hand with these joint angles.
    pub fn of_angles(signer: &Signer, angles: &HandAngles) -> HandForm {
        let mut pose = LocalPose::rest(&signer.skeleton);
        signer.hand(Side::Left).apply(angles, &mut pose);
        HandForm::of(signer, Side::Left, &pose)
    }

    /// The end of a digit, in the hand's axes, metres.
    pub fn tip(&self, digit: Digit) -> DVec3 {
        self.0[3 * digit as usize + 2]
    }

    /// How far the ends of the digits are from those of another form at most, metres.
    pub fn tips_apart(&self, other: &HandForm) -> f64 {
        Digit::ALL.into_iter().map(|digit| self.tip(digit).distance(other.tip(digit))).fold(0.0, f64::max)
    }

    /// The root of the mean square distance of all points, metres: how alike two hands are as wholes.
    pub fn distance(&self, other: &HandForm) -> f64 {
        let squares = self.0.iter().zip(&other.0).map(|(a, b)| a.distance_squared(*b)).sum::<f64>();
        (squares / FORM_POINTS as f64).sqrt()
    }

    /// Whether no digit's end is farther from the other's than [`SAME_TIP_M`].
    pub fn is_same(&self, other: &HandForm) -> bool {
        self.tips_apart(other) < SAME_TIP_M
    }
}

/// The forms of an inventory's handshapes on a signer's hand.
#[derive(Debug, Clone)]
pub struct HandForms {
    shapes: Vec<ShapeForm>,
}

/// A handshape's form.
#[derive(Debug, Clone)]
pub struct ShapeForm {
    /// Its id in the inventory.
    pub id: String,
    /// The point that touches a place where nothing else is said.
    pub touches_with: HandPoint,
    /// Its form.
    pub form: HandForm,
}

/// A handshape that a form is near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// The number of the shape, of [`HandForms::shapes`].
    pub shape: usize,
    /// Its distance, metres ([`HandForm::distance`]).
    pub distance: f64,
    /// How much farther the next shape is that is not the same; metres.
    pub ahead: f64,
}

impl HandForms {
    /// The forms of all handshapes, in the inventory's order.
    pub fn new(handshapes: &HandshapeInventory, signer: &Signer) -> HandForms {
        let form = |shape: &crate::phonology::Handshape| ShapeForm {
            id: shape.id.clone(),
            touches_with: shape.touches_with,
            form: HandForm::of_angles(signer, &shape.angles()),
        };
        HandForms { shapes: handshapes.shapes().iter().map(form).collect() }
    }

    /// The shapes, in the inventory's order.
    pub fn shapes(&self) -> &[ShapeForm] {
        &self.shapes
    }

    /// The shape nearest to a form, the first of equals; `None` where the inventory is empty.
    ///
    /// ```
    /// use chereme::body::measure::HandForms;
    /// use chereme::phonology::HandshapeInventory;
    /// let signer = chereme::avatar::signer().unwrap();
    /// let forms = HandForms::new(&HandshapeInventory::builtin(), &signer);
    /// let nearest = forms.nearest(&forms.shapes()[7].form).unwrap();
    /// assert!(nearest.distance < 1e-9 && forms.are_same(nearest.shape, 7));
    /// ```
    pub fn nearest(&self, form: &HandForm) -> Option<Nearest> {
        let far = |(i, shape): (usize, &ShapeForm)| (i, shape.form.distance(form));
        let (shape, distance) = self.shapes.iter().enumerate().map(far).min_by(|a, b| a.1.total_cmp(&b.1))?;
        let others = self.shapes.iter().enumerate().filter(|(i, _)| !self.are_same(shape, *i)).map(far);
        let ahead = others.map(|(_, far)| far - distance).fold(f64::INFINITY, f64::min);
        Some(Nearest { shape, distance, ahead })
    }

    /// Whether two shapes are the same on this hand: no digit's end 4 mm apart.
    pub fn are_same(&self, a: usize, b: usize) -> bool {
        a == b || self.shapes[a].form.is_same(&self.shapes[b].form)
    }
}
