//! Half-range streams, dense towards grazing, and the polynomials that go with them.
//!
//! Radiances leaving a slab have singularities at grazing (μ ln μ; e^{-τ/μ} in thin slabs). Streams are
//! therefore polynomials in y = √μ: μ_i = y_i² with the Gauss rule of ∫₀¹f 2y dy = ∫₀¹f dμ, the points of
//! the Radau rule in x = 2y - 1 without x = -1 (zeros of P_n + P_{n+1}; Abramowitz & Stegun 25.4.31). Σw_i
//! = 1; from the largest stream to the smallest, so that matrices in 1/μ are graded with their large
//! elements last. φ_k(y), orthonormal on dμ, are Jacobi polynomials P_k^{(0,1)}(x) with xφ_k =
//! b_{k+1}φ_{k+1} + a_kφ_k + b_kφ_{k-1}, a_k = 1/((2k+1)(2k+3)), b_k = √(k(k+1))/(2k+1). Q_ik = √w_i
//! φ_k(y_i) is an orthogonal matrix: node values times √w to coefficients and back.

use super::matrix::{Matrix, dot};
use std::f64::consts::PI;

/// The streams of one hemisphere.
#[derive(Clone, Debug)]
pub(crate) struct Streams {
    pub(crate) mu: Vec<f64>,
    pub(crate) weight: Vec<f64>,
    pub(crate) root_weight: Vec<f64>,
    /// Q_ik.
    pub(crate) transform: Matrix,
}

impl Streams {
    pub(crate) fn new(count: usize) -> Self {
        let y = nodes(count);
        let mut transform = Matrix::zeros(count);
        let mut weight = Vec::with_capacity(count);
        for (i, y) in y.iter().enumerate() {
            let row = transform.row_mut(i);
            polynomials(*y, row);
            // The rule's weights are 1/Σφ_k².
            weight.push(1.0 / dot(row, row));
            row.iter_mut().for_each(|value| *value *= weight[i].sqrt());
        }
        let root_weight: Vec<f64> = weight.iter().map(|w| w.sqrt()).collect();
        let mu = y.iter().map(|y| y * y).collect();
        Self { mu, weight, root_weight, transform }
    }

    pub(crate) fn count(&self) -> usize {
        self.mu.len()
    }
}

/// P_0(x) … P_{n-1}(x).
pub(crate) fn legendre_row(x: f64, row: &mut [f64]) {
    let (mut before, mut value) = (0.0, 1.0);
    for (l, p) in row.iter_mut().enumerate() {
        *p = value;
        let l = l as f64;
        (before, value) = (value, ((2.0 * l + 1.0) * x * value - l * before) / (l + 1.0));
    }
}

/// a_k and b_k.
pub(crate) fn recurrence(k: usize) -> (f64, f64) {
    let k = k as f64;
    (1.0 / ((2.0 * k + 1.0) * (2.0 * k + 3.0)), (k * (k + 1.0)).sqrt() / (2.0 * k + 1.0))
}

/// φ_0(y) … φ_{n-1}(y).
fn polynomials(y: f64, row: &mut [f64]) {
    let (mut before, mut value) = (0.0, 1.0);
    for (k, entry) in row.iter_mut().enumerate() {
        *entry = value;
        let (a, b) = recurrence(k);
        (before, value) = (value, ((2.0 * y - 1.0 - a) * value - b * before) / recurrence(k + 1).1);
    }
}

/// y, falling, by Newton's method on P_n + P_{n+1}.
fn nodes(count: usize) -> Vec<f64> {
    let n = count as f64;
    let mut row = vec![0.0; count + 2];
    let mut node = |i: usize| {
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (n + 1.0));
        for _ in 0..6 {
            legendre_row(x, &mut row);
            let (below, above) = (row[count], row[count + 1]);
            let slope = n * (x * below - row[count - 1]) + (n + 1.0) * (x * above - below);
            x -= (below + above) * (x * x - 1.0) / slope;
        }
        0.5 * (1.0 + x)
    };
    (0..count).map(&mut node).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_orthogonal() {
        for count in [1, 2, 8, 33, 128] {
            let streams = Streams::new(count);
            for i in [0, count / 2, count - 1] {
                for j in 0..count {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    let product = dot(streams.transform.row(i), streams.transform.row(j));
                    assert!((product - expected).abs() < 1e-12, "{count} {i} {j}");
                }
            }
        }
    }
}
