//! The numbers that belong to one cloud.

use super::basis::TERMS;
use crate::Real;
use stratiform_quantities::{DomainError, Range, Side};

/// Powers of u, 1 included.
pub const POWERS: usize = 5;

/// What the model must know of a cloud.
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients<F> {
    /// 1-g of the full medium: optical thickness times this is τ'.
    pub similarity: F,
    /// 1-P_f: optical thickness times this is that of the modified medium.
    pub kept: F,
    /// a_kj of light that leaves at the top, `[j][k]`.
    pub top: [[F; TERMS]; POWERS],
    /// a_kj of light that leaves at the bottom, `[j][k]`.
    pub bottom: [[F; TERMS]; POWERS],
}

impl Coefficients<f64> {
    /// Checks every number.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 < 1-g ≤ 2, 0 < 1-P_f ≤ 1 and every a_kj is within ±1e4.
    pub fn check(&self) -> Result<(), DomainError> {
        let above_zero = |max| Range { min_included: false, ..Range::closed(0.0, max) };
        above_zero(2.0).check("similarity (1-g)", self.similarity)?;
        above_zero(1.0).check("kept (1-P_f)", self.kept)?;
        let all = self.top.iter().chain(&self.bottom).flatten();
        all.copied().try_for_each(|a| Range::closed(-1e4, 1e4).check("coefficient", a).map(|_| ()))
    }

    /// The same in another precision.
    pub fn cast<F: Real>(&self) -> Coefficients<F> {
        let cast = |table: &[[f64; TERMS]; POWERS]| table.map(|row| row.map(F::of));
        Coefficients {
            similarity: F::of(self.similarity),
            kept: F::of(self.kept),
            top: cast(&self.top),
            bottom: cast(&self.bottom),
        }
    }
}

impl<F: Real> Coefficients<F> {
    /// c_k(u) of one face.
    #[inline]
    pub fn at(&self, side: Side, u: F) -> [F; TERMS] {
        let table = match side {
            Side::Top => &self.top,
            Side::Bottom => &self.bottom,
        };
        let mut sums = table[POWERS - 1];
        for row in table[..POWERS - 1].iter().rev() {
            for (sum, a) in sums.iter_mut().zip(row) {
                *sum = *sum * u + *a;
            }
        }
        sums
    }
}
