//! What is solved for: extinction, albedo and Legendre moments.

use crate::{TraceMedium, TransportError};
use std::sync::Arc;
use stratiform_optics::phase::PhaseFunction;
use stratiform_quantities::{Medium, Range, SingleScatteringAlbedo};

/// Most moments used; what a longer series would add counts as error.
const MOST: usize = 1 << 13;

/// A phase function, or the moments that define one.
#[derive(Clone)]
pub(crate) enum Source {
    Phase(Arc<dyn PhaseFunction>),
    Moments(Vec<f64>),
}

/// A medium ready to be solved.
#[derive(Clone)]
pub struct SolveMedium {
    pub(crate) medium: Medium,
    /// Per unit of the full medium's optical thickness.
    pub(crate) extinction: f64,
    pub(crate) albedo: f64,
    source: Source,
}

impl SolveMedium {
    /// The full medium with phase function `phase`.
    pub fn full(phase: Arc<dyn PhaseFunction>, omega: SingleScatteringAlbedo) -> Self {
        Self { medium: Medium::Full, extinction: 1.0, albedo: omega.get(), source: Source::Phase(phase) }
    }

    /// The full medium whose phase function is exactly Σ(2l+1)χ_l P_l.
    ///
    /// # Errors
    /// [`TransportError::Domain`] unless χ_0 = 1 and |χ_l| ≤ 1.
    pub fn from_moments(chi: Vec<f64>, omega: SingleScatteringAlbedo) -> Result<Self, TransportError> {
        Range::closed(1.0, 1.0).check("moment chi_0", chi.first().copied().unwrap_or(f64::NAN))?;
        for (l, value) in chi.iter().enumerate() {
            Range::closed(-1.0, 1.0).check(&format!("moment chi_{l}"), *value)?;
        }
        let source = Source::Moments(chi);
        Ok(Self { medium: Medium::Full, extinction: 1.0, albedo: omega.get(), source })
    }

    /// Full or modified.
    pub fn medium(&self) -> Medium {
        self.medium
    }

    pub(crate) fn source(&self) -> &Source {
        &self.source
    }

    /// χ_0 … χ_{count-1}; 0 beyond those given.
    pub(crate) fn leading_moments(&self, count: usize) -> Vec<f64> {
        match &self.source {
            Source::Phase(phase) => phase.moments(count),
            Source::Moments(chi) => chi.iter().copied().chain(std::iter::repeat(0.0)).take(count).collect(),
        }
    }

    /// Moments enough for fluxes to `tolerance`, and a bound of what the rest contributes.
    ///
    /// Σ_{l>L}(2l+1)|χ_l|c_l² with c_l² ~ l⁻³ falls like max|χ|·4/L.
    pub(crate) fn moments(&self, tolerance: f64) -> (Vec<f64>, f64) {
        let phase = match &self.source {
            Source::Moments(chi) => return (chi.clone(), 0.0),
            Source::Phase(phase) => phase,
        };
        let mut count = 128;
        loop {
            let chi = phase.moments(count);
            let last = chi[count - count / 4..].iter().fold(0.0_f64, |most, chi| most.max(chi.abs()));
            let rest = last * 4.0 / count as f64;
            if rest <= 0.1 * tolerance || count >= MOST {
                return (chi, rest);
            }
            count *= 2;
        }
    }
}

impl From<&TraceMedium> for SolveMedium {
    fn from(traced: &TraceMedium) -> Self {
        Self {
            medium: traced.medium(),
            extinction: traced.extinction(),
            albedo: traced.albedo(),
            source: Source::Phase(traced.phase().clone()),
        }
    }
}
