//! What a scene is refused for.

use stratiform_artifact::ArtifactError;
use stratiform_quantities::DomainError;

/// Why there is no scene.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file cannot be read.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// A key that is misspelt, missing, or of the wrong kind.
    #[error("{place}: {message}")]
    Syntax {
        /// File and line.
        place: String,
        /// What the reader says.
        message: String,
    },
    /// A number outside its domain.
    #[error("{place}: {source}")]
    Domain {
        /// File and line.
        place: String,
        /// Quantity, value and range.
        source: DomainError,
    },
    /// A range whose ends are the wrong way round.
    #[error("{place}: {key} = {{ min = {min}, max = {max} }} is inverted: max must not lie below min")]
    Inverted {
        /// File and line.
        place: String,
        /// The key.
        key: String,
        /// Its lower end.
        min: f64,
        /// Its upper end.
        max: f64,
    },
    /// Keys that contradict each other, are missing, or list nothing.
    #[error("{place}: {message}")]
    Contents {
        /// File and line.
        place: String,
        /// What is wrong with which key.
        message: String,
    },
    /// Neither a name nor a file.
    #[error("no scene is called {name}, and no such file exists: the scenes are {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The scenes there are.
        known: String,
    },
}
