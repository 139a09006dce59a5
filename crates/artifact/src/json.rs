//! JSON documents. `serde_json` writes non-finite numbers as `null`; here they are an error.

use crate::{ArtifactError, atomic};
use serde::{Serialize, de::DeserializeOwned};
use std::path::Path;

/// The document as indented JSON with a final newline.
///
/// # Errors
/// [`ArtifactError::NotFinite`] if a number that is not optional is not finite (it would read back as `null`).
pub fn to_json<T: Serialize + DeserializeOwned>(document: &T) -> Result<String, ArtifactError> {
    let refuse = |error: serde_json::Error| ArtifactError::NotFinite { what: error.to_string() };
    let mut text = serde_json::to_string_pretty(document).map_err(refuse)?;
    serde_json::from_str::<T>(&text).map_err(refuse)?;
    text.push('\n');
    Ok(text)
}

/// Writes [`to_json`] to `path`, whole or not at all.
///
/// # Errors
/// As [`to_json`], and [`ArtifactError::Io`].
pub fn write_json<T: Serialize + DeserializeOwned>(path: &Path, document: &T) -> Result<(), ArtifactError> {
    atomic::write_atomic(path, to_json(document)?.as_bytes())
}

/// Reads a document.
///
/// # Errors
/// [`ArtifactError::Io`], or [`ArtifactError::Format`] with the line of the first thing that does not fit.
pub fn read_json<T: DeserializeOwned>(path: &Path) -> Result<T, ArtifactError> {
    let text = atomic::read_text(path)?;
    serde_json::from_str(&text)
        .map_err(|error| ArtifactError::format(path, Some(error.line() as u64), error.to_string()))
}
