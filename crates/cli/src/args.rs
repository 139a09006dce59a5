//! The command line exactly as typed. Turning it into checked objects is the commands' work.

mod advise;
mod atlas;
mod chart;
mod check;
mod compare;
mod errors;
mod export;
mod merge;
mod nearest;
mod phase_check;
mod render;
mod shell;
mod spread;
mod truth;
mod view;

use crate::numbers::{count, finite, pair, seed};
use clap::{Args, Parser, Subcommand, ValueEnum};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

pub use crate::solve_args::SolveArgs;
pub use advise::AdviseArgs;
pub use atlas::AtlasArgs;
pub use chart::ChartArgs;
pub use check::CheckArgs;
pub use compare::{CompareArgs, ComparedModels};
pub use errors::ErrorsArgs;
pub use export::{ExportArgs, Format};
pub use merge::MergeArgs;
pub use nearest::NearestArgs;
pub use phase_check::{Convention, PhaseCheckArgs};
pub use render::{RadianceModel, RenderArgs, SlabDepth, SlabNormals};
pub use shell::{CompletionsArgs, ManArgs};
pub use spread::SpreadArgs;
pub use truth::TruthArgs;
pub use view::WindowArgs;

/// From a cloud's droplets to real-time cloud-layer shading whose error is known.
#[derive(Debug, Parser)]
#[command(
    name = "stratiform",
    version,
    max_term_width = 100,
    arg_required_else_help = true,
    after_help = "Exit codes: 0 done; 1 a check failed or a tolerance could not be met; 2 bad input or usage; 130 \
                  interrupted.\nstdout is data, stderr is talk. The same seed gives the same bytes for any number \
                  of threads.\n\nExamples:\n  stratiform reproduce fit-configs/appendix-b.toml --out out/appendix-b\n  \
                  stratiform trace --phase hg:0.85 --tau 1,5,16 --mu0 1,0.5,diffuse --photons 1e6 --json\n  \
                  stratiform mie --x 100 --m 1.33,1e-5 --angles 0,90,180"
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Threads to use; the numbers do not depend on it. Default: one per core.
    #[arg(long, global = true, value_name = "N")]
    pub threads: Option<usize>,
    /// Say nothing on stderr but errors.
    #[arg(long, global = true)]
    pub quiet: bool,
}

/// The stages and what goes round them.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// One homogeneous sphere: efficiencies, asymmetry parameter, amplitudes.
    Mie(MieArgs),
    /// Optics of a droplet distribution: phase functions, moments, extinction.
    Optics(OpticsArgs),
    /// Monte Carlo reflectance and transmittance of slabs, per scattering order.
    Trace(TraceArgs),
    /// Add the shards of a trace and print what one process would.
    Merge(MergeArgs),
    /// Deterministic reflectance and transmittance of slabs, with estimated errors.
    Solve(SolveArgs),
    /// Fit the one-dimensional model to the solver or to photons, with errors and flags.
    Fit(StageArgs),
    /// Emit shader libraries, C, Rust, JSON and CSV from the accepted parameters; `--check` proves the emitted text fresh.
    Codegen(CodegenArgs),
    /// Write phase functions and parameters as others load them, and print what each file is worth.
    Export(ExportArgs),
    /// Hold the accepted table, the tracer, or another implementation's values against the truth; for CI.
    Check(CheckArgs),
    /// Say what is wrong with somebody's phase table or constants.
    PhaseCheck(PhaseCheckArgs),
    /// The nearest Henyey-Greenstein, two-lobe and HG + Draine functions, with their measured error.
    Nearest(NearestArgs),
    /// The cheapest method that keeps an error, or the most accurate within a cost, for a scene.
    Advise(AdviseArgs),
    /// Error and cost of every method on the lattice that `advise` reads.
    Errors(ErrorsArgs),
    /// Every stage, then the report: from droplets to shader tables.
    Reproduce(StageArgs),
    /// Error against cost of every way to shade a cloud layer, over scenes.
    Chart(ChartArgs),
    /// Where each method breaks: thickness, angles, droplets and albedo from end to end, in f32 and f64.
    Atlas(AtlasArgs),
    /// Draw a scene's clouds over its ground; needs the cargo feature `gpu`.
    Render(RenderArgs),
    /// Trace a scene's picture path by path, with an error for every pixel.
    Truth(TruthArgs),
    /// Hold a scene's picture against its path-traced truth; needs the cargo feature `gpu`.
    Compare(CompareArgs),
    /// Open a window on a scene, with camera, sun and time under keys and mouse; needs the cargo feature `view`.
    View(WindowArgs),
    /// Draw the figures and the page from a folder that `reproduce` wrote.
    Report(ReportArgs),
    /// Completion script of a shell.
    Completions(CompletionsArgs),
    /// Manual pages.
    Man(ManArgs),
}

