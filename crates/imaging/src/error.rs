//! What an image is refused for.

use std::path::PathBuf;
use stratiform_artifact::ArtifactError;
use stratiform_quantities::DomainError;

/// Why there is no image, or no comparison of two.
#[derive(Debug, thiserror::Error)]
pub enum ImagingError {
    /// A value outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The operating system refused.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// As many pixels as width times height.
    #[error("an image of {width} x {height} has {found} pixels")]
    Size {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Pixels that were given.
        found: usize,
    },
    /// Two images that should be alike are not of one size.
    #[error("images of {} x {} and {} x {} pixels cannot be compared", left.0, left.1, right.0, right.1)]
    Unlike {
        /// Columns and rows of one.
        left: (usize, usize),
        /// Of the other.
        right: (usize, usize),
    },
    /// A part of an image that reaches beyond it, or into which it cannot be divided.
    #[error("{what} does not fit an image of {} x {} pixels", size.0, size.1)]
    Part {
        /// The part.
        what: String,
        /// Columns and rows.
        size: (usize, usize),
    },
    /// A pixel that is NaN or infinite.
    #[error("pixel ({x}, {y}), column and row from the top left, is {value:?}: not finite")]
    NotFinite {
        /// Column.
        x: usize,
        /// Row.
        y: usize,
        /// What stands there.
        value: [f32; 3],
    },
    /// A file that cannot be read or written.
    #[error("{}: {message}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        message: String,
    },
}
