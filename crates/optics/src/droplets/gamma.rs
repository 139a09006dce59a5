//! n(r) ∝ r^α e^{-b r^c}: Deirmendjian's generalised gamma, with the modified gamma as α = γ-1, b = 1/r_n, c = 1.
//!
//! Normalised, n = c b^s/Γ(s) r^α e^{-b r^c} with s = (α+1)/c, and ⟨r^k⟩ = b^{-k/c} Γ(s + k/c)/Γ(s).

use super::RADIUS_UM;
use stratiform_quantities::{DomainError, Range};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GeneralisedGamma {
    alpha: f64,
    b: f64,
    c: f64,
    /// ln of what multiplies r^α e^{-b r^c}.
    ln_norm: f64,
}

impl GeneralisedGamma {
    pub(super) fn new(alpha: f64, b: f64, c: f64) -> Result<Self, DomainError> {
        Range::closed(-0.9, 500.0).check("alpha", alpha)?;
        Range::closed(1e-6, 1e6).check("b", b)?;
        Range::closed(0.2, 10.0).check("c", c)?;
        Ok(Self::normalised(alpha, b, c))
    }

    pub(super) fn modified(gamma: f64, effective_radius: f64) -> Result<Self, DomainError> {
        Range::closed(0.1, 500.0).check("gamma", gamma)?;
        RADIUS_UM.check("effective_radius_um", effective_radius)?;
        Ok(Self::normalised(gamma - 1.0, (gamma + 2.0) / effective_radius, 1.0))
    }

    fn normalised(alpha: f64, b: f64, c: f64) -> Self {
        let s = (alpha + 1.0) / c;
        Self { alpha, b, c, ln_norm: libm::log(c) + s * libm::log(b) - libm::lgamma(s) }
    }

    fn shape(&self) -> f64 {
        (self.alpha + 1.0) / self.c
    }

    pub(super) fn density(&self, r: f64) -> f64 {
        if r <= 0.0 {
            return 0.0;
        }
        libm::exp(self.ln_norm + self.alpha * libm::log(r) - self.b * libm::pow(r, self.c))
    }

    pub(super) fn moment(&self, k: u32) -> f64 {
        let (s, step) = (self.shape(), f64::from(k) / self.c);
        libm::exp(libm::lgamma(s + step) - libm::lgamma(s) - step * libm::log(self.b))
    }
}
