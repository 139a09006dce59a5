//! Every comparator over 2000 seeds of true hypotheses, against its stated rate of false alarms.
//!
//! Each figure here fails a right instrument once in 10 000 choices of the seeds.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{SEEDS, alarms, calibrated, histogram, normal, uniform};
use rand_pcg::Pcg32;
use stratiform_stats::{
    Estimate, chi_square, chi_square_two_sample, family_threshold, holm, kolmogorov_smirnov,
    kolmogorov_smirnov_two_sample, z_score,
};

const ALPHAS: [f64; 2] = [0.1, 0.01];

/// p-values of true hypotheses are at most α in a share α of them.
fn check(test: u64, p_value: impl Fn(&mut Pcg32) -> f64) {
    for alpha in ALPHAS {
        let found = alarms(test, |rng| p_value(rng) <= alpha);
        assert!(calibrated(found, alpha), "{found} alarms of {SEEDS} at {alpha}");
    }
}

/// Hits of `trials` with probability 0.3.
fn hits(rng: &mut Pcg32, trials: u64) -> Estimate {
    Estimate::from_hits((0..trials).filter(|_| uniform(rng) < 0.3).count() as u64, trials)
}

#[test]
fn z_of_two_counted_proportions() {
    for alpha in ALPHAS {
        let threshold = family_threshold(alpha, 1).unwrap();
        let found = alarms(1, |rng| z_score(hits(rng, 4000), hits(rng, 2000)).abs() > threshold);
        assert!(calibrated(found, alpha), "{found} alarms of {SEEDS} at {alpha}");
    }
}

/// The comparison is worth something: errors stated 20 % too small, or 30 % too large, are noticed.
#[test]
fn wrong_errors_are_noticed() {
    for (scale, alpha) in [(0.8, 0.1), (0.8, 0.01), (1.3, 0.1)] {
        let threshold = family_threshold(alpha, 1).unwrap();
        let found = alarms(2, |rng| normal(rng).abs() / scale > threshold);
        assert!(!calibrated(found, alpha), "{found} alarms of {SEEDS} at {alpha}, errors times {scale}");
    }
    assert!(calibrated(200, 0.1) && !calibrated(140, 0.1) && !calibrated(260, 0.1));
}

#[test]
fn a_family_of_z() {
    for alpha in ALPHAS {
        let threshold = family_threshold(alpha, 10).unwrap();
        let found = alarms(3, |rng| (0..10).any(|_| normal(rng).abs() > threshold));
        assert!(calibrated(found, alpha), "{found} alarms of {SEEDS} at {alpha}");
    }
}

/// 1 - (1 - α/5)⁵ of independent hypotheses.
#[test]
fn holm_of_five() {
    for alpha in ALPHAS {
        let found = alarms(4, |rng| {
            let p: Vec<f64> = (0..5).map(|_| uniform(rng)).collect();
            holm(&p, alpha).unwrap().contains(&true)
        });
        let rate = -libm::expm1(5.0 * libm::log1p(-alpha / 5.0));
        assert!(calibrated(found, rate), "{found} alarms of {SEEDS} at {alpha}");
    }
}

/// Cumulative shares of a geometric distribution: its tail needs pooling, its last cells stay empty.
fn geometric() -> Vec<f64> {
    (1..=30).map(|k| 1.0 - libm::pow(0.7, f64::from(k))).collect()
}

#[test]
fn chi_square_against_expectations() {
    let cumulative = geometric();
    let shares = (0..30).map(|k| cumulative[k] - if k > 0 { cumulative[k - 1] } else { 0.0 });
    let expected: Vec<f64> = shares.map(|share| 2000.0 * share).collect();
    check(5, |rng| chi_square(&histogram(rng, &cumulative, 2000), &expected).unwrap().p_value);
}

#[test]
fn chi_square_of_two_histograms() {
    let cumulative = geometric();
    check(6, |rng| {
        let (a, b) = (histogram(rng, &cumulative, 3000), histogram(rng, &cumulative, 1000));
        chi_square_two_sample(&a, &b).unwrap().p_value
    });
}

fn sample(rng: &mut Pcg32, size: usize) -> Vec<f64> {
    (0..size).map(|_| normal(rng)).collect()
}

fn normal_distribution(x: f64) -> f64 {
    0.5 * libm::erfc(-x * std::f64::consts::FRAC_1_SQRT_2)
}

#[test]
fn kolmogorov_smirnov_of_one_sample() {
    for (test, size) in [(7, 5), (8, 100), (9, 1500)] {
        check(test, |rng| kolmogorov_smirnov(&sample(rng, size), normal_distribution).unwrap().p_value);
    }
}

/// 61 and 48 have no common factor: the lattice of possible distances is fine, and α is nearly met.
#[test]
fn kolmogorov_smirnov_of_two_samples() {
    check(10, |rng| kolmogorov_smirnov_two_sample(&sample(rng, 61), &sample(rng, 48)).unwrap().p_value);
}

/// Ties make it cautious, never rash.
#[test]
fn ties_raise_no_false_alarms() {
    let rounded =
        |rng: &mut Pcg32, size| -> Vec<f64> { sample(rng, size).iter().map(|x| (2.0 * x).round()).collect() };
    let found = alarms(11, |rng| {
        kolmogorov_smirnov_two_sample(&rounded(rng, 61), &rounded(rng, 48)).unwrap().p_value <= 0.1
    });
    assert!(found < 200 && found > 0, "{found} alarms of {SEEDS} at 0.1");
}

/// Its p-values are uniform, by Kolmogorov and Smirnov: the two instruments judge each other.
#[test]
fn p_values_of_chi_square_are_uniform() {
    let cumulative: Vec<f64> = (1..=10).map(|k| f64::from(k) / 10.0).collect();
    let mut p = Vec::new();
    alarms(12, |rng| {
        let (a, b) = (histogram(rng, &cumulative, 1500), histogram(rng, &cumulative, 1000));
        p.push(chi_square_two_sample(&a, &b).unwrap().p_value);
        false
    });
    assert!(kolmogorov_smirnov(&p, |p| p).unwrap().p_value > 1e-4);
    let squared: Vec<f64> = p.iter().map(|p| libm::pow(*p, 1.2)).collect();
    assert!(kolmogorov_smirnov(&squared, |p| p).unwrap().p_value < 1e-4);
}
