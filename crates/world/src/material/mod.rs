//! What the cloud consists of.

mod load;

use std::path::PathBuf;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::ExtinctionConvention;

/// The droplets' optics, one extinction for all three channels.
#[derive(Clone, Debug)]
pub struct Material {
    /// Where the generated text stands: `stratiform*.wgsl`.
    pub generated: PathBuf,
    /// κ of the full medium, 1/m.
    pub extinction_per_m: f64,
    /// By which convention.
    pub extinction_convention: ExtinctionConvention,
    /// ω.
    pub single_scattering_albedo: f64,
    /// g.
    pub asymmetry: f64,
    /// θ_f, degrees.
    pub theta_f_deg: f64,
    /// P_f at the tables' wavelength.
    pub forward_fraction: f64,
    /// P at the wavelength of the tables.
    pub phase: PhaseTable,
    /// P in linear sRGB.
    pub colour: [PhaseTable; 3],
    /// P² in linear sRGB.
    pub colour_squared: [PhaseTable; 3],
}
