//! `[clouds]`: the layer of a picture, as thick as a pattern or a file says.

use crate::Interval;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// How thickness varies over the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pattern {
    /// The same everywhere: the greatest thickness.
    Flat,
    /// Cells with rounded tops, parted by thin or clear lanes.
    #[default]
    Stratocumulus,
    /// Bands across the wind (undulatus).
    Ripples,
}

/// A flat base, and above it a thickness that repeats itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Clouds {
    /// Folder that `reproduce` wrote, or one like the committed ones; relative to the scene's file.
    pub tables: PathBuf,
    /// Altitude of the base.
    #[serde(default = "base_m")]
    pub base_m: f64,
    /// Period in both directions.
    #[serde(default = "extent_m")]
    pub extent_m: f64,
    /// What thickness follows; nothing and no file: stratocumulus.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<Pattern>,
    /// PNG (grey, 8 or 16 bit: black is 0, white `scale_m`) or EXR of one channel (times `scale_m`), square, north at the top.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Metres of a file's 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale_m: Option<f64>,
    /// Texels a side of a pattern.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<u32>,
    /// Least and greatest thickness of a pattern's clouds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_m: Option<Interval>,
    /// Which of all patterns of the kind.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u32>,
    /// Share of the plane with cloud over it; 1 where the least thickness is not 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cover: Option<f64>,
    /// Width of a cell, or of a band; brought to a whole number of them in the period.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cell_m: Option<f64>,
    /// Octaves of noise; none is finer than the texels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub octaves: Option<u32>,
    /// Where the pattern drifts: east, north.
    #[serde(default)]
    pub wind_m_per_s: [f64; 2],
    /// After how long the pattern has changed beyond recognition and come back; without it it only drifts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub evolution_s: Option<f64>,
}

fn base_m() -> f64 {
    2000.0
}

fn extent_m() -> f64 {
    16_000.0
}

/// A pattern's keys with their defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatternKeys {
    /// The kind.
    pub pattern: Pattern,
    /// Texels a side.
    pub side: u32,
    /// Least and greatest thickness.
    pub thickness_m: Interval,
    /// Which one.
    pub seed: u32,
    /// Share of the plane with cloud over it.
    pub cover: f64,
    /// Width of a cell or band.
    pub cell_m: f64,
    /// Octaves of noise.
    pub octaves: u32,
}

/// Thinner than this share of the greatest thickness is edge: a derived layer begins there.
const EDGE: f64 = 0.01;

impl Clouds {
    /// The pattern, unless a file stands in its place.
    pub fn pattern_keys(&self) -> Option<PatternKeys> {
        let thickness_m = self.thickness_m.unwrap_or(Interval { min: 0.0, max: 500.0 });
        self.file.is_none().then(|| PatternKeys {
            pattern: self.pattern.unwrap_or_default(),
            side: self.side.unwrap_or(512),
            thickness_m,
            seed: self.seed.unwrap_or(2006),
            cover: self.cover.unwrap_or(if thickness_m.min > 0.0 { 1.0 } else { 0.9 }),
            cell_m: self.cell_m.unwrap_or(1600.0),
            octaves: self.octaves.unwrap_or(6),
        })
    }

    /// Thicknesses from its edges to its tops; `None` for a file, which nobody has read yet.
    pub fn thickness_range_m(&self) -> Option<Interval> {
        let keys = self.pattern_keys()?;
        let most = keys.thickness_m.max;
        let least = if keys.pattern == Pattern::Flat { most } else { keys.thickness_m.min.max(EDGE * most) };
        Some(Interval { min: least, max: most })
    }
}
