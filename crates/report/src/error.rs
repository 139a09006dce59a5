use std::path::PathBuf;
use stratiform_artifact::ArtifactError;
use stratiform_quantities::DomainError;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file that no report can do without.
    #[error("{} is missing: the report needs {needed_for}", path.display())]
    Missing {
        /// The file.
        path: PathBuf,
        /// What it is for.
        needed_for: &'static str,
    },
    /// A file that cannot be read, understood or written.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// A number that cannot be what its column or field says.
    #[error("{}: {source}", path.display())]
    Domain {
        /// The file.
        path: PathBuf,
        /// Which number, and the allowed values.
        source: DomainError,
    },
}
