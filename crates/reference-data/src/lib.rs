//! The one way into `reference-data/`: a file is handed out only if its `SOURCE.toml` lists it and its SHA-256 is the
//! listed one.
//!
//! [`read`] and [`rows`] look in this workspace's folder; they are for tests, benchmarks and examples. [`read_in`] and
//! [`rows_in`] take the folder that holds the sources. A source is a folder of text files beside a `SOURCE.toml` with title,
//! citation, origin, licence, digits and a table `[files]` of hashes ([`Source`]).

mod error;
mod source;

pub use error::ReferenceError;
pub use source::{Source, sha256};

use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// The workspace's folder of sources, as it was when this was compiled.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../reference-data"))
}

/// The text of `file` of `source` in [`root`].
///
/// # Errors
/// Those of [`read_in`].
pub fn read(source: &str, file: &str) -> Result<String, ReferenceError> {
    read_in(&root(), source, file)
}

/// The text of `root/source/file`.
///
/// # Errors
/// [`ReferenceError`] if the source has no valid `SOURCE.toml`, does not list the file, or the file cannot be read, has
/// another SHA-256 than the listed one, or is not UTF-8.
pub fn read_in(root: &Path, source: &str, file: &str) -> Result<String, ReferenceError> {
    Source::load(root, source)?.read(file)
}

/// The rows of the CSV table `file` of `source` in [`root`].
///
/// # Errors
/// Those of [`rows_in`].
pub fn rows<T: DeserializeOwned>(source: &str, file: &str) -> Result<Vec<T>, ReferenceError> {
    rows_in(&root(), source, file)
}

/// The rows of the CSV table `root/source/file`; the first line is the header, lines that begin with `#` are comments.
/// `T` is a struct named by the header, or a tuple or `Vec` of the fields in order.
///
/// # Errors
/// Those of [`read_in`], and [`ReferenceError::Row`] for a row that is no `T` or has not as many fields as the header.
pub fn rows_in<T: DeserializeOwned>(root: &Path, source: &str, file: &str) -> Result<Vec<T>, ReferenceError> {
    let text = read_in(root, source, file)?;
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader
        .deserialize()
        .collect::<Result<_, _>>()
        .map_err(|error| ReferenceError::Row { path: root.join(source).join(file), source: error })
}
