//! `stratiform check` as typed.

use crate::numbers::{count, seed};
use clap::Args;
use std::path::PathBuf;

/// `stratiform check`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  stratiform check fit-configs/appendix-b.toml\n  \
                        stratiform check fit-configs/appendix-b.toml --points points.csv\n  \
                        stratiform check fit-configs/appendix-b.toml --values values.csv --junit check.xml --markdown check.md\n\
                        Without --values: the accepted table against the deterministic solver, and fresh photons against the stored \
                        counts. With --values: only the values of that file, against the solver.\n\
                        Columns of --values and --points: quantity,theta_l_deg,theta_v_deg,phi_deg,tau,order,value; \
                        quantity = reflectance | transmittance | radiance_top | radiance_bottom; theta_l_deg in [0, 90] or \
                        `diffuse`; theta_v_deg and phi_deg empty for fluxes; tau is the full medium's; order 0 to 60, tail (three \
                        and more) or total. Totals are those of the config's totals_medium, orders those of its orders_medium. Radiance is \
                        pi L/(mu0 F0) without unscattered light, of order 1, 2 or total; phi 0: light keeps the sun's azimuth. \
                        Columns stand in any order, others are ignored, lines that start with # are comments, no place may stand twice.\n\
                        Exit codes: 0 everything within its bounds; 1 something is not, or nothing was compared; 2 misuse.")]
pub struct CheckArgs {
    /// The config (TOML), whose section `check` holds the bounds.
    pub config: PathBuf,
    /// Judge these values of another implementation, and nothing else.
    #[arg(long, value_name = "FILE")]
    pub values: Option<PathBuf>,
    /// Write the places at which fluxes are best evaluated, with `value` left empty, and stop.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["values", "store_counts", "junit", "markdown"])]
    pub points: Option<PathBuf>,
    /// Trace the counts that fresh photons are held against, write them, and stop.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["values", "junit", "markdown"])]
    pub store_counts: Option<PathBuf>,
    /// Overrides the config's photons per incidence and medium.
    #[arg(long, value_parser = count, conflicts_with_all = ["values", "points"])]
    pub photons: Option<u64>,
    /// Overrides the config's seed.
    #[arg(long, value_parser = seed, conflicts_with_all = ["values", "points"])]
    pub seed: Option<u64>,
    /// How many of the worst offenders are listed.
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub worst: usize,
    /// Write the result as JUnit XML.
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,
    /// Write the result as a Markdown table, for a CI summary.
    #[arg(long, value_name = "FILE")]
    pub markdown: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}
