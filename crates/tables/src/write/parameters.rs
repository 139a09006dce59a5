//! Parameter tables in the same containers.

use super::exr::{self, Plane};
use super::ktx2::Texture;
use super::metadata::line;
use super::npy::{doubles, string};
use super::{Precision, zip};
use crate::TablesError;
use crate::parameters::{COLUMNS, ParameterTexels, ParameterValues};
use std::fmt::Write;
use stratiform_artifact::to_json;

/// CSV: metadata in one `#` line, then theta_l_deg (or `diffuse`), mu_l, b, c, kappa_c, t, r.
///
/// # Errors
/// [`TablesError::Container`] for metadata that are not finite.
pub fn parameters_csv(table: &ParameterTexels) -> Result<Vec<u8>, TablesError> {
    let mut text = format!("# {}\ntheta_l_deg,mu_l,b,c,kappa_c,t,r\n", line(&table.metadata)?);
    for row in &table.rows {
        let angle = row.theta_l_deg.map_or("diffuse".to_owned(), |degrees| degrees.to_string());
        let _ =
            writeln!(text, "{angle},{},{},{},{},{},{}", row.mu_l, row.b, row.c, row.kappa_c, row.t, row.r);
    }
    Ok(text.into_bytes())
}

/// JSON: `metadata` and `rows`.
///
/// # Errors
/// [`TablesError::Artifact`] for numbers that are not finite.
pub fn parameters_json(table: &ParameterTexels) -> Result<Vec<u8>, TablesError> {
    Ok(to_json(table)?.into_bytes())
}

/// npz: mu_l, b, c, kappa_c, t, r, one value per row, and metadata (JSON).
///
/// # Errors
/// [`TablesError::Container`] for metadata that are not finite.
pub fn parameters_npz(table: &ParameterTexels) -> Result<Vec<u8>, TablesError> {
    let column = |name: &str, of: fn(&ParameterValues) -> f64| {
        let values: Vec<f64> = table.rows.iter().map(of).collect();
        (format!("{name}.npy"), doubles(&[values.len()], &values))
    };
    Ok(zip::stored(&[
        column("mu_l", |row| row.mu_l),
        column("b", |row| row.b),
        column("c", |row| row.c),
        column("kappa_c", |row| row.kappa_c),
        column("t", |row| row.t),
        column("r", |row| row.r),
        ("metadata.npy".to_owned(), string(&line(&table.metadata)?)),
    ]))
}

/// EXR, f32: a column per row of the table, a channel per entry of [`COLUMNS`].
///
/// # Errors
/// [`TablesError::Domain`] for values that f32 cannot hold.
pub fn parameters_exr(table: &ParameterTexels) -> Result<Vec<u8>, TablesError> {
    check(table, Precision::F32)?;
    let planes = COLUMNS.iter().enumerate().map(|(i, name)| Plane {
        name: (*name).to_owned(),
        values: table.rows.iter().map(|row| row.columns()[i] as f32).collect(),
    });
    let metadata = &table.metadata;
    let comments = format!(
        "Parameters of the one-dimensional model. {}. {}. {}. Last column: {}.",
        metadata.units, metadata.formula, metadata.interpolation, metadata.last_row
    );
    exr::image((table.rows.len(), 1), planes.collect(), &comments, &line(metadata)?)
}

/// KTX2: a column per row of the table; row 0 is (b, 1/c, t, μ_l), row 1 is (1/κ_c, 1/r, 0, μ_l).
///
/// # Errors
/// [`TablesError::Domain`] for values that the format cannot hold, [`TablesError::Container`] for f64.
pub fn parameters_ktx2(table: &ParameterTexels, precision: Precision) -> Result<Vec<u8>, TablesError> {
    check(table, precision)?;
    let columns: Vec<[f64; 6]> = table.rows.iter().map(ParameterValues::columns).collect();
    let first = columns.iter().flat_map(|&[mu_l, b, inverse_c, t, _, _]| [b, inverse_c, t, mu_l]);
    let second = columns.iter().flat_map(|&[mu_l, _, _, _, kappa_c, r]| [kappa_c, r, 0.0, mu_l]);
    let layout = [["b", "inverse_c", "t", "mu_l"], ["inverse_kappa_c", "inverse_r", "", "mu_l"]];
    let layout = layout.map(|row| row.map(str::to_owned).to_vec());
    let values = first.chain(second).collect();
    Texture::new(table.rows.len(), values, false, [line(&table.metadata)?, line(&layout.to_vec())?])
        .bytes(precision)
}

/// The largest relative change that storing a table's columns makes.
pub fn rounding(table: &ParameterTexels, precision: Precision) -> f64 {
    let values = table.rows.iter().flat_map(ParameterValues::columns).filter(|value| *value != 0.0);
    values.fold(0.0, |worst, value| (precision.stored(value) / value - 1.0).abs().max(worst))
}

fn check(table: &ParameterTexels, precision: Precision) -> Result<(), TablesError> {
    for row in &table.rows {
        for (name, value) in COLUMNS.iter().zip(row.columns()) {
            precision.check(name, value)?;
        }
    }
    Ok(())
}
