//! `stratiform render` as typed.

use crate::numbers::finite;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// How the sun's light leaves the cloud.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RadianceModel {
    /// The paper's orders, corrected.
    Angular,
    /// One event exactly, all others as the fitted exponential.
    Fitted,
}

/// Thickness of the slab that stands for the cloud at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SlabDepth {
    /// That above the base where the line of sight meets the cloud.
    Local,
    /// That of the way which the line of sight goes in the cloud.
    Chord,
}

/// Normals by which the sun's light of one and two events leaves the cloud.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SlabNormals {
    /// Those of the cloud's face.
    Local,
    /// The vertical.
    Vertical,
}

/// `stratiform render`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform render fit-configs/scenes/stratocumulus.toml --out cloud.png\n  stratiform render \
                  fit-configs/scenes/stratocumulus.toml --out cloud.png --exr cloud.exr --size 960x540 --time 600 --model angular\n  \
                  stratiform render fit-configs/scenes/stratocumulus.toml --out single.png --only single,background --timings\n\
                  Contributions: background, halo, single, double, multiple, sky, ground; with --model fitted double is in multiple.\n\
                  Needs a Vulkan driver, software ones included, and the cargo feature `gpu`. Prints the files written."
)]
pub struct RenderArgs {
    /// A scene with camera and clouds: a file, or a name such as stratocumulus.
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// The picture, tone-mapped (PNG, sRGB).
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// The picture's radiance too (EXR, linear sRGB, in units of the sun's irradiance).
    #[arg(long, value_name = "FILE")]
    pub exr: Option<PathBuf>,
    /// Columns and rows instead of the scene's.
    #[arg(long, value_parser = size, value_name = "WxH")]
    pub size: Option<[usize; 2]>,
    /// Rays a pixel each way, whose mean is the pixel: what is smaller than a pixel no longer glitters.
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=16), value_name = "N", default_value = "1")]
    pub oversample: u8,
    /// The clouds as they are after so many seconds.
    #[arg(long, value_parser = finite, value_name = "S", default_value = "0")]
    pub time: f64,
    /// How the sun's light leaves the cloud.
    #[arg(long, value_enum, default_value = "fitted")]
    pub model: RadianceModel,
    /// Draw these contributions only.
    #[arg(long, value_delimiter = ',', value_name = "NAME,...", conflicts_with = "without")]
    pub only: Vec<String>,
    /// Draw all contributions but these.
    #[arg(long, value_delimiter = ',', value_name = "NAME,...")]
    pub without: Vec<String>,
    /// Which slab stands for the cloud at a point.
    #[arg(long, value_enum, default_value = "local")]
    pub depth: SlabDepth,
    /// By which normals the sun's light of one and two events leaves.
    #[arg(long, value_enum, default_value = "local")]
    pub normals: SlabNormals,
    /// Stops instead of the scene's; at 0 a white diffuser that faces the sun is white.
    #[arg(long, value_parser = finite, value_name = "EV")]
    pub exposure: Option<f64>,
    /// Print the device's seconds per pass (CSV) instead of the files.
    #[arg(long)]
    pub timings: bool,
}

/// `WIDTHxHEIGHT`, each from 1 to 65536.
///
/// # Errors
/// A message naming the text and the range.
pub fn size(text: &str) -> Result<[usize; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=65_536).contains(side));
    let sides = text.split_once('x').and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| format!("`{text}` is not WIDTHxHEIGHT, each in [1, 65536]"))
}

#[cfg(test)]
mod tests {
    use super::size;

    #[test]
    fn sizes_are_two_numbers() {
        assert_eq!(size("480x270"), Ok([480, 270]));
        for text in ["480", "0x1", "1x65537", "-1x2", "axb", "1x2x3"] {
            assert!(size(text).is_err(), "{text}");
        }
    }
}
