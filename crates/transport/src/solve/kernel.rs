//! Scattering between streams, every Legendre moment included, whatever the number of streams.
//!
//! The azimuthally averaged redistribution p(μ,μ') = Σ(2l+1)χ_l P_l(μ)P_l(μ') acts on polynomials of degree
//! < n in each hemisphere in y = μ^{1/q} (Galerkin): K_kk' = Σ(2l+1)χ_l c_kl c_k'l over even or odd l, with
//! c_kl = ∫₀¹φ_k P_l dμ. A usual discrete-ordinate code evaluates P_l at the nodes, must stop at l = 2n, and so
//! needs δ-M (Wiscombe 1977) for a peak. Here a peak narrower than the streams, even χ_l = 1 for all l,
//! becomes the identity it is for smooth radiances: what δ-M approximates. K is the compression of an
//! operator of norm ≤ 1, so the medium never creates light; and ∫P_l dμ = 0 for even l > 0 holds to
//! rounding, so none is lost.
//!
//! c_kl follows from the recurrence of P_l, (l+1)P_{l+1} = (2l+1)μP_l - lP_{l-1}, in the basis φ_k, where μ
//! = y^q is the tridiagonal matrix of y applied q times.

use super::matrix::{Matrix, add_scaled};
use super::quadrature::{POWER, Streams, legendre_row, recurrence};

/// Moments and their compression to at most `size` polynomials per hemisphere.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    moments: Vec<f64>,
    /// c_kl, a row of `size` numbers for each l.
    projections: Vec<f64>,
    even: Matrix,
    odd: Matrix,
}

/// p(μ, μ_j) √w_j from the streams into one direction, for even and odd l.
pub(crate) struct Towards {
    pub(crate) even: Vec<f64>,
    pub(crate) odd: Vec<f64>,
}

impl Kernel {
    pub(crate) fn new(moments: Vec<f64>, size: usize) -> Self {
        let projections = projections(moments.len(), size);
        let [even, odd] = compressed(&moments, &projections, size);
        Self { moments, projections, even, odd }
    }

    /// W^{1/2} p W^{1/2} between streams, for even and odd l.
    pub(crate) fn between(&self, streams: &Streams) -> (Matrix, Matrix) {
        let to_nodes = |coefficients: &Matrix| {
            let leading = Matrix::from_fn(streams.count(), |k, m| coefficients[(k, m)]);
            streams.transform.times(&leading).times(&streams.transform.transposed())
        };
        (to_nodes(&self.even), to_nodes(&self.odd))
    }

    /// Into any direction cosine `mu`.
    pub(crate) fn towards(&self, mu: f64, streams: &Streams) -> Towards {
        let count = streams.count();
        let mut weights = vec![0.0; self.moments.len()];
        legendre_row(mu, &mut weights);
        let each = weights.iter_mut().zip(&self.moments).enumerate();
        each.for_each(|(l, (weight, chi))| *weight *= (2 * l + 1) as f64 * chi);
        let parity = onto(&weights, &self.projections, (self.even.size(), count));
        let to_nodes = |coefficients: &[f64]| {
            (0..count).map(|j| super::matrix::dot(streams.transform.row(j), coefficients)).collect()
        };
        Towards { even: to_nodes(&parity[0]), odd: to_nodes(&parity[1]) }
    }
}

/// K_kk' of even and of odd l.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn compressed(moments: &[f64], projections: &[f64], size: usize) -> [Matrix; 2] {
    let mut parity = [Matrix::zeros(size), Matrix::zeros(size)];
    for (l, (row, chi)) in projections.chunks_exact(size).zip(moments).enumerate() {
        let weight = (2 * l + 1) as f64 * chi;
        if weight != 0.0 {
            for (k, c) in row.iter().enumerate() {
                add_scaled(parity[l % 2].row_mut(k), weight * c, row);
            }
        }
    }
    parity
}

/// Σ weight_l c_kl of even and of odd l, for k < `count`.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn onto(weights: &[f64], projections: &[f64], (size, count): (usize, usize)) -> [Vec<f64>; 2] {
    let mut parity = [vec![0.0; count], vec![0.0; count]];
    for (l, (row, weight)) in projections.chunks_exact(size).zip(weights).enumerate() {
        add_scaled(&mut parity[l % 2], *weight, &row[..count]);
    }
    parity
}

/// c_kl for l < `count`, k < `size`. Polynomials have a zero ahead, so that every k has a neighbour.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn projections(count: usize, size: usize) -> Vec<f64> {
    let width = size + POWER * (count + 2);
    let (middle, beside): (Vec<f64>, Vec<f64>) =
        (0..=width).map(recurrence).map(|(a, b)| (0.5 * (1.0 + a), 0.5 * b)).unzip();
    let mut before = vec![0.0; width + 2];
    let (mut now, mut left, mut right) = (before.clone(), before.clone(), before.clone());
    now[1] = 1.0;
    let mut table = Vec::with_capacity(count * size);
    for l in 0..count {
        table.extend_from_slice(&now[1..=size]);
        // Beyond k = ql all is zero; beyond size + q(count - l) nothing is asked for.
        let last = (POWER * (l + 2)).min(size + POWER * (count - l));
        let times_y = |of: &[f64], put: &mut [f64], (old, new): (f64, f64)| {
            let neighbours = of[..last].iter().zip(&of[1..=last]).zip(&of[2..last + 2]);
            let coefficients = beside[..last].iter().zip(&middle[..last]).zip(&beside[1..=last]);
            for ((put, ((low, of), high)), ((below, a), above)) in
                put[1..=last].iter_mut().zip(neighbours).zip(coefficients)
            {
                *put = old * *put + new * (above * high + a * of + below * low);
            }
        };
        times_y(&now, &mut left, (0.0, 1.0));
        for _ in 2..POWER {
            times_y(&left, &mut right, (0.0, 1.0));
            std::mem::swap(&mut left, &mut right);
        }
        let (up, down) = ((2 * l + 1) as f64 / (l + 1) as f64, l as f64 / (l + 1) as f64);
        // P_{l-1} makes room for P_{l+1}.
        times_y(&left, &mut before, (-down, up));
        std::mem::swap(&mut before, &mut now);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the rule itself, with enough points to be exact: √w_i φ_k(y_i) times √w_i P_l(y_i^q), summed.
    #[test]
    fn the_recurrence_gives_the_integrals() {
        let (count, size) = (200, 20);
        let table = projections(count, size);
        let streams = Streams::new((POWER * count + size) / 2 + 1);
        let mut by_quadrature = vec![0.0; count * size];
        let mut p = vec![0.0; count];
        for (i, mu) in streams.mu.iter().enumerate() {
            legendre_row(*mu, &mut p);
            for (l, p) in p.iter().enumerate() {
                let row = &mut by_quadrature[l * size..(l + 1) * size];
                add_scaled(row, p * streams.root_weight[i], &streams.transform.row(i)[..size]);
            }
        }
        let worst = table.iter().zip(&by_quadrature).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
        assert!(worst < 1e-12, "{worst:e}");
    }

    /// χ_l = 1 is no scattering at all: the identity. The sum over l converges like 1/L.
    #[test]
    fn a_delta_peak_is_the_identity() {
        let streams = Streams::new(6);
        let (even, odd) = Kernel::new(vec![1.0; 4000], 6).between(&streams);
        for i in 0..6 {
            for j in 0..6 {
                let expected = if i == j { 1.0 } else { 0.0 };
                let found = 0.5 * (even[(i, j)] + odd[(i, j)]);
                assert!((found - expected).abs() < 0.1, "{i} {j}: {found}");
            }
        }
    }
}
