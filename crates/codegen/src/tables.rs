//! The parameter tables: as model types, and as files.

use crate::{CodegenError, Inputs};
use stratiform_artifact::{ParameterRow, ParameterTable, to_csv, to_json};
use stratiform_model::table::{Angle, ParameterGrid};
use stratiform_model::{Parameters, Real, Values};
use stratiform_quantities::Incidence;

/// What emitted code uses of a row.
fn emitted(table: &ParameterTable, row: &ParameterRow) -> Values<f64> {
    Values {
        beta: table.beta.value,
        b: row.b.emitted,
        c: row.c.emitted,
        kappa_c: row.kappa_c.emitted,
        t: row.t.emitted,
        r: row.r.emitted,
        kappa_s: table.kappa_s,
    }
}

/// The rows that hold for an angle.
pub(crate) fn angles(table: &ParameterTable) -> Vec<Angle> {
    let angle = |row: &ParameterRow| {
        row.theta_l_deg.degrees().map(|theta_l_deg| Angle { theta_l_deg, values: emitted(table, row) })
    };
    table.rows.iter().filter_map(angle).collect()
}

/// The interpolated table, as the shaders have it.
///
/// # Errors
/// [`CodegenError`] if the rows are out of domain, unsorted, or do not cover 0 to 90 degrees.
pub fn parameter_grid<F: Real>(table: &ParameterTable) -> Result<ParameterGrid<F>, CodegenError> {
    let angles = angles(table);
    let grid = ParameterGrid::new(&angles)?;
    let (first, last) = (angles[0].theta_l_deg, angles[angles.len() - 1].theta_l_deg);
    if first != 0.0 || last != 90.0 {
        return Err(CodegenError::Uncovered { first, last });
    }
    Ok(grid)
}

/// The row `diffuse`.
pub(crate) fn diffuse_values(table: &ParameterTable) -> Result<Values<f64>, CodegenError> {
    let row = table.rows.iter().find(|row| row.theta_l_deg.degrees().is_none());
    let row = row.ok_or(CodegenError::NoDiffuseRow)?;
    match row.theta_l_deg.to_string() {
        word if word == "diffuse" => Ok(emitted(table, row)),
        word => Err(CodegenError::UnknownRow { word }),
    }
}

/// The parameters of diffuse light.
///
/// # Errors
/// [`CodegenError`] if the row is missing or out of domain.
pub fn diffuse_parameters<F: Real>(table: &ParameterTable) -> Result<Parameters<F>, CodegenError> {
    Ok(Parameters::new(&diffuse_values(table)?, Incidence::Diffuse)?)
}

/// parameters.json and parameters.csv.
pub(crate) fn files(inputs: &Inputs) -> Result<Vec<(String, String)>, CodegenError> {
    Ok(vec![
        ("parameters.json".to_owned(), to_json(&inputs.parameters)?),
        ("parameters.csv".to_owned(), to_csv(&inputs.parameters.csv_rows())?),
    ])
}
