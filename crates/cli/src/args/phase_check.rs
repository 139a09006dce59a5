//! `stratiform phase-check` as typed.

use crate::numbers::finite;
use clap::{ArgGroup, Args, ValueEnum};
use std::path::PathBuf;

/// What a table's values integrate to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Convention {
    /// Mean 1 over the sphere, as everywhere in this program.
    MeanOne,
    /// Integral over solid angle 1: a density per steradian.
    PerSteradian,
    /// Integral over the cosine 1.
    PerCosine,
}

/// `stratiform phase-check`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true,
    group = ArgGroup::new("subject").args(["file", "hg", "two_lobe", "draine"]).required(true),
    after_help = "Examples:\n  stratiform phase-check table.csv\n  \
                  stratiform phase-check mieplot.txt --file-wavelength 0.55 --config fit-configs/appendix-b.toml\n  \
                  stratiform phase-check --hg 0.85 --r-eff 7 --gamma 2 --wavelength 0.55 --json\n\
                  FILE: columns of angle (degrees, radians or cosines) and value, with or without header; MiePlot's text; \
                  Legendre coefficients of SHDOM's make_mie_table or libRadtran's mie; or \
                  constants in a file .toml or .json with the keys henyey_greenstein = G, blend = { w, g1, g2, alpha }, asymmetry, \
                  forward_fraction, extinction_per_m.\n\
                  Without droplets: unit, sign, normalisation, sampling, integral. With droplets also, against Mie: forward \
                  peak, P_f, g, shape beyond theta_f, fogbow, glory.\n\
                  Bounds: integral 1e-3; sampling 0.5 % of light misplaced between rows, 1 % between trapezoids in the cosine and P \
                  linear in the angle; g and P_f 2 % of 1-g and 1-P_f; shape 2 % of the light; P(0), glory and the bow's contrast 10 %; \
                  its angle 1 degree; extinction 2 %. What is out of bounds because something else is wrong is marked `follows`.\n\
                  Exit codes: 0 nothing wrong; 1 something is; 2 the file cannot be read, or misuse.")]
pub struct PhaseCheckArgs {
    /// A phase table, or constants (.toml, .json).
    pub file: Option<PathBuf>,
    /// A Henyey-Greenstein function instead of a file.
    #[arg(long, value_parser = finite, value_name = "G")]
    pub hg: Option<f64>,
    /// (1-W) HG(G1) + W HG(G2) instead of a file.
    #[arg(long, value_delimiter = ',', value_parser = finite, num_args = 1, value_name = "W,G1,G2")]
    pub two_lobe: Vec<f64>,
    /// (1-W) HG(G1) + W Draine(G2, ALPHA) instead of a file.
    #[arg(long, value_delimiter = ',', value_parser = finite, num_args = 1, value_name = "W,G1,G2,ALPHA")]
    pub draine: Vec<f64>,
    /// Column of FILE that holds the value, where there are several: its name, or its number from 1.
    #[arg(long, value_name = "NAME", requires = "file")]
    pub column: Option<String>,
    /// Wavelength of the rows of FILE to take, as it stands there.
    #[arg(long, value_parser = finite, value_name = "LAMBDA", requires = "file")]
    pub file_wavelength: Option<f64>,
    /// Effective radius of the Legendre coefficients of FILE to take, as it stands there.
    #[arg(long, value_parser = finite, value_name = "RADIUS", requires = "file")]
    pub file_r_eff: Option<f64>,
    /// What the values are meant to integrate to.
    #[arg(long, value_enum, default_value = "mean-one")]
    pub normalisation: Convention,
    /// Write the table with unit, sign and normalisation undone, columns theta_deg,p, mean 1.
    #[arg(long, value_name = "OUT", requires = "file")]
    pub repaired: Option<PathBuf>,
    /// Droplets, index and theta_f of this config; its transport's wavelength unless --wavelength says another.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["r_eff", "gamma", "n0"])]
    pub config: Option<PathBuf>,
    /// Effective radius in µm of a modified gamma distribution.
    #[arg(long, value_parser = finite, requires_all = ["gamma", "wavelength"])]
    pub r_eff: Option<f64>,
    /// Shape γ of the modified gamma distribution; effective variance 1/(γ+2).
    #[arg(long, value_parser = finite, requires = "r_eff")]
    pub gamma: Option<f64>,
    /// Droplets per cm³; only an extinction coefficient needs them.
    #[arg(long, value_parser = finite, requires = "r_eff")]
    pub n0: Option<f64>,
    /// Wavelength in µm.
    #[arg(long, value_parser = finite)]
    pub wavelength: Option<f64>,
    /// θ_f in degrees; default 5, or the config's.
    #[arg(long, value_parser = finite, value_name = "DEG")]
    pub theta_f: Option<f64>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}
