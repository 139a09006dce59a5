//! Maps and page of an atlas of methods: classes of values over planes, from `atlas.csv`, `summary.csv` and `atlas.json`.

mod input;
mod map;
mod page;
mod tint;

use crate::ReportError;
use input::Inputs;
use map::Map;
use std::path::{Path, PathBuf};
use stratiform_artifact::{create_folder, write_atomic};

/// What [`build`] wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct AtlasSummary {
    /// One map for each method.
    pub maps: Vec<PathBuf>,
    /// The page.
    pub page: PathBuf,
}

/// Draws the atlas in the folder `dir` into the same folder.
///
/// # Errors
/// [`ReportError`] naming the file that is missing, damaged, or cannot be written.
pub fn build(dir: &Path) -> Result<AtlasSummary, ReportError> {
    let inputs = Inputs::read(dir)?;
    let maps: Vec<Map<'_>> = inputs.document.methods.iter().map(|method| Map::new(method, &inputs)).collect();
    let text = page::render(&inputs, &maps);
    create_folder(dir)?;
    let mut written = Vec::new();
    for map in &maps {
        let path = dir.join(format!("{}.svg", map.file()));
        write_atomic(&path, map.to_svg().as_bytes())?;
        written.push(path);
    }
    let page = dir.join("atlas.html");
    write_atomic(&page, text.as_bytes())?;
    Ok(AtlasSummary { maps: written, page })
}
