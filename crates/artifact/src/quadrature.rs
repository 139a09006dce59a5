//! `optics/quadrature.csv`: error of the size average against radii and against seconds.

use serde::{Deserialize, Serialize};

/// One refinement of the radius quadrature at one wavelength. Errors are those the refinement itself estimates, in the
/// terms of [`ReachedError`](crate::ReachedError).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuadratureRow {
    /// Wavelength in µm.
    pub wavelength_um: f64,
    /// Radii used so far.
    pub radii: u64,
    /// Wall time since the first radius, in seconds.
    pub seconds: f64,
    /// Absolute, in g.
    pub asymmetry: f64,
    /// Absolute, in P_f.
    pub forward_fraction: f64,
    /// Absolute, largest over the Legendre moments.
    pub moments: f64,
    /// Relative, largest of P below 60°.
    pub phase_below_60_deg: f64,
    /// Relative, largest of P from 60° on.
    pub phase_beyond_60_deg: f64,
}
