//! The fitted coefficients of the radiance model: schema `stratiform/radiance-parameters/1`.

use crate::{MediumRecord, Provenance};
use serde::{Deserialize, Serialize};
use stratiform_quantities::Side;
use stratiform_stats::Estimate;

/// The points of a set of reference radiances.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceSample {
    /// Smallest and largest optical thickness of the full medium.
    pub tau: [f64; 2],
    /// Smallest and largest of θ_l and θ_v, degrees.
    pub theta_deg: [f64; 2],
    /// Left out of transmission: Θ below this, degrees.
    pub aureole_deg: f64,
}

/// Model over reference minus 1, in magnitude.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceMisfit {
    /// The face.
    pub side: Side,
    /// Where the points lie.
    pub sample: RadianceSample,
    /// Whether the coefficients were fitted to these points.
    pub fitted: bool,
    /// How many there are.
    pub points: usize,
    /// Half of the points are nearer.
    pub median: f64,
    /// 95 of 100 points are nearer.
    pub p95: f64,
    /// Largest.
    pub worst: f64,
    /// Where: τ, θ_l, θ_v, φ (degrees).
    pub worst_at: [f64; 4],
}

/// The coefficients of one face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceFace {
    /// The face.
    pub side: Side,
    /// a_kj, a row for each power j of u, an entry for each term k.
    pub coefficients: Vec<Vec<Estimate>>,
    /// Median over the fitted points of the relative standard error of M that follows from the coefficients' covariance.
    pub relative_std_error: f64,
}

/// The document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceParametersDocument {
    /// `stratiform/radiance-parameters/1`.
    pub schema: String,
    /// How it was made.
    pub provenance: Provenance,
    /// The cloud.
    pub medium: MediumRecord,
    /// Exponents of μ_l+μ_v, μ_l μ_v and cosΘ in each term k.
    pub exponents: Vec<[u32; 3]>,
    /// Top, then bottom.
    pub faces: Vec<RadianceFace>,
    /// Errors at the fitted points and at others.
    pub misfit: Vec<RadianceMisfit>,
}

impl RadianceParametersDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/radiance-parameters/1";

    /// The coefficients of a face, `[j][k]`; `None` if the face is missing or its table has another shape.
    pub fn table<const TERMS: usize, const POWERS: usize>(
        &self,
        side: Side,
    ) -> Option<[[f64; TERMS]; POWERS]> {
        let face = self.faces.iter().find(|face| face.side == side)?;
        let row = |row: &Vec<Estimate>| -> Option<[f64; TERMS]> {
            row.iter().map(|a| a.value).collect::<Vec<_>>().try_into().ok()
        };
        face.coefficients.iter().map(row).collect::<Option<Vec<_>>>()?.try_into().ok()
    }
}
