//! Figures and a self-contained page from the artifacts of `reproduce`. No physics is computed here: model
//! curves, misfits and shares come ready from files; this crate reads, checks, draws and explains.
//!
//! [`build`] reads the folder (see `input.rs` for the files, which of them are needed, and what is checked),
//! renders everything in memory, and only then writes `figures/*.svg` and `report.html`, each whole or not at
//! all. The bytes depend on the artifacts alone.

mod atlas;
mod chart;
mod checks;
mod comparison;
mod error;
mod estimators;
mod figures;
mod input;
mod methods;
mod page;

pub use atlas::{AtlasSummary, build as build_atlas};
pub use comparison::{build as build_comparison, draw_costs};
pub use error::ReportError;
pub use estimators::draw as draw_estimators;
use input::Inputs;
pub use methods::{ChartSummary, build as build_chart};
use std::path::{Path, PathBuf};
use stratiform_artifact::{create_folder, write_atomic};

/// What [`build`] wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportSummary {
    /// The figures, in the order of the page.
    pub figures: Vec<PathBuf>,
    /// The page.
    pub page: PathBuf,
    /// What was left out, and the file whose absence is the reason.
    pub left_out: Vec<LeftOut>,
}

/// Something the page lacks because an optional file is absent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// What is lacking, in words.
    pub what: &'static str,
    /// The absent file, relative to the folder.
    pub file: &'static str,
}

/// Builds the report of the folder `dir` into the same folder.
///
/// # Errors
/// [`ReportError`] naming the file that is missing, damaged, holds an impossible number, or cannot be written.
/// Nothing is written unless all inputs are sound.
pub fn build(dir: &Path) -> Result<ReportSummary, ReportError> {
    let inputs = Inputs::read(dir)?;
    let figures = figures::all(&inputs);
    let left_out = inputs.left_out();
    let page = page::render(&inputs, &figures, &left_out);
    let folder = dir.join("figures");
    create_folder(&folder)?;
    let mut written = Vec::new();
    for figure in &figures {
        let path = folder.join(format!("{}.svg", figure.name));
        write_atomic(&path, figure.to_svg().as_bytes())?;
        written.push(path);
    }
    let path = dir.join("report.html");
    write_atomic(&path, page.as_bytes())?;
    Ok(ReportSummary { figures: written, page: path, left_out })
}
