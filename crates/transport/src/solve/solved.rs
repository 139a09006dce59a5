//! The solver's answer.

use super::solver::Solver;
use stratiform_quantities::{Incidence, Order};
use stratiform_stats::Estimate;

/// Reflectance and transmittance with estimated absolute errors (in `std_error`).
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    tau: Vec<f64>,
    incidence: Vec<Incidence>,
    /// Rows of each thickness and incidence.
    orders: Vec<Order>,
    /// R, T for each order, these inside thickness, that inside incidence.
    rows: Vec<(f64, f64)>,
    streams: usize,
    moments: usize,
}

impl Solved {
    pub(crate) fn new(
        solver: &Solver,
        (tau, incidence): (&[f64], &[Incidence]),
        orders: Vec<Order>,
        (rows, streams): (Vec<(f64, f64)>, usize),
    ) -> Self {
        let (tau, incidence, moments) = (tau.to_vec(), incidence.to_vec(), solver.moments().len());
        Self { tau, incidence, orders, rows, streams, moments }
    }

    /// Optical thicknesses of the full medium, as asked.
    pub fn tau(&self) -> &[f64] {
        &self.tau
    }

    /// Incidences, as asked.
    pub fn incidence(&self) -> &[Incidence] {
        &self.incidence
    }

    /// Streams per hemisphere that were needed.
    pub fn streams(&self) -> usize {
        self.streams
    }

    /// Legendre moments used.
    pub fn moments(&self) -> usize {
        self.moments
    }

    /// Largest estimated error of any row.
    pub fn worst_error(&self) -> f64 {
        self.rows.iter().fold(0.0, |worst, (_, error)| worst.max(*error))
    }

    /// The orders solved for.
    pub fn orders(&self) -> &[Order] {
        &self.orders
    }

    /// Reflectance and transmittance of the order in place `order_index` of [`orders`](Self::orders).
    ///
    /// # Panics
    /// If an index is out of bounds.
    pub fn estimate(
        &self,
        incidence_index: usize,
        tau_index: usize,
        order_index: usize,
    ) -> (Estimate, Estimate) {
        let place = (incidence_index * self.tau.len() + tau_index) * self.orders.len() + order_index;
        let of = |(value, std_error): (f64, f64)| Estimate { value, std_error };
        (of(self.rows[2 * place]), of(self.rows[2 * place + 1]))
    }

    /// Total reflectance and transmittance.
    ///
    /// # Panics
    /// If an index is out of bounds.
    pub fn total(&self, incidence_index: usize, tau_index: usize) -> (Estimate, Estimate) {
        self.estimate(incidence_index, tau_index, self.orders.len() - 1)
    }
}
