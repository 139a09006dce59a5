//! The two sources held against each other: the same objective fitted to solved and to traced fluxes must give the same
//! parameters within both errors.
//!
//! The witness is the source that the table is not fitted to. [`stratiform_fit::compare`] judges all parameters together
//! at one false-alarm rate.

use crate::CliError;
use std::path::Path;
use stratiform_artifact::{
    AgreementDocument, AgreementRow, FittedParameter, ParametersDocument, read_json, write_csv, write_json,
};
use stratiform_fit::{Comparison, Deviation, compare};

/// Probability that sources which agree are said to differ.
const FALSE_ALARM_RATE: f64 = 1e-4;

/// Compares the tables and writes `agreement.csv` and `agreement.json`.
///
/// # Errors
/// [`CliError::Input`] for tables that do not belong together or a file that cannot be written.
pub fn write(
    dir: &Path,
    solved: &ParametersDocument,
    traced: &ParametersDocument,
    photons: u64,
) -> Result<Vec<String>, CliError> {
    let comparison = compare(solved, traced, FALSE_ALARM_RATE).map_err(super::input_error)?;
    let rows: Vec<AgreementRow> =
        comparison.deviations.iter().map(|d| row(&comparison, d, solved, traced)).collect();
    let size = |row: &&AgreementRow| row.z.map_or(f64::INFINITY, f64::abs);
    let worst = rows.iter().max_by(|a, b| size(a).total_cmp(&size(b)));
    let worst = worst.cloned().ok_or_else(|| CliError::Input("no parameter was compared".to_owned()))?;
    let document = AgreementDocument {
        schema: AgreementDocument::SCHEMA.to_owned(),
        provenance: traced.provenance.clone(),
        photons,
        false_alarm_rate: FALSE_ALARM_RATE,
        comparisons: rows.len() as u64,
        threshold: comparison.threshold,
        differing: rows.iter().filter(|row| row.differs).count() as u64,
        worst,
    };
    write_csv(&dir.join("agreement.csv"), &rows)?;
    write_json(&dir.join("agreement.json"), &document)?;
    Ok(vec!["agreement.csv".to_owned(), "agreement.json".to_owned()])
}

/// What was found, if there was a witness.
pub fn read(dir: &Path) -> Option<AgreementDocument> {
    read_json(&dir.join("agreement.json")).ok()
}

fn row(
    comparison: &Comparison,
    deviation: &Deviation,
    solved: &ParametersDocument,
    traced: &ParametersDocument,
) -> AgreementRow {
    let Deviation { theta_l_deg, parameter, values: [of_solver, of_photons], z } = deviation.clone();
    AgreementRow {
        solved: of_solver,
        solved_error: error(solved, &theta_l_deg, parameter),
        traced: of_photons,
        traced_std_error: error(traced, &theta_l_deg, parameter),
        z: z.is_finite().then_some(z),
        differs: z.is_nan() || z.abs() > comparison.threshold,
        parameter: parameter.to_owned(),
        theta_l_deg,
    }
}

/// The error of one parameter of the table in optical thickness.
fn error(document: &ParametersDocument, theta_l_deg: &str, parameter: &str) -> Option<f64> {
    let row = document.optical.rows.iter().find(|row| row.theta_l_deg.to_string() == theta_l_deg);
    let of = |part: fn(&stratiform_artifact::ParameterRow) -> &FittedParameter| {
        row.and_then(|row| part(row).std_error)
    };
    match parameter {
        "b" => of(|row| &row.b),
        "c" => of(|row| &row.c),
        "kappa_c" => of(|row| &row.kappa_c),
        "t" => of(|row| &row.t),
        "r" => of(|row| &row.r),
        _ => Some(document.optical.beta.std_error),
    }
}
