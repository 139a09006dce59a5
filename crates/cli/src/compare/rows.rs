//! Numbers of every part, model and band.

use super::{Draw, Part, Subject, Truth, model_name};
use crate::CliError;
use crate::pipeline::input_error;
use stratiform_artifact::ComparisonRow;
use stratiform_imaging::Image;
use stratiform_imaging::compare::flip::{PIXELS_PER_DEGREE, flip};
use stratiform_imaging::compare::{Band, Sampled, errors, significance};
use stratiform_render::{Model, Settings};

/// Floor of relative errors as a share of the truth's mean.
pub const FLOOR_SHARE: f64 = 0.01;
/// Pixels beyond so many standard errors are counted.
const SIGMAS: f64 = 3.0;

/// One part as `model` draws it, beside its truth.
pub struct Compared {
    /// Which.
    pub part: Part,
    /// By which model.
    pub model: Model,
    /// What it drew.
    pub picture: Image,
    /// What it should be.
    pub mean: Image,
    /// Within this.
    pub std_error: Image,
}

/// Draws every part by every model and compares it.
///
/// # Errors
/// [`CliError::Input`] for what cannot be drawn or compared.
pub fn rows(
    subject: &Subject<'_>,
    truth: &Truth,
    draw: &mut Draw,
) -> Result<(Vec<ComparisonRow>, Vec<Compared>), CliError> {
    let (mut rows, mut all) = (Vec::new(), Vec::new());
    for &model in subject.models {
        for part in Part::of_model(model) {
            let settings = Settings { model, contributions: part.contributions(), ..subject.settings };
            let picture = draw.picture(&settings)?;
            let (mean, std_error) = part.truth(truth)?;
            let compared = Compared { part, model, picture, mean, std_error };
            for band in Band::ALL {
                rows.push(row(subject, truth, &compared, band)?);
            }
            all.push(compared);
        }
    }
    Ok((rows, all))
}

fn row(
    subject: &Subject<'_>,
    truth: &Truth,
    compared: &Compared,
    band: Band,
) -> Result<ComparisonRow, CliError> {
    let Compared { part, model, picture, mean, std_error } = compared;
    let sampled = Sampled { mean, std_error };
    let found = errors(picture, &sampled, band, FLOOR_SHARE).map_err(input_error)?;
    let beyond = significance(picture, &sampled, band, SIGMAS).map_err(input_error)?.beyond;
    let seen = match band {
        Band::Luminance => {
            Some(flip(picture, mean, &subject.tone, PIXELS_PER_DEGREE).map_err(input_error)?.mean())
        }
        _ => None,
    };
    let whole = mean_of(&truth.mean, band);
    Ok(ComparisonRow {
        scene: subject.name.to_owned(),
        model: model_name(*model).to_owned(),
        contribution: part.name.clone(),
        band: band.name().to_owned(),
        pixels: picture.pixels().len() as u64,
        mean_truth: found.mean_truth,
        mean_picture: found.mean_picture,
        bias: found.bias,
        bias_error: found.bias_error,
        floor: found.floor,
        median: found.median,
        p95: found.p95,
        worst: found.worst,
        noise_median: found.noise_median,
        rms: found.rms,
        noise: found.noise,
        excess_rms: found.excess_rms,
        share: if whole > 0.0 { found.excess_rms / whole } else { 0.0 },
        beyond_3_sigma: beyond,
        flip: seen,
    })
}

fn mean_of(image: &Image, band: Band) -> f64 {
    image.pixels().iter().map(|pixel| band.of(*pixel)).sum::<f64>() / image.pixels().len() as f64
}
