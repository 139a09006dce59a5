//! How far a picture is from its truth, over all pixels.

use super::{Band, Sampled, Triple, triples};
use crate::{Grey, Image, ImagingError};
use stratiform_quantities::Range;

/// Numbers of one band. Radiances are in the images' unit, relative errors are shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Mean of the truth, and its standard error (pixels err independently of each other).
    pub mean_truth: f64,
    /// Mean of the picture.
    pub mean_picture: f64,
    /// Mean of picture - truth; its standard error is `bias_error`.
    pub bias: f64,
    /// √(Σσ²)/n.
    pub bias_error: f64,
    /// The least denominator of a relative error: a share of the truth's mean.
    pub floor: f64,
    /// Median of |picture - truth|/max(|truth|, floor).
    pub median: f64,
    /// Its 95th percentile.
    pub p95: f64,
    /// Its largest.
    pub worst: f64,
    /// Median of σ/max(|truth|, floor): what the truth's own noise does to a median.
    pub noise_median: f64,
    /// √ of the mean of (picture - truth)².
    pub rms: f64,
    /// √ of the mean of σ².
    pub noise: f64,
    /// √(rms² - noise²): the picture's own rms error. 0 where the difference is no larger than the noise.
    pub excess_rms: f64,
}

/// Errors of `picture` against `truth` in `band`. Relative ones have `floor_share` of the mean truth as least denominator: darker pixels
/// count by their absolute error.
///
/// # Errors
/// [`ImagingError`] for images that are not alike or not finite, for a negative standard error, and for a share outside (0, 1].
pub fn errors(
    picture: &Image,
    truth: &Sampled<'_>,
    band: Band,
    floor_share: f64,
) -> Result<Errors, ImagingError> {
    let pixels = triples(picture, truth, band)?;
    let floor = floor(&pixels, floor_share)?;
    let n = pixels.len() as f64;
    let mean = |of: &dyn Fn(&Triple) -> f64| pixels.iter().map(of).sum::<f64>() / n;
    let sorted = |of: &dyn Fn(&Triple) -> f64| {
        let mut values: Vec<f64> = pixels.iter().map(|p| of(p) / denominator(p, floor)).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    let relative = sorted(&|p| (p.picture - p.truth).abs());
    let square = mean(&|p| (p.picture - p.truth) * (p.picture - p.truth));
    let noise_square = mean(&|p| p.std_error * p.std_error);
    let (mean_truth, mean_picture) = (mean(&|p| p.truth), mean(&|p| p.picture));
    Ok(Errors {
        mean_truth,
        mean_picture,
        bias: mean_picture - mean_truth,
        bias_error: (noise_square / n).sqrt(),
        floor,
        median: percentile(&relative, 0.5),
        p95: percentile(&relative, 0.95),
        worst: percentile(&relative, 1.0),
        noise_median: percentile(&sorted(&|p| p.std_error), 0.5),
        rms: square.sqrt(),
        noise: noise_square.sqrt(),
        excess_rms: (square - noise_square).max(0.0).sqrt(),
    })
}

/// |picture - truth|/max(|truth|, floor) of every pixel.
///
/// # Errors
/// As [`errors`].
pub fn relative(
    picture: &Image,
    truth: &Sampled<'_>,
    band: Band,
    floor_share: f64,
) -> Result<Grey, ImagingError> {
    let pixels = triples(picture, truth, band)?;
    let floor = floor(&pixels, floor_share)?;
    let of = |p: &Triple| ((p.picture - p.truth).abs() / denominator(p, floor)) as f32;
    Grey::new(picture.width(), picture.height(), pixels.iter().map(of).collect())
}

/// Picture - truth of every pixel.
///
/// # Errors
/// As [`errors`].
pub fn signed(picture: &Image, truth: &Sampled<'_>, band: Band) -> Result<Grey, ImagingError> {
    let pixels = triples(picture, truth, band)?;
    let values = pixels.iter().map(|p| (p.picture - p.truth) as f32).collect();
    Grey::new(picture.width(), picture.height(), values)
}

/// A share of the mean truth; of 1 where all truth is 0, so that nothing is divided by 0.
fn floor(pixels: &[Triple], share: f64) -> Result<f64, ImagingError> {
    let range = Range { min_included: false, ..Range::closed(0.0, 1.0) };
    let share = range.check("floor_share", share)?;
    let mean = pixels.iter().map(|p| p.truth.abs()).sum::<f64>() / pixels.len() as f64;
    Ok(if mean > 0.0 { share * mean } else { share })
}

fn denominator(pixel: &Triple, floor: f64) -> f64 {
    pixel.truth.abs().max(floor)
}

/// The value with at least `share` of the sorted ones at or below it.
fn percentile(sorted: &[f64], share: f64) -> f64 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of the length")]
    let rank = libm::ceil(share * sorted.len() as f64) as usize;
    sorted[rank.clamp(1, sorted.len()) - 1]
}
