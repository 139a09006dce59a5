//! What code is generated from.

use crate::{CodegenError, parameter_grid};
use serde::{Deserialize, Serialize};
use stratiform_artifact::{ParametersDocument, RadianceParametersDocument};
use stratiform_quantities::{Incidence, OpticalThickness, Range};

/// The fluxes, in the order in which they are emitted.
pub const QUANTITIES: [&str; 9] = ["t_ms", "r_ms", "t_0", "t_1", "t_2", "t_3_plus", "r_1", "r_2", "r_3_plus"];

/// A row of a phase table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhaseRow {
    /// Θ in degrees.
    pub theta_deg: f64,
    /// P, with mean 1 over the sphere.
    pub p: f64,
}

/// The three phase functions, piecewise linear in Θ between rows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PhaseTables {
    /// P of the full medium.
    pub full: Vec<PhaseRow>,
    /// P_S of the modified medium.
    pub modified: Vec<PhaseRow>,
    /// P_S convolved with itself on the sphere.
    pub squared: Vec<PhaseRow>,
}

/// The shape of light that met two or more forward events, over s = sin(Θ/2) and the optical path q of the full medium, both
/// evenly spaced from 0; mean 1 over the sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HaloTable {
    /// Last s.
    pub reach: f64,
    /// Last q.
    pub longest: f64,
    /// Number of s.
    pub angles: usize,
    /// Row by row of q.
    pub values: Vec<f64>,
}

impl HaloTable {
    fn check(&self) -> Result<(), CodegenError> {
        Range { min_included: false, ..Range::closed(0.0, 1.0) }.check("halo reach", self.reach)?;
        EXTINCTION.check("halo longest", self.longest)?;
        Range::at_least(2.0).check("halo angles", self.angles as f64)?;
        Range::at_least(2.0).check("halo paths", self.values.len() as f64 / self.angles as f64)?;
        self.values.iter().try_for_each(|value| PHASE.check("halo", *value).map(drop))?;
        match self.values.len() % self.angles {
            0 => Ok(()),
            rest => {
                Err(CodegenError::Phase { table: "halo", message: format!("its last row has {rest} values") })
            }
        }
    }
}

/// A flux that something else than the model computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReferencePoint {
    /// Beam or diffuse.
    pub incidence: Incidence,
    /// Optical thickness of the full medium.
    pub tau: OpticalThickness,
    /// One of [`QUANTITIES`].
    pub quantity: String,
    /// The flux.
    pub value: f64,
    /// Its standard error, or estimated error: see [`Provenance::error_name`](stratiform_artifact::Provenance::error_name).
    pub std_error: f64,
}

/// Parameters with which single precision computes: their products stay finite.
const SINGLE: Range = Range::closed(-1e9, 1e9);
/// Extinctions likewise, which it does not lose to 0.
const EXTINCTION: Range = Range::closed(1e-9, 1e9);
/// P likewise; a droplet of size parameter 1e5 has 1e10 in its peak.
const PHASE: Range = Range::closed(0.0, 1e12);

/// Everything that the emitted text depends on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Inputs {
    /// The fitted parameters.
    pub parameters: ParametersDocument,
    /// The phase functions of the medium.
    pub phase: PhaseTables,
    /// Shape of the halo of forward events; none where the medium has no forward peak.
    pub halo: Option<HaloTable>,
    /// Coefficients of the fitted radiance model; none where it was not fitted.
    pub radiance: Option<RadianceParametersDocument>,
    /// Fluxes for the error card: at the table's angles, between them, and diffuse, in any order. May be empty.
    pub reference: Vec<ReferencePoint>,
}

impl Inputs {
    /// Hash of all of it.
    pub fn hash(&self) -> String {
        stratiform_artifact::hash_of(self)
    }

    pub(crate) fn check(&self) -> Result<(), CodegenError> {
        let medium = &self.parameters.medium;
        EXTINCTION.check("extinction_per_m", medium.extinction_per_m)?;
        EXTINCTION.check("kappa_s", self.parameters.optical.kappa_s)?;
        Range { max_included: false, ..Range::closed(0.0, 1.0) }
            .check("forward_fraction", medium.forward_fraction)?;
        Range::closed(0.0, 180.0).check("theta_f_deg", medium.theta_f_deg)?;
        parameter_grid::<f64>(&self.parameters.optical)?;
        SINGLE.check("(1 - beta) / beta", 1.0 / self.parameters.optical.beta.value - 1.0)?;
        for row in &self.parameters.optical.rows {
            for (name, value) in
                [("b", &row.b), ("c", &row.c), ("kappa_c", &row.kappa_c), ("t", &row.t), ("r", &row.r)]
            {
                SINGLE.check(name, value.emitted)?;
            }
        }
        for (table, rows) in
            [("full", &self.phase.full), ("modified", &self.phase.modified), ("squared", &self.phase.squared)]
        {
            check_phase(rows).map_err(|message| CodegenError::Phase { table, message })?;
        }
        self.halo.as_ref().map_or(Ok(()), HaloTable::check)?;
        if self.radiance.as_ref().is_some_and(|radiance| radiance.medium != *medium) {
            return Err(CodegenError::RadianceMedium);
        }
        for point in &self.reference {
            Range::at_least(0.0).check("std_error", point.std_error)?;
        }
        match self.reference.iter().find(|point| !QUANTITIES.contains(&point.quantity.as_str())) {
            Some(point) => Err(CodegenError::UnknownQuantity { quantity: point.quantity.clone() }),
            None => Ok(()),
        }
    }
}

fn check_phase(rows: &[PhaseRow]) -> Result<(), String> {
    let [first, .., last] = rows else {
        return Err(format!("it has {} rows: at least 2 are needed", rows.len()));
    };
    if first.theta_deg != 0.0 || last.theta_deg != 180.0 {
        return Err(format!(
            "it covers {} to {} degrees: it must cover 0 to 180",
            first.theta_deg, last.theta_deg
        ));
    }
    for row in rows {
        Range::closed(0.0, 180.0).check("theta_deg", row.theta_deg).map_err(|error| error.to_string())?;
        PHASE.check("p", row.p).map_err(|error| error.to_string())?;
    }
    match rows.windows(2).find(|pair| pair[1].theta_deg < pair[0].theta_deg) {
        Some(pair) => Err(format!("theta_deg = {} follows {}", pair[1].theta_deg, pair[0].theta_deg)),
        None => Ok(()),
    }
}
