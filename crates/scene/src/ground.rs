//! `[ground]`: what lies below the cloud.

use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// One share for all colours, or one each in linear sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "albedo must be a number or [red, green, blue]")]
pub enum Albedo {
    /// Grey.
    Grey(f64),
    /// Red, green, blue.
    Colour([f64; 3]),
}

impl Albedo {
    /// Linear sRGB.
    pub fn rgb(&self) -> [f64; 3] {
        match *self {
            Self::Grey(albedo) => [albedo; 3],
            Self::Colour(rgb) => rgb,
        }
    }

    /// Its luminance (weights of sRGB, IEC 61966-2-1).
    pub fn luminance(&self) -> f64 {
        match *self {
            Self::Grey(albedo) => albedo,
            Self::Colour([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue,
        }
    }
}

/// How two kinds of ground share the plane, half and half.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GroundPattern {
    /// Water in the west, ice in the east, a straight edge between them.
    WaterIce,
    /// Water and land, a winding shore.
    Coast,
    /// Ice floes on water.
    Floes,
    /// Squares.
    Checker,
}

/// Broadband albedo of open water under a high sun (Oke, Boundary Layer Climates, 2nd ed. 1987, table 1.1: 0.03 to 0.10).
const WATER: Albedo = Albedo::Colour([0.04, 0.06, 0.08]);
/// Bare sea ice (Perovich 1996, CRREL Monograph 96-1: 0.5 to 0.7).
const ICE: Albedo = Albedo::Grey(0.6);
/// Grass, woods and fields (Oke 1987, table 1.1: 0.05 to 0.26).
const LAND: Albedo = Albedo::Colour([0.12, 0.15, 0.07]);
/// Light and dark squares.
const SQUARES: [Albedo; 2] = [Albedo::Grey(0.1), Albedo::Grey(0.8)];

impl GroundPattern {
    /// Of its two kinds, the darker first.
    pub fn albedos(self) -> [Albedo; 2] {
        match self {
            Self::WaterIce | Self::Floes => [WATER, ICE],
            Self::Coast => [WATER, LAND],
            Self::Checker => SQUARES,
        }
    }
}

/// One of albedo, pattern and image. It gives light back the same in all directions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Share of the light that it gives back.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub albedo: Option<Albedo>,
    /// Two kinds that share the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<GroundPattern>,
    /// Their albedos, in place of the pattern's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub albedos: Option<[Albedo; 2]>,
    /// PNG (sRGB) or EXR (linear), square, north at the top; relative to the scene's file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub image: Option<PathBuf>,
    /// Period in both directions; the clouds' where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extent_m: Option<f64>,
    /// Texels a side of a pattern.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<u32>,
    /// Width of a square, a bay or a floe.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
    /// Which of all shores or floes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u32>,
}

impl Ground {
    /// One albedo everywhere.
    pub fn grey(albedo: f64) -> Self {
        Self { albedo: Some(Albedo::Grey(albedo)), ..Self::default() }
    }

    /// Albedos of its two kinds, the same twice where there is but one; `None` for an image.
    pub fn kinds(&self) -> Option<[Albedo; 2]> {
        let patterned = self.pattern.map(|pattern| self.albedos.unwrap_or(pattern.albedos()));
        patterned.or(self.albedo.map(|albedo| [albedo; 2]))
    }

    /// Mean luminance; `None` for an image, which nobody has read yet.
    pub fn mean_albedo(&self) -> Option<f64> {
        self.kinds().map(|[one, other]| 0.5 * (one.luminance() + other.luminance()))
    }
}
