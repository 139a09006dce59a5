//! Why a reference file is not handed out.

use std::path::PathBuf;

/// A reference file that is missing, without source, or not what was transcribed.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// The operating system refused.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// `SOURCE.toml` lacks a field, or has one that means nothing.
    #[error("{}: {message}", path.display())]
    Source {
        /// The `SOURCE.toml`.
        path: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// The table `[files]` does not list the file.
    #[error("{} does not list `{file}`; it lists {listed}", path.display())]
    NotListed {
        /// The `SOURCE.toml`.
        path: PathBuf,
        /// The file that was asked for.
        file: String,
        /// The files it lists, separated by commas.
        listed: String,
    },
    /// The file is not what was transcribed.
    #[error("{} has SHA-256 {found}, SOURCE.toml lists {listed}", path.display())]
    Hash {
        /// The file.
        path: PathBuf,
        /// The hash in `SOURCE.toml`.
        listed: String,
        /// The hash of the file.
        found: String,
    },
    /// The file is not text.
    #[error("{}: {source}", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Where UTF-8 ends.
        source: std::string::FromUtf8Error,
    },
    /// A row is not of the type asked for.
    #[error("{}: {source}", path.display())]
    Row {
        /// The file.
        path: PathBuf,
        /// Line, field and reason.
        source: csv::Error,
    },
}
