//! FABRIK and the closed form: laws on random input, then expectations 31–36 of facts/phonology.md §9.

use super::motion_rotation::{any_direction, finite};
use chereme::motion::fabrik::{InnerAngles, Options, Outcome, Pole, solve_arm, solve_chain};
use chereme::motion::reach::{reach, swivelled};
use chereme::motion::two_bone::{inner_angle, solve, swivel_of};
use glam::DVec3;
use proptest::prelude::*;
use std::f64::consts::PI;

const UPPER_M: f64 = 0.288;
const FORE_M: f64 = 0.247;
const REACH_M: f64 = UPPER_M + FORE_M;

fn arm(a: DVec3, b: DVec3) -> [DVec3; 3] {
    [DVec3::ZERO, a * UPPER_M, a * UPPER_M + b * FORE_M]
}

fn any_arm() -> impl Strategy<Value = [DVec3; 3]> {
    (any_direction(), any_direction()).prop_map(|(a, b)| arm(a, b))
}

fn keeps_bones(before: &[DVec3], after: &[DVec3]) -> bool {
    let bones = |j: &[DVec3]| j.windows(2).map(|w| w[0].distance(w[1])).collect::<Vec<_>>();
    bones(before).iter().zip(bones(after)).all(|(a, b)| (a - b).abs() < 1e-9)
}

fn any_pole() -> impl Strategy<Value = Pole> {
    prop_oneof![
        Just(Pole::Inherited),
        any_direction().prop_map(Pole::WhenStraight),
        any_direction().prop_map(Pole::Always)
    ]
}

