//! What the cloud consists of.
//!
//! Colour is in the phase functions alone: κ, P_f and g are those of one wavelength (0.55 µm). Of the paper's cloud that leaves out,
//! from 0.47 to 0.63 µm: κ -0.6 to +0.6 % (physical extinction; the paper's has no colour); 1 - P_f -1.7 to +1.7 %, to
//! which order 1 of thick layers is proportional; 1 - g -1.8 to +2.1 %, to which the reflection of thin layers is. Real clouds are that much
//! redder in what they reflect and bluer in what they let through (`cargo run -p stratiform-cli --example colour_tables`).

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
    /// P in linear sRGB: red, green, blue.
    pub colour: [PhaseTable; 3],
    /// P_S convolved with itself on the sphere, of every wavelength's own P_S, likewise.
    pub colour_squared: [PhaseTable; 3],
}
