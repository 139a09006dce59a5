//! Half-range Gauss–Legendre streams and the polynomials that go with them.
//!
//! Streams μ_i ∈ (0, 1), Σw_i = 1, from the largest to the smallest (so that matrices in 1/μ are graded with their
//! large elements last). φ_k(μ) = √(2k+1) P_k(2μ-1) are orthonormal on \[0, 1\], and Q_ik = √w_i φ_k(μ_i) is an
//! orthogonal matrix: node values times √w to coefficients and back.

use super::matrix::Matrix;
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
        let (x, weight): (Vec<f64>, Vec<f64>) = gauss_legendre(count).into_iter().unzip();
        let mu: Vec<f64> = x.iter().map(|x| 0.5 * (1.0 + x)).collect();
        let weight: Vec<f64> = weight.iter().map(|w| 0.5 * w).collect();
        let root_weight: Vec<f64> = weight.iter().map(|w| w.sqrt()).collect();
        let mut transform = Matrix::zeros(count);
        for (i, x) in x.iter().enumerate() {
            let row = transform.row_mut(i);
            legendre_row(*x, row);
            for (k, value) in row.iter_mut().enumerate() {
                *value *= root_weight[i] * ((2 * k + 1) as f64).sqrt();
            }
        }
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

/// Nodes (falling) and weights on \[-1, 1\] by Newton's method (Abramowitz & Stegun 25.4.29).
pub(crate) fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    let mut row = vec![0.0; count + 1];
    let mut node = |i: usize| {
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (n + 0.5));
        let mut slope = 1.0;
        for _ in 0..6 {
            legendre_row(x, &mut row);
            slope = n * (x * row[count] - row[count - 1]) / (x * x - 1.0);
            x -= row[count] / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(&mut node).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::matrix::dot;

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
