//! Reflectance and transmittance per order: schema `stratiform/orders/1` and `orders.csv`.

use crate::Provenance;
use serde::{Deserialize, Serialize};
use stratiform_quantities::{ExtinctionConvention, Incidence, Medium, Order};
use stratiform_stats::Estimate;

/// What was traced or solved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TracedMedium {
    /// The phase function as the user named it.
    pub phase: String,
    /// Single-scattering albedo of the full medium.
    pub single_scattering_albedo: f64,
    /// Asymmetry parameter of the full medium.
    pub asymmetry: f64,
    /// Full or modified.
    pub medium: Medium,
    /// θ_f in degrees (modified medium only).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub theta_f_deg: Option<f64>,
    /// P_f (modified medium only).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forward_fraction: Option<f64>,
    /// Wavelength, where the medium has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelength_um: Option<f64>,
    /// Which κ turns metres into optical thickness, where the medium has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extinction_convention: Option<ExtinctionConvention>,
    /// That κ, 1/m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extinction_per_m: Option<f64>,
}

/// One row of `results`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrderResult {
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Cosine of the zenith angle of incidence, or `"diffuse"`.
    pub mu0: Incidence,
    /// 0…N, `"tail"` or `"total"`.
    pub order: Order,
    /// Photons traced, where photons were.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub photons: Option<u64>,
    /// Reflected flux per incident flux.
    pub reflectance: Estimate,
    /// Transmitted flux per incident flux, unscattered light included in order 0 and the total.
    pub transmittance: Estimate,
}

/// The JSON document printed by `trace` and `solve`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrdersDocument {
    /// `stratiform/orders/1`.
    pub schema: String,
    /// What was traced.
    pub medium: TracedMedium,
    /// How.
    pub provenance: Provenance,
    /// One entry per thickness, incidence and order.
    pub results: Vec<OrderResult>,
}

impl OrdersDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/orders/1";
}

/// A row of `orders.csv` as `reproduce` writes it. Standard errors are estimated errors where nothing was random.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrdersRow {
    /// Incidence angle in degrees, or `diffuse`.
    pub theta_l_deg: String,
    /// Thickness in metres.
    pub thickness_m: f64,
    /// Full or modified.
    pub medium: Medium,
    /// 0…N, `tail` or `total`.
    pub order: String,
    /// Reflected flux per incident flux.
    pub reflectance: f64,
    /// Its standard error.
    pub reflectance_std_error: f64,
    /// Transmitted flux per incident flux.
    pub transmittance: f64,
    /// Its standard error.
    pub transmittance_std_error: f64,
}
