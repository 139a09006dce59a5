//! One azimuthal mode of the scaled medium: its streams, how they scatter, and how its light decays.
//!
//! As `solve::modes`, for p_m(μ,μ') = Σ(2l+1)χ_l Λ_l^mΛ_l^m over l - m even or odd. Streams are Gauss points
//! on (0, 1) (double Gauss, Sykes 1951), which integrate each P_l in use over its hemisphere without error: nothing is
//! lost at m = 0.

use super::eigen;
use super::legendre::{associated, gauss};
use super::scaled::Scaled;
use crate::solve::jacobi;
use crate::solve::matrix::{Matrix, add_scaled, dot};
use crate::solve::modes::{Decay, decay};

/// The streams of one hemisphere.
#[derive(Clone, Debug)]
pub(super) struct Streams {
    pub(super) mu: Vec<f64>,
    pub(super) root_weight: Vec<f64>,
}

impl Streams {
    pub(super) fn new(count: usize) -> Self {
        let (mu, weight) = gauss(count);
        Self { mu, root_weight: weight.iter().map(|w| w.sqrt()).collect() }
    }
}

/// Mode m.
pub(super) struct Mode<'a> {
    pub(super) m: usize,
    streams: &'a Streams,
    medium: &'a Scaled,
    /// Λ_l^m(μ_i)√w_i with l - m even and odd, a row for each stream.
    legendre: [Vec<Vec<f64>>; 2],
    /// (2l+1)χ_l, the same.
    weights: [Vec<f64>; 2],
    pub(super) decay: Decay,
}

/// Scattering into one direction: p_m√w from streams, and from decaying modes, by parity of l - m.
#[derive(Clone, Debug)]
pub(super) struct Towards {
    pub(super) even: Vec<f64>,
    pub(super) odd: Vec<f64>,
    pub(super) sum: Vec<f64>,
    pub(super) difference: Vec<f64>,
}

impl<'a> Mode<'a> {
    pub(super) fn new(medium: &'a Scaled, streams: &'a Streams, m: usize) -> Self {
        let mut row = vec![0.0; medium.moments.len() - m];
        let mut legendre = [Vec::new(), Vec::new()];
        for (mu, root) in streams.mu.iter().zip(&streams.root_weight) {
            associated(m, *mu, &mut row);
            row.iter_mut().for_each(|value| *value *= root);
            legendre.iter_mut().zip(by_parity(&row)).for_each(|(rows, row)| rows.push(row));
        }
        let weights: Vec<f64> =
            (m..medium.moments.len()).map(|l| (2 * l + 1) as f64 * medium.moments[l]).collect();
        let weights = by_parity(&weights);
        let kernel = |parity: usize| between(&legendre[parity], &weights[parity]);
        let singular =
            |columns: Matrix| if m == 0 { jacobi::singular(columns) } else { eigen::singular(&columns) };
        let decay = decay(&streams.mu, (&kernel(0), &kernel(1)), medium.albedo, singular);
        Self { m, streams, medium, legendre, weights, decay }
    }

    pub(super) fn streams(&self) -> &Streams {
        self.streams
    }

    pub(super) fn medium(&self) -> &Scaled {
        self.medium
    }

    pub(super) fn towards(&self, mu: f64) -> Towards {
        let mut row = vec![0.0; self.medium.moments.len() - self.m];
        associated(self.m, mu, &mut row);
        let mut rows = by_parity(&row);
        let [even, odd] = [0, 1].map(|parity| -> Vec<f64> {
            rows[parity].iter_mut().zip(&self.weights[parity]).for_each(|(value, weight)| *value *= weight);
            self.legendre[parity].iter().map(|of| dot(&rows[parity], of)).collect()
        });
        let onto = |row: &[f64], modes: &Matrix| (0..row.len()).map(|j| dot(row, modes.row(j))).collect();
        let (sum, difference) = (onto(&even, &self.decay.sum), onto(&odd, &self.decay.difference));
        Towards { even, odd, sum, difference }
    }
}

/// Elements at even and at odd places.
fn by_parity(row: &[f64]) -> [Vec<f64>; 2] {
    [0, 1].map(|parity| row.iter().skip(parity).step_by(2).copied().collect())
}

/// √w p_m √w between streams, l - m of one parity.
fn between(legendre: &[Vec<f64>], weights: &[f64]) -> Matrix {
    let count = legendre.len();
    let mut kernel = Matrix::zeros(count);
    for (l, weight) in weights.iter().enumerate() {
        let column: Vec<f64> = legendre.iter().map(|row| row[l]).collect();
        for i in 0..count {
            add_scaled(kernel.row_mut(i), weight * column[i], &column);
        }
    }
    kernel
}
