//! `[sky]`, `[picture]`, `[radiosity]`.

use serde::{Deserialize, Serialize};

/// How the sky's light is spread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SkyModel {
    /// The same from everywhere: the sky of Bouthors, Neyret & Lefebvre 2006.
    #[default]
    Uniform,
    /// Clear air over the cloud.
    Clear,
}

/// `[sky]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sky {
    /// How its light is spread.
    #[serde(default)]
    pub model: SkyModel,
    /// Irradiance of a level plane as a share of the sun's normal to the beam, of a uniform sky; a quarter where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
    /// Haze of clear air: 1 is none, 2 very clear, 5 hazy; 2 where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turbidity: Option<f64>,
}

/// `[picture]`: how radiance becomes a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// Stops brighter than a white sheet in the sun at 1.
    #[serde(default)]
    pub exposure_ev: f64,
}

/// How light from ground to cloud and back is summed: which weights three nested squares get, or every texel its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rings {
    /// Levels 0, 1, 3 with the paper's weights of discs.
    AsPrinted,
    /// Levels 1, 2, 4 with the same weights.
    WiderSquares,
    /// Levels 0, 1, 3 with the weights of squares.
    SquareWeights,
    /// Every texel by its form factor.
    Exact,
    /// Every texel by the weight of the least error.
    #[default]
    LeastSquares,
}

/// `[radiosity]`: light between ground and cloud.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Radiosity {
    /// Texels a side.
    #[serde(default = "side")]
    pub side: u32,
    /// Exchanges; left out: as many as the ground's albedo and `error` need.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passes: Option<u32>,
    /// Share of the exchanged light that may be missing.
    #[serde(default = "error")]
    pub error: f64,
    /// The weights.
    #[serde(default)]
    pub rings: Rings,
}

fn side() -> u32 {
    16
}

fn error() -> f64 {
    1e-3
}

impl Default for Radiosity {
    fn default() -> Self {
        Self { side: side(), passes: None, error: error(), rings: Rings::default() }
    }
}
