//! Radiance: there is no deterministic truth for it yet.

use super::ValueRow;
use crate::CliError;
use stratiform_stats::Estimate;

/// Refuses the row.
///
/// # Errors
/// [`CliError::Input`], always.
pub(super) fn truth(row: &ValueRow) -> Result<Estimate, CliError> {
    Err(CliError::Input(format!("{} is not available: the solver gives fluxes only", row.quantity)))
}
