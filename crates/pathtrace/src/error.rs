//! Why a picture is not traced.

use stratiform_imaging::ImagingError;
use stratiform_optics::OpticsError;
use stratiform_quantities::DomainError;

/// Why there is no truth.
#[derive(Debug, thiserror::Error)]
pub enum PathtraceError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A phase function without a wide part, or out of domain.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// An image of no size.
    #[error(transparent)]
    Image(#[from] ImagingError),
    /// A crop that is empty or not within the picture.
    #[error(
        "the crop {x},{y},{width},{height} is not within the picture of {picture_width} x {picture_height}"
    )]
    Crop {
        /// First column.
        x: usize,
        /// First row.
        y: usize,
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Columns of the picture.
        picture_width: usize,
        /// Rows of the picture.
        picture_height: usize,
    },
}
