//! Light scattered once, exactly: (ω/4μ0) P(Θ) κ∫e^{-t/μ0}·(way out of t) dt, κ = 1/μ.
//!
//! The closed form of Chandrasekhar 1950, ch. 7 §45.3, as reflectance factor πL/(μ0F0): above it is
//! ωP/(4(μ+μ0))·(1-e^{-τ(1/μ+1/μ0)}), below ωP/4·(e^{-τ/μ}-e^{-τ/μ0})/(μ-μ0), through divided differences
//! regular at μ = μ0, at grazing and for τ from 0 to infinity.

use super::depth::Exit;
use super::phase::Phase;
use super::scaled::Scaled;
use super::view::{GRAZING, Geometry};
use stratiform_quantities::Side;
use stratiform_stats::Estimate;

/// The slab as seen along `geometry`.
pub(super) fn exit(medium: &Scaled, tau: f64, geometry: &Geometry) -> Exit {
    let top = geometry.side == Side::Top;
    Exit { top, tau: tau * medium.extinction, sun: 1.0 / geometry.mu0, view: 1.0 / geometry.mu }
}

/// Radiance of order 1; in a scaled medium with the exact P/(1-f) (Nakajima & Tanaka 1988, TMS).
pub(super) fn once(medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> f64 {
    per_phase(medium, tau, geometry) * phase.at(geometry.deflection())
}

/// The same with the error of P.
pub(super) fn once_estimate(medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> Estimate {
    let factor = per_phase(medium, tau, geometry);
    let value = factor * phase.at(geometry.deflection());
    // A cosine of 0 is taken for the least one that is not.
    let grazing = if geometry.mu.min(geometry.mu0) > GRAZING { 0.0 } else { 2.0 * GRAZING };
    let rounding = 4.0 * f64::EPSILON + grazing / geometry.mu.max(geometry.mu0);
    Estimate { value, std_error: rounding * value.abs() + factor * phase.error }
}

/// Radiance of order 1 per value of P.
fn per_phase(medium: &Scaled, tau: f64, geometry: &Geometry) -> f64 {
    let exit = exit(medium, tau, geometry);
    0.25 * medium.albedo / (1.0 - medium.forward) * exit.sun * exit.view * exit.once()
}
