//! `stratiform solve` as typed.

use crate::args::{MediumArgs, SlabArgs, ViewArgs};
use crate::numbers::finite;
use clap::Args;

/// `stratiform solve`.
#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:\n  stratiform solve --phase hg:0.75 --tau 1,8 --mu0 1,diffuse --tolerance 1e-8\n  stratiform solve \
                  --phase config:fit-configs/appendix-b.toml --modified 5 --tau 5 --mu0 0.1,0.5 --tolerance 1e-5 --json\n  stratiform \
                  solve --phase hg:0.85 --tau 5 --mu0 0.5 --view-mu 1,0.5 --phi 0,90,180 --tolerance 1e-4\n\
                  The columns std_error hold the estimated absolute error; exit code 1 if it cannot be brought below \
                  --tolerance."
)]
pub struct SolveArgs {
    /// What light goes through.
    #[command(flatten)]
    pub medium: MediumArgs,
    /// Slabs and suns.
    #[command(flatten)]
    pub slab: SlabArgs,
    /// Radiance instead of fluxes.
    #[command(flatten)]
    pub views: ViewArgs,
    /// Orders listed one by one, at most 60 (2 for radiance); the rest is the tail.
    #[arg(long, default_value_t = 2)]
    pub orders: u32,
    /// Largest absolute error allowed, from 1e-12; default 1e-6. For radiance: relative above 1, from 2e-8, default 1e-3.
    #[arg(long, value_parser = finite)]
    pub tolerance: Option<f64>,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
