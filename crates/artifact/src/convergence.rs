//! `convergence.csv`: error against photons or streams and against seconds.

use serde::{Deserialize, Serialize};

/// One point of a convergence curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConvergenceRow {
    /// `plain` or `half-space`, the tracers, or `solver`.
    pub estimator: String,
    /// Incidence angle in degrees.
    pub theta_l_deg: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// 0…N, `tail` or `total`.
    pub order: String,
    /// Histories traced; of the solver, streams per hemisphere.
    pub photons: u64,
    /// Wall time in seconds.
    pub seconds: f64,
    /// |reflectance - truth|, the truth being the solver's with 96 streams per hemisphere.
    pub error: f64,
    /// Standard error claimed by the run itself; of the solver, the change from the row before.
    pub std_error: f64,
}
