//! Radiance leaving a slab: schema `stratiform/radiance/1`.

use crate::{Provenance, TracedMedium};
use serde::{Deserialize, Serialize};
use stratiform_quantities::{Order, Side};

/// One row of `results`, and of the CSV.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceResult {
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Cosine of the zenith angle of incidence.
    pub mu0: f64,
    /// Cosine of the leaving light's angle to the normal.
    pub mu: f64,
    /// Azimuth; at 0 light keeps the sun's.
    pub phi_deg: f64,
    /// The face it leaves.
    pub side: Side,
    /// 1, 2, …, `"tail"` (traced ones only) or `"total"`; the total is without unscattered light.
    pub order: Order,
    /// πL/(μ0 F0).
    pub value: f64,
    /// Estimated absolute error if solved, standard error if traced.
    pub std_error: f64,
    /// Of traced values only: whether enough of the rare large scores were met for the error to be a measurement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settled: Option<bool>,
}

/// The JSON document printed by `solve` and `trace` for views.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceDocument {
    /// `stratiform/radiance/1`.
    pub schema: String,
    /// What was solved or traced.
    pub medium: TracedMedium,
    /// How.
    pub provenance: Provenance,
    /// One entry per thickness, incidence, view, side and order.
    pub results: Vec<RadianceResult>,
}

impl RadianceDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/radiance/1";
}
