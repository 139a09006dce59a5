//! `stratiform truth` as typed.

use super::render::size;
use crate::numbers::{count, finite, seed};
use clap::Args;
use std::path::PathBuf;

/// `stratiform truth`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform truth fit-configs/scenes/stratocumulus.toml --out out/truth --size 160x90 --target 0.02\n  \
                  stratiform truth glory --out out/glory --crop 200,100,32,18 --samples 1000 --json\n\
                  Writes truth.exr (radiance; layers std_error, and NAME and NAME_std_error of each contribution), truth.png and truth.json. \
                  Exit code 1, the files written all the same, if --samples did not suffice for --target. With --seconds alone the result \
                  depends on the machine."
)]
pub struct TruthArgs {
    /// A scene with camera and clouds: a file, or a name such as stratocumulus.
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Folder for the files.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Columns and rows instead of the scene's.
    #[arg(long, value_parser = size, value_name = "WxH")]
    pub size: Option<[usize; 2]>,
    /// The clouds as they are after so many seconds.
    #[arg(long, value_parser = finite, value_name = "S", default_value = "0")]
    pub time: f64,
    /// Paths of each pixel; with --target at most so many. Default: 64, with --target 1e6.
    #[arg(long, value_parser = count, value_name = "N")]
    pub samples: Option<u64>,
    /// Stop when the median over pixels of the luminance's standard error is at most this share of it.
    #[arg(long, value_parser = finite, value_name = "SHARE")]
    pub target: Option<f64>,
    /// Stop after about so many seconds.
    #[arg(long, value_parser = finite, value_name = "S", conflicts_with_all = ["samples", "target"])]
    pub seconds: Option<f64>,
    /// First column and row, columns and rows: these pixels only, the same as in the whole picture.
    #[arg(long, value_parser = crop, value_name = "X,Y,W,H")]
    pub crop: Option<[usize; 4]>,
    /// Seed of the random streams.
    #[arg(long, value_parser = seed, default_value = "1")]
    pub seed: u64,
    /// Print truth.json instead of the files written.
    #[arg(long)]
    pub json: bool,
}

/// `X,Y,W,H`, whole numbers.
fn crop(text: &str) -> Result<[usize; 4], String> {
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.parse().ok()).collect();
    let crop = numbers.and_then(|numbers| <[usize; 4]>::try_from(numbers).ok());
    crop.ok_or_else(|| format!("`{text}` is not X,Y,W,H, four whole numbers"))
}

#[cfg(test)]
mod tests {
    use super::crop;

    #[test]
    fn crops_are_four_numbers() {
        assert_eq!(crop("1,2,32,18"), Ok([1, 2, 32, 18]));
        for text in ["1,2,3", "1,2,3,4,5", "-1,2,3,4", "", "a,b,c,d"] {
            assert!(crop(text).is_err(), "{text}");
        }
    }
}
