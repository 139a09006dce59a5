//! Light from plane to plane without the library's weights: every fine texel to every other, the kernel h²/(π (r² + h²)²) integrated over the
//! giving texel by two Gauss points each way, images summed over [`IMAGES`] periods each way from the nearest row outwards, the rest spread evenly.

#![allow(dead_code, reason = "tests and the example use their parts")]

use std::f64::consts::PI;
use stratiform_render::RingRule;
use stratiform_render::radiosity::Weights;
use stratiform_world::Map;

/// Periods on each side whose images are summed.
pub const IMAGES: i32 = 6;
/// Fine texels along a texel of the exchange.
pub const FINER: usize = 4;

/// Every rule.
pub const RULES: [RingRule; 5] = [
    RingRule::AsPrinted,
    RingRule::WiderSquares,
    RingRule::SquareWeights,
    RingRule::Exact,
    RingRule::LeastSquares,
];

/// Share that reaches the centre of texel 0 from texel `(x, y)`, `h` in texels.
fn shares(side: usize, h: f64) -> Vec<f64> {
    let kernel = |x: f64, y: f64| {
        let square = x * x + y * y + h * h;
        h * h / (PI * square * square)
    };
    let gauss = 0.5 / 3.0_f64.sqrt();
    let texel = |x: f64, y: f64| {
        let corners = [(-gauss, -gauss), (gauss, -gauss), (-gauss, gauss), (gauss, gauss)];
        corners.iter().map(|(u, v)| 0.25 * kernel(x + u, y + v)).sum::<f64>()
    };
    let n = side as i32;
    let nearest = |i: usize| ((i as i32 + n / 2) % n - n / 2, n);
    let images = |i: usize| {
        let ((x, n), (y, _)) = (nearest(i % side), nearest(i / side));
        let mut sum = 0.0;
        for u in -IMAGES..=IMAGES {
            for v in -IMAGES..=IMAGES {
                sum += texel(f64::from(x + u * n), f64::from(y + v * n));
            }
        }
        sum
    };
    let near: Vec<f64> = (0..side * side).map(images).collect();
    let rest = (1.0 - near.iter().sum::<f64>()) / (side * side) as f64;
    near.iter().map(|share| share + rest).collect()
}

/// Irradiance at the centres of `side` x `side` texels from as many of these radiosities, planes `h` texels apart.
pub fn irradiance(radiosity: &[f64], side: usize, h: f64) -> Vec<f64> {
    let share = shares(side, h);
    let at = |p: usize| {
        let (x, y) = (p % side, p / side);
        let mut sum = 0.0;
        for (q, b) in radiosity.iter().enumerate() {
            sum += share[(q / side + side - y) % side * side + (q % side + side - x) % side] * b;
        }
        sum
    };
    (0..side * side).map(at).collect()
}

/// What a rule makes of the same radiosities: their means over `FINER` x `FINER` texels, gathered, bilinear at the fine texels' centres.
pub fn by_rule(rule: RingRule, radiosity: &[f64], side: usize, h: f64) -> Vec<f64> {
    let coarse = side / FINER;
    let mean = |i: usize| {
        let fine = |k: usize| (i / coarse * FINER + k / FINER) * side + i % coarse * FINER + k % FINER;
        [(0..FINER * FINER).map(|k| radiosity[fine(k)]).sum::<f64>() / (FINER * FINER) as f64; 3]
    };
    let means: Vec<[f64; 3]> = (0..coarse * coarse).map(mean).collect();
    let weights = Weights::new(rule, coarse, FINER as f64, h).unwrap();
    let map = Map::new(coarse, side as f64, weights.gather(&means)).unwrap();
    (0..side * side).map(|i| map.value((i % side) as f64 + 0.5, (i / side) as f64 + 0.5)[0]).collect()
}

/// Root mean square and largest error over the mean of the truth.
pub fn error(found: &[f64], truth: &[f64]) -> [f64; 2] {
    let count = truth.len() as f64;
    let mean = truth.iter().sum::<f64>() / count;
    let off = || found.iter().zip(truth).map(|(a, b)| (a - b).abs());
    let rms = (off().map(|d| d * d).sum::<f64>() / count).sqrt();
    [rms / mean, off().fold(0.0, f64::max) / mean]
}
