//! Damped least squares within bounds (Levenberg 1944, Marquardt 1963), with a numeric Jacobian.

use super::goals::Goals;

const N: usize = 21;
/// The step of the numeric derivative, radians.
const STEP: f64 = 2e-3;

/// The least sum of squares found from a start, and where.
pub fn solve(goals: &Goals, start: [f64; N], iterations: usize) -> (f64, [f64; N]) {
    let (mut x, mut damping) = (start, 1e-2);
    let mut residuals = goals.residuals(x);
    let mut cost = squares(&residuals);
    for _ in 0..iterations {
        let (normal, gradient) = normal_equations(goals, x, &residuals);
        let mut improved = false;
        for _ in 0..6 {
            let mut damped = normal;
            for i in 0..N {
                damped[i][i] += damping * (normal[i][i] + 1.0);
            }
            let step = cholesky_solve(&damped, &gradient);
            let tried = goals.clamp(std::array::from_fn(|i| x[i] - step[i]));
            let found = goals.residuals(tried);
            let tried_cost = squares(&found);
            if tried_cost < cost {
                improved = cost - tried_cost > 3e-5 * cost;
                (x, residuals, cost) = (tried, found, tried_cost);
                damping = (damping * 0.3).max(1e-6);
                break;
            }
            damping *= 4.0;
        }
        if !improved {
            break;
        }
    }
    (cost, x)
}

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

/// JᵀJ and Jᵀr; rows that are zero throughout (nothing enters anything there) cost nothing.
fn normal_equations(goals: &Goals, x: [f64; N], residuals: &[f64]) -> ([[f64; N]; N], [f64; N]) {
    let columns: Vec<Vec<f64>> = (0..N)
        .map(|i| {
            let mut moved = x;
            moved[i] += STEP;
            let there = goals.residuals(moved);
            there.iter().zip(residuals).map(|(a, b)| (a - b) / STEP).collect()
        })
        .collect();
    let mut normal = [[0.0; N]; N];
    let mut gradient = [0.0; N];
    for (row, residual) in residuals.iter().enumerate() {
        let values: [f64; N] = std::array::from_fn(|i| columns[i][row]);
        if *residual == 0.0 && values.iter().all(|v| *v == 0.0) {
            continue;
        }
        for i in 0..N {
            gradient[i] += values[i] * residual;
            for j in 0..=i {
                normal[i][j] += values[i] * values[j];
            }
        }
    }
    let lower = normal;
    for (i, row) in lower.iter().enumerate() {
        for (above, value) in normal[..i].iter_mut().zip(row) {
            above[i] = *value;
        }
    }
    (normal, gradient)
}

/// Solves a symmetric positive definite system (damping makes it so).
fn cholesky_solve(a: &[[f64; N]; N], b: &[f64; N]) -> [f64; N] {
    let mut l = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            l[i][j] = if i == j { (a[i][i] - sum).max(1e-12).sqrt() } else { (a[i][j] - sum) / l[j][j] };
        }
    }
    let mut y = [0.0; N];
    for i in 0..N {
        y[i] = (b[i] - (0..i).map(|k| l[i][k] * y[k]).sum::<f64>()) / l[i][i];
    }
    let mut x = [0.0; N];
    for i in (0..N).rev() {
        x[i] = (y[i] - (i + 1..N).map(|k| l[k][i] * x[k]).sum::<f64>()) / l[i][i];
    }
    x
}
