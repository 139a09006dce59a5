//! The evaluation.

use super::basis::{basis, saturation};
use super::coefficients::Coefficients;
use crate::Real;
use crate::angular::{Angular, PhaseLookup, Sight};
use stratiform_quantities::{DomainError, Range, Side};

/// Optical thickness of the full medium.
pub const TAU: Range = Range::closed(0.0, 1e6);

/// μ_l.
pub const MU_L: Range = Range::closed(0.0, 1.0);

/// μ_v.
pub const MU_V: Range = Range { min: 0.0, max: 1.0, min_included: false, max_included: true };

/// y/(τ' s): how fast D leaves its thin limit.
const RISE: f64 = 4.0 / 3.0;

/// 0.7 ≈ ¾/1.07, of the transmission of thick slabs.
const DIFFUSION: f64 = 0.7;

/// A slab and the line along which it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab<'a, F> {
    coefficients: &'a Coefficients<F>,
    tau: F,
    sight: Sight<F>,
}

/// D: what M is without its fitted factor, for τ' > 0.
#[inline]
pub fn envelope<F: Real>(scaled: F, sight: &Sight<F>) -> F {
    let sum = sight.mu_l + sight.mu_v;
    let rise = F::of(RISE) * scaled * sum;
    let share = rise / (sight.mu_l * sight.mu_v + rise);
    let escape = share * share / sum;
    match sight.side {
        Side::Top => escape,
        Side::Bottom => escape / (F::of(1.0) + F::of(DIFFUSION) * scaled),
    }
}

impl<'a, F: Real> Slab<'a, F> {
    /// A slab of optical thickness `tau` of the full medium.
    ///
    /// # Errors
    /// [`DomainError`] unless τ lies in [`TAU`], the cosines in [`MU_L`] and [`MU_V`], and v in \[0, 2\].
    pub fn new(coefficients: &'a Coefficients<F>, tau: F, sight: Sight<F>) -> Result<Self, DomainError> {
        TAU.check("tau", tau.to_f64())?;
        MU_L.check("mu_l", sight.mu_l.to_f64())?;
        MU_V.check("mu_v", sight.mu_v.to_f64())?;
        Range::closed(0.0, 2.0).check("v", sight.v.to_f64())?;
        Ok(Self::unchecked(coefficients, tau, sight))
    }

    /// As [`new`](Self::new), for a caller that knows its input to lie in the domain.
    #[inline]
    pub fn unchecked(coefficients: &'a Coefficients<F>, tau: F, sight: Sight<F>) -> Self {
        Self { coefficients, tau, sight }
    }

    /// I1.
    #[inline]
    pub fn one(&self, phase: &impl PhaseLookup<F>) -> F {
        Angular::unchecked(self.coefficients.kept * self.tau, self.sight).one(phase)
    }

    /// M: everything that met more than one wide event.
    #[inline]
    pub fn more(&self) -> F {
        let scaled = self.coefficients.similarity * self.tau;
        if scaled > F::of(0.0) {
            let coefficients = self.coefficients.at(self.sight.side, saturation(scaled));
            let terms = basis(&self.sight);
            let exponent =
                coefficients.iter().zip(&terms).fold(F::of(0.0), |sum, (c, term)| sum + *c * *term);
            envelope(scaled, &self.sight) * exponent.exp()
        } else {
            F::of(0.0)
        }
    }

    /// I1 + M.
    #[inline]
    pub fn radiance(&self, phase: &impl PhaseLookup<F>) -> F {
        self.one(phase) + self.more()
    }
}