proptest! {
    #[test]
    fn bones_keep_their_length(start in any_arm(), to in any_direction(), share in 0.0..1.5f64, pole in any_pole()) {
        let options = Options { pole, ..Options::default() };
        let target = to * share * REACH_M;
        let solved = solve_arm(start, target, &options);
        prop_assert!(keeps_bones(&start, &solved.joints));
        prop_assert!((solved.joints[2].distance(target) - solved.residual_m).abs() < 1e-9);
        prop_assert_eq!(solved.joints[0], start[0]);
        let chain = solve_chain(&start, target, &options);
        prop_assert!(keeps_bones(&start, &chain.joints));
        let reached = reach(start, target, &options);
        prop_assert!(keeps_bones(&start, &reached.joints));
        prop_assert!((reached.joints[2].distance(target) - reached.residual_m).abs() < 1e-9);
    }

    #[test]
    fn long_chains_keep_their_bones_and_reach(
        directions in prop::collection::vec(any_direction(), 3..10), to in any_direction(), share in 0.4..0.9f64,
    ) {
        let mut start = vec![DVec3::ZERO];
        for d in &directions {
            start.push(*start.last().unwrap() + *d * 0.1);
        }
        let target = to * share * 0.1 * directions.len() as f64;
        let solved = solve_chain(&start, target, &Options::default());
        prop_assert!(keeps_bones(&start, &solved.joints));
        prop_assert!(solved.converged(), "{:?} {}", solved.outcome, solved.residual_m);
    }

    #[test]
    fn the_plane_s_one_number_iterates_as_the_vectors_do(start in any_arm(), to in any_direction(), share in 0.3..0.98f64) {
        let target = to * share * REACH_M;
        prop_assume!((start[1].normalize().cross(to)).length() > 0.05 );
        let (fast, slow) = (solve_arm(start, target, &Options::default()), solve_chain(&start, target, &Options::default()));
        prop_assert_eq!(fast.iterations, slow.iterations);
        for (a, b) in fast.joints.iter().zip(&slow.joints) {
            prop_assert!(a.distance(*b) < 1e-9, "{fast:?} {slow:?}");
        }
    }

    #[test]
    fn swivel_reads_back(to in any_direction(), share in 0.2..0.99f64, swivel in -3.1..3.1f64, reference in any_direction()) {
        prop_assume!(reference.cross(to).length() > 1e-3);
        let arm = solve(DVec3::ZERO, to * share * REACH_M, UPPER_M, FORE_M, swivel, reference);
        prop_assert!((swivel_of(DVec3::ZERO, arm.elbow, arm.wrist, reference).unwrap() - swivel).abs() < 1e-6);
        prop_assert!((arm.elbow.length() - UPPER_M).abs() < 1e-9 && (arm.elbow.distance(arm.wrist) - FORE_M).abs() < 1e-9);
        let turned = swivelled([DVec3::ZERO, arm.elbow, arm.wrist], 0.5, reference);
        prop_assert!((swivel_of(turned[0], turned[1], turned[2], reference).unwrap() - 0.5).abs() < 1e-6);
    }

    #[test]
    fn limits_hold_and_nothing_nearer_is_allowed(start in any_arm(), to in any_direction(), share in 0.01..1.2f64) {
        let limits = InnerAngles { least: 0.6, greatest: 2.9 };
        let options = Options { limits: Some(limits), ..Options::default() };
        let target = to * share * REACH_M;
        for solved in [solve_arm(start, target, &options), reach(start, target, &options)] {
            let [s, e, w] = solved.joints;
            let inner = inner_angle(s, e, w);
            prop_assert!(inner > limits.least - 1e-9 && inner < limits.greatest + 1e-9, "{inner} {solved:?}");
            prop_assert!(keeps_bones(&start, &solved.joints));
        }
        let exact = reach(start, target, &Options { tolerance_m: 1e-9, max_iterations: 0, ..options });
        let [s, e, w] = exact.joints;
        let inner = inner_angle(s, e, w);
        prop_assert!(inner > limits.least - 1e-6 && inner < limits.greatest + 1e-6, "{inner} {exact:?}");
    }

    #[test]
    fn no_finite_input_gives_nan(v in prop::array::uniform12(finite())) {
        let at = |i: usize| DVec3::new(v[i], v[i + 1], v[i + 2]);
        for options in [Options::default(), Options { limits: Some(InnerAngles { least: v[0], greatest: v[1] }), pole: Pole::Always(at(3)), ..Options::default() }] {
            let fast = solve_arm([at(0), at(3), at(6)], at(9), &options);
            let slow = solve_chain(&[at(0), at(3), at(6)], at(9), &options);
            let any = reach([at(0), at(3), at(6)], at(9), &options);
            for s in [fast.joints.to_vec(), slow.joints, any.joints.to_vec()] {
                prop_assert!(s.iter().all(|j| j.is_finite()), "{s:?}");
            }
            prop_assert!(fast.residual_m.is_finite() && slow.residual_m.is_finite() && any.residual_m.is_finite());
        }
    }

    #[test]
    fn e31_unreachable_is_straight_toward_the_target(start in any_arm(), to in any_direction(), share in 1.001..20.0f64) {
        let target = to * share * REACH_M;
        for solved in [solve_arm(start, target, &Options::default()), reach(start, target, &Options::default())] {
            let [s, e, w] = solved.joints;
            prop_assert_eq!(solved.outcome, if solved.residual_m > 1e-3 { Outcome::TooFar } else { Outcome::Converged });
            prop_assert!(inner_angle(s, e, w).to_degrees() > 179.0);
            prop_assert!((w - s).angle_between(to).to_degrees() < 0.1);
            prop_assert!((solved.residual_m - (target.length() - REACH_M)).abs() < 1e-9);
        }
    }

    #[test]
    fn e32_target_on_or_near_the_shoulder_is_finite(start in any_arm(), to in any_direction(), share in 0.0..0.1f64) {
        for target in [DVec3::ZERO, to * share * (UPPER_M - FORE_M), to * 1e-13] {
            for solved in [solve_arm(start, target, &Options::default()), reach(start, target, &Options::default())] {
                prop_assert!(solved.joints.iter().all(|j| j.is_finite()));
                prop_assert_eq!(solved.outcome, Outcome::TooNear);
                prop_assert!((solved.residual_m - (UPPER_M - FORE_M - target.length())).abs() < 1e-9);
                prop_assert!(keeps_bones(&start, &solved.joints));
            }
        }
    }

    // The wrist within 1 mm, and the elbow within 2 mm of the closed form's: its circle and its swivel.
    #[test]
    fn e33_fabrik_agrees_with_the_closed_form(start in any_arm(), to in any_direction(), share in 0.35..0.98f64) {
        let target = to * share * REACH_M;
        let solved = solve_arm(start, target, &Options::default());
        let exact = solve(DVec3::ZERO, target, UPPER_M, FORE_M, 0.0, start[1]);
        prop_assert!(solved.converged() && solved.joints[2].distance(exact.wrist) <= 1e-3);
        // Along the circle's axis 1 mm of wrist is at most 3 mm of elbow near full stretch: measure at .01 mm.
        let close = solve_arm(start, target, &Options { tolerance_m: 1e-5, max_iterations: 1000, ..Options::default() });
        prop_assume!(start[1].normalize().cross(to).length() > 0.02);
        prop_assert!(close.joints[1].distance(exact.elbow) <= 2e-3, "{}", close.joints[1].distance(exact.elbow));
    }

    #[test]
    fn e34_at_most_100_iterations_up_to_99_percent_of_reach(start in any_arm(), to in any_direction(), share in 0.3..0.99f64) {
        let solved = solve_arm(start, to * share * REACH_M, &Options::default());
        prop_assert!(solved.converged() && solved.iterations <= 100, "{solved:?}");
    }

    #[test]
    fn e35_collinear_starts_are_solved(to in any_direction(), share in 0.3..0.98f64, pole in any_direction(), fold in any::<bool>()) {
        prop_assume!(pole.cross(to).length() > 0.05);
        let side = if fold { -to } else { to };
        for start in [arm(to, side), arm(-to, side), arm(to, -side)] {
            let options = Options { pole: Pole::WhenStraight(pole), ..Options::default() };
            let target = to * share * REACH_M;
            let solved = solve_arm(start, target, &options);
            prop_assert!(solved.converged(), "{solved:?}");
            prop_assert!(solved.joints[1].dot(pole - to * pole.dot(to)) > 0.0, "bends toward the pole");
            let chain = solve_chain(&start, target, &options);
            prop_assert!(chain.converged() && chain.joints[1].dot(pole - to * pole.dot(to)) > 0.0, "{chain:?}");
        }
    }
}

