//! FABRIK against the closed form and rebirth-ik, on the same random targets at 1 mm.
//!
//! `cargo bench --bench fabrik` prints one line of solves a second and ratios (the best of many
//! runs, taken in turn in one process), then divan's table.

use chereme::motion::fabrik::{Options, solve_arm, solve_chain};
use chereme::motion::two_bone;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::DVec3;
use rebirth_ik::Vec3;
use std::time::Instant;

const UPPER_M: f64 = 0.288;
const FORE_M: f64 = 0.247;
const TARGETS: usize = 4096;
const ROUNDS: usize = 60;

/// A small linear congruential generator (Knuth's MMIX), so that every run has the same targets.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Targets spread evenly over directions and over .3 to .98 of the reach.
fn targets() -> Vec<DVec3> {
    let mut random = Lcg(7);
    let mut all = Vec::with_capacity(TARGETS);
    while all.len() < TARGETS {
        let v = DVec3::new(random.next() * 2.0 - 1.0, random.next() * 2.0 - 1.0, random.next() * 2.0 - 1.0);
        if (0.1..1.0).contains(&v.length()) {
            let reach = (UPPER_M + FORE_M) * (0.3 + 0.68 * random.next());
            all.push(v.normalize() * reach);
        }
    }
    all
}

fn start() -> [DVec3; 3] {
    let elbow = DVec3::new(0.1, -0.95, 0.2).normalize() * UPPER_M;
    [DVec3::ZERO, elbow, elbow + DVec3::new(0.0, 0.3, 0.9).normalize() * FORE_M]
}

fn single(v: DVec3) -> Vec3 {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

fn ours(targets: &[DVec3]) -> f64 {
    let (start, options) = (start(), Options::default());
    targets.iter().map(|t| black_box(solve_arm(black_box(start), *t, &options)).residual_m).sum()
}

fn chain(targets: &[DVec3]) -> f64 {
    let (start, options) = (start(), Options::default());
    targets.iter().map(|t| black_box(solve_chain(black_box(&start), *t, &options)).residual_m).sum()
}

fn closed_form(targets: &[DVec3]) -> f64 {
    targets
        .iter()
        .map(|t| black_box(two_bone::solve(DVec3::ZERO, black_box(*t), UPPER_M, FORE_M, 0.0, -DVec3::Y)).residual_m)
        .sum()
}

fn rebirth(targets: &[DVec3]) -> f64 {
    let begin = start().map(single);
    let lengths = [UPPER_M as f32, FORE_M as f32];
    let solve = |t: &DVec3| {
        let mut joints = black_box(begin);
        let result = rebirth_ik::solve_chain(&mut joints, &lengths, single(*t), 100, 1e-3);
        black_box(joints);
        f64::from(result.error)
    };
    targets.iter().map(solve).sum()
}

/// The least time of one solve, nanoseconds, over rounds taken in turn.
fn least_ns(solvers: &[fn(&[DVec3]) -> f64], targets: &[DVec3]) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; solvers.len()];
    for _ in 0..ROUNDS {
        for (solver, least) in solvers.iter().zip(&mut least) {
            let begin = Instant::now();
            black_box(solver(black_box(targets)));
            *least = least.min(begin.elapsed().as_nanos() as f64 / targets.len() as f64);
        }
    }
    least
}

fn report() {
    let targets = targets();
    let ns = least_ns(&[ours, chain, closed_form, rebirth], &targets);
    let line = |name: &str, ns: f64, mean_mm: f64| {
        println!("{name:<28} {ns:7.1} ns/solve {:8.2} million solves/s, mean residual {mean_mm:.3} mm", 1e3 / ns);
    };
    let mean_mm = |f: fn(&[DVec3]) -> f64| f(&targets) / TARGETS as f64 * 1e3;
    line("chereme FABRIK, arm", ns[0], mean_mm(ours));
    line("chereme FABRIK, any chain", ns[1], mean_mm(chain));
    line("chereme closed form", ns[2], mean_mm(closed_form));
    line("rebirth-ik 0.1 solve_chain", ns[3], mean_mm(rebirth));
    let options = Options::default();
    let iterations: u32 = targets.iter().map(|t| solve_arm(start(), *t, &options).iterations).sum();
    println!("mean iterations {:.2}", f64::from(iterations) / TARGETS as f64);
    println!(
        "ratio: rebirth-ik / chereme FABRIK = {:.2}, chereme FABRIK / closed form = {:.2}",
        ns[3] / ns[0],
        ns[0] / ns[2]
    );
}

fn main() {
    report();
    divan::main();
}

#[divan::bench]
fn fabrik_arm(bencher: Bencher) {
    let targets = targets();
    bencher.counter(ItemsCount::new(TARGETS)).bench_local(|| ours(&targets));
}

#[divan::bench]
fn fabrik_chain(bencher: Bencher) {
    let targets = targets();
    bencher.counter(ItemsCount::new(TARGETS)).bench_local(|| chain(&targets));
}

#[divan::bench]
fn two_bone_closed_form(bencher: Bencher) {
    let targets = targets();
    bencher.counter(ItemsCount::new(TARGETS)).bench_local(|| closed_form(&targets));
}

#[divan::bench]
fn rebirth_ik_chain(bencher: Bencher) {
    let targets = targets();
    bencher.counter(ItemsCount::new(TARGETS)).bench_local(|| rebirth(&targets));
}
