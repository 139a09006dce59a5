//! `convergence.csv`: error against photons and against seconds.

use serde::{Deserialize, Serialize};

/// One point of a convergence curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConvergenceRow {
    /// `plain` or `half-space`.
    pub estimator: String,
    /// Incidence angle in degrees.
    pub theta_l_deg: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// 0…N, `tail` or `total`.
    pub order: String,
    /// Histories traced.
    pub photons: u64,
    /// Wall time in seconds.
    pub seconds: f64,
    /// |reflectance - reference|, the reference being a run of many more photons.
    pub error: f64,
    /// Standard error claimed by the run itself.
    pub std_error: f64,
}
