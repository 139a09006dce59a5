//! Tables over effective radius: schema `stratiform/family/1`, and the errors of what stands between them
//! (`family-interpolation.csv`, `family-scaling.csv`).

use crate::{Extinction, ParametersDocument, Provenance};
use serde::{Deserialize, Serialize};

/// The document `family.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FamilyDocument {
    /// `stratiform/family/1`.
    pub schema: String,
    /// How it was made.
    pub provenance: Provenance,
    /// The function of r_e in which parameters are interpolated, e.g. `log(r)`.
    pub coordinate: String,
    /// One table per effective radius, rising.
    pub members: Vec<FamilyMember>,
}

/// One effective radius.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FamilyMember {
    /// r_e, µm.
    pub effective_radius_um: f64,
    /// N0: chosen so that N0 π r_e² is that of the config's own radius, and the thicknesses in metres are the same
    /// optical thicknesses.
    pub number_density_per_cm3: f64,
    /// κ per metre in both conventions.
    pub extinction_per_m: Extinction,
    /// g_S of the modified medium.
    pub modified_asymmetry: f64,
    /// The fitted table; g, P_f and ω stand in its medium.
    pub parameters: ParametersDocument,
}

impl FamilyDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/family/1";
}

impl FamilyMember {
    /// ⟨Q_ext⟩ = ⟨Q_ext π r²⟩/(π r_e²): what turns optical thickness in the paper's convention into the physical one.
    pub fn extinction_ratio(&self) -> f64 {
        self.extinction_per_m.mie / self.extinction_per_m.paper
    }
}

/// One flux of one effective radius, from a table made for others: a row of `family-interpolation.csv` or
/// `family-scaling.csv`. Differences are absolute, in shares of the incident flux.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FamilyErrorRow {
    /// r_e at which the flux is wanted, µm.
    pub effective_radius_um: f64,
    /// r_e of the tables used, µm, separated by spaces.
    pub table_radii_um: String,
    /// Coordinate of the interpolation, or the thickness with which one table is entered; `own` for the radius's own table.
    pub method: String,
    /// `solver`, or `fit`: the model with parameters fitted at this radius.
    pub against: String,
    /// `to-80`: angles up to 80 degrees; `all`: those beyond and diffuse light too.
    pub angles: String,
    /// `t_ms`, `t_0` … `r_3_plus`.
    pub quantity: String,
    /// Root mean square over angles and thicknesses.
    pub rms: f64,
    /// Largest magnitude.
    pub worst: f64,
    /// Where: angle in degrees, or `diffuse`.
    pub worst_theta_l_deg: String,
    /// Where: optical thickness.
    pub worst_tau: f64,
    /// Number of points.
    pub points: u64,
}
