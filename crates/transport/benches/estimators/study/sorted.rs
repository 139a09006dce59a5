//! Plane albedo at every zenith angle from one diffusely lit run: photons sorted by the angle at which they came in, by
//! that at which they left, and both together.
//!
//! By reciprocity the share of diffuse light that leaves in a bin is the bin's share of the light times its albedo. A bin
//! with share w and albedo R has variance R(1-wR)/w per photon by exit and R(1-R)/w by entry: exit is never better. Both
//! give the mean over a bin, not the albedo at an angle.

use super::history::{Photon, Words, xi};
use super::measure::rounded;
use super::truth::{self, largest};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;
use stratiform_quantities::Incidence;
use stratiform_stats::{Estimate, Purpose, key, photon_stream, z_score};
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{SolveMedium, Solver};

/// Bins of zenith angle, 10° each.
const BINS: usize = 9;
const WIDTH: f64 = FRAC_PI_2 / BINS as f64;

/// A row of `reciprocity.csv`.
#[derive(Serialize)]
pub struct SortedRow {
    pub phase: String,
    pub tau: f64,
    pub theta_from_deg: f64,
    /// Solved mean over the bin, and what it differs from the albedo in the bin's middle.
    pub solved: f64,
    pub mean_less_middle: f64,
    /// Variance per photon, sorted by entry.
    pub variance: f64,
    /// That over the variance sorted by exit, and of the mean of both; the time is the same.
    pub merit_exit: f64,
    pub merit_both: f64,
    /// Of entry, exit and both against the solver, the largest.
    pub largest_z: f64,
}

/// Albedos by entry, by exit, by both.
pub type Albedos = [[f64; BINS]; 3];

/// One diffusely lit run of `photons` through a slab.
pub fn albedos(medium: &TraceMedium, bottom: f64, photons: u64, replicate: u64) -> Albedos {
    let mut counts = [[0.0; BINS]; 2];
    for index in replicate * photons..(replicate + 1) * photons {
        let mut words = Words::new(photon_stream(key(23, Purpose::Calibration), index), &[]);
        let entry = xi(words.next()).sqrt();
        if let Some(exit) = reflected(medium, bottom, entry, &mut words) {
            counts[0][bin(entry)] += 1.0;
            counts[1][bin(exit)] += 1.0;
        }
    }
    let [entry, exit] = counts.map(|row| std::array::from_fn(|k| row[k] / (photons as f64 * share(k))));
    [entry, exit, std::array::from_fn(|k| 0.5 * (entry[k] + exit[k]))]
}

/// The cosine at which a photon leaves the top, if it does.
fn reflected(medium: &TraceMedium, bottom: f64, entry: f64, words: &mut Words<'_>) -> Option<f64> {
    let mut photon = Photon::new(entry);
    loop {
        photon.fly(words);
        if photon.depth < 0.0 {
            return Some(-photon.mu);
        }
        if photon.depth >= bottom {
            return None;
        }
        photon.scatter(medium.table(), words);
    }
}

/// The bin of a cosine.
fn bin(mu: f64) -> usize {
    ((libm::acos(mu.clamp(0.0, 1.0)) / WIDTH) as usize).min(BINS - 1)
}

/// Share of diffuse light in a bin: the difference of sin²θ at its ends.
fn share(bin: usize) -> f64 {
    let square = |edge: usize| libm::sin(edge as f64 * WIDTH) * libm::sin(edge as f64 * WIDTH);
    square(bin + 1) - square(bin)
}

/// Solved albedos: means over the bins (Simpson's rule, 8 steps in sin²θ, whose error is in the `std_error`), and at middles.
pub fn solved(medium: &TraceMedium, bottom: f64) -> [(Estimate, f64); BINS] {
    const STEPS: usize = 8;
    let node = |k: usize, i: usize| {
        let square = |edge: usize| libm::sin(edge as f64 * WIDTH) * libm::sin(edge as f64 * WIDTH);
        let sine = square(k) + (square(k + 1) - square(k)) * i as f64 / STEPS as f64;
        (1.0 - sine).max(0.0).sqrt()
    };
    let beams = (0..BINS).flat_map(|k| {
        let middle = libm::cos((k as f64 + 0.5) * WIDTH);
        (0..=STEPS).map(move |i| node(k, i)).chain([middle])
    });
    let beams: Vec<Incidence> = beams.map(|mu| Incidence::beam(mu).unwrap()).collect();
    let solver = Solver::new(SolveMedium::from(medium), 1e-4).unwrap();
    let solved = solver.totals(&[bottom], &beams).unwrap();
    std::array::from_fn(|k| {
        let at = |i: usize| solved.total(k * (STEPS + 2) + i, 0).0.value;
        let rule = |step: usize| {
            let inner = |i: usize| if i / step % 2 == 1 { 4.0 } else { 2.0 } * at(i);
            let inner: f64 = (step..STEPS).step_by(step).map(inner).sum();
            (at(0) + inner + at(STEPS)) * step as f64 / (3 * STEPS) as f64
        };
        let std_error = (rule(1) - rule(2)).abs() + solved.worst_error();
        (Estimate { value: rule(1), std_error }, at(STEPS + 1))
    })
}

/// Merits of one slab from replicates.
pub fn compare(phase: &str, medium: &TraceMedium, tau: f64, photons: u64, replicates: u64) -> Vec<SortedRow> {
    let runs: Vec<Albedos> = (0..replicates).map(|r| albedos(medium, tau, photons, r)).collect();
    let truth = solved(medium, tau);
    let row = |k: usize| {
        let found: [Estimate; 3] = std::array::from_fn(|way| mean(&runs, |run| run[way][k]));
        let square = |way: usize| found[way].std_error * found[way].std_error;
        SortedRow {
            phase: phase.to_owned(),
            tau,
            theta_from_deg: (k as f64 * WIDTH).to_degrees().round(),
            solved: truth::solved(truth[k].0.value),
            mean_less_middle: rounded(truth[k].0.value - truth[k].1),
            variance: rounded(square(0) * (photons * replicates) as f64),
            merit_exit: rounded(square(0) / square(1)),
            merit_both: rounded(square(0) / square(2)),
            largest_z: rounded(largest(&found.map(|found| z_score(found, truth[k].0)))),
        }
    };
    (0..BINS).map(row).collect()
}

/// Mean over runs and its standard error.
fn mean(runs: &[Albedos], of: impl Fn(&Albedos) -> f64) -> Estimate {
    let n = runs.len() as f64;
    let value = runs.iter().map(&of).sum::<f64>() / n;
    let square = runs.iter().map(|run| (of(run) - value) * (of(run) - value)).sum::<f64>();
    Estimate { value, std_error: (square / (n - 1.0) / n).sqrt() }
}