/// `stratiform mie`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: stratiform mie --x 100 --m 1.33,1e-5 --angles 0,90,180 --json\nDomain: 1e-3 <= x <= 1e5; \
                  m = n + ik with k >= 0 absorbing; amplitudes in Bohren and Huffman's sign."
)]
pub struct MieArgs {
    /// Size parameter 2πr/λ.
    #[arg(long, value_parser = finite)]
    pub x: f64,
    /// Complex refractive index n,k relative to the medium outside.
    #[arg(long, value_parser = pair, value_name = "N,K")]
    pub m: [f64; 2],
    /// Scattering angles in degrees.
    #[arg(long, value_delimiter = ',', value_parser = finite, value_name = "DEG,...")]
    pub angles: Vec<f64>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// `stratiform optics`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform optics --config fit-configs/appendix-b.toml --out out/optics\n  stratiform optics \
                  --r-eff 7 --gamma 2 --n0 300 --wavelength 0.65,0.55,0.45 --out out/optics"
)]
pub struct OpticsArgs {
    /// Take droplets, wavelengths and index from this file's optics section.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["r_eff", "gamma", "n0", "wavelength"])]
    pub config: Option<PathBuf>,
    /// Effective radius in µm of a modified gamma distribution.
    #[arg(long, value_parser = finite, required_unless_present = "config")]
    pub r_eff: Option<f64>,
    /// Shape γ of the modified gamma distribution; effective variance 1/(γ+2).
    #[arg(long, value_parser = finite, required_unless_present = "config")]
    pub gamma: Option<f64>,
    /// Droplets per cm³.
    #[arg(long, value_parser = finite, required_unless_present = "config")]
    pub n0: Option<f64>,
    /// Wavelengths in µm.
    #[arg(long, value_delimiter = ',', value_parser = finite, required_unless_present = "config")]
    pub wavelength: Vec<f64>,
    /// θ_f in degrees, the edge of the modified phase function.
    #[arg(long, value_parser = finite, default_value = "5", value_name = "DEG")]
    pub modified: f64,
    /// Folder to write optics.json and the tables to.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print optics.json.
    #[arg(long)]
    pub json: bool,
}

/// MEDIUM: what light is traced through.
#[derive(Debug, Args)]
pub struct MediumArgs {
    /// isotropic | rayleigh | hg:G | draine:G,ALPHA | moments:FILE | table:FILE | config:FILE.
    #[arg(long, value_name = "PHASE")]
    pub phase: String,
    /// Divide a phase table by its norm even if that is off by more than 1e-3.
    #[arg(long)]
    pub renormalise: bool,
    /// Single-scattering albedo; default 1, or what config:FILE says.
    #[arg(long, value_parser = finite)]
    pub omega: Option<f64>,
    /// Move scattering by less than this angle (degrees) into the unscattered beam. Orders then count wide
    /// events; --tau still means the full medium's optical thickness.
    #[arg(long, value_parser = finite, value_name = "DEG")]
    pub modified: Option<f64>,
}

/// Which tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Estimator {
    /// Depth and μ only, one history for all thicknesses.
    HalfSpace,
    /// Three-dimensional, one slab at a time: slower, the reference.
    Plain,
}

/// Where photons are traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Device {
    /// The processor, all cores.
    Cpu,
    /// The graphics adapter that the system prefers.
    Gpu,
}

/// Slabs and how they are lit, the same for every solver.
#[derive(Debug, Args)]
pub struct SlabArgs {
    /// Optical thicknesses of the full medium.
    #[arg(long, value_delimiter = ',', value_parser = finite, required = true)]
    pub tau: Vec<f64>,
    /// Cosines of the sun's zenith angle in [0, 1], or `diffuse`.
    #[arg(long, value_delimiter = ',', required = true)]
    pub mu0: Vec<String>,
}

/// Directions of leaving light, the same for every solver.
#[derive(Debug, Args)]
pub struct ViewArgs {
    /// Radiance instead of fluxes: cosines of the leaving light's angle to the normal, in [0, 1].
    #[arg(long, value_delimiter = ',', value_parser = finite, value_name = "MU,...")]
    pub view_mu: Vec<f64>,
    /// Azimuths in degrees for --view-mu; default 0, where light keeps the sun's. The glory is side top, 180, mu = mu0.
    #[arg(long, value_delimiter = ',', value_parser = finite, value_name = "DEG,...", requires = "view_mu")]
    pub phi: Vec<f64>,
}

