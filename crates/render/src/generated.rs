//! The generated text and tables of one cloud, read at run time from the folder that `codegen` wrote.

use crate::{Model, RenderError};
use std::path::Path;
use stratiform_artifact::{read_csv, read_json, read_text};

/// Values of a row of the phase table.
pub const PHASE_COUNT: usize = 1024;

/// Columns and rows of the halo's table.
const HALO: [usize; 2] = [128, 16];

#[derive(serde::Serialize, serde::Deserialize)]
struct WarpedRow {
    index: usize,
    theta_deg: f64,
    p: f64,
    p_squared: f64,
}

#[derive(serde::Serialize, serde::Deserialize)]
struct HaloTable {
    reach: f64,
    longest: f64,
    angles: usize,
    values: Vec<f64>,
}

/// Shader text for `model`: what the passes stand on.
///
/// # Errors
/// [`RenderError::Generated`] for a missing file.
pub fn text(folder: &Path, model: Model) -> Result<String, RenderError> {
    let radiance = match model {
        Model::Angular => "stratiform_radiance.wgsl",
        Model::Fitted => "stratiform_shade.wgsl",
    };
    let names = [
        "stratiform.wgsl",
        "stratiform_weights.wgsl",
        "stratiform_phase.wgsl",
        radiance,
        "stratiform_halo.wgsl",
    ];
    let texts = names.iter().map(|name| read_text(&folder.join(name)));
    Ok(texts.collect::<Result<Vec<_>, _>>()?.join("\n"))
}

/// Rows 0 and 1 of the phase table: P, and P_S convolved with itself.
///
/// # Errors
/// [`RenderError::Generated`] for a missing file, [`RenderError::Contents`] for one of another length.
pub fn phase_rows(folder: &Path) -> Result<[Vec<f64>; 2], RenderError> {
    let file = folder.join("phase_warped.csv");
    let rows: Vec<WarpedRow> = read_csv(&file)?;
    if rows.len() != PHASE_COUNT {
        let message = format!("{} rows, {PHASE_COUNT} are needed", rows.len());
        return Err(RenderError::Contents { file, message });
    }
    Ok([rows.iter().map(|row| row.p).collect(), rows.iter().map(|row| row.p_squared).collect()])
}

/// The halo's table, row by row.
///
/// # Errors
/// [`RenderError::Generated`] for a missing file, [`RenderError::Contents`] for one of another size.
pub fn halo(folder: &Path) -> Result<Vec<f32>, RenderError> {
    let file = folder.join("halo.json");
    let table: HaloTable = read_json(&file)?;
    if table.angles != HALO[0] || table.values.len() != HALO[0] * HALO[1] {
        let message =
            format!("{} values in rows of {}, {HALO:?} are needed", table.values.len(), table.angles);
        return Err(RenderError::Contents { file, message });
    }
    Ok(table.values.iter().map(|value| *value as f32).collect())
}
