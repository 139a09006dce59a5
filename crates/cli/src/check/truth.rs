//! The truth: totals and orders from the deterministic solver.

use crate::CliError;
use crate::check::config::CheckConfig;
use crate::config::Config;
use crate::pipeline::{self, fluxes::light, reference::Media};
use stratiform_artifact::RowIncidence;
use stratiform_quantities::Order;
use stratiform_stats::Estimate;
use stratiform_transport::solve::{Solved, Solver};

/// Orders that the tail does not contain: it is light that was scattered three times and more.
pub const LISTED: u32 = 2;

/// Totals of the config's `totals_medium` and orders of its `orders_medium` at every incidence and thickness.
/// `std_error` is the estimated error.
pub struct Truth {
    totals: Solved,
    orders: Solved,
}

impl Truth {
    /// Solves for orders up to `max_order`, at least [`LISTED`].
    ///
    /// # Errors
    /// [`CliError::Failed`] if the config's tolerance is not met; [`CliError::Input`] for numbers out of domain.
    pub fn solve(
        config: &Config,
        media: &Media,
        rows: &[RowIncidence],
        tau: &[f64],
        max_order: u32,
    ) -> Result<Self, CliError> {
        let incidences = rows.iter().map(light).collect::<Result<Vec<_>, _>>()?;
        let CheckConfig { tolerance, .. } = config.check;
        let transport = &config.transport;
        let solver = |medium| Solver::new(media.get(medium).into(), tolerance);
        let solve = || {
            let totals = solver(transport.totals_medium)?.totals(tau, &incidences)?;
            let orders = solver(transport.orders_medium)?.orders(tau, &incidences, max_order.max(LISTED))?;
            Ok(Self { totals, orders })
        };
        solve().map_err(|error| pipeline::trace_error(error).at("the deterministic truth"))
    }

    /// Reflectance and transmittance of an order at the places in the lists that were solved for.
    ///
    /// # Panics
    /// If a place is out of bounds, or the order above the largest solved for.
    pub fn at(&self, row: usize, tau: usize, order: Order) -> (Estimate, Estimate) {
        match order {
            Order::Total => self.totals.total(row, tau),
            Order::Exactly(n) => self.orders.estimate(row, tau, n as usize),
            Order::Tail => (0..=LISTED as usize).fold(self.orders.total(row, tau), |rest, n| {
                let (reflectance, transmittance) = self.orders.estimate(row, tau, n);
                (less(rest.0, reflectance), less(rest.1, transmittance))
            }),
        }
    }
}

fn less(a: Estimate, b: Estimate) -> Estimate {
    Estimate { value: a.value - b.value, std_error: a.std_error + b.std_error }
}
