//! What a world is refused for.

use std::path::PathBuf;
use stratiform_artifact::ArtifactError;
use stratiform_imaging::ImagingError;
use stratiform_optics::OpticsError;
use stratiform_quantities::DomainError;
use stratiform_scene::SceneError;

/// Why there is no world.
#[derive(Debug, thiserror::Error)]
pub enum WorldError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A file between stages.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// The scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A phase function.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// An image.
    #[error(transparent)]
    Image(#[from] ImagingError),
    /// A field or map whose number of texels is not the square of its side.
    #[error("a map of {side} x {side} texels has {found} values")]
    Texels {
        /// Texels a side.
        side: usize,
        /// Values that were given.
        found: usize,
    },
    /// A folder that is no reproduced cloud.
    #[error("{}: {message}", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What it lacks.
        message: String,
    },
    /// Parts that do not fit together.
    #[error("{0}")]
    Contents(String),
}
