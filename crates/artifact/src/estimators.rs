//! `convergence.csv` of a study of estimators: error against photons and seconds.

use serde::{Deserialize, Serialize};

/// Runs of one estimator with one number of photons, one row of their results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EstimatorErrorRow {
    /// Its name.
    pub estimator: String,
    /// `R` or `T`, with the order behind it if it is of one order.
    pub quantity: String,
    /// Optical thickness.
    pub tau: f64,
    /// Cosine of the angle of incidence.
    pub mu0: f64,
    /// Histories of a run.
    pub photons: u64,
    /// Wall time of a run, all thicknesses together: mean flights times the least time per flight of any run.
    pub seconds: f64,
    /// Root mean square over runs of the difference from the solver.
    pub error: f64,
}
