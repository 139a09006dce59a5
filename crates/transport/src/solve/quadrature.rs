//! Half-range streams, dense towards grazing, and the polynomials that go with them.
//!
//! Radiances leaving a slab have singularities at grazing (μ ln μ), and in a thin slab they change over μ ~
//! τ. Streams are therefore polynomials in y = μ^{1/q}: μ_i = y_i^q with the Gauss rule of ∫₀¹f q y^{q-1} dy
//! = ∫₀¹f dμ; Σw_i = 1. q = 3: with q = 2 a slab of τ = 1e-6 would need thousands of streams at μ0 = 0 (its
//! layer is 1e-3 wide in √μ, but 1e-2 in the cube root), from q = 6 on 1/μ loses digits and forward peaks
//! need more streams. From the largest stream to the smallest, so that matrices in 1/μ are graded with their
//! large elements last. φ_k(y), orthonormal on dμ, are Jacobi polynomials P_k^{(0,q-1)}(x), x = 2y - 1, with
//! xφ_k = b_{k+1}φ_{k+1} + a_kφ_k + b_kφ_{k-1} (Abramowitz & Stegun 22.7.1). Q_ik = √w_i φ_k(y_i) is an
//! orthogonal matrix: node values times √w to coefficients and back.

use super::matrix::{Matrix, dot};
use std::f64::consts::PI;

/// q of μ = y^q.
pub(crate) const POWER: usize = 3;

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
        let table: Vec<(f64, f64)> = (0..=count).map(recurrence).collect();
        let y = nodes(&table);
        let mut transform = Matrix::zeros(count);
        let mut weight = Vec::with_capacity(count);
        for (i, y) in y.iter().enumerate() {
            let row = transform.row_mut(i);
            polynomials(*y, &table, row);
            // The rule's weights are 1/Σφ_k².
            weight.push(1.0 / dot(row, row));
            row.iter_mut().for_each(|value| *value *= weight[i].sqrt());
        }
        let root_weight: Vec<f64> = weight.iter().map(|w| w.sqrt()).collect();
        let mu = y.iter().map(|y| (0..POWER).fold(1.0, |mu, _| mu * y)).collect();
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
    let (k, beta) = (k as f64, POWER as f64 - 1.0);
    let s = 2.0 * k + beta;
    let a = beta * beta / (s * (s + 2.0));
    (a, 2.0 * k * (k + beta) / (s * ((s - 1.0) * (s + 1.0)).sqrt()))
}

/// φ_0(y) … φ_{n-1}(y).
fn polynomials(y: f64, table: &[(f64, f64)], row: &mut [f64]) {
    let (mut before, mut value) = (0.0, 1.0);
    for (entry, pair) in row.iter_mut().zip(table.windows(2)) {
        *entry = value;
        let [(a, b), (_, up)] = [pair[0], pair[1]];
        (before, value) = (value, ((2.0 * y - 1.0 - a) * value - b * before) / up);
    }
}

/// y, falling: zeros of φ_n by Newton's method, each zero divided out once it is found (Maehly 1954).
fn nodes(table: &[(f64, f64)]) -> Vec<f64> {
    const STEPS: usize = 40;
    let count = table.len() - 1;
    let (n, beta) = (count as f64, POWER as f64 - 1.0);
    let mut found: Vec<f64> = Vec::with_capacity(count);
    for i in 0..count {
        let guess = libm::cos(PI * (2.0 * i as f64 + 1.5) / (2.0 * n + beta + 1.0));
        let mut y = 0.5 * (1.0 + guess);
        for _ in 0..STEPS {
            let others = found.iter().fold(0.0, |sum, other| sum + 1.0 / (y - other));
            let step = 1.0 / (logarithmic_slope(y, table) - others);
            y -= step;
            // Convergence is quadratic: the next step would be rounding.
            if step.abs() <= 1e-10 * y {
                break;
            }
        }
        found.push(y);
    }
    found
}

/// φ_n'/φ_n at y, from the recurrence and its derivative.
fn logarithmic_slope(y: f64, table: &[(f64, f64)]) -> f64 {
    let (mut before, mut value) = ((0.0, 0.0), (1.0, 0.0));
    for pair in table.windows(2) {
        let [(a, b), (_, up)] = [pair[0], pair[1]];
        let x = 2.0 * y - 1.0 - a;
        let next = (x * value.0 - b * before.0, 2.0 * value.0 + x * value.1 - b * before.1);
        (before, value) = (value, (next.0 / up, next.1 / up));
    }
    value.1 / value.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_orthogonal() {
        for count in [1, 2, 8, 33, 128] {
            let streams = Streams::new(count);
            assert!(streams.mu.windows(2).all(|pair| pair[1] < pair[0]), "{count}");
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
