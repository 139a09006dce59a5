//! Fluxes from photons: the Monte Carlo reference of a fit, and the witness of a solved one.

use super::fluxes::{Covariance, IncidenceFluxes, MediumFluxes, Referred};
use super::reference::{AtIncidence, Media, Plan};
use crate::CliError;
use crate::config::Config;
use stratiform_quantities::{Medium, Order};
use stratiform_transport::{Extent, Fluxes, Quantity, trace_fluxes};

/// Which fluxes are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Every order and the totals of both media.
    All,
    /// What is fitted: of a medium whose totals are not, the orders up to [`MAX_ORDER`](super::fluxes::MAX_ORDER).
    Fitted,
}

/// Traces `plan`; `progress` sees the photons done so far.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] for numbers out of domain.
pub fn trace(
    config: &Config,
    media: &Media,
    plan: &Plan,
    wanted: Wanted,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Referred>, CliError> {
    let extent = |medium| match wanted {
        Wanted::Fitted if medium != config.transport.totals_medium => Extent::ListedOrders,
        _ => Extent::ToTheEnd,
    };
    let traced = plan.trace(progress, |medium, request, control| {
        trace_fluxes(media.get(medium), request, extent(medium), control)
    })?;
    traced.iter().map(|traced| referred(config, &plan.tau, traced)).collect()
}

/// All that other stages need of one incidence; the covariance is that of batch means.
fn referred(config: &Config, tau: &[f64], traced: &AtIncidence<Fluxes>) -> Result<Referred, CliError> {
    let all = |quantity| (0..tau.len()).map(move |k| (k, quantity)).collect::<Vec<_>>();
    let each = [
        Quantity::Transmittance(Order::Exactly(1)),
        Quantity::Transmittance(Order::Exactly(2)),
        Quantity::Reflectance(Order::Exactly(1)),
        Quantity::Reflectance(Order::Exactly(2)),
    ];
    let covariance = |medium, quantities: Vec<_>| {
        let known = traced.get(medium).covariance(&quantities);
        known
            .map(|rows| rows.concat())
            .ok_or_else(|| CliError::Failed("a fitted flux was not traced".to_owned()))
    };
    let transport = &config.transport;
    let covariance = Covariance {
        t_ms: covariance(transport.totals_medium, all(Quantity::Transmittance(Order::Total)))?,
        orders: covariance(transport.orders_medium, each.into_iter().flat_map(all).collect())?,
    };
    let [full, modified] = [Medium::Full, Medium::Modified].map(|medium| {
        let fluxes = traced.get(medium);
        MediumFluxes::new(fluxes.orders(), tau.len(), |k, order| fluxes.estimate(k, order))
    });
    IncidenceFluxes { row: traced.row.clone(), tau: tau.to_vec(), full, modified }
        .referred(config, covariance)
}
