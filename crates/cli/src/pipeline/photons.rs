//! Fluxes from photons: the Monte Carlo reference of a fit, and the witness of a solved one.

use super::fluxes::{Covariance, IncidenceFluxes, MAX_ORDER, MediumFluxes, Referred};
use super::reference::{AtIncidence, Media, Plan};
use crate::CliError;
use crate::config::Config;
use stratiform_quantities::{Medium, Order};
use stratiform_transport::{
    Control, FirstOrders, Quantity, TraceRequest, Traced, TransportError, trace_first_orders,
    trace_half_space,
};

/// How far photons are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Until they leave: every order and the totals of both media.
    All,
    /// As far as the fit asks: in a medium whose totals are not fitted, to order [`MAX_ORDER`].
    Fitted,
}

/// One medium's photons.
enum Photons {
    All(Traced),
    First(FirstOrders),
}

/// Traces `plan`; `progress` sees the photons done so far.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] for numbers out of domain.
pub fn trace(
    config: &Config,
    media: &Media,
    plan: &Plan,
    extent: Extent,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Referred>, CliError> {
    let one = |medium: Medium, request: &TraceRequest, control: Control<'_>| {
        let all = extent == Extent::All || medium == config.transport.totals_medium;
        Photons::trace(all, media, medium, request, control)
    };
    plan.trace(progress, one)?.iter().map(|traced| referred(config, &plan.tau, traced)).collect()
}

impl Photons {
    fn trace(
        all: bool,
        media: &Media,
        medium: Medium,
        request: &TraceRequest,
        control: Control<'_>,
    ) -> Result<Self, TransportError> {
        let medium = media.get(medium);
        match all {
            true => trace_half_space(medium, request, control).map(Self::All),
            false => trace_first_orders(medium, request, control).map(Self::First),
        }
    }

    fn fluxes(&self) -> MediumFluxes {
        match self {
            Self::All(traced) => {
                let rows = Order::rows(MAX_ORDER).collect();
                MediumFluxes::new(rows, traced.tau().len(), |k, order| Some(traced.estimate(k, order)))
            }
            Self::First(traced) => {
                let rows = (0..=MAX_ORDER).map(Order::Exactly).collect();
                MediumFluxes::new(rows, traced.tau().len(), |k, order| traced.estimate(k, order))
            }
        }
    }

    fn covariance(&self, quantities: &[(usize, Quantity)]) -> Result<Vec<f64>, CliError> {
        let covariance = match self {
            Self::All(traced) => Some(traced.covariance(quantities)),
            Self::First(traced) => traced.covariance(quantities),
        };
        let missing = || CliError::Failed("a flux that is fitted was not traced".to_owned());
        Ok(covariance.ok_or_else(missing)?.concat())
    }
}

/// All that other stages need of one incidence; the covariance is that of batch means.
fn referred(config: &Config, tau: &[f64], traced: &AtIncidence<Photons>) -> Result<Referred, CliError> {
    let all = |quantity| (0..tau.len()).map(move |k| (k, quantity)).collect::<Vec<_>>();
    let each = [
        Quantity::Transmittance(Order::Exactly(1)),
        Quantity::Transmittance(Order::Exactly(2)),
        Quantity::Reflectance(Order::Exactly(1)),
        Quantity::Reflectance(Order::Exactly(2)),
    ];
    let of = |medium| traced.get(medium);
    let covariance = Covariance {
        t_ms: of(config.transport.totals_medium).covariance(&all(Quantity::Transmittance(Order::Total)))?,
        orders: of(config.transport.orders_medium)
            .covariance(&each.into_iter().flat_map(all).collect::<Vec<_>>())?,
    };
    let [full, modified] = [Medium::Full, Medium::Modified].map(|medium| of(medium).fluxes());
    IncidenceFluxes { row: traced.row.clone(), tau: tau.to_vec(), full, modified }
        .referred(config, covariance)
}
