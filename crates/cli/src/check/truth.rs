//! The truth: totals and orders from the deterministic solver.

use crate::CliError;
use crate::config::Config;
use crate::pipeline::{self, fluxes::light, reference::Media};
use stratiform_artifact::RowIncidence;
use stratiform_quantities::Order;
use stratiform_stats::Estimate;
use stratiform_transport::solve::{Solved, Solver};

/// Orders that the tail does not contain: it is light that was scattered three times and more.
pub const LISTED: u32 = 2;

/// The solver for both media, ready for any places.
pub struct Solvers {
    totals: Solver,
    orders: Solver,
}

/// Totals of the config's `totals_medium` and orders of its `orders_medium` at every incidence and thickness.
/// `std_error` is the estimated error.
pub struct Truth {
    totals: Solved,
    orders: Solved,
}

impl Solvers {
    /// Prepares both media of the config.
    ///
    /// # Errors
    /// [`CliError::Input`] for a tolerance out of domain.
    pub fn new(config: &Config, media: &Media) -> Result<Self, CliError> {
        let solver = |medium| {
            Solver::new(media.get(medium).into(), config.check.tolerance).map_err(pipeline::trace_error)
        };
        let transport = &config.transport;
        Ok(Self { totals: solver(transport.totals_medium)?, orders: solver(transport.orders_medium)? })
    }

    /// Solves for orders up to `max_order`, and for those that are [`LISTED`] at least.
    ///
    /// # Errors
    /// [`CliError::Failed`] if the config's tolerance is not met; [`CliError::Input`] for numbers out of domain.
    pub fn solve(&self, rows: &[RowIncidence], tau: &[f64], max_order: u32) -> Result<Truth, CliError> {
        let incidences = rows.iter().map(light).collect::<Result<Vec<_>, _>>()?;
        let solve = || {
            let totals = self.totals.totals(tau, &incidences)?;
            Ok(Truth { totals, orders: self.orders.orders(tau, &incidences, max_order.max(LISTED))? })
        };
        solve().map_err(|error| pipeline::trace_error(error).at("the deterministic truth"))
    }
}

impl Truth {
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
