//! The statistics against scipy (tools/statistics_oracle.py prints the values), and the laws of rank tests.

use chereme::evaluation::statistics::bootstrap::{Statistic, estimate};
use chereme::evaluation::statistics::describe::{correlation, quantile, summary};
use chereme::evaluation::statistics::gamma::{chi_square_tail, gamma_q, ln_gamma, normal_tail};
use chereme::evaluation::statistics::{Method, holm, kruskal_wallis, mann_whitney, wilson};
use proptest::prelude::*;

const A: [f64; 12] = [5.0, 4.0, 4.0, 3.0, 5.0, 2.0, 4.0, 5.0, 3.0, 4.0, 4.0, 5.0];
const B: [f64; 12] = [3.0, 2.0, 4.0, 1.0, 3.0, 3.0, 2.0, 5.0, 4.0, 2.0, 3.0, 3.0];
const C: [f64; 12] = [4.0, 3.0, 3.0, 2.0, 5.0, 4.0, 3.0, 3.0, 2.0, 4.0, 1.0, 4.0];

#[track_caller]
fn near(a: f64, b: f64, share: f64) {
    assert!((a - b).abs() <= share * b.abs().max(1e-300), "{a} is not {b}");
}

#[test]
fn distributions_are_those_of_scipy() {
    let gamma = [
        (0.5, 0.01, 0.887537083981715),
        (0.5, 3.0, 0.014305878435429641),
        (1.0, 2.0, 0.1353352832366127),
        (2.5, 0.3, 0.9880032427940937),
        (2.5, 9.0, 0.0029464045878802923),
        (10.0, 10.0, 0.4579297144718523),
        (50.0, 30.0, 0.999481108537452),
        (50.0, 90.0, 1.6494985017178526e-06),
        (0.1, 1e-06, 0.7359663456720775),
        (500.0, 520.0, 0.18469114909874365),
    ];
    gamma.into_iter().for_each(|(a, x, q)| near(gamma_q(a, x), q, 2e-12));
    let logarithms = [
        (0.1, 2.252712651734206),
        (0.5, 0.5723649429247),
        (1.5, -0.12078223763524526),
        (3.7, 1.428072326665388),
        (12.0, 17.502307845873887),
        (100.5, 361.43554046777757),
        (1e6, 12815504.569147611),
    ];
    logarithms.into_iter().for_each(|(x, y)| near(ln_gamma(x), y, 1e-13));
    let normal = [
        (-3.0, 0.9986501019683699),
        (-1.0, 0.8413447460685429),
        (0.0, 0.5),
        (0.5, 0.3085375387259869),
        (4.0, 3.167124183311986e-05),
        (8.0, 6.22096057427174e-16),
    ];
    normal.into_iter().for_each(|(z, p)| near(normal_tail(z), p, 1e-12));
    assert!(gamma_q(-1.0, 2.0).is_nan() && gamma_q(1.0, f64::NAN).is_nan() && ln_gamma(0.0).is_nan());
    assert_eq!((chi_square_tail(-1.0, 2.0), chi_square_tail(f64::INFINITY, 2.0)), (1.0, 0.0));
}

