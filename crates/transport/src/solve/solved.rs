//! The solver's answer.

use super::solver::Solver;
use stratiform_quantities::Incidence;
use stratiform_stats::Estimate;

/// Reflectance and transmittance with estimated absolute errors (in `std_error`).
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    tau: Vec<f64>,
    incidence: Vec<Incidence>,
    /// Orders 0…N listed, none for totals only.
    orders: usize,
    /// R, T for each row of orders, thickness inside incidence.
    rows: Vec<(f64, f64)>,
    streams: usize,
    moments: usize,
}

impl Solved {
    pub(crate) fn totals(
        solver: &Solver,
        tau: &[f64],
        incidence: &[Incidence],
        rows: Vec<(f64, f64)>,
        streams: usize,
    ) -> Self {
        let (tau, incidence, moments) = (tau.to_vec(), incidence.to_vec(), solver.moment_count());
        Self { tau, incidence, orders: 0, rows, streams, moments }
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

    /// Total reflectance and transmittance.
    ///
    /// # Panics
    /// If an index is out of bounds.
    pub fn total(&self, incidence_index: usize, tau_index: usize) -> (Estimate, Estimate) {
        let at = 2 * (incidence_index * self.tau.len() + tau_index);
        let of = |(value, std_error): (f64, f64)| Estimate { value, std_error };
        (of(self.rows[at]), of(self.rows[at + 1]))
    }
}
