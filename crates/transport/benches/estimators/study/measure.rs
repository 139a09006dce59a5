//! Mean, variance and time of an estimator from independent replicates.

use super::{Estimator, Job};
use std::time::Instant;
use stratiform_stats::Estimate;

/// What a photon costs. Flights are averaged over all replicates, their time is that of the fastest: the machine's noise only
/// adds.
#[derive(Clone, Copy)]
pub struct Work {
    pub flights_per_photon: f64,
    pub seconds_per_flight: f64,
}

impl Work {
    /// Seconds per photon.
    pub fn seconds(&self) -> f64 {
        self.flights_per_photon * self.seconds_per_flight
    }
}

/// What replicates of one estimator gave, row by row.
pub struct Measured {
    pub mean: Vec<f64>,
    /// Variance of a replicate's mean times its photons; from r replicates it is known to √(2/(r-1)).
    pub variance: Vec<f64>,
    pub work: Work,
    /// Of all replicates.
    pub photons: u64,
}

impl Measured {
    /// Row `q` with the standard error that the replicates show.
    pub fn estimate(&self, q: usize) -> Estimate {
        Estimate { value: self.mean[q], std_error: (self.variance[q] / self.photons as f64).sqrt() }
    }
}

/// Runs `replicates` of `photons` each.
pub fn measure(estimator: Estimator, job: &Job<'_>, photons: u64, replicates: u64) -> Measured {
    let (rows, work) = replicate(estimator, job, photons, replicates);
    let n = replicates as f64;
    let mean: Vec<f64> = (0..rows[0].len()).map(|q| rows.iter().map(|row| row[q]).sum::<f64>() / n).collect();
    let deviation = |q: usize| rows.iter().map(|row| (row[q] - mean[q]) * (row[q] - mean[q])).sum::<f64>();
    let variance = (0..mean.len()).map(|q| deviation(q) / (n - 1.0) * photons as f64).collect();
    Measured { mean, variance, work, photons: photons * replicates }
}

/// The means of each replicate, and what they cost.
pub fn replicate(
    estimator: Estimator,
    job: &Job<'_>,
    photons: u64,
    replicates: u64,
) -> (Vec<Vec<f64>>, Work) {
    let (mut flights, mut seconds_per_flight) = (0, f64::INFINITY);
    let one = |replicate: u64| {
        let start = Instant::now();
        let scores = estimator(job, replicate * photons..(replicate + 1) * photons);
        let seconds = start.elapsed().as_secs_f64();
        seconds_per_flight = seconds_per_flight.min(seconds / scores.flights as f64);
        flights += scores.flights;
        scores.means(photons)
    };
    let rows = (0..replicates).map(one).collect();
    let flights_per_photon = flights as f64 / (photons * replicates) as f64;
    (rows, Work { flights_per_photon, seconds_per_flight })
}

/// To three digits: more are not known of what was sampled or timed.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap()
}
