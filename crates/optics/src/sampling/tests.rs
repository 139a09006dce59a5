//! The table against the cumulatives of the functions it was made from.

use super::{LinearPieces, SamplingTable};
use crate::phase::{HenyeyGreenstein, Isotropic, Modified, PhaseFunction, PhaseTable};
use rand::Rng;
use std::sync::Arc;
use stratiform_quantities::Asymmetry;
use stratiform_stats::{Purpose, chi_square, key, photon_stream};

/// A third of the light in v ∈ [0.1, 0.2], the rest in [1.5, 1.6]: the gap begins inside an interval.
struct Gap;

impl PhaseFunction for Gap {
    fn value(&self, v: f64) -> f64 {
        match v {
            0.1..=0.2 => 20.0 / 3.0,
            1.5..=1.6 => 40.0 / 3.0,
            _ => 0.0,
        }
    }

    fn cumulative(&self, v: f64) -> f64 {
        ((v - 0.1).clamp(0.0, 0.1) + 2.0 * (v - 1.5).clamp(0.0, 0.1)) / 0.3
    }

    fn invert(&self, xi: f64) -> f64 {
        if xi < 1.0 / 3.0 { 0.1 + 0.3 * xi } else { 1.5 + 0.15 * (xi - 1.0 / 3.0) }
    }

    fn asymmetry(&self) -> f64 {
        unreachable!("not needed for sampling")
    }

    fn moments(&self, _count: usize) -> Vec<f64> {
        unreachable!("not needed for sampling")
    }
}

const EDGE_DEG: f64 = 5.0;

fn hg(g: f64) -> HenyeyGreenstein {
    HenyeyGreenstein::new(Asymmetry::new(g).unwrap())
}

/// A function cut off below 5°, as the modified medium's is.
fn cut(inner: Arc<dyn PhaseFunction>) -> Arc<dyn PhaseFunction> {
    Arc::new(Modified::new(inner, EDGE_DEG).unwrap())
}

/// Moments 0.9^l as a table, piecewise linear in Θ.
fn table() -> Arc<dyn PhaseFunction> {
    let moments: Vec<f64> = (0..200).map(|l| libm::pow(0.9, f64::from(l))).collect();
    Arc::new(PhaseTable::from_moments(&moments).unwrap())
}

fn functions() -> Vec<(&'static str, Arc<dyn PhaseFunction>)> {
    vec![
        ("isotropic", Arc::new(Isotropic)),
        ("hg -0.5", Arc::new(hg(-0.5))),
        ("hg 0.85", Arc::new(hg(0.85))),
        ("hg 0.99", Arc::new(hg(0.99))),
        ("hg 0.999", Arc::new(hg(0.999))),
        ("cut hg 0.85", cut(Arc::new(hg(0.85)))),
        ("cut hg 0.99", cut(Arc::new(hg(0.99)))),
        ("table", table()),
        ("cut table", cut(table())),
        ("gap", Arc::new(Gap)),
    ]
}

/// Ends of every interval with their neighbours, and a million words in between.
fn words() -> impl Iterator<Item = u32> {
    let ends = (0..4096_u32).flat_map(|k| (0..3_u32).map(move |d| (k << 20).wrapping_sub(1).wrapping_add(d)));
    ends.chain((0..1_000_000_u32).map(|k| k.wrapping_mul(2_654_435_761)))
}

fn xi(word: u32) -> f64 {
    (f64::from(word) + 0.5) / 4_294_967_296.0
}

#[test]
fn inversion_is_within_its_bound() {
    for (name, phase) in functions() {
        let table = SamplingTable::new(phase.clone());
        for word in words() {
            let v = table.sample(word);
            assert!((0.0..=2.0).contains(&v), "{name}: v = {v}");
            let error = (phase.cumulative(v) - xi(word)).abs();
            assert!(error <= SamplingTable::BOUND, "{name}: word {word}, v = {v}, error {error:e}");
        }
    }
}

#[test]
fn sampling_is_monotone() {
    for (name, phase) in functions() {
        let table = SamplingTable::new(phase);
        let mut sorted: Vec<u32> = words().collect();
        sorted.sort_unstable();
        for pair in sorted.windows(2) {
            assert!(table.sample(pair[0]) <= table.sample(pair[1]), "{name}: {pair:?}");
        }
    }
}

