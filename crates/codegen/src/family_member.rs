//! A family's tables as model types.

use crate::tables::{angles, diffuse_values};
use crate::{CodegenError, parameter_grid};
use stratiform_artifact::ParameterTable;
use stratiform_model::family::Member;

/// The table of one effective radius.
///
/// # Errors
/// [`CodegenError`] if rows are missing, out of domain, unsorted, or do not cover 0 to 90 degrees.
pub fn family_member(effective_radius_um: f64, table: &ParameterTable) -> Result<Member, CodegenError> {
    parameter_grid::<f64>(table)?;
    Ok(Member { effective_radius_um, angles: angles(table), diffuse: diffuse_values(table)? })
}
