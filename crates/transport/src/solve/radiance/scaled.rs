//! The medium as the solver sees it, and δ-M scaling (Wiscombe 1977).
//!
//! With f = χ_L, the first moment left to others, a share f of all events counts as no scattering: τ' = (1-ωf)τ, ω' =
//! ω(1-f)/(1-ωf), χ_l' = (χ_l-f)/(1-f). A phase function with a hole forward (the modified
//! one) has no such share: f = 0, so that its rim keeps its place in orders 1 and 2.
//!
//! L = 3n/2 for n streams per hemisphere. DISORT takes 2n, but a rule of n points mixes up functions whose degrees add up to
//! 2n or more; what L leaves out is
//! known from elsewhere (`double`, `narrow`).

use crate::solve::medium::SolveMedium;

/// Optical properties after a share of forward events has been left out.
#[derive(Clone, Debug)]
pub(super) struct Scaled {
    /// f.
    pub(super) forward: f64,
    /// Per unit of the full medium's optical thickness.
    pub(super) extinction: f64,
    pub(super) albedo: f64,
    /// χ_l' for l < L.
    pub(super) moments: Vec<f64>,
}

impl Scaled {
    /// As it is.
    pub(super) fn not(medium: &SolveMedium) -> Self {
        let (extinction, albedo) = (medium.extinction, medium.albedo);
        Self { forward: 0.0, extinction, albedo, moments: Vec::new() }
    }

    /// For `streams` per hemisphere, with a `hole` forward or not; `chi` has more than 3/2 of that many moments.
    pub(super) fn new(medium: &SolveMedium, chi: &[f64], streams: usize, hole: bool) -> Self {
        let resolved = 3 * streams / 2;
        // A forward delta is all peak.
        let forward = if hole { 0.0 } else { chi[resolved].min(1.0 - 1e-12) };
        let kept = 1.0 - forward;
        let scale = 1.0 - medium.albedo * forward;
        let moments = chi[..resolved].iter().map(|chi| (chi - forward) / kept).collect();
        let albedo = (medium.albedo * kept / scale).min(1.0);
        Self { forward, extinction: medium.extinction * scale, albedo, moments }
    }
}
