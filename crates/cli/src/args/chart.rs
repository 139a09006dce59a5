//! `stratiform chart` as typed.

use clap::Args;
use std::path::PathBuf;

/// `stratiform chart`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform chart --out out/chart\n  stratiform chart --scene glory-view --methods single-mie,octaves:4 \
                  --out out/glory\n  stratiform chart --scene my-scene.toml --quick --out out/mine --json\nErrors are relative, against \
                  the deterministic solver on the full medium. Writes chart.csv, knobs.csv, manifest.json, one SVG per scene and \
                  chart.html. Only times differ between runs (ns_per_evaluation, and the front, which follows from them)."
)]
pub struct ChartArgs {
    /// Scenes: names or TOML files; default: all named ones.
    #[arg(long, value_delimiter = ',', value_name = "NAME|FILE")]
    pub scene: Vec<String>,
    /// Methods by name, with or without knob, such as octaves:8; default: all, and the curves of their knobs.
    #[arg(long, value_delimiter = ',', value_name = "NAME[:KNOB]")]
    pub methods: Vec<String>,
    /// Folder for tables, figures and page.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Few points and one cloud per scene, no knobs: seconds, for CI.
    #[arg(long)]
    pub quick: bool,
    /// Print one JSON object instead of chart.csv.
    #[arg(long)]
    pub json: bool,
}
