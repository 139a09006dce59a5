//! The files of an atlas, checked.

use crate::ReportError;
use std::path::Path;
use stratiform_artifact::{
    ArtifactError, AtlasCount, AtlasDocument, AtlasRow, read_csv, read_json, read_numbered_csv,
};

/// Everything an atlas is drawn from.
pub struct Inputs {
    pub document: AtlasDocument,
    pub rows: Vec<AtlasRow>,
    pub counts: Vec<AtlasCount>,
}

impl Inputs {
    /// Reads the folder.
    ///
    /// # Errors
    /// [`ReportError`] naming the file, and the line of an unknown class.
    pub fn read(dir: &Path) -> Result<Self, ReportError> {
        let path = dir.join("atlas.json");
        let document: AtlasDocument = read_json(&path)?;
        if document.schema != AtlasDocument::SCHEMA {
            let message = format!("schema `{}` is not `{}`", document.schema, AtlasDocument::SCHEMA);
            return Err(ArtifactError::format(path, None, message).into());
        }
        Ok(Self {
            document,
            rows: rows(&dir.join("atlas.csv"))?,
            counts: read_csv(&dir.join("summary.csv"))?,
        })
    }
}

fn rows(path: &Path) -> Result<Vec<AtlasRow>, ReportError> {
    let rows: Vec<(u64, AtlasRow)> = read_numbered_csv(path)?;
    for (line, row) in &rows {
        if !AtlasRow::CLASSES.contains(&row.class.as_str()) {
            let message = format!("`{}` is no class", row.class);
            return Err(ArtifactError::format(path.to_owned(), Some(*line), message).into());
        }
    }
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}
