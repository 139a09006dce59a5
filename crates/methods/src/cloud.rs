//! The droplets a method is prepared for.

use crate::MethodError;
use std::sync::{Arc, OnceLock};
use stratiform_optics::phase::{Modified, PhaseFunction, PhaseTable};
use stratiform_quantities::SingleScatteringAlbedo;

/// A homogeneous cloud: P, ω, θ_f, and the effective radius if its droplets have one.
#[derive(Clone)]
pub struct Cloud {
    phase: Arc<PhaseTable>,
    modified: Arc<Modified>,
    /// P_S * P_S, once asked for.
    squared: Arc<OnceLock<Result<Arc<PhaseTable>, MethodError>>>,
    omega: SingleScatteringAlbedo,
    theta_f_deg: f64,
    r_eff_um: Option<f64>,
}

impl Cloud {
    /// A cloud of this phase function.
    ///
    /// # Errors
    /// [`MethodError::Domain`] unless 0 < θ_f ≤ 90° and P_f < 1.
    pub fn new(
        phase: PhaseTable,
        omega: SingleScatteringAlbedo,
        theta_f_deg: f64,
        r_eff_um: Option<f64>,
    ) -> Result<Self, MethodError> {
        let phase = Arc::new(phase);
        let modified = Arc::new(Modified::new(phase.clone(), theta_f_deg)?);
        Ok(Self { phase, modified, squared: Arc::default(), omega, theta_f_deg, r_eff_um })
    }

    /// P of the full medium.
    pub fn phase(&self) -> &Arc<PhaseTable> {
        &self.phase
    }

    /// P_S.
    pub fn modified(&self) -> &Arc<Modified> {
        &self.modified
    }

    /// P_S convolved with itself on the sphere; worked out once.
    ///
    /// # Errors
    /// [`MethodError::Phase`] if P_S has no square.
    pub fn squared(&self) -> Result<Arc<PhaseTable>, MethodError> {
        let square = || Ok(Arc::new(self.phase.modified(self.theta_f_deg)?.squared()?));
        self.squared.get_or_init(square).clone()
    }

    /// ω of the full medium.
    pub fn omega(&self) -> SingleScatteringAlbedo {
        self.omega
    }

    /// g of the full medium.
    pub fn asymmetry(&self) -> f64 {
        self.phase.asymmetry()
    }

    /// θ_f in degrees.
    pub fn theta_f_deg(&self) -> f64 {
        self.theta_f_deg
    }

    /// P_f.
    pub fn forward_fraction(&self) -> f64 {
        self.modified.forward_fraction()
    }

    /// Effective radius, µm.
    pub fn r_eff_um(&self) -> Option<f64> {
        self.r_eff_um
    }
}
