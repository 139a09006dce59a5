//! `comparison.csv`, `comparison.json`: a picture against its truth.

use crate::Provenance;
use serde::{Deserialize, Serialize};

/// One contribution of one model's picture in one band against the truth: a row of `comparison.csv`. Radiances are in units of the sun's
/// irradiance normal to its beam, 1/sr; relative errors are shares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComparisonRow {
    /// Name of the scene.
    pub scene: String,
    /// `angular` or `fitted`.
    pub model: String,
    /// `all`, or one of the parts that light is split into.
    pub contribution: String,
    /// `luminance`, `red`, `green` or `blue`.
    pub band: String,
    /// Pixels.
    pub pixels: u64,
    /// Mean of the truth.
    pub mean_truth: f64,
    /// Mean of the picture.
    pub mean_picture: f64,
    /// Mean of picture - truth.
    pub bias: f64,
    /// Its standard error, from the truth's.
    pub bias_error: f64,
    /// Least denominator of relative errors.
    pub floor: f64,
    /// Median of |picture - truth|/max(|truth|, floor).
    pub median: f64,
    /// Its 95th percentile.
    pub p95: f64,
    /// Its largest.
    pub worst: f64,
    /// Median of the truth's standard error over the same denominators.
    pub noise_median: f64,
    /// Root of the mean square of picture - truth.
    pub rms: f64,
    /// Root of the mean square of the truth's standard errors.
    pub noise: f64,
    /// √(rms² - noise²), 0 where the noise is larger.
    pub excess_rms: f64,
    /// `excess_rms` over the mean of the whole truth in this band: the part's share of the picture's error.
    pub share: f64,
    /// Share of pixels off by more than three standard errors (0.0027 by noise alone).
    pub beyond_3_sigma: f64,
    /// Mean of FLIP; only in rows of luminance.
    pub flip: Option<f64>,
}

/// What the pictures of a comparison are: `comparison.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComparisonDocument {
    /// `stratiform/comparison/1`.
    pub schema: String,
    /// Program, version, hash of the scene and settings, seed of the truth.
    pub provenance: Provenance,
    /// Name of the scene.
    pub scene: String,
    /// In words.
    pub title: String,
    /// Columns.
    pub width: u64,
    /// Rows.
    pub height: u64,
    /// Of all pictures, in stops.
    pub exposure_ev: f64,
    /// What FLIP was told.
    pub pixels_per_degree: f64,
    /// Floor of relative errors as a share of the truth's mean.
    pub floor_share: f64,
    /// Where the truth comes from, in words.
    pub truth: String,
    /// The device that drew.
    pub adapter: String,
    /// The pictures in their order.
    pub pictures: Vec<ComparisonPicture>,
}

/// A picture beside `comparison.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComparisonPicture {
    /// `angular`, `fitted`, or empty for the truth.
    pub model: String,
    /// `all`, or a part.
    pub contribution: String,
    /// `truth`, `picture`, `difference`, `relative`, `flip` or `z`.
    pub kind: String,
    /// The SVG with title and scale.
    pub file: String,
}

impl ComparisonDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/comparison/1";
}
