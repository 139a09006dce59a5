//! Weights for means over texels whose results are read bilinearly: the least squares fit of the exact kernel.
//!
//! Between planes at distance h the exact kernel multiplies a wave of wave number k by K(k) = kh K_1(kh), the Hankel transform of
//! h²/(π (r² + h²)²) (Gradshteyn & Ryzhik 6.565.4). Means over texels multiply it by a = sinc(k_x/2) sinc(k_y/2), bilinear reading by b = a², and both
//! mix it with its aliases k + 2π(m_x, m_y), texels of 1. For fields with sharp edges, whose power falls as P = |k|^-3, the weights' transform with the least
//! mean square error is W = Σ_m b K a P / (Σ_m b² Σ_m a² P). Texels wider than about h ask for negative weights: these are left out and the
//! others scaled so that Σ w = 1.

use std::f64::consts::{PI, TAU};

/// Aliases each way; those left out hold less than 1e-3 of P a².
const ALIASES: i32 = 3;

/// Weights over the offset on `side` x `side` texels, planes `h` texels apart.
pub(super) fn least_squares(side: usize, h: f64) -> Vec<f64> {
    let count = side / 2 + 1;
    let wave = |n: usize| TAU * n as f64 / side as f64;
    let transform: Vec<f64> =
        (0..count * count).map(|i| response(wave(i % count), wave(i / count), h)).collect();
    let weights = inverse(&transform, side);
    let total: f64 = weights.iter().map(|w| w.max(0.0)).sum();
    weights.iter().map(|w| w.max(0.0) / total).collect()
}

/// W at a wave vector.
fn response(x: f64, y: f64, h: f64) -> f64 {
    if x == 0.0 && y == 0.0 {
        return 1.0;
    }
    let (mut wanted, mut read, mut given) = (0.0, 0.0, 0.0);
    for i in -ALIASES..=ALIASES {
        for j in -ALIASES..=ALIASES {
            let (u, v) = (x + TAU * f64::from(i), y + TAU * f64::from(j));
            let square = u * u + v * v;
            let (k, a) = (square.sqrt(), sinc(0.5 * u) * sinc(0.5 * v));
            let (b, power) = (a * a, 1.0 / (square * k));
            wanted += b * kernel(k * h) * a * power;
            read += b * b;
            given += a * a * power;
        }
    }
    wanted / (read * given)
}

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::sin(x) / x }
}

/// z K_1(z) = ∫ z e^(-z cosh t) cosh t dt over t >= 0 by the trapezoidal rule, which converges faster than any power of its step.
pub(super) fn kernel(z: f64) -> f64 {
    const STEP: f64 = 0.2;
    if z == 0.0 {
        return 1.0;
    }
    let mut sum = 0.5 * libm::exp(-z);
    for i in 1.. {
        let cosh = libm::cosh(STEP * f64::from(i));
        let term = cosh * libm::exp(-z * cosh);
        sum += term;
        if z * cosh > 50.0 {
            break;
        }
    }
    z * STEP * sum
}

/// Σ_k W cos(k_x x) cos(k_y y)/side², W even and given for the waves 0 to side/2 each way.
fn inverse(transform: &[f64], side: usize) -> Vec<f64> {
    let count = side / 2 + 1;
    let cosines: Vec<f64> = (0..side).map(|i| libm::cos(2.0 * PI * i as f64 / side as f64)).collect();
    let sum = |of: &dyn Fn(usize) -> f64, place: usize| {
        (0..side).map(|n| of(n.min(side - n)) * cosines[n * place % side]).sum::<f64>() / side as f64
    };
    // Rows of waves y, columns of places x.
    let half: Vec<f64> =
        (0..count * side).map(|i| sum(&|n| transform[i / side * count + n], i % side)).collect();
    (0..side * side).map(|i| sum(&|n| half[n * side + i % side], i / side)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::weights::form_factors;
    use super::*;

    /// A wave on texels is a staircase: Σ over aliases of K a. Two derivations that share nothing but h.
    #[test]
    fn image_sums_have_the_kernels_transform() {
        for (side, h, bound) in [(16, 2.0, 2e-5), (7, 0.3, 1e-4), (12, 6.0, 2e-4), (8, 16.0, 1e-3)] {
            let weights = form_factors(side, h, 4);
            for (i, j) in [(0, 0), (1, 0), (1, 1), (0, 3), (2, 3)] {
                let wave = |n: usize| TAU * n as f64 / side as f64;
                let summed: f64 = (0..side * side)
                    .map(|p| weights[p] * libm::cos(wave(i * (p % side)) + wave(j * (p / side))))
                    .sum();
                let mut exact = 0.0;
                for m in -200..=200_i32 {
                    for n in -200..=200_i32 {
                        let (u, v) = (wave(i) + TAU * f64::from(m), wave(j) + TAU * f64::from(n));
                        let z = h * (u * u + v * v).sqrt();
                        if z < 40.0 {
                            exact += kernel(z) * sinc(0.5 * u) * sinc(0.5 * v);
                        }
                    }
                }
                assert!((summed - exact).abs() < bound, "{side} {h} {i} {j}: {summed} {exact}");
            }
        }
    }

    #[test]
    fn fine_texels_leave_the_kernel_as_it_is() {
        let weights = least_squares(64, 32.0);
        let wave: f64 = (0..64 * 64).map(|p| weights[p] * libm::cos(TAU * (p % 64) as f64 / 64.0)).sum();
        assert!((wave / kernel(PI) - 1.0).abs() < 2e-3, "{wave} {}", kernel(PI));
    }
}
