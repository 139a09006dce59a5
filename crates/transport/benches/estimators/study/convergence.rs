//! Error against photons and against seconds: rms over replicates of the difference from the solver.

use super::measure::{replicate, rounded};
use super::scores::NAMES;
use super::truth::solve;
use super::{ALL, Estimator, Job};
use std::ops::RangeInclusive;
use stratiform_artifact::EstimatorErrorRow;
use stratiform_stats::{Estimate, Purpose, key};
use stratiform_transport::TraceMedium;

const BOTTOMS: [f64; 4] = [0.25, 1.0, 4.0, 16.0];

/// Place in `BOTTOMS` and name: the row that decides how long a run lasts, and one that few words decide.
const DRAWN: [(usize, &str); 2] = [(3, "R"), (0, "R1")];

/// An error from these is known to 1/√128, 9 %.
const REPLICATES: u64 = 64;

/// Rows of every estimator for 2^k photons, k in `powers`; each run traces all slabs.
pub fn convergence(medium: &TraceMedium, mu0: f64, powers: RangeInclusive<u32>) -> Vec<EstimatorErrorRow> {
    let truth = solve(medium, &BOTTOMS, mu0);
    let job = Job { table: medium.table(), bottoms: &BOTTOMS, mu0, key: key(29, Purpose::Calibration) };
    let of_one = |(name, estimator): (&str, Estimator)| {
        let run = |photons| (photons, replicate(estimator, &job, photons, REPLICATES));
        let runs: Vec<_> = powers.clone().map(|k| run(1 << k)).collect();
        let times = runs.iter().map(|(_, (_, work))| work.seconds_per_flight);
        let seconds_per_flight = times.fold(f64::INFINITY, f64::min);
        let rows = runs.iter().flat_map(|(photons, (means, work))| {
            let seconds = seconds_per_flight * work.flights_per_photon * *photons as f64;
            DRAWN.map(|(slab, quantity)| EstimatorErrorRow {
                estimator: name.to_owned(),
                quantity: quantity.to_owned(),
                tau: BOTTOMS[slab],
                mu0,
                photons: *photons,
                seconds: rounded(seconds),
                error: rounded(error(means, &truth, slab, quantity)),
            })
        });
        rows.collect::<Vec<_>>()
    };
    ALL.into_iter().flat_map(of_one).collect()
}

/// Rms over the runs.
fn error(means: &[Vec<f64>], truth: &[Estimate], slab: usize, quantity: &str) -> f64 {
    let q = slab * NAMES.len() + NAMES.iter().position(|name| *name == quantity).unwrap();
    let off = |row: &Vec<f64>| (row[q] - truth[q].value) * (row[q] - truth[q].value);
    (means.iter().map(off).sum::<f64>() / means.len() as f64).sqrt()
}
