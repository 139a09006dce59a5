//! Figures and page of a chart of methods: error against cost, from `chart.csv`, `knobs.csv` and `manifest.json`.

mod input;
mod knobs;
mod page;
mod scene;

use crate::ReportError;
use crate::chart::Figure;
use input::Inputs;
use std::path::{Path, PathBuf};
use stratiform_artifact::{create_folder, write_atomic};

/// What [`build`] wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartSummary {
    /// The figures.
    pub figures: Vec<PathBuf>,
    /// The page.
    pub page: PathBuf,
}

/// Draws the chart in the folder `dir` into the same folder.
///
/// # Errors
/// [`ReportError`] naming the file that is missing, damaged, or cannot be written.
pub fn build(dir: &Path) -> Result<ChartSummary, ReportError> {
    let inputs = Inputs::read(dir)?;
    let mut figures: Vec<Figure> =
        inputs.manifest.scenes.iter().map(|one| scene::figure(one, &inputs.rows)).collect();
    figures.extend(inputs.manifest.scenes.iter().filter_map(|one| scene::shaders(one, &inputs.rows)));
    figures.extend(knobs::figures(&inputs.knobs));
    let text = page::render(&inputs, &figures)?;
    create_folder(dir)?;
    let mut written = Vec::new();
    for figure in &figures {
        let path = dir.join(format!("{}.svg", figure.name));
        write_atomic(&path, figure.to_svg().as_bytes())?;
        written.push(path);
    }
    let page = dir.join("chart.html");
    write_atomic(&page, text.as_bytes())?;
    Ok(ChartSummary { figures: written, page })
}
