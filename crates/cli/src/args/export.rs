//! `stratiform export` as typed.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Format {
    /// Text, f64: a line per texel.
    Csv,
    /// Schema stratiform/phase-table/1, f64.
    Json,
    /// NumPy, f64.
    Npz,
    /// OpenEXR, f32: a row per function, a channel per wavelength.
    Exr,
    /// KTX2, RGBA32F.
    #[value(name = "ktx2-32")]
    Ktx2F32,
    /// KTX2, RGBA16F.
    #[value(name = "ktx2-16")]
    Ktx2F16,
}

/// `stratiform export`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform export fit-configs/appendix-b.toml --out out/tables\n  stratiform export \
                  fit-configs/appendix-b.toml --out out/tables --formats exr,ktx2-16 --texels 512\nFiles: phase.* with P, P_S \
                  and P_S*P_S of every wavelength at equal steps of the angle map's coordinate. Printed is each file's card: the integral \
                  of its look-up, g, and the errors relative to the optics at peak, fogbow and glory."
)]
pub struct ExportArgs {
    /// The fit-config, whose optics section is exported.
    pub config: PathBuf,
    /// Folder to write the files to.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Which files.
    #[arg(long, value_enum, value_delimiter = ',', value_name = "FORMAT,...", default_values_t = Format::value_variants().to_vec())]
    pub formats: Vec<Format>,
    /// Values of each phase function, 64 to 1024.
    #[arg(long, value_name = "N", default_value_t = 256)]
    pub texels: usize,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
