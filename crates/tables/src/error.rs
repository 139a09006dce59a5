//! What cannot be written, read or approximated.

use stratiform_artifact::ArtifactError;
use stratiform_optics::OpticsError;
use stratiform_quantities::DomainError;

/// A table that cannot be written, read or approximated.
#[derive(Debug, thiserror::Error)]
pub enum TablesError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A file.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// A phase function that is none.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// Parameters that form no table.
    #[error("parameters: {reason}")]
    Parameters {
        /// What is wrong with their rows.
        reason: String,
    },
    /// A container that its library refuses to write.
    #[error("{format}: {reason}")]
    Container {
        /// EXR, netCDF, ...
        format: &'static str,
        /// What the library says.
        reason: String,
    },
}
