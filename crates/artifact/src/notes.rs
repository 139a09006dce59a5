//! Numbers that explain why a published table differs from the regenerated one: schema `stratiform/notes/1`.

use crate::{Misfit, Provenance, RowIncidence};
use serde::{Deserialize, Serialize};

/// How a phase function's energy is shared among three ranges of the scattering angle. The sum is 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AngularShares {
    /// 0 to θ_f.
    pub forward: f64,
    /// θ_f to 90°.
    pub wide: f64,
    /// Beyond 90°.
    pub backward: f64,
}

/// The shares at one wavelength, converged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WavelengthShares {
    /// Wavelength in µm.
    pub wavelength_um: f64,
    /// The shares.
    pub shares: AngularShares,
}

/// What a table of equal angular steps, integrated linearly in cosΘ, makes of the same phase function.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoarseTabulation {
    /// Wavelength in µm.
    pub wavelength_um: f64,
    /// Step of the table in degrees.
    pub step_deg: f64,
    /// ½∫P dcosΘ of the table; 1 if the table were fine enough.
    pub raw_integral: f64,
    /// P_f of the table as it stands.
    pub raw_forward_fraction: f64,
    /// P_f after dividing by `raw_integral`.
    pub forward_fraction: f64,
}

/// Full minus modified medium, where it is largest over the thickness grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ModifiedBias {
    /// θ_l in degrees or `"diffuse"`.
    pub theta_l_deg: RowIncidence,
    /// Where, in metres.
    pub thickness_m: f64,
    /// T_full - T_modified, all orders.
    pub difference: f64,
    /// Its standard error.
    pub std_error: f64,
}

/// Misfit of the published parameters against the reference at one angle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedMisfit {
    /// Incidence angle in degrees.
    pub theta_l_deg: f64,
    /// Per quantity, thickness in metres.
    pub misfit: Vec<Misfit>,
}

/// The document `notes.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NotesDocument {
    /// `stratiform/notes/1`.
    pub schema: String,
    /// How it was made.
    pub provenance: Provenance,
    /// Who published the table and where, in words.
    pub published_source: String,
    /// The published β, if there is one.
    pub published_beta: Option<f64>,
    /// The published shares, if there are any.
    pub published_shares: Option<AngularShares>,
    /// The converged shares, one entry per wavelength.
    pub shares: Vec<WavelengthShares>,
    /// What coarse tabulation makes of them.
    pub coarse_tabulation: Vec<CoarseTabulation>,
    /// Bias of the modified medium, one entry per incidence.
    pub modified_bias: Vec<ModifiedBias>,
    /// Misfit of the published table, one entry per angle.
    pub published_misfit: Vec<PublishedMisfit>,
}

impl NotesDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/notes/1";
}
