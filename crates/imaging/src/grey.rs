//! One number per pixel.

use crate::ImagingError;

/// Heights, masks, errors: row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Grey {
    width: usize,
    height: usize,
    values: Vec<f32>,
}

impl Grey {
    /// Of `values` in rows of `width`.
    ///
    /// # Errors
    /// [`ImagingError::Size`] unless there are width times height, at least one.
    pub fn new(width: usize, height: usize, values: Vec<f32>) -> Result<Self, ImagingError> {
        if values.is_empty() || width.checked_mul(height) != Some(values.len()) {
            return Err(ImagingError::Size { width, height, found: values.len() });
        }
        Ok(Self { width, height, values })
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
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The mean.
    pub fn mean(&self) -> f64 {
        self.values.iter().copied().map(f64::from).sum::<f64>() / self.values.len() as f64
    }
}
