//! The picture with its errors.

use crate::PathtraceError;
use crate::request::Crop;
use crate::tally::Tally;
use stratiform_imaging::Image;
use stratiform_stats::Estimate;
use stratiform_world::Contribution;

/// Linear sRGB radiance of every pixel, a mean over the pixel's square, with the standard error of the mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// All light.
    pub mean: Image,
    /// Its standard error, from the scatter of the pixel's own samples.
    pub std_error: Image,
    /// Mean and standard error of each contribution, in the order of [`Contribution::ALL`]; the means add up to the whole.
    pub parts: Vec<(Contribution, Image, Image)>,
    /// Samples of each pixel.
    pub samples: u64,
    /// The pixels of the picture that were traced.
    pub crop: Crop,
    /// Of each pixel, row by row, the share of the luminance that one sample brought. Where it is no longer small, the standard error
    /// is a guess.
    pub largest_share: Vec<f32>,
    /// Median over pixels of the standard error of luminance as a share of the luminance, pixels without light left out.
    pub median_error: f64,
}

impl Truth {
    pub(crate) fn new(tallies: &[Tally], crop: Crop, samples: u64) -> Result<Self, PathtraceError> {
        let image = |of: &dyn Fn(&Tally) -> [Estimate; 3], take: &dyn Fn(Estimate) -> f64| {
            let pixels =
                tallies.iter().map(|tally| of(tally).map(|estimate| take(estimate) as f32)).collect();
            Image::new(crop.width, crop.height, pixels)
        };
        let (mean, error) = (|e: Estimate| e.value, |e: Estimate| e.std_error);
        let parts = Contribution::ALL.into_iter().map(|part| {
            let of = |tally: &Tally| tally.part(part.index());
            Ok((part, image(&of, &mean)?, image(&of, &error)?))
        });
        Ok(Self {
            mean: image(&Tally::total, &mean)?,
            std_error: image(&Tally::total, &error)?,
            parts: parts.collect::<Result<_, PathtraceError>>()?,
            samples,
            crop,
            largest_share: tallies.iter().map(|tally| tally.largest_share() as f32).collect(),
            median_error: median_error(tallies),
        })
    }
}

/// Median of the relative standard errors of luminance; 0 if there is no light at all.
pub(crate) fn median_error(tallies: &[Tally]) -> f64 {
    let lit = tallies.iter().map(Tally::luminance).filter(|luminance| luminance.value > 0.0);
    let mut shares: Vec<f64> = lit.map(|luminance| luminance.std_error / luminance.value).collect();
    shares.sort_by(f64::total_cmp);
    shares.get(shares.len() / 2).copied().unwrap_or(0.0)
}