#[test]
fn one_by_one_and_all_at_once_are_the_same() {
    for (_, phase) in functions() {
        let table = SamplingTable::new(phase);
        let all: Vec<u32> = words().take(20_000).collect();
        for chunk in all.chunks_exact(16) {
            let words: &[u32; 16] = chunk.try_into().unwrap();
            assert_eq!(table.sample_all(words), words.map(|word| table.sample(word)));
        }
    }
}

#[test]
fn nothing_is_sampled_where_the_function_is_zero() {
    // 1 - cos 5°, less rounding.
    let edge = 0.003_805_301_908_254_45;
    for inner in [Arc::new(hg(0.85)), Arc::new(hg(0.99)), table()] {
        let table = SamplingTable::new(cut(inner));
        assert!(words().all(|word| table.sample(word) >= edge));
    }
    let table = SamplingTable::new(Arc::new(Gap));
    assert!(words().all(|word| Gap.value(table.sample(word)) > 0.0));
}

/// The exact path is a rare one.
#[test]
fn few_intervals_need_exact_inversion() {
    for (name, phase) in functions() {
        let share = SamplingTable::new(phase).exact_share();
        assert!(share <= 0.005, "{name}: {share}");
    }
}

/// P-value of 2·10⁶ samples of `sampled` in 400 cells, against the cumulative of `claimed`.
fn p_value(sampled: Arc<dyn PhaseFunction>, claimed: &dyn PhaseFunction, seed: u64) -> f64 {
    let samples = 2_000_000;
    // Cells of equal probability, in v.
    let edges: Vec<f64> = (1..400).map(|k| claimed.invert(f64::from(k) / 400.0)).collect();
    let table = SamplingTable::new(sampled);
    let mut rng = photon_stream(key(seed, Purpose::Calibration), 0);
    let mut observed = vec![0; 400];
    for _ in 0..samples {
        let v = table.sample(rng.next_u32());
        observed[edges.partition_point(|edge| *edge < v)] += 1;
    }
    let mut bounds: Vec<f64> = edges.iter().map(|v| claimed.cumulative(*v)).collect();
    bounds.insert(0, 0.0);
    bounds.push(1.0);
    let expected: Vec<f64> = bounds.windows(2).map(|pair| (pair[1] - pair[0]) * f64::from(samples)).collect();
    chi_square(&observed, &expected).unwrap().p_value
}

/// Ten tests at p = 10⁻⁴ each: one false alarm in 1000 seeds.
#[test]
fn samples_follow_the_cumulative() {
    for (name, phase) in functions() {
        let p = p_value(phase.clone(), phase.as_ref(), 11);
        assert!(p > 1e-4, "{name}: p = {p:e}");
    }
}

/// The same test tells g = 0.85 from one 1 % smaller.
#[test]
fn a_planted_asymmetry_is_rejected() {
    assert!(p_value(Arc::new(hg(0.8415)), &hg(0.85), 11) < 1e-4);
}

/// Legendre moments 0…63 of the samples of 2²⁰ evenly spaced words.
fn sampled_moments(pieces: &LinearPieces) -> Vec<f64> {
    let mut sums = vec![0.0; 64];
    for k in 0..1_u32 << 20 {
        let x = 1.0 - f64::from(pieces.sample((k << 12) + 2048));
        let (mut before, mut value) = (0.0, 1.0);
        for (l, sum) in sums.iter_mut().enumerate() {
            *sum += value;
            let l = l as f64;
            (before, value) = (value, ((2.0 * l + 1.0) * x * value - l * before) / (l + 1.0));
        }
    }
    sums.iter().map(|sum| sum / f64::from(1 << 20)).collect()
}

#[test]
fn straight_pieces_keep_the_moments() {
    for (name, phase) in functions().into_iter().filter(|(name, _)| *name != "gap") {
        let pieces = LinearPieces::new(phase.as_ref());
        let (exact, got) = (phase.moments(64), sampled_moments(&pieces));
        let errors: Vec<f64> = exact.iter().zip(&got).map(|(a, b)| (a - b).abs()).collect();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        assert!(worst < 1e-6, "{name}: {worst:e}");
    }
}
