//! `ablation.csv`: what each part of a picture costs, and what its absence does to the error. `render-costs.csv`: time of each pass.

use serde::{Deserialize, Serialize};

/// The picture with one thing changed: a row of `ablation.csv`. Errors are of luminance, over the mean of the truth.
///
/// `ms` and `ms_saved` differ between runs and machines; nothing else does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AblationRow {
    /// Name of the scene.
    pub scene: String,
    /// `nothing`; `without` a contribution, as in `without halo`; or another setting, as in `radiosity passes 0`.
    pub change: String,
    /// Noise-corrected rms error; 0 where it is less than the noise.
    pub error: f64,
    /// Rms of the truth's standard errors: an error or rise far below it is not known.
    pub noise: f64,
    /// `error` less that of the row `nothing`; below 0 where the change helps.
    pub rise: f64,
    /// Rms difference from the picture of the row `nothing`: no rise, of this or of several changes together, exceeds their sum.
    pub difference: f64,
    /// Mean of FLIP.
    pub flip: f64,
    /// Columns of the picture that was drawn and timed; a truth has fewer.
    pub width: u64,
    /// Rows.
    pub height: u64,
    /// The device's time for a frame, milliseconds; empty where it has no clock.
    pub ms: Option<f64>,
    /// What the change saves of it.
    pub ms_saved: Option<f64>,
}

impl AblationRow {
    /// The row that the others are compared with.
    pub const NOTHING: &'static str = "nothing";

    /// The contribution that is left out, if the row is of that kind.
    pub fn without(&self) -> Option<&str> {
        self.change.strip_prefix("without ")
    }
}

/// One pass of one frame: a row of `render-costs.csv`. Times differ between runs and machines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RenderCostRow {
    /// Name of the scene.
    pub scene: String,
    /// The device.
    pub adapter: String,
    /// Columns of the picture.
    pub width: u64,
    /// Rows.
    pub height: u64,
    /// `angular` or `fitted`.
    pub model: String,
    /// Texels a side of the light between ground and cloud.
    pub radiosity_side: u64,
    /// Exchanges; empty where they follow from the albedo.
    pub radiosity_passes: Option<u64>,
    /// Name of the pass.
    pub pass: String,
    /// Its time by the device's clock: the median of several frames, milliseconds.
    pub ms: f64,
}
