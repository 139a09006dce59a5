//! The cloud layer and its droplets.

use crate::Interval;
use serde::{Deserialize, Serialize};
use stratiform_quantities::{ExtinctionConvention, SingleScatteringAlbedo};

/// `[layer]`: how thick. One of the two keys stands there.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// κH of the full medium.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub optical_thickness: Option<Interval>,
    /// H; needs `droplets.number_density_per_cm3` and `extinction_convention`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_m: Option<Interval>,
    /// Which κ turns metres into optical thickness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extinction_convention: Option<ExtinctionConvention>,
}

/// `[droplets]`: a modified gamma distribution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Droplets {
    /// r_e, µm.
    pub effective_radius_um: Interval,
    /// v_e = 1/(γ+2).
    pub effective_variance: f64,
    /// θ_f, degrees.
    #[serde(default = "theta_f")]
    pub theta_f_deg: f64,
    /// N0; needed with a thickness in metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number_density_per_cm3: Option<f64>,
    /// ω; absent: as Mie theory gives it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub single_scattering_albedo: Option<SingleScatteringAlbedo>,
}

fn theta_f() -> f64 {
    5.0
}

impl Droplets {
    /// γ of the distribution.
    pub fn gamma(&self) -> f64 {
        1.0 / self.effective_variance - 2.0
    }
}
