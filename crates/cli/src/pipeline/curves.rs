//! `curves.csv`: the one-dimensional model drawn finely, from the fitted and from the published parameters.

use super::published;
use crate::CliError;
use std::path::Path;
use stratiform_artifact::{
    CurveModel, CurveQuantity, CurvesRow, ParameterRow, ParameterTable, ParametersDocument, PublishedRow,
    write_csv,
};
use stratiform_model::{Fluxes, Form, Parameters, Thickness, Values, table::cos_degrees};
use stratiform_quantities::Incidence;

const POINTS: u32 = 61;

/// Writes the file and returns its name.
///
/// # Errors
/// [`CliError::Input`] if parameters are out of the model's domain or the file cannot be written.
pub fn write(
    dir: &Path,
    document: &ParametersDocument,
    published: &[PublishedRow],
) -> Result<String, CliError> {
    let mut rows = Vec::new();
    for row in &document.metres.rows {
        if let Some(theta) = row.theta_l_deg.degrees() {
            draw(&mut rows, document, theta, CurveModel::Fitted, &emitted(&document.metres, row))?;
        }
    }
    for row in published {
        let values = published::values(row, document.metres.kappa_s);
        draw(&mut rows, document, row.theta_l_deg, CurveModel::Published, &values)?;
    }
    write_csv(&dir.join("curves.csv"), &rows)?;
    Ok("curves.csv".to_owned())
}

/// What emitted code uses for a row of `table`.
pub fn emitted(table: &ParameterTable, row: &ParameterRow) -> Values<f64> {
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

/// The model at one angle and thickness.
///
/// # Errors
/// [`CliError::Input`] for parameters or thickness out of the model's domain.
pub fn fluxes(values: &Values<f64>, theta_l_deg: f64, thickness_m: f64) -> Result<Fluxes<f64>, CliError> {
    let model =
        |error: stratiform_model::ModelError| CliError::Input(format!("{theta_l_deg} degrees: {error}"));
    let incidence = Incidence::beam(cos_degrees(theta_l_deg))?;
    let parameters = Parameters::new(values, incidence).map_err(model)?;
    Ok(parameters.fluxes(Form::Corrected, Thickness::new(thickness_m).map_err(model)?))
}

fn draw(
    rows: &mut Vec<CurvesRow>,
    document: &ParametersDocument,
    theta_l_deg: f64,
    model: CurveModel,
    values: &Values<f64>,
) -> Result<(), CliError> {
    let [min, max] = document.thickness_range_m;
    for point in 0..POINTS {
        let thickness_m = min * libm::pow(max / min, f64::from(point) / f64::from(POINTS - 1));
        let fluxes = fluxes(values, theta_l_deg, thickness_m)?;
        rows.extend(quantities(&fluxes).map(|(quantity, value)| CurvesRow {
            theta_l_deg,
            thickness_m,
            quantity,
            model,
            value,
        }));
    }
    Ok(())
}

fn quantities(fluxes: &Fluxes<f64>) -> [(CurveQuantity, f64); 9] {
    [
        (CurveQuantity::TMs, fluxes.t_ms),
        (CurveQuantity::RMs, fluxes.r_ms),
        (CurveQuantity::T0, fluxes.t_0),
        (CurveQuantity::T1, fluxes.t_1),
        (CurveQuantity::T2, fluxes.t_2),
        (CurveQuantity::T3Plus, fluxes.t_3_plus),
        (CurveQuantity::R1, fluxes.r_1),
        (CurveQuantity::R2, fluxes.r_2),
        (CurveQuantity::R3Plus, fluxes.r_3_plus),
    ]
}