#[test]
fn rank_tests_are_those_of_scipy() {
    let three = kruskal_wallis(&[&A, &B, &C]).unwrap();
    near(three.h, 6.364914818386386, 1e-12);
    near(three.p, 0.04148358761215521, 1e-12);
    near(kruskal_wallis(&[&A, &B]).unwrap().p, 0.01855414569171124, 1e-12);
    for (x, y, u, p) in
        [(A, B, 111.5, 0.02009509375918393), (A, C, 103.0, 0.06669570997723208), (B, C, 61.0, 0.5280517026734719)]
    {
        let test = mann_whitney(&x, &y).unwrap();
        assert_eq!((test.u, test.method), (u, Method::Normal));
        near(test.p, p, 1e-12);
    }
    let x = [1.1, 2.3, 0.4, 5.2, 3.3];
    let y = [2.2, 6.1, 7.5, 4.4, 8.0, 9.1, 3.9];
    let exact = mann_whitney(&x, &y).unwrap();
    assert_eq!((exact.u, exact.method), (5.0, Method::Exact));
    near(exact.p, 0.04797979797979798, 1e-12);
    let many: Vec<f64> = (0..30).map(|i| f64::from(i) * 0.37 + 0.013).collect();
    let exact = mann_whitney(&[0.9, 8.8, 4.1, 3.7, 6.6, 2.0, 7.1, 5.5], &many).unwrap();
    assert_eq!((exact.u, exact.method), (108.0, Method::Exact));
    near(exact.p, 0.6862514439664147, 1e-10);
    let twelve: Vec<f64> = (0..12).map(|i| f64::from(i) * 0.91 + 0.5).collect();
    let normal = mann_whitney(&twelve, &many).unwrap();
    assert_eq!((normal.u, normal.method), (184.0, Method::Normal));
    near(normal.p, 0.9223705814421508, 1e-12);
}

#[test]
fn intervals_and_summaries_are_those_of_scipy() {
    for (hits, n, low, high) in [
        (0, 10, 0.0, 0.27753279986288926),
        (8, 10, 0.4901624715366418, 0.9433178485456248),
        (36, 57, 0.5017779822249521, 0.744764429655843),
        (49, 57, 0.746755353906559, 0.9271272385676139),
        (10, 10, 0.7224672001371109, 1.0),
    ] {
        let rate = wilson(hits, n).unwrap();
        assert!((rate.low - low).abs() < 1e-12 && (rate.high - high).abs() < 1e-12, "{rate:?}");
    }
    let s = summary(&A).unwrap();
    assert_eq!((s.q1, s.median, s.q3), (3.75, 4.0, 5.0));
    near(s.sd, 0.9534625892455924, 1e-14);
    near(correlation(&A, &C).unwrap(), 0.3421595691073206, 1e-13);
}

#[test]
fn what_has_no_answer_gets_none() {
    assert_eq!(kruskal_wallis(&[&A, &[]]), None);
    assert_eq!(kruskal_wallis(&[&[3.0, 3.0], &[3.0]]), None);
    assert_eq!(mann_whitney(&[], &A), None);
    assert_eq!(mann_whitney(&[2.0; 9], &[2.0; 9]).unwrap().p, 1.0);
    assert_eq!((wilson(0, 0), wilson(3, 2), summary(&[]), quantile(&[f64::NAN], 0.5)), (None, None, None, None));
    assert_eq!(estimate(&[vec![], vec![]], Statistic::Mean, 10, 0), None);
}

/// The exact p by counting all orders, one by one.
fn counted(first: &[f64], second: &[f64]) -> f64 {
    let all = [first, second].concat();
    let u_of = |chosen: &dyn Fn(usize) -> bool| {
        let (mine, others): (Vec<usize>, Vec<usize>) = (0..all.len()).partition(|i| chosen(*i));
        mine.iter().flat_map(|i| others.iter().map(move |j| (i, j))).filter(|(i, j)| all[**i] > all[**j]).count() as f64
    };
    let middle = (first.len() * second.len()) as f64 / 2.0;
    let apart = (u_of(&|i| i < first.len()) - middle).abs();
    let orders = (0u32..1 << all.len()).filter(|mask| mask.count_ones() as usize == first.len());
    let far: Vec<bool> = orders.map(|mask| (u_of(&|i| mask >> i & 1 == 1) - middle).abs() >= apart - 1e-9).collect();
    far.iter().filter(|f| **f).count() as f64 / far.len() as f64
}

