//! Pixels of linear radiance.

use std::path::PathBuf;
use stratiform_quantities::DomainError;

/// Why there is no image.
#[derive(Debug, thiserror::Error)]
pub enum ImagingError {
    /// A value outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
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
    #[error("images of {left:?} and {right:?} pixels cannot be compared")]
    Unlike {
        /// Columns and rows of one.
        left: (usize, usize),
        /// Of the other.
        right: (usize, usize),
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

/// Linear sRGB (D65 white), row by row from the top left. Radiance in units of the sun's irradiance normal to its beam.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<[f32; 3]>,
}

impl Image {
    /// Of `pixels` in rows of `width`.
    ///
    /// # Errors
    /// [`ImagingError::Size`] unless there are width times height, at least one.
    pub fn new(width: usize, height: usize, pixels: Vec<[f32; 3]>) -> Result<Self, ImagingError> {
        if pixels.is_empty() || width.checked_mul(height) != Some(pixels.len()) {
            return Err(ImagingError::Size { width, height, found: pixels.len() });
        }
        Ok(Self { width, height, pixels })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Row by row from the top.
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.pixels
    }

    /// The pixel in column `x` of row `y`.
    pub fn at(&self, x: usize, y: usize) -> [f32; 3] {
        self.pixels[y * self.width + x]
    }
}
