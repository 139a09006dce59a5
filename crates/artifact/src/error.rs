//! What can go wrong with a file.

use std::path::PathBuf;

/// A file that cannot be read, written or understood.
#[derive(Debug, thiserror::Error)]
pub enum ArtifactError {
    /// The operating system refused.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// "read", "write", "create".
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// The content is not what it must be.
    #[error("{}{}: {message}", path.display(), line.map_or(String::new(), |n| format!(":{n}")))]
    Format {
        /// The file.
        path: PathBuf,
        /// Line, counted from 1, where known.
        line: Option<u64>,
        /// What is wrong, with the value and the allowed range.
        message: String,
    },
    /// A number that the file format cannot hold.
    #[error("{what} is not finite and cannot be written")]
    NotFinite {
        /// The field or column.
        what: String,
    },
}

impl ArtifactError {
    /// A [`ArtifactError::Format`].
    pub fn format(path: impl Into<PathBuf>, line: Option<u64>, message: impl Into<String>) -> Self {
        Self::Format { path: path.into(), line, message: message.into() }
    }
}
