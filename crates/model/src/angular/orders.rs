//! The orders of the model.

use super::{Emission, PhaseLookup, Sight, path};
use crate::{Fluxes, Real};
use stratiform_quantities::{DomainError, Range, Side};

/// Reflectance factors by number of wide scatterings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orders<F> {
    /// I1.
    pub one: F,
    /// I2.
    pub two: F,
    /// I3+: negative where the flux model's difference is, see [`problems`](crate::problems).
    pub three_plus: F,
}

impl<F: Real> Orders<F> {
    /// I1 + I2 + I3+.
    pub fn total(&self) -> F {
        self.one + self.two + self.three_plus
    }
}

/// A slab and the line along which it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angular<F> {
    pub(super) depth: F,
    pub(super) sight: Sight<F>,
}

impl<F: Real> Angular<F> {
    /// `depth` is x_S = (1-P_f) τ, the optical thickness of the modified medium.
    ///
    /// # Errors
    /// [`DomainError`] unless x_S ≥ 0, 0 ≤ μ_l ≤ 1, 0 < μ_v ≤ 1 and 0 ≤ v ≤ 2.
    pub fn new(depth: F, sight: Sight<F>) -> Result<Self, DomainError> {
        Range::at_least(0.0).check("x_S", depth.to_f64())?;
        Range::closed(0.0, 1.0).check("mu_l", sight.mu_l.to_f64())?;
        let leaving = Range { min: 0.0, max: 1.0, min_included: false, max_included: true };
        leaving.check("mu_v", sight.mu_v.to_f64())?;
        Range::closed(0.0, 2.0).check("v", sight.v.to_f64())?;
        Ok(Self { depth, sight })
    }

    /// As [`new`](Self::new), for a caller that knows its input to lie in the domain.
    pub fn unchecked(depth: F, sight: Sight<F>) -> Self {
        Self { depth, sight }
    }

    /// The weights w_1 and w_2 of I1 = P_S/4·w_1 and I2 = P_S²/8·w_2; 0 in an empty slab.
    pub fn weights(&self) -> (F, F) {
        if self.depth > F::of(0.0) {
            path::weights(self.depth, &self.sight)
        } else {
            (F::of(0.0), F::of(0.0))
        }
    }

    /// I1: light scattered once, exact in the modified medium.
    pub fn one(&self, phase: &impl PhaseLookup<F>) -> F {
        F::of(0.25) * phase.wide(self.sight.v) * self.weights().0
    }

    /// I2: light scattered twice.
    pub fn two(&self, phase: &impl PhaseLookup<F>) -> F {
        F::of(0.125) * phase.wide_squared(self.sight.v) * self.weights().1
    }

    /// I3+: what is left of the slab's flux, from its 1-D model at the same θ_l and thickness.
    pub fn three_plus(&self, fluxes: &Fluxes<F>, emission: Emission) -> F {
        let flux = match self.sight.side {
            Side::Top => fluxes.r_3_plus,
            Side::Bottom => fluxes.t_3_plus,
        };
        flux * emission.factor(self.sight.mu_v)
    }

    /// All three.
    pub fn orders(&self, phase: &impl PhaseLookup<F>, fluxes: &Fluxes<F>, emission: Emission) -> Orders<F> {
        Orders { one: self.one(phase), two: self.two(phase), three_plus: self.three_plus(fluxes, emission) }
    }
}
