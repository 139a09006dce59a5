//! What tells two images apart.
//!
//! A truth that was sampled has an error of its own at every pixel; [`errors`] and [`significance`] take it into account, and
//! [`flip::flip`] does not.

mod band;
mod errors;
pub mod flip;
mod significance;

pub use band::Band;
pub use errors::{Errors, errors, relative, signed};
pub use significance::{Significance, significance};

use crate::{Image, ImagingError};
use stratiform_quantities::Range;

/// A sampled image: means of its pixels, and their standard errors.
#[derive(Clone, Copy, Debug)]
pub struct Sampled<'a> {
    /// Means.
    pub mean: &'a Image,
    /// Standard errors, not negative; 0 where the mean is exact.
    pub std_error: &'a Image,
}

/// A pixel of one band.
struct Triple {
    picture: f64,
    truth: f64,
    std_error: f64,
}

/// The pixels of `band` one by one, checked.
fn triples(picture: &Image, truth: &Sampled<'_>, band: Band) -> Result<Vec<Triple>, ImagingError> {
    for image in [picture, truth.mean, truth.std_error] {
        image.must_be_like(picture)?;
        image.must_be_finite()?;
    }
    for value in truth.std_error.pixels().as_flattened() {
        Range::at_least(0.0).check("std_error", f64::from(*value))?;
    }
    let bands = picture.pixels().iter().zip(truth.mean.pixels()).zip(truth.std_error.pixels());
    let triple = |((p, t), s): ((&[f32; 3], &[f32; 3]), &[f32; 3])| {
        let [picture, truth, std_error] = [p, t, s].map(|pixel| band.of(*pixel));
        Triple { picture, truth, std_error }
    };
    Ok(bands.map(triple).collect())
}
