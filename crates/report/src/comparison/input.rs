//! The files of a comparison, checked.

use crate::ReportError;
use serde::de::DeserializeOwned;
use std::path::Path;
use stratiform_artifact::{
    AblationRow, ArtifactError, ComparisonDocument, ComparisonPicture, ComparisonRow, RenderCostRow,
    read_json, read_numbered_csv, read_text,
};
use stratiform_quantities::Range;

/// Everything a page of comparison is made from.
pub struct Inputs {
    pub document: ComparisonDocument,
    pub rows: Vec<ComparisonRow>,
    /// Pictures with the text of their files.
    pub pictures: Vec<(ComparisonPicture, String)>,
    /// Empty where nothing was left out.
    pub ablation: Vec<AblationRow>,
    /// Empty where nothing was timed.
    pub costs: Vec<RenderCostRow>,
}

impl Inputs {
    /// Reads the folder.
    ///
    /// # Errors
    /// [`ReportError`] naming the file, and the line of a number that cannot be.
    pub fn read(dir: &Path) -> Result<Self, ReportError> {
        let path = dir.join("comparison.json");
        let document: ComparisonDocument = read_json(&path)?;
        if document.schema != ComparisonDocument::SCHEMA {
            let message = format!("schema `{}` is not `{}`", document.schema, ComparisonDocument::SCHEMA);
            return Err(ArtifactError::format(path, None, message).into());
        }
        let pictures = document.pictures.iter().map(|picture| Ok((picture.clone(), drawing(dir, picture)?)));
        Ok(Self {
            pictures: pictures.collect::<Result<_, ReportError>>()?,
            rows: table(&dir.join("comparison.csv"), |row: &ComparisonRow| {
                vec![("median", row.median), ("p95", row.p95), ("rms", row.rms), ("share", row.share)]
            })?,
            ablation: optional(&dir.join("ablation.csv"), |row: &AblationRow| {
                vec![("error", row.error), ("difference", row.difference), ("ms", row.ms.unwrap_or(0.0))]
            })?,
            costs: optional(&dir.join("render-costs.csv"), |row: &RenderCostRow| vec![("ms", row.ms)])?,
            document,
        })
    }
}

/// The text of a picture, which must be a file of the folder and one `svg` element.
fn drawing(dir: &Path, picture: &ComparisonPicture) -> Result<String, ReportError> {
    let path = dir.join(&picture.file);
    if picture.file.contains(['/', '\\']) {
        return Err(ArtifactError::format(path, None, "a picture lies in the folder itself").into());
    }
    let text = read_text(&path)?;
    let sound = text.starts_with("<svg ") && text.trim_end().ends_with("</svg>") && !text.contains("<script");
    if !sound {
        return Err(ArtifactError::format(path, None, "not one svg element without script").into());
    }
    Ok(text)
}

type Numbers = Vec<(&'static str, f64)>;

fn optional<T: DeserializeOwned>(
    path: &Path,
    numbers: impl Fn(&T) -> Numbers,
) -> Result<Vec<T>, ReportError> {
    if path.exists() { table(path, numbers) } else { Ok(Vec::new()) }
}

/// The rows of a file whose errors and times are not negative.
fn table<T: DeserializeOwned>(path: &Path, numbers: impl Fn(&T) -> Numbers) -> Result<Vec<T>, ReportError> {
    let rows: Vec<(u64, T)> = read_numbered_csv(path)?;
    for (line, row) in &rows {
        for (name, value) in numbers(row) {
            let checked = Range::at_least(0.0).check(name, value);
            checked.map_err(|error| ArtifactError::format(path, Some(*line), error.to_string()))?;
        }
    }
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}
