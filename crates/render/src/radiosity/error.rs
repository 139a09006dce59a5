//! Why there is no exchange of light.

use stratiform_artifact::ArtifactError;
use stratiform_gpu::GpuError;
use stratiform_model::ModelError;
use stratiform_quantities::DomainError;

/// Why the light between ground and cloud cannot be computed.
#[derive(Debug, thiserror::Error)]
pub enum RadiosityError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// `parameters.json` or the emitted text.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// Parameters outside their domain.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// Parts that do not fit together.
    #[error("{0}")]
    Contents(String),
}