/// The largest step of the elbow over that of the wrist, on a smooth way of the target.
fn elbow_jump(target: impl Fn(f64) -> DVec3, pole: Pole, start: [DVec3; 3]) -> f64 {
    let options = Options { pole, tolerance_m: 1e-4, ..Options::default() };
    let elbows: Vec<DVec3> =
        (0..=240).map(|i| reach(start, target(f64::from(i) / 240.0), &options).joints[1]).collect();
    let exact: Vec<DVec3> = (0..=240)
        .map(|i| {
            let toward = match pole {
                Pole::Always(p) => p,
                Pole::Inherited | Pole::WhenStraight(_) => start[1],
            };
            solve(DVec3::ZERO, target(f64::from(i) / 240.0), UPPER_M, FORE_M, 0.0, toward).elbow
        })
        .collect();
    let largest = |path: &[DVec3]| path.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
    largest(&elbows) / largest(&exact)
}

#[test]
fn e36_smooth_targets_give_no_elbow_jump_above_three_times_the_exact_one() {
    let start = arm(DVec3::new(0.3, -0.9, 0.1).normalize(), DVec3::new(-0.3, 0.3, 0.9).normalize());
    let circle = |t: f64| DVec3::new(0.1 + 0.15 * (2.0 * PI * t).cos(), 0.15 * (2.0 * PI * t).sin(), 0.3);
    let out = |t: f64| DVec3::new(0.02, 0.05, 1.0).normalize() * (0.12 + 0.5 * t);
    let sweep = |t: f64| DVec3::new(0.4 - 0.6 * t, 0.1, 0.25);
    for pole in [Pole::Inherited, Pole::Always(DVec3::new(0.5, -1.0, -0.3))] {
        for (name, ratio) in [
            ("circle", elbow_jump(circle, pole, start)),
            ("out", elbow_jump(out, pole, start)),
            ("sweep", elbow_jump(sweep, pole, start)),
        ] {
            assert!(ratio <= 3.0, "{name} {pole:?} {ratio}");
        }
    }
}

#[test]
fn bones_without_length_are_solved() {
    let target = DVec3::new(0.1, 0.2, 0.05);
    for start in [[DVec3::ZERO; 3], [DVec3::ZERO, DVec3::ZERO, DVec3::X], [DVec3::ZERO, DVec3::X, DVec3::X]] {
        for joints in
            [solve_arm(start, target, &Options::default()).joints, reach(start, target, &Options::default()).joints]
        {
            assert!(joints.iter().all(|j| j.is_finite()) && keeps_bones(&start, &joints), "{joints:?}");
        }
    }
    assert_eq!(solve_chain(&[], target, &Options::default()).outcome, Outcome::Refused);
}
