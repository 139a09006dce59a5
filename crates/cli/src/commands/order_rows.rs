//! What `trace` and `solve` share: incidences as typed, rows as printed.

use crate::CliError;
use crate::output::Data;
use serde::Serialize;
use stratiform_artifact::{OrderResult, to_csv};
use stratiform_quantities::{Incidence, Medium};

/// A row of the CSV.
#[derive(Serialize)]
struct Row {
    tau: f64,
    mu0: String,
    medium: Medium,
    order: String,
    reflectance: f64,
    reflectance_std_error: f64,
    transmittance: f64,
    transmittance_std_error: f64,
}

/// Numbers in [0, 1] or `diffuse`.
///
/// # Errors
/// [`CliError::Input`] naming the word that is neither.
pub fn parse_incidences(words: &[String]) -> Result<Vec<Incidence>, CliError> {
    words.iter().map(|word| word.parse().map_err(CliError::Input)).collect()
}

/// The results in `medium` as CSV.
///
/// # Errors
/// [`CliError::Input`] if they cannot be written.
pub fn csv(medium: Medium, results: Vec<OrderResult>) -> Result<Data, CliError> {
    let row = |result: OrderResult| Row {
        tau: result.tau,
        mu0: result.mu0.to_string(),
        medium,
        order: result.order.to_string(),
        reflectance: result.reflectance.value,
        reflectance_std_error: result.reflectance.std_error,
        transmittance: result.transmittance.value,
        transmittance_std_error: result.transmittance.std_error,
    };
    let rows: Vec<Row> = results.into_iter().map(row).collect();
    Ok(to_csv(&rows)?)
}
