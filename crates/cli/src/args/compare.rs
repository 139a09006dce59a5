//! `stratiform compare` as typed.

use super::render::size;
use crate::numbers::{count, finite, seed};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// What takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ComparedModels {
    /// The paper's orders, corrected.
    Angular,
    /// One event exactly, all others as the fitted exponential.
    Fitted,
    /// One after the other.
    Both,
}

/// `stratiform compare`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform compare fit-configs/scenes/stratocumulus.toml --out out/compare --size 96x54 --samples 64\n  \
                  stratiform compare stratocumulus --out out/compare --truth truth.exr --ablation --costs 640x360,1920x1080\n\
                  Writes comparison.html, comparison.csv, comparison.json, pictures and maps (SVG, PNG), truth.exr, and ablation.csv and \
                  render-costs.csv where asked for. Prints comparison.csv. Needs a Vulkan driver, software ones included, and the cargo \
                  feature `gpu`."
)]
pub struct CompareArgs {
    /// A scene with camera and clouds: a file, or a name such as stratocumulus.
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Folder for everything.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Columns and rows instead of the scene's, or those of --truth.
    #[arg(long, value_parser = size, value_name = "WxH")]
    pub size: Option<[usize; 2]>,
    /// Paths a pixel of the truth that is traced.
    #[arg(long, value_parser = count, value_name = "N", default_value = "64", conflicts_with = "truth")]
    pub samples: u64,
    /// Take the truth from this EXR, with its standard error and parts as layers, instead of tracing it.
    #[arg(long, value_name = "FILE")]
    pub truth: Option<PathBuf>,
    /// Which models draw.
    #[arg(long, value_enum, default_value = "both")]
    pub model: ComparedModels,
    /// The clouds as they are after so many seconds.
    #[arg(long, value_parser = finite, value_name = "S", default_value = "0")]
    pub time: f64,
    /// Stops instead of the scene's; at 0 a white diffuser that faces the sun is white.
    #[arg(long, value_parser = finite, value_name = "EV")]
    pub exposure: Option<f64>,
    /// Rays a pixel each way: the truth is a mean over each pixel's square.
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=16), value_name = "N", default_value = "4")]
    pub oversample: u8,
    /// Leave out one thing at a time: ablation.csv.
    #[arg(long)]
    pub ablation: bool,
    /// Time every pass at these sizes: render-costs.csv and its figure.
    #[arg(long, value_parser = size, value_delimiter = ',', value_name = "WxH,...")]
    pub costs: Vec<[usize; 2]>,
    /// Seed of the paths.
    #[arg(long, value_parser = seed, default_value = "1")]
    pub seed: u64,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
