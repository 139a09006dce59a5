//! `stratiform advise`.

use crate::numbers::finite;
use clap::Args;
use std::path::PathBuf;

/// What is typed.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform advise fit-configs/scenes/thick-overcast.toml --max-error 20%\n  stratiform advise low-sun \
                  --max-ns 30 --json\nExit code 1 if no listed method meets the budget; the nearest is printed all the same."
)]
pub struct AdviseArgs {
    /// A scene: a file, or a name such as thin-veil.
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Largest error of radiances at 95 % of the scene: `2%` or 0.02.
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true)]
    pub max_error: Option<String>,
    /// Largest cost of a pixel in nanoseconds (f32, one thread).
    #[arg(long, value_parser = finite, value_name = "NS")]
    pub max_ns: Option<f64>,
    /// Albedo of the ground where its light is seen, instead of the scene's `[ground] albedo`; 0.2 where neither says.
    #[arg(long, value_parser = finite, value_name = "RHO")]
    pub ground_albedo: Option<f64>,
    /// Write a config for `reproduce` and `codegen` that emits just what is advised.
    #[arg(long, value_name = "FILE")]
    pub emit: Option<PathBuf>,
    /// Error data of `stratiform errors` instead of those that come with the program.
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// What leaving out parts of the scene's picture does: ablation.csv of `stratiform compare`, instead of
    /// fit-configs/render/ablation.csv. Needs --max-error.
    #[arg(long, value_name = "FILE", requires = "max_error")]
    pub ablation: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}
