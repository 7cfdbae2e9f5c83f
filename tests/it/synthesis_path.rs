//! The shapes that hands draw: expectation 45 of facts/phonology.md §9, and laws on random paths.

use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::symmetry::Turns;
use chereme::phonology::{Action, Clock, Direction, Extent, Motion, Movement};
use chereme::synthesis::legs::lay_out;
use chereme::synthesis::path::Path;
use glam::DVec3;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn circle(axis: Direction, radius: f64, start: u8, turns: f64) -> Path {
    let motion = Motion::Circle {
        axis: axis.into(),
        extent: Extent::Metres(radius),
        start: Clock::new(start).unwrap(),
        turns,
        ellipse: None,
        growth: 0,
        overlay: None,
    };
    let movement = Movement::Action(Box::new(Action::new(motion)));
    lay_out(&movement, &MovementTable::embedded(), Turns::default()).remove(0).path
}

#[test]
fn expectation_45_a_circle_closes_has_one_radius_and_is_2_pi_r_long() {
    for axis in Direction::all() {
        for start in 0..8 {
            let (radius, path) = (0.07, circle(axis, 0.07, start, 1.0));
            assert!(path.end().length() < 1e-3);
            let points: Vec<DVec3> = (0..720).map(|i| path.at(f64::from(i) / 720.0)).collect();
            // The centre lies opposite the start, a radius away: find it as the middle of the two farthest points.
            let far = points.iter().copied().max_by(|a, b| a.length().total_cmp(&b.length())).unwrap();
            let centre = far / 2.0;
            for p in &points {
                assert!((p.distance(centre) / radius - 1.0).abs() < 0.01);
                assert!((*p).dot(axis.vector()).abs() < 1e-9, "the circle lies across its axis");
            }
            assert!((path.length(2000) / (TAU * radius) - 1.0).abs() < 0.001);
        }
    }
}

#[test]
fn a_circle_starts_at_its_top_and_goes_clockwise_for_one_who_looks_along_its_axis() {
    // Axis out: the signer looks along it, clockwise from the top is to the signer's right first.
    let path = circle(Direction::OUT, 0.1, 0, 1.0);
    let early = path.at(0.3);
    assert!(early.x < -0.01 && early.y < 0.0, "{early}");
}

#[test]
fn an_arc_passes_the_top_of_its_bend_and_ends_at_its_chord() {
    let path = Path::Arc { chord: DVec3::X * 0.2, bend: DVec3::Y * 0.05 };
    assert!(path.at(0.5).distance(DVec3::new(0.1, 0.05, 0.0)) < 1e-9);
    assert!(path.end().distance(DVec3::X * 0.2) < 1e-9);
    let semicircle = Path::Arc { chord: DVec3::X * 0.2, bend: DVec3::Y * 0.1 };
    assert!((semicircle.length(2000) / (0.1 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
}

#[test]
fn a_straight_stroke_has_the_profile_of_minimum_jerk() {
    let path = Path::Straight(DVec3::Y);
    assert!((path.at(0.25).y - 0.10352).abs() < 1e-4);
    let speed = (path.at(0.501).y - path.at(0.499).y) / 0.002;
    assert!((speed - 1.875).abs() < 0.001);
}

fn path() -> impl Strategy<Value = Path> {
    let vector = || (-0.3f64..0.3, -0.3f64..0.3, -0.3f64..0.3).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    let leaf = prop_oneof![
        Just(Path::Still),
        vector().prop_map(Path::Straight),
        (vector(), vector()).prop_map(|(chord, bend)| Path::Arc { chord, bend }),
        (vector(), vector(), 0.0..TAU, 0.1f64..4.0).prop_map(|(top, side, start, turns)| Path::Round {
            top,
            side,
            start,
            turns,
            growth: 1.0
        }),
        (vector(), 1.0f64..6.0, any::<bool>()).prop_map(|(across, count, zigzag)| Path::Waves {
            across,
            count,
            zigzag
        }),
    ];
    leaf.prop_recursive(3, 12, 3, |inner| {
        prop_oneof![
            proptest::collection::vec(inner.clone(), 1..4).prop_map(Path::Sum),
            proptest::collection::vec((0.1f64..1.0, inner.clone()), 1..4).prop_map(Path::Chain),
            proptest::collection::vec(inner.clone(), 1..4).prop_map(Path::Fused),
            inner.clone().prop_map(|p| Path::Backwards(Box::new(p))),
            (0.3f64..2.0, inner).prop_map(|(f, p)| Path::Scaled(f, Box::new(p))),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_path_starts_at_nothing_and_does_not_jump(path in path()) {
        prop_assert!(path.at(0.0).length() < 1e-9);
        let points: Vec<DVec3> = (0..=40000).map(|i| path.at(f64::from(i) / 40000.0)).collect();
        let most = points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
        prop_assert!(most < 0.05, "a step of {most} m");
    }

    #[test]
    fn backwards_comes_back(path in path()) {
        let back = Path::Backwards(Box::new(path.clone()));
        prop_assert!((path.end() + back.end()).length() < 1e-9);
        prop_assert!((path.at(0.3) - path.end() - back.at(0.7)).length() < 1e-9);
    }

    #[test]
    fn reflection_is_its_own_inverse_and_commutes_with_time(path in path(), share in 0.0f64..1.0) {
        let signs = DVec3::new(-1.0, 1.0, 1.0);
        let reflected = path.reflected(signs);
        prop_assert!((reflected.at(share) - path.at(share) * signs).length() < 1e-9);
        prop_assert_eq!(reflected.reflected(signs), path);
    }
}
