//! Error against photons and against seconds: rms over replicates of the difference from the solver.

use super::measure::replicate;
use super::scores::NAMES;
use super::truth::solve;
use super::{ALL, Job};
use std::ops::RangeInclusive;
use stratiform_artifact::EstimatorErrorRow;
use stratiform_stats::{Purpose, key};
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
    let mut found = Vec::new();
    for (name, estimator) in ALL {
        for photons in powers.clone().map(|k| 1 << k) {
            let (rows, work) = replicate(estimator, &job, photons, REPLICATES);
            let seconds = work.seconds() * photons as f64;
            for (slab, quantity) in DRAWN {
                let q = slab * NAMES.len() + NAMES.iter().position(|name| *name == quantity).unwrap();
                let off = |row: &Vec<f64>| (row[q] - truth[q].value) * (row[q] - truth[q].value);
                let error = (rows.iter().map(off).sum::<f64>() / REPLICATES as f64).sqrt();
                let (estimator, quantity) = (name.to_owned(), quantity.to_owned());
                found.push(EstimatorErrorRow {
                    estimator,
                    quantity,
                    tau: BOTTOMS[slab],
                    mu0,
                    photons,
                    seconds,
                    error,
                });
            }
        }
    }
    found
}
