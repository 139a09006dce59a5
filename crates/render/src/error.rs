//! Why there is no picture.

use crate::radiosity::RadiosityError;
use std::path::PathBuf;
use stratiform_artifact::ArtifactError;
use stratiform_gpu::GpuError;
use stratiform_imaging::ImagingError;
use stratiform_model::ModelError;
use stratiform_quantities::DomainError;

/// What the renderer refuses, and what it refuses to call a picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A device that is missing, lost, too small, or that refused work.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A generated file that is missing or unreadable.
    #[error("the cloud's generated text: {0}")]
    Generated(#[from] ArtifactError),
    /// A generated file that holds something else than the renderer reads.
    #[error("{}: {message}", file.display())]
    Contents {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// Light between ground and cloud that cannot be computed.
    #[error(transparent)]
    Radiosity(#[from] RadiosityError),
    /// Parameters outside their domain.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A picture without pixels.
    #[error(transparent)]
    Image(#[from] ImagingError),
    /// Radiance parameters of another form than the twin's.
    #[error("the radiance parameters are of another shape than this program's")]
    Shape,
    /// A camera where the model knows no radiance.
    #[error("the camera is inside the cloud: {height_m} m above its base, where it is {thickness_m} m thick")]
    InsideCloud {
        /// Height above the base, m.
        height_m: f64,
        /// Thickness of the cloud there, m.
        thickness_m: f64,
    },
    /// A pixel that is no number, or infinite.
    #[error("pixel ({x}, {y}) is {value:?}")]
    NotFinite {
        /// Column, from the left.
        x: usize,
        /// Row, from the top.
        y: usize,
        /// What it is.
        value: [f32; 3],
    },
    /// A ray that did not reach the end of the layer within the bound of turns.
    #[error(
        "the ray of pixel ({x}, {y}) did not end: the line of sight is too near to the horizontal for this height field"
    )]
    Endless {
        /// Column, from the left.
        x: usize,
        /// Row, from the top.
        y: usize,
    },
    /// Every pixel is 0 although there is light.
    #[error("every pixel is black, although there is light in the scene: the device did not draw")]
    Black,
}
