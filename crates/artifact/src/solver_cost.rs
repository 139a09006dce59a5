//! `solver_cost.csv`: seconds of the deterministic solver against streams, thickness and number of thicknesses.

use serde::{Deserialize, Serialize};

/// One timed call. The medium is prepared beforehand: its moments, and their projection on the
/// streams.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolverCostRow {
    /// What varies: `streams`, `tau` or `thicknesses`.
    pub against: String,
    /// What is solved for: `first`, total fluxes, the first of the medium; `further`, total fluxes with the modes
    /// known; `orders`, orders 0 to 2 and the total.
    pub task: String,
    /// Streams per hemisphere.
    pub streams: u64,
    /// Optical thickness of the full medium; the largest of several.
    pub tau: f64,
    /// Number of thicknesses.
    pub thicknesses: u64,
    /// Wall time in seconds, the least of several.
    pub seconds: f64,
}
