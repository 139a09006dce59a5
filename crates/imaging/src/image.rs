//! Pixels of linear radiance.

use crate::ImagingError;

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

    /// `change` of every pixel.
    #[must_use]
    pub fn map(&self, change: impl Fn([f32; 3]) -> [f32; 3]) -> Self {
        let pixels = self.pixels.iter().map(|pixel| change(*pixel)).collect();
        Self { width: self.width, height: self.height, pixels }
    }

    /// `join` of the pixels of both.
    ///
    /// # Errors
    /// [`ImagingError::Unlike`] if they are not of one size.
    pub fn zip(
        &self,
        other: &Self,
        join: impl Fn([f32; 3], [f32; 3]) -> [f32; 3],
    ) -> Result<Self, ImagingError> {
        self.must_be_like(other)?;
        let pixels = self.pixels.iter().zip(&other.pixels).map(|(a, b)| join(*a, *b)).collect();
        Ok(Self { width: self.width, height: self.height, pixels })
    }

    /// The part `size` (columns, rows) whose top left pixel is `from`.
    ///
    /// # Errors
    /// [`ImagingError::Part`] if it is empty or reaches beyond the image.
    pub fn crop(&self, from: (usize, usize), size: (usize, usize)) -> Result<Self, ImagingError> {
        let fits = |from: usize, size: usize, all: usize| {
            size > 0 && from.checked_add(size).is_some_and(|end| end <= all)
        };
        if !fits(from.0, size.0, self.width) || !fits(from.1, size.1, self.height) {
            return Err(
                self.refuse(format!("the part of {} x {} at ({}, {})", size.0, size.1, from.0, from.1))
            );
        }
        let row = |y: usize| &self.pixels[y * self.width + from.0..][..size.0];
        let pixels = (from.1..from.1 + size.1).flat_map(row).copied().collect();
        Self::new(size.0, size.1, pixels)
    }

    /// Means over squares of `factor` x `factor` pixels.
    ///
    /// # Errors
    /// [`ImagingError::Part`] unless `factor` divides both sides.
    pub fn downsample(&self, factor: usize) -> Result<Self, ImagingError> {
        if factor == 0 || !self.width.is_multiple_of(factor) || !self.height.is_multiple_of(factor) {
            return Err(self.refuse(format!("a box of {factor} x {factor}")));
        }
        let (width, height) = (self.width / factor, self.height / factor);
        let share = 1.0 / (factor * factor) as f64;
        let mean = |x: usize, y: usize| {
            let mut sum = [0.0; 3];
            for row in 0..factor {
                for pixel in &self.pixels[(y * factor + row) * self.width + x * factor..][..factor] {
                    (0..3).for_each(|c| sum[c] += f64::from(pixel[c]));
                }
            }
            sum.map(|s| (s * share) as f32)
        };
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| mean(x, y));
        Self::new(width, height, pixels.collect())
    }

    /// # Errors
    /// [`ImagingError::NotFinite`] names the first pixel that is NaN or infinite.
    pub fn must_be_finite(&self) -> Result<(), ImagingError> {
        let bad = |pixel: &[f32; 3]| !pixel.iter().all(|value| value.is_finite());
        match self.pixels.iter().position(bad) {
            Some(at) => Err(ImagingError::NotFinite {
                x: at % self.width,
                y: at / self.width,
                value: self.pixels[at],
            }),
            None => Ok(()),
        }
    }

    /// # Errors
    /// [`ImagingError::Unlike`] if they are not of one size.
    pub fn must_be_like(&self, other: &Self) -> Result<(), ImagingError> {
        let [left, right] = [self, other].map(|image| (image.width, image.height));
        if left == right { Ok(()) } else { Err(ImagingError::Unlike { left, right }) }
    }

    fn refuse(&self, what: String) -> ImagingError {
        ImagingError::Part { what, size: (self.width, self.height) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red counts columns, green counts rows.
    fn ramp(width: usize, height: usize) -> Image {
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x as f32, y as f32, 1.0])).collect();
        Image::new(width, height, pixels).unwrap()
    }

    #[test]
    fn a_part_is_where_it_was() {
        let part = ramp(5, 4).crop((2, 1), (3, 2)).unwrap();
        assert_eq!(
            (part.width(), part.height(), part.at(0, 0), part.at(2, 1)),
            (3, 2, [2.0, 1.0, 1.0], [4.0, 2.0, 1.0])
        );
        for (from, size) in [((3, 0), (3, 1)), ((0, 0), (0, 1)), ((usize::MAX, 0), (2, 1))] {
            assert!(matches!(ramp(5, 4).crop(from, size), Err(ImagingError::Part { .. })));
        }
    }

    #[test]
    fn means_over_boxes_keep_the_mean() {
        let small = ramp(6, 4).downsample(2).unwrap();
        assert_eq!((small.width(), small.height()), (3, 2));
        assert_eq!((small.at(0, 0), small.at(2, 1)), ([0.5, 0.5, 1.0], [4.5, 2.5, 1.0]));
        assert!(matches!(ramp(6, 4).downsample(4), Err(ImagingError::Part { .. })));
        assert!(matches!(ramp(6, 4).downsample(0), Err(ImagingError::Part { .. })));
    }

    #[test]
    fn images_of_other_size_and_nan_are_refused() {
        let sum = ramp(2, 2).zip(&ramp(2, 2), |a, b| [a[0] + b[0], 0.0, 0.0]).unwrap();
        assert_eq!(sum.at(1, 0), [2.0, 0.0, 0.0]);
        assert!(matches!(ramp(2, 2).zip(&ramp(2, 3), |a, _| a), Err(ImagingError::Unlike { .. })));
        let bad = ramp(3, 2).map(|[x, y, _]| [x, y, if (x, y) == (1.0, 1.0) { f32::NAN } else { 0.0 }]);
        assert!(matches!(bad.must_be_finite(), Err(ImagingError::NotFinite { x: 1, y: 1, .. })));
        assert!(ramp(3, 2).must_be_finite().is_ok());
        assert!(matches!(Image::new(2, 2, vec![[0.0; 3]; 3]), Err(ImagingError::Size { found: 3, .. })));
    }
}
