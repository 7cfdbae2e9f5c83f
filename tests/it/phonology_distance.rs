//! Distances: laws over the whole inventory, and what a signer would call near.

use chereme::body::hand::HandRig;
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::{JointId, Skeleton};
use chereme::phonology::distance::{Course, CourseKind, HandPoints, courses, headings, orientations};
use chereme::phonology::{Digit, Direction, HandshapeInventory, Heading, Orientation, Side};
use glam::DVec3;
use proptest::prelude::*;

fn hands() -> Vec<(String, HandPoints)> {
    let inventory = HandshapeInventory::builtin();
    inventory.shapes().iter().map(|shape| (shape.id.clone(), HandPoints::of(&shape.angles()))).collect()
}

#[test]
fn configurations_keep_the_laws_of_a_distance_over_all_triples() {
    let hands = hands();
    let all: Vec<Vec<f64>> = hands.iter().map(|(_, a)| hands.iter().map(|(_, b)| a.distance(b)).collect()).collect();
    for (i, row) in all.iter().enumerate() {
        assert_eq!(row[i], 0.0);
        for (j, distance) in row.iter().enumerate() {
            assert!((0.0..=1.0).contains(distance));
            assert!(i == j || *distance > 0.0, "{} and {} are one hand", hands[i].0, hands[j].0);
            assert_eq!(*distance, all[j][i]);
            for k in 0..hands.len() {
                assert!(all[i][k] <= distance + all[j][k] + 1e-12, "{} {} {}", hands[i].0, hands[j].0, hands[k].0);
            }
        }
    }
}

#[test]
fn configurations_span_the_scale_and_order_hands_as_people_do() {
    let inventory = HandshapeInventory::builtin();
    let between = |a: &str, b: &str| {
        let points = |name: &str| HandPoints::of(&inventory.find(name, None).unwrap().angles());
        points(a).distance(&points(b))
    };
    let apart = between("5", "S");
    assert!((0.9..0.93).contains(&apart), "the spread hand and the fist: {apart}");
    assert!(between("5", "4") < between("5", "3") && between("5", "3") < between("5", "S"));
    assert!(between("U", "V") < between("U", "B") && between("1", "X") < between("1", "B"));
}

/// The generic hand of the distance against the avatar's: the same pairs are far apart, so that its fingers and thumb bend as the rig's do.
#[test]
fn configurations_are_as_far_apart_on_the_rig() {
    let skeleton = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
    let rig = HandRig::new(&skeleton, Side::Right).unwrap();
    let inventory = HandshapeInventory::builtin();
    let on_rig: Vec<Vec<DVec3>> = inventory
        .shapes()
        .iter()
        .map(|shape| {
            let mut pose = LocalPose::rest(&skeleton);
            rig.apply(&shape.angles(), &mut pose);
            let model = pose.to_model(&skeleton);
            let tip = |joint: JointId| model.point(joint, skeleton[joint].tail_model - skeleton[joint].rest_model);
            let digit = |d: Digit| {
                let [_, second, third] = rig.of_digit(d);
                [model.position(second), model.position(third), tip(third)]
            };
            Digit::ALL.into_iter().flat_map(digit).collect()
        })
        .collect();
    let hands = hands();
    let mut pairs = Vec::new();
    for i in 0..hands.len() {
        for j in 0..i {
            let apart: f64 = on_rig[i].iter().zip(&on_rig[j]).map(|(a, b)| a.distance(*b)).sum();
            pairs.push((hands[i].1.distance(&hands[j].1), apart));
        }
    }
    let mean = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let sum = |of: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| of(p.0 - x, p.1 - y)).sum::<f64>();
    let correlation = sum(&|a, b| a * b) / (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt();
    assert!(correlation > 0.98, "correlation {correlation:.4} over {} pairs", pairs.len());
    // Which is then no accident of the scale's end.
    let at_end = pairs.iter().filter(|p| p.0 >= 1.0).count();
    assert!(at_end == 0, "{at_end} of {} pairs are beyond the scale", pairs.len());
}

#[test]
fn headings_keep_the_laws_of_a_distance() {
    let all: Vec<Heading> = Direction::all().map(Heading::from).collect();
    for a in &all {
        assert_eq!(headings(*a, *a), 0.0);
        assert!((headings(*a, a.opposite()) - 1.0).abs() < 1e-12);
        for b in &all {
            assert_eq!(headings(*a, *b), headings(*b, *a));
            assert!(all.iter().all(|c| headings(*a, *c) <= headings(*a, *b) + headings(*b, *c) + 1e-12));
        }
    }
}

fn course() -> impl Strategy<Value = Course> {
    let kinds = vec![CourseKind::Hold, CourseKind::Straight, CourseKind::Arc, CourseKind::Circle, CourseKind::Twist];
    let directions: Vec<Option<Heading>> = Direction::all().map(|d| Some(d.into())).chain([None]).collect();
    let metres = prop::option::of(0.001..2.0f64);
    (prop::sample::select(kinds), prop::sample::select(directions), metres, 1..4u8)
        .prop_map(|(kind, direction, metres, times)| Course { kind, direction, metres, times })
}

proptest! {
    #[test]
    fn movements_keep_the_laws_of_a_distance(a in course(), b in course(), c in course()) {
        prop_assert_eq!(a.distance(&a), 0.0);
        prop_assert_eq!(a.distance(&b), b.distance(&a));
        prop_assert!((0.0..=1.0 + 1e-12).contains(&a.distance(&b)));
        prop_assert!(a.distance(&c) <= a.distance(&b) + b.distance(&c) + 1e-12);
    }

    #[test]
    fn sequences_are_symmetric_and_at_most_one(a in prop::collection::vec(course(), 0..5), b in prop::collection::vec(course(), 0..5)) {
        prop_assert_eq!(courses(&a, &a), 0.0);
        prop_assert!((courses(&a, &b) - courses(&b, &a)).abs() < 1e-12);
        prop_assert!((0.0..=1.0 + 1e-12).contains(&courses(&a, &b)));
    }
}

#[test]
fn orientations_compare_what_both_say() {
    let say = |fingers: Option<Direction>, palm: Option<Direction>| Orientation {
        fingers: fingers.map(Heading::from),
        palm: palm.map(Heading::from),
        along_path: false,
    };
    let both = say(Some(Direction::UP), Some(Direction::OUT));
    assert_eq!(orientations(&both, &say(None, Some(Direction::OUT))), Some(0.0));
    assert_eq!(orientations(&both, &say(Some(Direction::UP), Some(Direction::IN))), Some(0.5));
    assert_eq!(orientations(&say(Some(Direction::UP), None), &say(None, Some(Direction::OUT))), None);
}
