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

/// Reads rows.
///
/// # Errors
/// [`ArtifactError::Io`], or [`ArtifactError::Format`] naming the line.
pub fn read_csv<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>, ArtifactError> {
    Ok(read_numbered_csv(path)?.into_iter().map(|(_, row)| row).collect())
}

/// Reads rows with the lines on which they stand, counted from 1.
///
/// # Errors
/// As [`read_csv`].
pub fn read_numbered_csv<T: DeserializeOwned>(path: &Path) -> Result<Vec<(u64, T)>, ArtifactError> {
    parse_numbered(&atomic::read_text(path)?, path)
}

/// The rows of a text; `origin` stands in messages.
///
/// # Errors
/// [`ArtifactError::Format`] naming the line.
pub fn parse_csv<T: DeserializeOwned>(text: &str, origin: &Path) -> Result<Vec<T>, ArtifactError> {
    Ok(parse_numbered(text, origin)?.into_iter().map(|(_, row)| row).collect())
}

fn parse_numbered<T: DeserializeOwned>(text: &str, path: &Path) -> Result<Vec<(u64, T)>, ArtifactError> {
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let fault = |error: csv::Error| {
        ArtifactError::format(path, error.position().map(csv::Position::line), error.to_string())
    };
    let headers = reader.headers().map_err(fault)?.clone();
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(fault)?;
        let line = record.position().map_or(0, csv::Position::line);
        let row = record
            .deserialize(Some(&headers))
            .map_err(|error| ArtifactError::format(path, Some(line), error.to_string()))?;
        rows.push((line, row));
    }
    if rows.is_empty() {
        return Err(ArtifactError::format(path, None, "the table has no rows"));
    }
    Ok(rows)
}
