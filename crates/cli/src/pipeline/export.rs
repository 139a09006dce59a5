//! What is exported of a config: its cloud's phase functions, and the accepted parameters.

use super::optics::{ensembles, optics_error};
use super::{accepted, input_error};
use crate::CliError;
use crate::config::Config;
use std::path::Path;
use stratiform_artifact::{ParametersDocument, Provenance, read_json};
use stratiform_optics::ensemble::Ensemble;
use stratiform_tables::parameters::ParameterTexels;
use stratiform_tables::set::{About, Channel, ChannelMedium, PhaseSet};

/// The three phase functions at every wavelength of the config.
///
/// # Errors
/// As [`ensembles`], and [`CliError::Input`] if a function cannot be formed.
pub fn phase_set(config: &Config) -> Result<PhaseSet, CliError> {
    let ensembles = ensembles(&config.optics)?;
    let about = about(config, &ensembles)?;
    let full = ensembles.into_iter().map(|one| (Channel::WavelengthUm(one.wavelength_um), one.phase));
    PhaseSet::new(full.collect(), about).map_err(input_error)
}

/// The accepted parameters of the config at `path`; none if none were accepted yet, or another config's.
///
/// # Errors
/// [`CliError::Input`] naming a damaged file, or what is wrong with its rows.
pub fn accepted_parameters(config: &Config, path: &Path) -> Result<Option<ParameterTexels>, CliError> {
    let folder = path.parent().unwrap_or(Path::new(".")).join(&config.codegen.accepted);
    let file = folder.join(accepted::FILES[0]);
    if !file.exists() {
        return Ok(None);
    }
    let document: ParametersDocument = read_json(&file)?;
    if !accepted::belong(&document, config) {
        return Ok(None);
    }
    let place = |error| input_error(error).at(&file.display().to_string());
    ParameterTexels::new(&document).map(Some).map_err(place)
}

fn about(config: &Config, ensembles: &[Ensemble]) -> Result<About, CliError> {
    let optics = &config.optics;
    let droplets = optics.resolve().map_err(optics_error)?;
    let hash = optics.input_hash()?;
    Ok(About {
        title: config.title.clone(),
        droplets: droplets.words().to_owned(),
        effective_radius_um: droplets.effective_radius(),
        effective_variance: droplets.effective_variance(),
        number_density_per_cm3: optics.number_density_per_cm3,
        theta_f_deg: optics.theta_f_deg,
        medium: ensembles.iter().map(medium).collect(),
        provenance: Provenance::new(hash, None, "Mie theory averaged over the droplet sizes"),
    })
}

fn medium(one: &Ensemble) -> ChannelMedium {
    ChannelMedium {
        wavelength_um: one.wavelength_um,
        refractive_index: one.refractive_index,
        single_scattering_albedo: one.single_scattering_albedo,
        extinction_paper_per_m: one.extinction.paper,
        extinction_mie_per_m: one.extinction.mie,
        asymmetry: one.asymmetry,
        forward_fraction: one.forward_fraction,
    }
}
