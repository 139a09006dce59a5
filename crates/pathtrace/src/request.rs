//! What of a picture is traced, and for how long.

use crate::PathtraceError;
use stratiform_quantities::Range;
use stratiform_world::Camera;

/// Pixels of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// First column.
    pub x: usize,
    /// First row.
    pub y: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

/// When it is enough. Samples are those of each pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// After so many samples.
    Samples(u64),
    /// When the median over pixels of the standard error of luminance is at most this share of the luminance, or at so many samples.
    Target {
        /// The share.
        error: f64,
        /// Most samples.
        at_most: u64,
    },
    /// As many samples as this time lets in, at least two. The only rule by which the result depends on the machine.
    Seconds(f64),
}

/// One trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// When it is enough.
    pub stop: Stop,
    /// The pixels; all of them if `None`. A pixel's paths do not depend on the crop.
    pub crop: Option<Crop>,
    /// Seed of every random stream.
    pub seed: u64,
}

/// Samples of a pixel: two for an error, and an index of 32 bits.
pub(crate) const SAMPLES: Range = Range::closed(2.0, 4_294_967_296.0);

impl Request {
    /// The pixels to trace, after all numbers are checked.
    pub(crate) fn pixels(&self, camera: &Camera) -> Result<Crop, PathtraceError> {
        match self.stop {
            Stop::Samples(samples) => SAMPLES.check("samples", samples as f64)?,
            Stop::Target { error, at_most } => {
                Range::open(0.0, 1.0).check("target", error)?;
                SAMPLES.check("samples", at_most as f64)?
            }
            Stop::Seconds(seconds) => Range::above(0.0).check("seconds", seconds)?,
        };
        let (width, height) = (camera.width, camera.height);
        let crop = self.crop.unwrap_or(Crop { x: 0, y: 0, width, height });
        let within = |from: usize, size: usize, whole: usize| {
            size > 0 && from.checked_add(size).is_some_and(|end| end <= whole)
        };
        if within(crop.x, crop.width, width) && within(crop.y, crop.height, height) {
            return Ok(crop);
        }
        let Crop { x, y, width: w, height: h } = crop;
        Err(PathtraceError::Crop { x, y, width: w, height: h, picture_width: width, picture_height: height })
    }
}
