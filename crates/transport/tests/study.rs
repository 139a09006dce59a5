//! The estimators of `benches/estimators` in small: unbiased against the solver, by a check that sees planted errors.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../benches/estimators/study/mod.rs"]
#[allow(dead_code, reason = "the benchmark uses the rest")]
mod study;

use std::ops::Range;
use stratiform_stats::{Purpose, family_threshold, key};
use study::expected::expected_with;
use study::measure::measure;
use study::scores::Scores;
use study::{ALL, Estimator, Job, half_space, media, sorted, truth};

/// Of each family of normal z. These z have Student's distribution with 127 degrees of freedom, which exceeds the threshold four
/// times as often: false alarms are 4 in 10 000 seeds.
const ALPHA: f64 = 1e-4;
const PHOTONS: u64 = 512;
const REPLICATES: u64 = 128;
const BOTTOMS: [f64; 3] = [0.25, 2.0, 8.0];

/// z of every common mean of each estimator in turn.
fn z_scores(estimators: &[(&str, Estimator)], mu0: f64) -> Vec<Vec<f64>> {
    let medium = media::henyey_greenstein();
    let job = Job { table: medium.table(), bottoms: &BOTTOMS, mu0, key: key(3, Purpose::Calibration) };
    let truth = truth::solve(&medium, &BOTTOMS, mu0);
    let z = |(_, run): &(&str, Estimator)| truth::z_scores(&measure(*run, &job, PHOTONS, REPLICATES), &truth);
    estimators.iter().map(z).collect()
}

fn accepts(z: &[f64]) -> bool {
    truth::largest(z) <= family_threshold(ALPHA, z.len()).unwrap()
}

#[test]
fn every_estimator_is_unbiased() {
    let z: Vec<f64> = [1.0, 0.3].iter().flat_map(|mu0| z_scores(&ALL, *mu0)).flatten().collect();
    assert!(z.len() > 200, "guard against checking nothing: {}", z.len());
    assert!(accepts(&z), "{}", truth::largest(&z));
}

#[test]
fn planted_errors_are_rejected() {
    fn without_slant(job: &Job<'_>, photons: Range<u64>) -> Scores {
        expected_with(job, photons, |depth, _| libm::exp(-depth))
    }
    fn linear(job: &Job<'_>, photons: Range<u64>) -> Scores {
        expected_with(job, photons, |depth, mu| (1.0 - depth / mu).max(0.0))
    }
    fn thinner(job: &Job<'_>, photons: Range<u64>) -> Scores {
        half_space(&Job { bottoms: &BOTTOMS.map(|bottom| 0.9 * bottom), ..*job }, photons)
    }
    let planted: [(&str, Estimator); 3] =
        [("slant", without_slant), ("linear", linear), ("thinner", thinner)];
    for ((name, _), z) in planted.iter().zip(z_scores(&planted, 0.3)) {
        assert!(!accepts(&z), "{name}");
    }
}

/// Photons of one diffusely lit run tell the same albedos by entry and, through reciprocity, by exit.
#[test]
fn albedos_by_entry_and_exit_are_the_solved_ones() {
    let rows = sorted::compare("hg 0.85", &media::henyey_greenstein(), 4.0, PHOTONS, REPLICATES);
    let z = truth::largest(&rows.iter().map(|row| row.largest_z).collect::<Vec<f64>>());
    assert!(z <= family_threshold(ALPHA, 3 * rows.len()).unwrap(), "{z}");
    assert!(rows.iter().all(|row| row.merit_exit < 1.6 && row.merit_both > 1.0));
}
