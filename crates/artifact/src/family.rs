//! Tables over effective radius: schema `stratiform/family/1`, and the errors of what stands between them
//! (`family-interpolation.csv`, `family-scaling.csv`, `family-phase.csv`).

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
    /// P of the full medium at equal steps of the angle map, seven digits.
    pub phase: Vec<f64>,
    /// P_S convolved with itself, likewise.
    pub phase_squared: Vec<f64>,
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

/// How well a phase function at one effective radius is had from others: a row of `family-phase.csv`. The five worst
/// errors are relative.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FamilyPhaseRow {
    /// r_e at which P is wanted, µm.
    pub effective_radius_um: f64,
    /// r_e of the two tables used, µm, separated by a space.
    pub table_radii_um: String,
    /// What is linear in ln r_e: `P`, `log P`, `log P stretched`, or `texels`, P of the family's texels.
    pub method: String,
    /// `full` for P, `squared` for P_S convolved with itself.
    pub function: String,
    /// Share of the scattered light that goes elsewhere: half of ½∫|difference| sinΘ dΘ.
    pub elsewhere: f64,
    /// ½∫P sinΘ dΘ minus 1.
    pub norm_error: f64,
    /// Up to 5°.
    pub worst_peak: f64,
    /// From 5° to 30°.
    pub worst_forward: f64,
    /// From 30° to 130°.
    pub worst_side: f64,
    /// From 130° to 165°.
    pub worst_fogbow: f64,
    /// From 165° to 180°.
    pub worst_glory: f64,
}