/// `stratiform trace`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform trace --phase hg:0.75 --tau 1,8 --mu0 1 --photons 1e7\n  stratiform trace \
                  --phase config:fit-configs/appendix-b.toml --modified 5 --tau 5 --mu0 0,0.5,diffuse --photons 1e6 \
                  --json\n  stratiform trace --phase hg:0.85 --tau 5 --mu0 0.5 --view-mu 1,0.5 --phi 0,90,180 --photons 1e5\n  \
                  stratiform trace --phase hg:0.85 --tau 16 --mu0 1 --photons 1e11 --checkpoint run.ckpt\n  stratiform trace \
                  --phase hg:0.85 --tau 16 --mu0 1 --photons 1e11 --shard 3/100 --out part3.bin\nKilled and started again \
                  with the same arguments, a trace with --checkpoint goes on, and prints the bytes of an uninterrupted one; \
                  so does `stratiform merge` of all shards.\n\
                  Radiance is scored by local estimates. A forward peak makes rare scores large: every std_error contains \
                  one more of the largest, and rows where too few were met have settled = false; raise --photons, or \
                  use --modified.\nA phase table is piecewise linear in the angle; its rows are theta_deg,p with 1/2 ∫ p \
                  dcosΘ = 1."
)]
pub struct TraceArgs {
    /// What light is traced through.
    #[command(flatten)]
    pub medium: MediumArgs,
    /// Slabs and suns.
    #[command(flatten)]
    pub slab: SlabArgs,
    /// Radiance instead of fluxes, 0 left out of the cosines.
    #[command(flatten)]
    pub views: ViewArgs,
    /// Photons per incidence (with --std-error: at most so many), for radiance per slab and sun.
    #[arg(long, value_parser = count)]
    pub photons: u64,
    /// Stop as soon as every standard error is at most this; exit code 1 if --photons did not suffice. Not with --view-mu.
    #[arg(long, value_parser = finite)]
    pub std_error: Option<f64>,
    /// Orders listed one by one; the rest is the tail.
    #[arg(long, default_value_t = 2)]
    pub orders: u32,
    /// Seed of the random streams.
    #[arg(long, value_parser = seed, default_value = "1")]
    pub seed: u64,
    /// Which tracer; default half-space. Radiance is always scored by the plain one.
    #[arg(long, value_enum)]
    pub estimator: Option<Estimator>,
    /// Where photons are traced: on a graphics device in single precision, slabs up to 300 deep. Fluxes, half-space.
    #[arg(long, value_enum, default_value_t = Device::Cpu)]
    pub device: Device,
    /// Over time and machines. Fluxes only.
    #[command(flatten)]
    pub spread: SpreadArgs,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}

/// `stratiform fit` and `stratiform reproduce`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform reproduce fit-configs/appendix-b.toml --out out/appendix-b\n  stratiform fit \
                  fit-configs/appendix-b.toml --out out/appendix-b\nStages whose inputs are unchanged are not run again."
)]
pub struct StageArgs {
    /// The fit-config (TOML).
    pub config: PathBuf,
    /// Folder for all artifacts.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Overrides the config's seed.
    #[arg(long, value_parser = seed)]
    pub seed: Option<u64>,
    /// Overrides the config's photons per incidence and medium.
    #[arg(long, value_parser = count)]
    pub photons: Option<u64>,
    /// Print parameters.json instead of the table.
    #[arg(long)]
    pub json: bool,
}

/// `stratiform codegen`.
#[derive(Debug, Args)]
#[command(
    after_help = "Example: stratiform codegen fit-configs/appendix-b.toml --check\nThe config's [codegen] section names the \
                  languages: targets = [\"wgsl\", \"glsl-450\", \"glsl-330\", \"glsl-300es\", \"hlsl\", \"msl\", \"c\", \"rust\", \
                  \"spirv\"], all of them where the key is left out."
)]
pub struct CodegenArgs {
    /// The fit-config, whose codegen section names the accepted artifacts and the output folder.
    pub config: PathBuf,
    /// Write nothing; exit code 1 with a diff if the emitted text is stale or edited.
    #[arg(long)]
    pub check: bool,
    /// Print one JSON object: the files and whether each is fresh.
    #[arg(long)]
    pub json: bool,
}

/// `stratiform report`.
#[derive(Debug, Args)]
#[command(after_help = "Example: stratiform report out/appendix-b")]
pub struct ReportArgs {
    /// A folder that `reproduce` wrote.
    pub dir: PathBuf,
    /// Print one JSON object: the files written.
    #[arg(long)]
    pub json: bool,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }
}
