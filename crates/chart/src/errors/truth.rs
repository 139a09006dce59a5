//! The truth of one sun.

use super::nodes::Sighted;
use stratiform_stats::Estimate;
use stratiform_transport::TransportError;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, View};

/// Asked of radiances: absolute below 1, relative above.
pub(super) const TOLERANCE: f64 = 1e-3;

/// The largest relative error of a truth that counts.
const SHARE: f64 = 0.01;

/// Total, and the shares of orders 1 and 2 in it.
pub(super) type Truth = Option<(f64, [f64; 2])>;

/// Thicknesses outside, views inside; one solution for all.
///
/// # Errors
/// [`TransportError`].
pub(super) fn of_sun(
    solver: &RadianceSolver,
    tau: &[f64],
    theta_l_deg: f64,
    views: &[Sighted],
) -> Result<Vec<Truth>, TransportError> {
    let mu = |theta: f64| libm::cos(theta.to_radians());
    let seen: Vec<View> = views
        .iter()
        .map(|sight| View { side: sight.side, mu: mu(sight.theta_v_deg), phi_deg: sight.phi_deg })
        .collect();
    let solved = solver.radiance_as_reached(RadianceOrder::Total, tau, &[mu(theta_l_deg)], &seen)?;
    let places = (0..tau.len()).flat_map(|t| (0..views.len()).map(move |v| (t, v)));
    Ok(places
        .map(|(t, v)| {
            let order = |order| solved.estimate(t, 0, v, order);
            let total = known(order(RadianceOrder::Total))?;
            Some((total, [RadianceOrder::One, RadianceOrder::Two].map(|one| order(one).value / total)))
        })
        .collect())
}

/// Well enough.
fn known(estimate: Estimate) -> Option<f64> {
    (estimate.value > 0.0 && estimate.std_error <= SHARE * estimate.value).then_some(estimate.value)
}
