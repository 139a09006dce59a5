//! A family's tables as model types.

use crate::tables::{angles, diffuse_values};
use crate::{CodegenError, parameter_grid};
use stratiform_artifact::{FamilyDocument, ParameterTable};
use stratiform_model::Real;
use stratiform_model::family::{Member, ParameterFamily, RadiusCoordinate};

/// The coordinate of the emitted interpolation: of four, `family-interpolation.csv` finds it best.
pub const FAMILY_COORDINATE: RadiusCoordinate = RadiusCoordinate::TwoThirds;

/// The table of one effective radius.
///
/// # Errors
/// [`CodegenError`] if rows are missing, out of domain, unsorted, or do not cover 0 to 90 degrees.
pub fn family_member(effective_radius_um: f64, table: &ParameterTable) -> Result<Member, CodegenError> {
    parameter_grid::<f64>(table)?;
    Ok(Member { effective_radius_um, angles: angles(table), diffuse: diffuse_values(table)? })
}

/// Every table of the document.
///
/// # Errors
/// As [`family_member`].
pub(super) fn members(family: &FamilyDocument) -> Result<Vec<Member>, CodegenError> {
    family.members.iter().map(|one| family_member(one.effective_radius_um, &one.parameters.optical)).collect()
}

/// The family, interpolated as the shaders do.
///
/// # Errors
/// As [`family_member`], and if radii do not rise.
pub fn parameter_family<F: Real>(family: &FamilyDocument) -> Result<ParameterFamily<F>, CodegenError> {
    Ok(ParameterFamily::new(FAMILY_COORDINATE, &members(family)?)?)
}
