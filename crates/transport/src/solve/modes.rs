//! The modes in which light decays with depth: discrete ordinates, azimuthally averaged.
//!
//! With u, v the radiances down and up, S = u+v and D = u-v (both times √w), M = diag μ, E and O the even
//! and odd kernel: M D' = -A S, M S' = -B D, A = I - ωE, B = I - ωO (Chandrasekhar 1950 ch. 6; halved as in
//! Stamnes & Swanson 1981). Hence S'' = M⁻¹BM⁻¹A S. With Cholesky factors A = FFᵀ, B = LLᵀ the decay rates
//! k_j are the singular values of FᵀM⁻¹L, its right vectors v_j give φ_j = M⁻¹L v_j (the part of S) and ψ_j
//! = L⁻ᵀv_j: S ∝ φ cosh kx, D ∝ -kψ sinh kx. A lossless medium has one k = 0, which needs no case of its
//! own: cosh → 1 and sinh(kx)/k → x.

use super::jacobi::singular;
use super::kernel::{Kernel, Towards};
use super::matrix::{Matrix, dot};
use super::quadrature::Streams;

/// All modes for one number of streams and one albedo.
#[derive(Clone, Debug)]
pub(crate) struct Modes {
    pub(crate) streams: Streams,
    pub(crate) omega: f64,
    /// k_j ≥ 0.
    pub(crate) decay: Vec<f64>,
    /// φ, a row for each mode.
    pub(crate) sum: Matrix,
    /// ψ, a row for each mode.
    pub(crate) difference: Matrix,
}

impl Modes {
    pub(crate) fn new(kernel: &Kernel, count: usize, omega: f64) -> Self {
        let streams = Streams::new(count);
        let (even, odd) = kernel.between(&streams);
        let Decay { rates, sum, difference } = decay(&streams.mu, (&even, &odd), omega, singular);
        Self { streams, omega, decay: rates, sum, difference }
    }

    /// How strongly each mode scatters into a direction, by its φ and by its ψ.
    pub(crate) fn towards(&self, streams: &Towards) -> (Vec<f64>, Vec<f64>) {
        let onto = |row: &[f64], modes: &Matrix| (0..row.len()).map(|j| dot(row, modes.row(j))).collect();
        (onto(&streams.even, &self.sum), onto(&streams.odd, &self.difference))
    }
}

/// Decay rates k_j and the parts φ and ψ, a row for each mode.
#[derive(Clone, Debug)]
pub(crate) struct Decay {
    pub(crate) rates: Vec<f64>,
    pub(crate) sum: Matrix,
    pub(crate) difference: Matrix,
}

/// Modes of streams `mu` that scatter by `even` and `odd`; `singular` gives singular values and right
/// vectors of a matrix from its columns.
pub(crate) fn decay(
    mu: &[f64],
    (even, odd): (&Matrix, &Matrix),
    omega: f64,
    singular: impl Fn(Matrix) -> (Vec<f64>, Matrix),
) -> Decay {
    let count = mu.len();
    let less = |kernel: &Matrix| {
        Matrix::from_fn(count, |i, j| (if i == j { 1.0 } else { 0.0 }) - omega * kernel[(i, j)])
    };
    let (f, l) = (less(even).cholesky(), less(odd).cholesky());
    let scaled = Matrix::from_fn(count, |j, m| l[(j, m)] / mu[m]);
    let (rates, vectors) = singular(scaled.times(&f.transposed()));
    let sum = vectors.times(&scaled);
    let difference = l.solve_upper(vectors.transposed()).transposed();
    Decay { rates, sum, difference }
}
