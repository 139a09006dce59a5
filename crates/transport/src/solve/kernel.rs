//! Scattering between streams, every Legendre moment included, whatever the number of streams.
//!
//! The azimuthally averaged redistribution p(μ,μ') = Σ(2l+1)χ_l P_l(μ)P_l(μ') acts on polynomials of degree < n in each
//! hemisphere (Galerkin): K_kk' = Σ(2l+1)χ_l c_kl c_k'l over even or odd l, with c_kl = ∫₀¹φ_k P_l dμ. A usual discrete-ordinate
//! code evaluates P_l at the nodes, must stop at l = 2n, and so needs δ-M (Wiscombe 1977) for a peak. Here a peak
//! narrower than the streams, even χ_l = 1 for all l, becomes the identity it is for smooth radiances: what δ-M approximates. K is
//! the compression of an operator of norm ≤ 1, so the medium never creates light. Σw_iK_ij = δ terms hold to rounding.
//!
//! c_kl follows from μφ_k = β_{k+1}φ_{k+1} + ½φ_k + β_kφ_{k-1}, β_k = k/(2√(4k²-1)), and the recurrence of P_l:
//! (l+1)c_{k,l+1} = (2l+1)(β_{k+1}c_{k+1,l} + ½c_kl + β_kc_{k-1,l}) - l c_{k,l-1}.

use super::matrix::{Matrix, add_scaled};
use super::quadrature::{Streams, legendre_row};

/// Moments and their compression to at most `size` polynomials per hemisphere.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    moments: Vec<f64>,
    /// c_kl, a row of `size` numbers for each l.
    projections: Vec<f64>,
    even: Matrix,
    odd: Matrix,
}

impl Kernel {
    pub(crate) fn new(moments: Vec<f64>, size: usize) -> Self {
        let projections = projections(moments.len(), size);
        let mut parity = [Matrix::zeros(size), Matrix::zeros(size)];
        for (l, (row, chi)) in projections.chunks(size).zip(&moments).enumerate() {
            let weight = (2 * l + 1) as f64 * chi;
            if weight != 0.0 {
                for (k, c) in row.iter().enumerate() {
                    add_scaled(parity[l % 2].row_mut(k), weight * c, row);
                }
            }
        }
        let [even, odd] = parity;
        Self { moments, projections, even, odd }
    }

    /// Largest number of streams served.
    pub(crate) fn size(&self) -> usize {
        self.even.size()
    }

    /// W^{1/2} p W^{1/2} between streams, for even and odd l.
    pub(crate) fn between(&self, streams: &Streams) -> (Matrix, Matrix) {
        let to_nodes = |coefficients: &Matrix| {
            let leading = Matrix::from_fn(streams.count(), |k, m| coefficients[(k, m)]);
            streams.transform.times(&leading).times(&streams.transform.transposed())
        };
        (to_nodes(&self.even), to_nodes(&self.odd))
    }

    /// p(μ, μ_j) √w_j into any direction cosine `mu`, for even and odd l.
    pub(crate) fn into_direction(&self, mu: f64, streams: &Streams) -> (Vec<f64>, Vec<f64>) {
        let (size, count) = (self.even.size(), streams.count());
        let mut legendre = vec![0.0; self.moments.len()];
        legendre_row(mu, &mut legendre);
        let mut parity = [vec![0.0; count], vec![0.0; count]];
        for (l, (row, chi)) in self.projections.chunks(size).zip(&self.moments).enumerate() {
            let weight = (2 * l + 1) as f64 * chi * legendre[l];
            add_scaled(&mut parity[l % 2], weight, &row[..count]);
        }
        let to_nodes = |coefficients: &[f64]| {
            (0..count).map(|j| super::matrix::dot(streams.transform.row(j), coefficients)).collect()
        };
        (to_nodes(&parity[0]), to_nodes(&parity[1]))
    }
}

/// c_kl for l < `count`, k < `size`.
fn projections(count: usize, size: usize) -> Vec<f64> {
    let width = size + count + 2;
    let beta: Vec<f64> = (0..width)
        .map(|k| k as f64)
        .map(|k| if k > 0.0 { k / (2.0 * (4.0 * k * k - 1.0).sqrt()) } else { 0.0 })
        .collect();
    let (mut before, mut now, mut next) = (vec![0.0; width], vec![0.0; width], vec![0.0; width]);
    now[0] = 1.0;
    let mut table = Vec::with_capacity(count * size);
    for l in 0..count {
        table.extend_from_slice(&now[..size]);
        // Beyond k = l + 1 all is zero; beyond size + count - l nothing is asked for.
        let last = (l + 2).min(size + count - l).min(width - 1);
        let (up, down) = ((2 * l + 1) as f64 / (l + 1) as f64, l as f64 / (l + 1) as f64);
        next[0] = up * (beta[1] * now[1] + 0.5 * now[0]) - down * before[0];
        for k in 1..last {
            next[k] =
                up * (beta[k + 1] * now[k + 1] + 0.5 * now[k] + beta[k] * now[k - 1]) - down * before[k];
        }
        std::mem::swap(&mut before, &mut now);
        std::mem::swap(&mut now, &mut next);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::quadrature::gauss_legendre;

    /// Against Gauss quadrature of φ_k P_l with enough points to be exact.
    #[test]
    fn the_recurrence_gives_the_integrals() {
        let (count, size) = (600, 20);
        let table = projections(count, size);
        let mut by_quadrature = vec![0.0; count * size];
        let (mut p, mut phi) = (vec![0.0; count], vec![0.0; size]);
        for (x, w) in gauss_legendre(320) {
            legendre_row(0.5 * (1.0 + x), &mut p);
            legendre_row(x, &mut phi);
            for l in 0..count {
                for k in 0..size {
                    by_quadrature[l * size + k] += 0.5 * w * p[l] * phi[k] * ((2 * k + 1) as f64).sqrt();
                }
            }
        }
        let worst = table.iter().zip(&by_quadrature).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
        assert!(worst < 1e-12, "{worst:e}");
    }

    /// χ_l = 1 is no scattering at all: the identity. The sum over l converges like 1/L.
    #[test]
    fn a_delta_peak_is_the_identity() {
        let streams = Streams::new(8);
        let (even, odd) = Kernel::new(vec![1.0; 4000], 8).between(&streams);
        for i in 0..8 {
            for j in 0..8 {
                let expected = if i == j { 1.0 } else { 0.0 };
                let found = 0.5 * (even[(i, j)] + odd[(i, j)]) * 1.0;
                assert!((found - expected).abs() < 0.02, "{i} {j}: {found}");
            }
        }
    }
}
