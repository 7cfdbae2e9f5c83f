//! Easings and slerp: laws on random input, then expectations 1–15 of facts/phonology.md §9.

use chereme::motion::easing::{Easing, slerp, sum};
use chereme::motion::profile::{fwhm, peak, speed};
use chereme::motion::rotation::{angle_between, continuous};
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

const ALL: [Easing; 7] = [
    Easing::Sigmoid { k: 10.0 },
    Easing::Sigmoid { k: 8.0 },
    Easing::Cosine,
    Easing::Linear,
    Easing::MinimumJerk,
    Easing::PaperCosine,
    Easing::PaperSigmoid,
];
const NORMALISED: Easing = Easing::Sigmoid { k: 10.0 };

pub fn any_rotation() -> impl Strategy<Value = DQuat> {
    (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64)
        .prop_map(|(x, y, z, w)| DQuat::from_xyzw(x, y, z, w))
        .prop_filter("has a direction", |q| q.length() > 1e-3)
        .prop_map(|q| q.normalize())
}

fn any_easing() -> impl Strategy<Value = Easing> {
    prop_oneof![(0.01..50.0f64).prop_map(|k| Easing::Sigmoid { k }), (1..7usize).prop_map(|i| ALL[i])]
}

proptest! {
    #[test]
    fn easings_grow_and_stay_between_the_ends(easing in any_easing(), a in 0.0..1.0f64, b in 0.0..1.0f64) {
        let (a, b) = (a.min(b), a.max(b));
        prop_assert!(easing.weight(a) <= easing.weight(b));
        prop_assert!((0.0..=1.0).contains(&easing.weight(a)));
    }

    #[test]
    fn rate_is_the_derivative_of_weight(easing in any_easing(), w in 0.01..0.99f64) {
        let h = 1e-5;
        let slope = (easing.weight(w + h) - easing.weight(w - h)) / (2.0 * h);
        prop_assert!((slope - easing.rate(w)).abs() < 1e-4, "{slope} {}", easing.rate(w));
    }

    #[test]
    fn easings_are_symmetric(easing in any_easing(), w in 0.0..1.0f64) {
        prop_assert!((easing.weight(w) + easing.weight(1.0 - w) - 1.0).abs() < 1e-12);
        prop_assert!((easing.rate(w) - easing.rate(1.0 - w)).abs() < 1e-9);
    }

    #[test]
    fn names_read_back(easing in any_easing()) {
        prop_assert_eq!(easing.to_string().parse::<Easing>().unwrap(), easing);
    }

    #[test]
    fn no_finite_input_gives_nan(
        k in prop::num::f64::NORMAL, w in prop::num::f64::NORMAL,
        x in prop::num::f64::NORMAL, y in prop::num::f64::NORMAL,
    ) {
        let easing = Easing::Sigmoid { k };
        prop_assert!(easing.weight(w).is_finite());
        prop_assert!(easing.rate(w).is_finite());
        let q = easing.ease_rotation(DQuat::from_xyzw(x, y, 0.0, 1.0), DQuat::from_xyzw(y, 0.0, x, 0.0), w);
        prop_assert!((q.length() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn e09_slerp_turns_by_its_share(a in any_rotation(), b in any_rotation(), w in 0.0..1.0f64) {
        prop_assert!((angle_between(a, slerp(a, b, w)) - w * angle_between(a, b)).abs() < 1e-6);
    }

    #[test]
    fn e10_slerp_of_one_rotation_stays(q in any_rotation(), w in 0.0..1.0f64) {
        prop_assert_eq!(slerp(q, q, w), slerp(q, q, 0.0));
        prop_assert!((slerp(q, q, w) - q).length() < 1e-15);
        prop_assert!((slerp(q, -q, w) - q).length() < 1e-15);
    }

    #[test]
    fn e11_the_path_keeps_to_the_short_arc(e in any_easing(), a in any_rotation(), b in any_rotation(), w in 0.0..1.0f64) {
        let (whole, q) = (angle_between(a, b), e.ease_rotation(a, b, w));
        prop_assert!(angle_between(a, q) <= whole + 1e-9);
        prop_assert!((angle_between(a, q) + angle_between(q, b) - whole).abs() < 1e-6);
    }

    #[test]
    fn e12_e13_unit_and_continuous(e in any_easing(), a in any_rotation(), b in any_rotation()) {
        let mut before = a;
        for i in 0..=60 {
            let q = e.ease_rotation(a, b, f64::from(i) / 60.0);
            prop_assert!((q.length() - 1.0).abs() < 1e-6);
            prop_assert!(before.dot(q) >= 0.0);
            prop_assert_eq!(continuous(before, q), q);
            before = q;
        }
    }
}

#[test]
fn e01_raw_sigmoid_values() {
    for (w, s) in [(0.0, 0.0066929), (0.25, 0.0758582), (0.5, 0.5), (0.75, 0.9241418), (1.0, 0.9933071)] {
        assert!((Easing::PaperSigmoid.weight(w) - s).abs() < 1e-6, "s({w})");
    }
}

#[test]
fn e02_raw_sigmoid_halves_add_up() {
    for i in 0..=1000 {
        let w = f64::from(i) / 1000.0;
        assert!((Easing::PaperSigmoid.weight(w) + Easing::PaperSigmoid.weight(1.0 - w) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn e03_normalised_sigmoid_is_exact_at_its_ends() {
    assert_eq!((NORMALISED.weight(0.0), NORMALISED.weight(1.0)), (0.0, 1.0));
    assert!((NORMALISED.weight(0.25) - 0.0701037).abs() < 1e-7);
    assert!((NORMALISED.weight(0.1) - 0.0114466).abs() < 1e-7);
}

#[test]
fn e04_cosine_values() {
    assert_eq!((Easing::Cosine.weight(0.0), Easing::Cosine.weight(1.0)), (0.0, 1.0));
    assert!((Easing::Cosine.weight(0.25) - 0.1464466).abs() < 1e-7);
    assert!((Easing::Cosine.weight(0.1) - 0.0244717).abs() < 1e-7);
}

#[test]
fn e05_strictly_monotone() {
    for easing in ALL {
        for i in 0..1000 {
            let (a, b) = (f64::from(i) / 1000.0, f64::from(i + 1) / 1000.0);
            assert!(easing.weight(a) < easing.weight(b), "{easing} at {a}");
        }
    }
}

/// The way of a point one metre from a joint that turns by one radian in one second, at 1000 frames a second.
fn wave(easing: Easing) -> (Vec<f64>, Fps) {
    let fps = Fps::new(1000.0).unwrap();
    let turn = DQuat::from_rotation_z(1.0);
    let path: Vec<DVec3> =
        (0..=1000).map(|i| easing.ease_rotation(DQuat::IDENTITY, turn, f64::from(i) / 1000.0) * DVec3::X).collect();
    (speed(&path, fps), fps)
}

#[test]
fn e06_peak_speeds_at_half_way() {
    let peaks = [
        (Easing::Linear, 1.0),
        (Easing::Cosine, FRAC_PI_2),
        (Easing::PaperSigmoid, 2.5),
        (NORMALISED, 2.5339),
        (Easing::MinimumJerk, 1.875),
    ];
    for (easing, expected) in peaks {
        assert!((easing.rate(0.5) - expected).abs() < 0.01 * expected, "{easing}");
        if easing != Easing::PaperSigmoid {
            let (profile, fps) = wave(easing);
            let peak = peak(&profile, fps).unwrap();
            assert!((peak.value - expected).abs() < 0.01 * expected, "{easing} {peak:?}");
            assert!(easing == Easing::Linear || (peak.time.0 - 0.5).abs() < 0.002, "{easing} {peak:?}");
        }
    }
}

#[test]
fn e07_widths_at_half_speed() {
    for (easing, expected) in
        [(Easing::Cosine, 0.6667), (NORMALISED, 0.3525), (Easing::MinimumJerk, 0.541), (Easing::Linear, 1.0)]
    {
        let (profile, fps) = wave(easing);
        let width = fwhm(&profile, fps).unwrap().0;
        assert!((width - expected).abs() < 1e-3, "{easing} {width}");
    }
}

#[test]
fn e08_speed_is_symmetric_in_time() {
    for easing in ALL {
        let (profile, _) = wave(easing);
        for i in 0..=500 {
            assert!((profile[i] - profile[1000 - i]).abs() < 1e-6, "{easing} {i}");
        }
    }
    // A → B → A.
    let b = DQuat::from_rotation_y(1.1);
    for i in 0..=60 {
        let w = f64::from(i) / 60.0;
        let (out, back) =
            (NORMALISED.ease_rotation(DQuat::IDENTITY, b, w), NORMALISED.ease_rotation(b, DQuat::IDENTITY, 1.0 - w));
        assert!(angle_between(out, back) < 1e-9);
    }
}

#[test]
fn e14_a_sum_of_quaternions_shrinks_to_cos_of_half_omega() {
    let raw = sum(DQuat::IDENTITY, DQuat::from_rotation_x(FRAC_PI_2), 0.5);
    assert!((raw.length() - 0.9239).abs() < 1e-4);
}

#[test]
fn e15_sum_and_slerp_differ_by_at_most_0_92_degrees_at_90() {
    let turn = DQuat::from_rotation_x(FRAC_PI_2);
    let worst = (0..=1000)
        .map(|i| f64::from(i) / 1000.0)
        .map(|w| {
            let paper = Easing::PaperCosine.ease_rotation(DQuat::IDENTITY, turn, w);
            angle_between(paper, Easing::Cosine.ease_rotation(DQuat::IDENTITY, turn, w)).to_degrees()
        })
        .fold(0.0, f64::max);
    assert!(worst <= 0.925 && worst > 0.9, "{worst}");
}

#[test]
fn easing_names_that_do_not_exist_say_what_does() {
    for text in ["sigmod", "", "sigmoid:", "sigmoid:0", "sigmoid:-3", "sigmoid:nan", "sigmoid:inf", "sigmoid:1e9"] {
        let message = text.parse::<Easing>().unwrap_err().to_string();
        assert!(message.contains("sigmoid:8"), "{message}");
    }
    assert_eq!("slerp".parse(), Ok(Easing::Linear));
    assert_eq!(" Minimum-Jerk ".parse(), Ok(Easing::MinimumJerk));
}
