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
    /// Mitsuba 3's `tabphase`, XML, 65537 values.
    Mitsuba,
    /// Eradiate's `tabphase_irregular`, XML.
    MitsubaIrregular,
    /// Eradiate's particle properties, netCDF.
    Eradiate,
    /// MCX's inverse cumulative distribution, JSON.
    Mcx,
    /// DISORT's Legendre moments, text.
    Disort,
    /// Bevy's chromatic phase texture in linear sRGB, KTX2; needs three visible wavelengths.
    Bevy,
}

impl Format {
    /// What is written unless asked otherwise: the containers, no other program's own files.
    const CONTAINERS: [Self; 6] = [Self::Csv, Self::Json, Self::Npz, Self::Exr, Self::Ktx2F32, Self::Ktx2F16];

    /// Whether it is another program's own.
    pub fn is_peer(self) -> bool {
        !Self::CONTAINERS.contains(&self)
    }
}

/// `stratiform export`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform export fit-configs/appendix-b.toml --out out/tables\n  stratiform export \
                  fit-configs/appendix-b.toml --out out/tables --formats exr,ktx2-16 --texels 512\nFiles: phase.* with P, P_S \
                  and P_S*P_S of every wavelength at equal steps of the angle map's coordinate. Printed is each file's card: the integral \
                  of its look-up, g, and the errors relative to the optics at peak, fogbow and glory. Formats of other programs (mitsuba, \
                  mitsuba-irregular, eradiate, mcx, disort, bevy) hold P alone, by each program's own convention, and their cards are of that \
                  program's look-up; --texels does not apply.\nColumns: scaled_by is what the fitted texels were multiplied by to integrate \
                  to 1; peak_error is relative and signed, at 0 degrees; fogbow_error (130 to 150 degrees), glory_error (170 to 180), \
                  largest_error (at largest_at_deg) and median_error are relative; total_variation is the share of light that the look-up \
                  sends elsewhere. Engines that read colours take phase-srgb.exr or .ktx2 (--srgb); the channels of phase.exr are wavelengths."
)]
pub struct ExportArgs {
    /// The fit-config, whose optics section is exported.
    pub config: PathBuf,
    /// Folder to write the files to.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Which files.
    #[arg(long, value_enum, ignore_case = true, value_delimiter = ',', value_name = "FORMAT,...", default_values_t = Format::CONTAINERS)]
    pub formats: Vec<Format>,
    /// Values of each phase function, 64 to 1024.
    #[arg(long, value_name = "N", default_value_t = 256)]
    pub texels: usize,
    /// Write the phase functions as linear sRGB too (phase-srgb.*): three wavelengths or more in [0.36, 0.83] µm.
    #[arg(long)]
    pub srgb: bool,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
