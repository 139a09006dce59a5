//! What light is traced through: full or modified medium, reduced to three numbers and a sampler.
//!
//! With forward fraction P_f, the modified medium leaves forward events out of extinction: per unit of the full
//! medium's τ its extinction is 1 - ωP_f, its albedo ω_S = ω(1-P_f)/(1-ωP_f), its phase function P_S. The
//! full medium is P_f = 0.

use crate::TransportError;
use std::sync::{Arc, OnceLock};
use stratiform_optics::phase::PhaseFunction;
use stratiform_optics::sampling::{LinearPieces, SamplingTable};
use stratiform_quantities::{Medium, Range, SingleScatteringAlbedo};

/// A medium ready to be traced.
#[derive(Clone)]
pub struct TraceMedium {
    medium: Medium,
    extinction: f64,
    albedo: f64,
    phase: Arc<dyn PhaseFunction>,
    tables: Arc<Tables>,
}

/// Samplers of the phase function, each made when first asked for.
#[derive(Default)]
struct Tables {
    double: OnceLock<SamplingTable>,
    single: OnceLock<LinearPieces>,
}

impl TraceMedium {
    /// The medium as it is.
    pub fn full(phase: Arc<dyn PhaseFunction>, omega: SingleScatteringAlbedo) -> Self {
        Self { medium: Medium::Full, extinction: 1.0, albedo: omega.get(), phase, tables: Arc::default() }
    }

    /// The medium whose forward events count as no scattering. `phase` is P_S, already without them;
    /// `omega` is that of the full medium; `forward_fraction` is P_f of the full phase function.
    ///
    /// # Errors
    /// [`TransportError::Domain`] unless 0 ≤ P_f < 1.
    pub fn modified(
        phase: Arc<dyn PhaseFunction>,
        omega: SingleScatteringAlbedo,
        forward_fraction: f64,
    ) -> Result<Self, TransportError> {
        let range = Range { max_included: false, ..Range::closed(0.0, 1.0) };
        let forward = range.check("forward_fraction", forward_fraction)?;
        let extinction = 1.0 - omega.get() * forward;
        let albedo = (omega.get() * (1.0 - forward) / extinction).min(1.0);
        Ok(Self { medium: Medium::Modified, extinction, albedo, phase, tables: Arc::default() })
    }

    /// Full or modified.
    pub fn medium(&self) -> Medium {
        self.medium
    }

    /// Extinction per unit of the full medium's optical thickness.
    pub fn extinction(&self) -> f64 {
        self.extinction
    }

    /// Probability that a collision scatters: ω, or ω_S.
    pub fn albedo(&self) -> f64 {
        self.albedo
    }

    /// The phase function.
    pub fn phase(&self) -> &Arc<dyn PhaseFunction> {
        &self.phase
    }

    /// The phase function, tabulated.
    pub fn table(&self) -> &SamplingTable {
        self.tables.double.get_or_init(|| SamplingTable::new(self.phase.clone()))
    }

    /// The phase function as straight pieces in single precision.
    pub fn pieces(&self) -> &LinearPieces {
        self.tables.single.get_or_init(|| LinearPieces::new(self.phase.as_ref()))
    }
}