fn ratings() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec((1u8..=5).prop_map(f64::from), 1..20)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn order_and_names_of_groups_do_not_matter(a in ratings(), b in ratings(), c in ratings()) {
        let reversed = |v: &[f64]| v.iter().rev().copied().collect::<Vec<_>>();
        match (kruskal_wallis(&[&a, &b, &c]), kruskal_wallis(&[&reversed(&c), &b, &reversed(&a)])) {
            (Some(x), Some(y)) => {
                prop_assert!((x.h - y.h).abs() < 1e-9 && (0.0..=1.0).contains(&x.p));
                prop_assert!((-1e-9..=1.0 + 1e-9).contains(&x.epsilon_squared));
            }
            (x, y) => prop_assert_eq!(x, y),
        }
        let (there, back) = (mann_whitney(&a, &b).unwrap(), mann_whitney(&reversed(&b), &a).unwrap());
        prop_assert!((there.p - back.p).abs() < 1e-12 && (there.rank_biserial + back.rank_biserial).abs() < 1e-12);
        prop_assert_eq!(there.u + back.u, (a.len() * b.len()) as f64);
    }

    #[test]
    fn only_the_order_of_values_matters(a in ratings(), b in ratings()) {
        let stretched = |v: &[f64]| v.iter().map(|x| x.exp() - 100.0).collect::<Vec<_>>();
        prop_assert_eq!(mann_whitney(&a, &b), mann_whitney(&stretched(&a), &stretched(&b)));
        prop_assert_eq!(kruskal_wallis(&[&a, &b]), kruskal_wallis(&[&stretched(&a), &stretched(&b)]));
    }

    #[test]
    fn the_exact_p_is_the_count_of_orders(values in prop::collection::hash_set(0u16..10_000, 4..9), cut in 1usize..3) {
        let values: Vec<f64> = values.into_iter().map(f64::from).collect();
        let (a, b) = values.split_at(cut);
        let test = mann_whitney(a, b).unwrap();
        prop_assert_eq!(test.method, Method::Exact);
        prop_assert!((test.p - counted(a, b)).abs() < 1e-9, "{} {}", test.p, counted(a, b));
    }

    #[test]
    fn holm_keeps_order_and_lies_between_raw_and_bonferroni(p in prop::collection::vec(0.0..1.0f64, 1..12)) {
        let corrected = holm(&p);
        for (i, (raw, held)) in p.iter().zip(&corrected).enumerate() {
            prop_assert!(raw <= held && *held <= (raw * p.len() as f64).min(1.0) + 1e-12);
            prop_assert!(p.iter().zip(&corrected).all(|(q, h)| q < raw || h >= held || p[i] > *q));
        }
    }

    #[test]
    fn intervals_hold_their_estimate(values in prop::collection::vec(-10.0..10.0f64, 2..30), hits in 0usize..40, more in 1usize..40) {
        let takes: Vec<Vec<f64>> = values.chunks(3).map(<[f64]>::to_vec).collect();
        for statistic in [Statistic::Mean, Statistic::Median] {
            let one = estimate(&takes, statistic, 200, 1).unwrap();
            prop_assert_eq!(one, estimate(&takes, statistic, 200, 1).unwrap());
            prop_assert!(one.low <= one.high && one.n == values.len());
        }
        let rate = wilson(hits, hits + more).unwrap();
        prop_assert!(0.0 <= rate.low && rate.low <= rate.share && rate.share <= rate.high && rate.high <= 1.0);
    }
}

#[test]
fn an_interval_of_means_covers_the_mean_as_often_as_it_says() {
    // 200 samples of 30 values from a known spread: about 95 % of the intervals hold the mean 0.5.
    let mut state = 12345u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let covered = (0..200).filter(|seed| {
        let takes: Vec<Vec<f64>> = (0..30).map(|_| vec![random()]).collect();
        let mean = estimate(&takes, Statistic::Mean, 300, *seed).unwrap();
        mean.low <= 0.5 && 0.5 <= mean.high
    });
    assert!((176..=199).contains(&covered.count()));
}
