//! CSV tables with a header row. Lines that start with `#` are comments.

use crate::{ArtifactError, atomic};
use serde::{Serialize, de::DeserializeOwned};
use std::path::Path;

/// The rows as CSV text.
///
/// # Errors
/// [`ArtifactError::NotFinite`] if a row cannot be written.
pub fn to_csv<T: Serialize>(rows: &[T]) -> Result<String, ArtifactError> {
    let refuse = |what: String| ArtifactError::NotFinite { what };
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).map_err(|error| refuse(error.to_string()))?;
    }
    let bytes = writer.into_inner().map_err(|error| refuse(error.to_string()))?;
    let text = String::from_utf8(bytes).map_err(|error| refuse(error.to_string()))?;
    match text.split([',', '\n']).find(|field| matches!(*field, "NaN" | "inf" | "-inf")) {
        Some(field) => Err(refuse(format!("a table entry ({field})"))),
        None => Ok(text),
    }
}

/// Writes [`to_csv`] to `path`, whole or not at all.
///
/// # Errors
/// As [`to_csv`], and [`ArtifactError::Io`].
pub fn write_csv<T: Serialize>(path: &Path, rows: &[T]) -> Result<(), ArtifactError> {
    atomic::write_atomic(path, to_csv(rows)?.as_bytes())
}

/// Reads rows with their line numbers left behind.
///
/// # Errors
/// [`ArtifactError::Io`], or [`ArtifactError::Format`] naming the line.
pub fn read_csv<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>, ArtifactError> {
    let text = atomic::read_text(path)?;
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let rows = reader.deserialize().collect::<Result<Vec<T>, _>>().map_err(|error| {
        ArtifactError::format(path, error.position().map(csv::Position::line), error.to_string())
    })?;
    if rows.is_empty() {
        return Err(ArtifactError::format(path, None, "the table has no rows"));
    }
    Ok(rows)
}
