//! `[radiance]` of a fit-config. Unknown keys are refused.

use crate::FitError;
use serde::{Deserialize, Serialize};
use stratiform_quantities::Range;

/// At which points the radiance model is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RadianceConfig {
    /// Smallest optical thickness of the full medium.
    pub tau_min: f64,
    /// Largest.
    pub tau_max: f64,
    /// How many, in geometric progression.
    pub tau_count: usize,
    /// Values of θ_l.
    pub suns: usize,
    /// Directions of view for each θ_l.
    pub views: usize,
    /// Largest θ_l and θ_v, degrees.
    pub up_to_deg: f64,
    /// Transmission with Θ below this is left out, degrees: the sun's aureole.
    pub aureole_deg: f64,
    /// Estimated error that the solver must reach: absolute below 1, relative above.
    pub tolerance: f64,
}

impl Default for RadianceConfig {
    fn default() -> Self {
        Self {
            tau_min: 0.1,
            tau_max: 300.0,
            tau_count: 13,
            suns: 12,
            views: 24,
            up_to_deg: 85.0,
            aureole_deg: 6.0,
            tolerance: 1e-3,
        }
    }
}

impl RadianceConfig {
    /// Checks every number.
    ///
    /// # Errors
    /// [`FitError::Domain`] naming the key.
    pub fn check(&self) -> Result<(), FitError> {
        let from = |min, max| Range { min_included: false, ..Range::closed(min, max) };
        super::DRAWN_TAU.check("radiance.tau_min", self.tau_min)?;
        from(self.tau_min, 1e6).check("radiance.tau_max", self.tau_max)?;
        Range::closed(5.0, 1e3).check("radiance.tau_count", self.tau_count as f64)?;
        Range::closed(2.0, 1e3).check("radiance.suns", self.suns as f64)?;
        Range::closed(2.0, 1e4).check("radiance.views", self.views as f64)?;
        let below = Range { max_included: false, ..from(0.0, 90.0) };
        below.check("radiance.up_to_deg", self.up_to_deg)?;
        Range { max_included: false, ..Range::closed(0.0, 90.0) }
            .check("radiance.aureole_deg", self.aureole_deg)?;
        Range { max_included: false, ..Range::closed(2e-8, 1.0) }
            .check("radiance.tolerance", self.tolerance)?;
        Ok(())
    }
}
