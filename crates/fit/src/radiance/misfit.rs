//! The model's relative errors over a list of points.

use super::Drawn;
use crate::FitError;
use stratiform_artifact::RadianceMisfit;
use stratiform_model::angular::PhaseLookup;
use stratiform_model::radiance::{Coefficients, Slab};
use stratiform_quantities::Side;

/// The errors of one face.
///
/// # Errors
/// [`FitError`] for points out of domain, or none of this face.
pub fn misfit(
    coefficients: &Coefficients<f64>,
    drawn: &Drawn<'_>,
    side: Side,
    fitted: bool,
    phase: &impl PhaseLookup<f64>,
) -> Result<RadianceMisfit, FitError> {
    let mut errors = Vec::new();
    for point in drawn.points.iter().filter(|point| point.side == side) {
        let model = Slab::new(coefficients, point.tau, point.sight()?)?.radiance(phase);
        errors.push(((model / point.radiance.value - 1.0).abs(), point));
    }
    errors.sort_by(|a, b| a.0.total_cmp(&b.0));
    let at = |share: f64| errors.get((share * errors.len() as f64) as usize).or(errors.last());
    let (Some(median), Some(p95), Some(worst)) = (at(0.5), at(0.95), errors.last()) else {
        return Err(FitError::Inconsistent(format!("no radiances at the {side}")));
    };
    let degrees = |mu: f64| libm::acos(mu).to_degrees();
    let place = worst.1;
    Ok(RadianceMisfit {
        side,
        sample: drawn.sample.clone(),
        fitted,
        points: errors.len(),
        median: median.0,
        p95: p95.0,
        worst: worst.0,
        worst_at: [place.tau, degrees(place.mu_l), degrees(place.mu_v), place.phi_deg],
    })
}
