//! Clouds in red, green and blue.

use super::{input_error, optics};
use crate::CliError;
use stratiform_chart::errors::WAVELENGTHS_UM;
use stratiform_methods::Cloud;
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_quantities::SingleScatteringAlbedo;

/// γ of the droplets of the adviser's data, as in Bouthors, Neyret & Lefebvre 2006.
const GAMMA: f64 = 2.0;

/// Droplets of that effective radius at the three wavelengths, without absorption.
///
/// # Errors
/// As [`optics::ensembles`].
pub fn clouds(effective_radius_um: f64) -> Result<[Cloud; 3], CliError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: GAMMA, effective_radius_um },
        number_density_per_cm3: 300.0,
        wavelengths_um: WAVELENGTHS_UM.to_vec(),
        refractive_index: Default::default(),
        theta_f_deg: 5.0,
        tolerance: Default::default(),
    };
    let omega = SingleScatteringAlbedo::new(1.0)?;
    let cloud = |one: stratiform_optics::ensemble::Ensemble| {
        Cloud::new(one.phase, omega, config.theta_f_deg, Some(effective_radius_um)).map_err(input_error)
    };
    let made = optics::ensembles(&config)?.into_iter().map(cloud).collect::<Result<Vec<_>, _>>()?;
    made.try_into().map_err(|_| CliError::Failed("the optics have not three wavelengths".to_owned()))
}
