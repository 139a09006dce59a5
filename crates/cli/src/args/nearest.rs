//! `stratiform nearest` as typed.

use crate::numbers::finite;
use clap::Args;

/// `stratiform nearest`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform nearest --phase config:fit-configs/appendix-b.toml --diameter 20\n  stratiform nearest \
                  --phase table:phase.csv --json\nAll have the form P = (1-w) HG(g1) + w Draine(g2, alpha). Each row says by what it was \
                  fitted and what it does to g, P_f, the backward share, the peak (0 degrees), the fogbow (where the table has it) and the glory \
                  (180 degrees); ratios are its value over the table's.\nWith mu = cos(angle) and mean 1 over the sphere (divide by 4 pi for \
                  the density per steradian):\n  HG(g) = (1-g^2) / (1+g^2-2 g mu)^1.5\n  Draine(g, a) = HG(g) (1+a mu^2) / \
                  (1+a (1+2 g^2)/3)"
)]
pub struct NearestArgs {
    /// moments:FILE | table:FILE | config:FILE (at the config's transport wavelength).
    #[arg(long, value_name = "PHASE")]
    pub phase: String,
    /// Divide a phase table by its norm even if that is off by more than 1e-3.
    #[arg(long)]
    pub renormalise: bool,
    /// θ_f of P_f in degrees.
    #[arg(long, value_parser = finite, default_value = "5", value_name = "DEG")]
    pub theta_f: f64,
    /// Droplet diameter in µm for the closed form of Jendersie and d'Eon 2023, besides the one that suits best.
    #[arg(long, value_parser = finite, value_name = "UM")]
    pub diameter: Option<f64>,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
