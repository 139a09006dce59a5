//! The medium as the solver sees it, and δ-M scaling (Wiscombe 1977).
//!
//! With f = χ_{2n}, the moment after the last that n streams per hemisphere resolve, a share f of all events counts as
//! no scattering: τ' = (1-ωf)τ, ω' = ω(1-f)/(1-ωf), χ_l' = (χ_l-f)/(1-f). f may be negative (the
//! modified phase function has a hole forward).

use crate::solve::medium::SolveMedium;

/// Optical properties after a share of forward events has been left out.
#[derive(Clone, Debug)]
pub(super) struct Scaled {
    /// f.
    pub(super) forward: f64,
    /// Per unit of the full medium's optical thickness.
    pub(super) extinction: f64,
    pub(super) albedo: f64,
    /// χ_l' for l < 2n.
    pub(super) moments: Vec<f64>,
}

impl Scaled {
    /// As it is.
    pub(super) fn not(medium: &SolveMedium) -> Self {
        let (extinction, albedo) = (medium.extinction, medium.albedo);
        Self { forward: 0.0, extinction, albedo, moments: Vec::new() }
    }

    /// For `streams` per hemisphere; `chi` has at least 2·`streams` + 1 moments.
    pub(super) fn new(medium: &SolveMedium, chi: &[f64], streams: usize) -> Self {
        // A forward delta is all peak.
        let forward = chi[2 * streams].min(1.0 - 1e-12);
        let kept = 1.0 - forward;
        let scale = 1.0 - medium.albedo * forward;
        let moments = chi[..2 * streams].iter().map(|chi| (chi - forward) / kept).collect();
        let albedo = (medium.albedo * kept / scale).min(1.0);
        Self { forward, extinction: medium.extinction * scale, albedo, moments }
    }
}
