//! What is asked for.

use stratiform_quantities::Side;
use stratiform_stats::Estimate;

/// A radiance: the reflectance factor πL/(μ_l F0) of scattered light leaving one slab in one direction. The unscattered beam is
/// left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Cosine of the sun's angle to the normal.
    pub mu_l: f64,
    /// Cosine of the leaving light's angle to the normal.
    pub mu_v: f64,
    /// Azimuth in degrees; at 0 light keeps the sun's.
    pub phi_deg: f64,
    /// The face it leaves.
    pub side: Side,
}

/// A pair of fluxes of one slab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FluxPoint {
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Cosine of the sun's angle to the normal.
    pub mu_l: f64,
}

/// Shares of the incident flux, unscattered light included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FluxPair {
    /// Plane albedo R.
    pub reflectance: Estimate,
    /// Transmittance T.
    pub transmittance: Estimate,
}
