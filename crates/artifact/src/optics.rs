//! Optical properties of a droplet distribution: schema `stratiform/optics/1`.

use crate::Provenance;
use serde::{Deserialize, Serialize};

/// κ in both conventions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Extinction {
    /// N0 π r_e².
    pub paper: f64,
    /// N0 ⟨Q_ext π r²⟩.
    pub mie: f64,
}

/// P_f for one θ_f.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForwardFraction {
    /// θ_f in degrees.
    pub theta_f_deg: f64,
    /// ½∫P sinΘ dΘ from 0 to θ_f.
    pub value: f64,
}

/// The error that the average over radii reached, estimated by comparing the last two refinements. It does not count the
/// interpolation between the table's angles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReachedError {
    /// Radii used.
    pub radii: u64,
    /// Absolute, in g.
    pub asymmetry: f64,
    /// Absolute, in P_f.
    pub forward_fraction: f64,
    /// Absolute, largest over the Legendre moments χ_0 … χ_127.
    pub moments: f64,
    /// Relative, largest of P below 60°.
    pub phase_below_60_deg: f64,
    /// Relative, largest of P from 60° on.
    pub phase_beyond_60_deg: f64,
}

/// One wavelength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WavelengthOptics {
    /// Wavelength in µm.
    pub wavelength_um: f64,
    /// n, k of m = n + ik.
    pub refractive_index: [f64; 2],
    /// κ per metre.
    pub extinction_per_m: Extinction,
    /// ω.
    pub single_scattering_albedo: f64,
    /// g.
    pub asymmetry: f64,
    /// P_f.
    pub forward_fraction: ForwardFraction,
    /// What the quadrature reached.
    pub reached_error: ReachedError,
    /// Phase function file relative to the folder; the full P, columns theta_deg,p.
    pub phase_csv: String,
    /// Modified phase function P_S, columns theta_deg,p.
    pub modified_phase_csv: String,
    /// Legendre moments χ_l of P, one a line.
    pub moments_csv: String,
}

/// N(r) sampled for plots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SizeDensity {
    /// r in µm.
    pub radius_um: Vec<f64>,
    /// N(r) in droplets per cm³ and µm.
    pub number_per_cm3_um: Vec<f64>,
}

/// The document `optics.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpticsDocument {
    /// `stratiform/optics/1`.
    pub schema: String,
    /// How it was made.
    pub provenance: Provenance,
    /// The distribution in words, with its numbers.
    pub droplets: String,
    /// Effective radius, µm.
    pub effective_radius_um: f64,
    /// Effective variance.
    pub effective_variance: f64,
    /// Droplets per cm³.
    pub number_density_per_cm3: f64,
    /// N(r).
    pub size_density: SizeDensity,
    /// One entry per wavelength.
    pub wavelengths: Vec<WavelengthOptics>,
}

impl OpticsDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/optics/1";
}
