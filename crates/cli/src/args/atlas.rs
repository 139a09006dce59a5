//! `stratiform atlas` as typed.

use clap::Args;
use std::path::PathBuf;

/// `stratiform atlas`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform atlas --out out/atlas\n  stratiform atlas --methods fitted,bouthors-corrected --quick --json\nEvery \
                  value is ok, without a promise, refused, or one of: loses-digits (f32), over-bound, above-one, negative, not-finite, \
                  not-refused. Writes atlas.csv, summary.csv, atlas.json, one SVG per method and atlas.html. The same bytes on every run. \
                  Exit 1 if a method breaks its contract."
)]
pub struct AtlasArgs {
    /// Methods by name, with or without knob, such as octaves:4; default: all, tracers with 1000 photons.
    #[arg(long, value_delimiter = ',', value_name = "NAME[:KNOB]")]
    pub methods: Vec<String>,
    /// Folder for tables, maps and page; without it only the summary is printed.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Thin planes, one droplet size: seconds, for CI.
    #[arg(long)]
    pub quick: bool,
    /// Print one JSON object instead of summary.csv.
    #[arg(long)]
    pub json: bool,
}
