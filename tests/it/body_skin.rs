//! The skinned mesh, and the handshapes measured on it (golden expectation 40).

use crate::body_hand::skeleton;
use chereme::avatar;
use chereme::body::hand_skin::{HandBone, HandSkin};
use chereme::body::skin::{Skin, SkinPart};
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::JointId;
use chereme::phonology::handshape::{Handshape, HandshapeInventory, ThumbGoal};
use chereme::phonology::{Digit, Side};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

/// A square in the plane z = 0 that faces +Z, hung from the root joint.
fn square() -> Skin {
    let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let part = SkinPart {
        name: "square".to_owned(),
        positions: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
        normals: vec![DVec3::Z; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        joints: vec![[JointId(0); 4]; 4],
        weights: vec![[1.0, 0.0, 0.0, 0.0]; 4],
    };
    Skin::new(&skeleton(), &[part]).expect("a sound part")
}

fn hand(side: Side) -> HandSkin {
    let skeleton = skeleton();
    HandSkin::new(&skeleton, &avatar::skin(&skeleton).expect("the avatar's skin"), side).expect("the avatar has hands")
}

fn vertices(hand: &HandSkin, of: impl Fn(HandBone) -> bool) -> Vec<usize> {
    (0..hand.bones().len()).filter(|v| of(hand.bones()[*v])).collect()
}

#[test]
fn parts_that_do_not_hang_together_are_refused() {
    let broken = SkinPart { positions: vec![DVec3::ZERO], ..SkinPart::default() };
    assert!(Skin::new(&skeleton(), &[broken]).is_err());
}

#[test]
fn the_rest_pose_is_the_mesh_itself() {
    let skeleton = skeleton();
    let skin = avatar::skin(&skeleton).expect("the avatar's skin");
    let rest = LocalPose::rest(&skeleton).to_model(&skeleton);
    let mut turned = LocalPose::rest(&skeleton);
    turned.rotations[0] = DQuat::from_rotation_y(0.5);
    let turned = turned.to_model(&skeleton);
    let (still, moved) = (skin.pose(&rest), skin.pose(&turned));
    let root = skeleton.joints()[0].rest_model;
    for (a, b) in still.positions.iter().zip(&moved.positions) {
        assert!((root + DQuat::from_rotation_y(0.5) * (*a - root)).distance(*b) < 1e-4, "a turn of the root turns all");
    }
}

proptest! {
    #[test]
    fn nearest_agrees_with_the_plane(x in 0.0..1.0f64, y in 0.0..1.0f64, z in -0.5..0.5f64) {
        let (skin, skeleton) = (square(), skeleton());
        let posed = skin.pose(&LocalPose::rest(&skeleton).to_model(&skeleton));
        let found = posed.nearest(DVec3::new(x, y, z), None).expect("there are triangles");
        prop_assert!(found.point.distance(DVec3::new(x, y, 0.0)) < 1e-9);
        prop_assert!((found.signed_m - z).abs() < 1e-9);
    }

    #[test]
    fn nearest_is_no_farther_than_any_vertex(x in -2.0..2.0f64, y in -2.0..2.0f64, z in -2.0..2.0f64) {
        let (skin, skeleton) = (square(), skeleton());
        let posed = skin.pose(&LocalPose::rest(&skeleton).to_model(&skeleton));
        let at = DVec3::new(x, y, z);
        let found = posed.nearest(at, None).expect("there are triangles");
        let least = posed.positions.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min);
        prop_assert!(found.signed_m.abs() <= least + 1e-12);
    }
}

/// The greatest difference of a finger's angle from the table, degrees.
fn from_table(shape: &Handshape) -> f64 {
    let (a, b) = (shape.angles().to_array(), shape.table.to_array());
    a[..16].iter().zip(b).map(|(a, b)| (a - b).abs().to_degrees()).fold(0.0, f64::max)
}

#[test]
fn every_named_contact_is_made_on_the_mesh() {
    let hand = hand(Side::Left);
    let mut missed = Vec::new();
    for shape in HandshapeInventory::builtin().shapes() {
        let solved = shape.solved.expect("every row is solved: run tools/solve_handshapes.rs");
        let residual = hand.pose(&solved.angles).residual_mm(&shape.thumb);
        assert!((residual - solved.residual_mm).abs() < 0.1, "{}: {residual} is not as stored: solve again", shape.id);
        if shape.has_contact() && residual > 3.0 {
            missed.push(format!("{} {residual:.1} mm", shape.id));
        }
        if matches!(shape.thumb, ThumbGoal::Gap(..)) {
            assert!(residual < 5.0, "{} misses its gap by {residual} mm", shape.id);
        }
        assert!(from_table(shape) < 15.0, "{} is {}° from the table", shape.id, from_table(shape));
    }
    assert!(missed.is_empty(), "{missed:?}");
}

#[test]
fn no_fingertip_enters_the_palm_and_no_digit_another() {
    let hand = hand(Side::Left);
    let palm = vertices(&hand, |b| b == HandBone::Palm);
    let tips = vertices(&hand, |b| matches!(b, HandBone::Phalanx(_, 2)));
    let digit = |d: Digit| vertices(&hand, |b| matches!(b, HandBone::Phalanx(e, k) if e == d && k >= 1));
    let mut wrong = Vec::new();
    for shape in HandshapeInventory::builtin().shapes() {
        let posed = hand.pose(&shape.angles());
        let depth = posed.deepest_mm(&tips, &palm);
        if depth > 2.0 {
            wrong.push(format!("{}: {depth:.1} mm in the palm", shape.id));
        }
        for a in Digit::ALL {
            for b in Digit::ALL.into_iter().filter(|b| *b != a) {
                let depth = posed.deepest_mm(&digit(a), &digit(b));
                if depth > 3.5 {
                    wrong.push(format!("{}: {} {depth:.1} mm in {}", shape.id, a.name(), b.name()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn different_handshapes_differ_at_the_fingertips() {
    let hand = hand(Side::Left);
    let inventory = HandshapeInventory::builtin();
    let tips: Vec<_> = inventory.shapes().iter().map(|s| (&s.id, hand.pose(&s.angles()).tips())).collect();
    for (i, (a, p)) in tips.iter().enumerate() {
        for (b, q) in &tips[i + 1..] {
            let greatest = p.iter().zip(q).map(|(p, q)| p.distance(*q) * 1000.0).fold(0.0, f64::max);
            // Bent knuckles leave little of a spread: `bent-4` and `bent-B-across` are nearly one.
            assert!(greatest >= 3.5, "{a} and {b} differ by {greatest:.1} mm");
        }
    }
}

#[test]
fn the_right_hand_is_the_mirror_image_on_the_mesh() {
    let (left, right) = (hand(Side::Left), hand(Side::Right));
    for shape in HandshapeInventory::builtin().shapes() {
        let (l, r) = (left.pose(&shape.angles()).tips(), right.pose(&shape.angles()).tips());
        for (l, r) in l.into_iter().zip(r) {
            assert!(l.distance(r * DVec3::new(-1.0, 1.0, 1.0)) < 5e-4, "{}: {l} {r}", shape.id);
        }
    }
}
