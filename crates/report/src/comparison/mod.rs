//! Page of a comparison of a picture with its truth, from `comparison.json`, `comparison.csv`, the SVG files that the document names, and,
//! where they are there, `ablation.csv` and `render-costs.csv`.

mod cost;
mod input;
mod page;
mod table;

use crate::ReportError;
use input::Inputs;
use std::path::{Path, PathBuf};
use stratiform_artifact::{RenderCostRow, write_atomic};

/// Writes `comparison.html` into the folder `dir`, and `render-costs.svg` if there are costs.
///
/// # Errors
/// [`ReportError`] naming the file that is missing, damaged, or cannot be written.
pub fn build(dir: &Path) -> Result<PathBuf, ReportError> {
    let inputs = Inputs::read(dir)?;
    let figures = cost::figures(&inputs.costs);
    let text = page::render(&inputs, &figures);
    for figure in &figures {
        write_atomic(&dir.join(format!("{}.svg", figure.name)), figure.to_svg().as_bytes())?;
    }
    let page = dir.join("comparison.html");
    write_atomic(&page, text.as_bytes())?;
    Ok(page)
}

/// Draws cost against resolution and against radiosity passes: one SVG per scene and device, by its file name.
pub fn draw_costs(rows: &[RenderCostRow]) -> Vec<(String, String)> {
    cost::figures(rows).iter().map(|figure| (format!("{}.svg", figure.name), figure.to_svg())).collect()
}
