//! Solved values, and how far estimates are from them.

use super::measure::Measured;
use stratiform_quantities::Incidence;
use stratiform_stats::{Estimate, z_score};
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{SolveMedium, Solver};

/// Hits expected of, or missing from, an analog run for its count to be nearly normal.
const ENOUGH: f64 = 1000.0;

/// What rounding may leave in the mean of a replicate of 4096 scores: an estimator may be exact.
pub const ROUNDING: f64 = 5e-13;

/// A solver that meets the finest tolerance it can; the rows of `bottoms` at `mu0`, named as in `scores`.
pub fn solve(medium: &TraceMedium, bottoms: &[f64], mu0: f64) -> Vec<Estimate> {
    let incidence = [Incidence::beam(mu0).unwrap()];
    let attempt = |tolerance| {
        Solver::new(SolveMedium::from(medium), tolerance).unwrap().orders(bottoms, &incidence, 2).ok()
    };
    let solved = [1e-6, 1e-5, 1e-4].into_iter().find_map(attempt).unwrap();
    let slab = |k: usize| {
        let [(_, t0), (r1, t1), (r2, t2), (r3, t3), (r, t)] =
            std::array::from_fn(|n| solved.estimate(0, k, n));
        [r1, r2, r3, r, t0, t1, t2, t3, t]
    };
    (0..bottoms.len()).flat_map(slab).collect()
}

/// Whether `photons` counted photons tell this probability.
pub fn is_common(truth: Estimate, photons: u64) -> bool {
    truth.value.min(1.0 - truth.value) * photons as f64 >= ENOUGH
}

/// z of every common row.
pub fn z_scores(measured: &Measured, truth: &[Estimate]) -> Vec<f64> {
    let rows = truth.iter().enumerate().filter(|(_, truth)| is_common(**truth, measured.photons));
    let rounded = |truth: &Estimate| Estimate { std_error: truth.std_error.max(ROUNDING), ..*truth };
    rows.map(|(q, truth)| z_score(measured.estimate(q), rounded(truth))).collect()
}

/// The z farthest from 0.
pub fn largest(z: &[f64]) -> f64 {
    z.iter().fold(0.0, |worst: f64, z| worst.max(z.abs()))
}

/// As it is listed: to six decimals, the solver's tolerance.
pub fn solved(value: f64) -> f64 {
    format!("{value:.6}").parse().unwrap()
}
