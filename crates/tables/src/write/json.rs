//! JSON: the metadata and the values, schema `stratiform/phase-table/1`. f64.

use super::{Metadata, Precision};
use crate::TablesError;
use crate::sampled::{coordinate, theta_deg};
use crate::set::SampledSet;
use serde::{Deserialize, Serialize};
use stratiform_artifact::to_json;

/// The document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhaseDocument {
    /// `stratiform/phase-table/1`.
    pub schema: String,
    /// Units, conventions, medium, provenance.
    pub metadata: Metadata,
    /// u of the texels.
    pub coordinate: Vec<f64>,
    /// Θ of the texels.
    pub theta_deg: Vec<f64>,
    /// `p[function][channel][texel]`.
    pub p: Vec<Vec<Vec<f64>>>,
}

/// The set as JSON.
///
/// # Errors
/// [`TablesError::Domain`] for values that are not finite.
pub fn phase_json(set: &SampledSet) -> Result<Vec<u8>, TablesError> {
    Precision::F64.check_set(set)?;
    let document = PhaseDocument {
        schema: Metadata::SCHEMA.to_owned(),
        metadata: Metadata::new(set),
        coordinate: (0..set.texels).map(|i| coordinate(i, set.texels)).collect(),
        theta_deg: (0..set.texels).map(|i| theta_deg(i, set.texels)).collect(),
        p: set.rows.iter().map(|row| row.iter().map(|sample| sample.values.clone()).collect()).collect(),
    };
    Ok(to_json(&document)?.into_bytes())
}
