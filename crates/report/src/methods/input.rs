//! The files of a chart, checked.

use crate::ReportError;
use std::path::Path;
use stratiform_artifact::{ArtifactError, ChartDocument, ChartRow, KnobRow, read_json, read_numbered_csv};
use stratiform_quantities::Range;

/// Everything a chart's page is made from.
pub struct Inputs {
    pub manifest: ChartDocument,
    pub rows: Vec<ChartRow>,
    /// Empty where no knob was turned.
    pub knobs: Vec<KnobRow>,
}

impl Inputs {
    /// Reads the folder.
    ///
    /// # Errors
    /// [`ReportError`] naming the file.
    pub fn read(dir: &Path) -> Result<Self, ReportError> {
        let path = dir.join("manifest.json");
        let manifest: ChartDocument = read_json(&path)?;
        if manifest.schema != ChartDocument::SCHEMA {
            let message = format!("schema `{}` is not `{}`", manifest.schema, ChartDocument::SCHEMA);
            return Err(ArtifactError::format(path, None, message).into());
        }
        let knobs = dir.join("knobs.csv");
        let of_knob = |row: &KnobRow| [row.median, row.p95, row.worst, row.ns_per_evaluation];
        let of_row = |row: &ChartRow| [row.median, row.p95, row.worst, row.ns_per_evaluation];
        Ok(Self {
            manifest,
            rows: table(&dir.join("chart.csv"), of_row)?,
            knobs: if knobs.exists() { table(&knobs, of_knob)? } else { Vec::new() },
        })
    }
}

/// The rows of a file whose errors and costs are what they can be.
fn table<T: serde::de::DeserializeOwned>(
    path: &Path,
    numbers: impl Fn(&T) -> [Option<f64>; 4],
) -> Result<Vec<T>, ReportError> {
    let rows: Vec<(u64, T)> = read_numbered_csv(path)?;
    for (line, row) in &rows {
        for (name, value) in ["median", "p95", "worst", "ns_per_evaluation"].iter().zip(numbers(row)) {
            let checked = value.map_or(Ok(0.0), |value| Range::at_least(0.0).check(name, value));
            checked.map_err(|error| ArtifactError::format(path, Some(*line), error.to_string()))?;
        }
    }
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}
