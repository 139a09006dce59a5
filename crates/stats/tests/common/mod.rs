//! Draws of the calibrations, and the interval that holds them to the stated rate.

#![allow(dead_code, reason = "each test program uses a part")]

use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;
use stratiform_stats::{Purpose, key, photon_stream};

/// Seeds of every calibration.
pub const SEEDS: u64 = 2000;

/// Uniform on (0, 1).
pub fn uniform(rng: &mut Pcg32) -> f64 {
    (f64::from(rng.next_u32()) + 0.5) / 4_294_967_296.0
}

/// Standard normal (Box & Muller 1958).
pub fn normal(rng: &mut Pcg32) -> f64 {
    let radius = (-2.0 * libm::log(uniform(rng))).sqrt();
    radius * libm::cos(TAU * uniform(rng))
}

/// `draws` cells of a distribution given by its cumulative shares.
pub fn histogram(rng: &mut Pcg32, cumulative: &[f64], draws: u64) -> Vec<u64> {
    let mut counts = vec![0; cumulative.len()];
    for _ in 0..draws {
        let xi = uniform(rng);
        counts[cumulative.iter().position(|share| xi < *share).unwrap_or(cumulative.len() - 1)] += 1;
    }
    counts
}

/// In how many of [`SEEDS`] independent draws `alarm` sounds.
pub fn alarms(test: u64, mut alarm: impl FnMut(&mut Pcg32) -> bool) -> u64 {
    let streams = (0..SEEDS).map(|seed| photon_stream(key(seed, Purpose::Calibration), test));
    streams.filter(|rng| alarm(&mut rng.clone())).count() as u64
}

/// Whether `alarms` of [`SEEDS`] agree with rate `alpha`: neither so many nor so few would be seen in one of 20 000
/// calibrations each, so a right instrument fails once in 10 000.
pub fn calibrated(alarms: u64, alpha: f64) -> bool {
    let log_factorial = |k: u64| libm::lgamma(k as f64 + 1.0);
    let probability = |k: u64| {
        let choose = log_factorial(SEEDS) - log_factorial(k) - log_factorial(SEEDS - k);
        libm::exp(choose + k as f64 * libm::log(alpha) + (SEEDS - k) as f64 * libm::log1p(-alpha))
    };
    let at_most: f64 = (0..=alarms).map(probability).sum();
    let at_least: f64 = (alarms..=SEEDS).map(probability).sum();
    at_most > 5e-5 && at_least > 5e-5
}
