//! The optics stage, and the one wavelength that is traced.

use crate::CliError;
use crate::config::Config;
use std::path::{Path, PathBuf};
use stratiform_artifact::{OpticsDocument, WavelengthOptics, read_json, write_csv};
use stratiform_optics::phase::{Norm, PhaseRow, PhaseTable};
use stratiform_optics::{OpticsError, ensemble::Ensemble, mie};
use stratiform_quantities::{ExtinctionConvention, SingleScatteringAlbedo};

/// What the transport needs to know of a cloud.
#[derive(Clone, Debug)]
pub struct Cloud {
    /// P of the full medium.
    pub phase: PhaseTable,
    /// ω.
    pub omega: SingleScatteringAlbedo,
    /// κ in the config's convention, 1/m.
    pub extinction_per_m: f64,
    /// g.
    pub asymmetry: f64,
    /// P_f.
    pub forward_fraction: f64,
}

impl Cloud {
    /// Optical thicknesses of the fit's grid.
    pub fn tau(&self, config: &Config) -> Vec<f64> {
        config.fit.thickness_m.metres().iter().map(|h| h * self.extinction_per_m).collect()
    }
}

/// Where computed optics are kept between runs: `STRATIFORM_CACHE`, or the user's cache folder. An empty
/// `STRATIFORM_CACHE` switches the cache off.
pub fn cache_folder() -> Option<PathBuf> {
    let set = |name: &str| std::env::var_os(name).map(PathBuf::from);
    match set("STRATIFORM_CACHE") {
        Some(folder) if folder.as_os_str().is_empty() => None,
        Some(folder) => Some(folder),
        None => set("XDG_CACHE_HOME")
            .or_else(|| set("HOME").map(|home| home.join(".cache")))
            .map(|folder| folder.join("stratiform")),
    }
}

/// Computes the optics, or takes them from the cache.
///
/// # Errors
/// [`CliError::Input`] for numbers out of domain, [`CliError::Failed`] if the error asked for is not reached.
pub fn ensembles(config: &stratiform_optics::OpticsConfig) -> Result<Vec<Ensemble>, CliError> {
    let cached = cache_folder().map(|folder| stratiform_optics::load_or_compute(config, &folder));
    match cached {
        // A cache that cannot be read or written is no reason to stop.
        None | Some(Err(OpticsError::Artifact(_))) => stratiform_optics::compute(config),
        Some(result) => result,
    }
    .map_err(optics_error)
}

/// A tolerance that is not met is no bad input.
pub fn optics_error(error: OpticsError) -> CliError {
    match error {
        OpticsError::NotConverged { .. } => CliError::Failed(error.to_string()),
        other => CliError::Input(other.to_string()),
    }
}

/// The ensemble that is traced, without a folder.
///
/// # Errors
/// As [`ensembles`].
pub fn at_transport_wavelength(config: &Config) -> Result<Cloud, CliError> {
    let all = ensembles(&config.optics)?;
    let wavelength = config.transport.wavelength_um;
    let one = all.into_iter().find(|e| e.wavelength_um == wavelength).ok_or_else(|| missing(wavelength))?;
    of_ensemble(config, one)
}

/// What the transport needs of an ensemble.
///
/// # Errors
/// [`CliError::Input`] for an albedo out of domain.
pub fn of_ensemble(config: &Config, one: Ensemble) -> Result<Cloud, CliError> {
    let extinction = [one.extinction.paper, one.extinction.mie];
    cloud(config, one.phase, one.single_scattering_albedo, extinction, [one.asymmetry, one.forward_fraction])
}

fn missing(wavelength: f64) -> CliError {
    CliError::Input(format!("wavelength_um = {wavelength} is not one of the optics' wavelengths"))
}

fn cloud(
    config: &Config,
    phase: PhaseTable,
    omega: f64,
    [paper, mie]: [f64; 2],
    [asymmetry, forward_fraction]: [f64; 2],
) -> Result<Cloud, CliError> {
    let extinction_per_m = match config.transport.extinction_convention {
        ExtinctionConvention::Paper => paper,
        ExtinctionConvention::Mie => mie,
    };
    let omega = match config.transport.single_scattering_albedo {
        Some(omega) => omega,
        None => SingleScatteringAlbedo::new(omega)?,
    };
    Ok(Cloud { phase, omega, extinction_per_m, asymmetry, forward_fraction })
}

/// Runs the stage: writes `optics/` under `dir` and returns the files.
///
/// # Errors
/// As [`ensembles`], and [`CliError::Input`] if a file cannot be written.
pub fn write(config: &Config, dir: &Path) -> Result<Vec<String>, CliError> {
    let folder = dir.join("optics");
    stratiform_artifact::create_folder(&folder)?;
    let document = stratiform_optics::write(&config.optics, &ensembles(&config.optics)?, &folder)
        .map_err(optics_error)?;
    write_sphere(config, &folder)?;
    let mut files = vec!["optics/optics.json".to_owned(), "optics/sphere.csv".to_owned()];
    for w in &document.wavelengths {
        files.extend(
            [&w.phase_csv, &w.modified_phase_csv, &w.moments_csv].map(|file| format!("optics/{file}")),
        );
    }
    Ok(files)
}

/// Radius of the single droplet that is drawn beside the cloud's phase functions, µm (the paper's figure 4).
const SPHERE_RADIUS_UM: f64 = 20.0;

/// `sphere.csv`: P of one droplet, whose ripples the size distribution smooths away.
fn write_sphere(config: &Config, folder: &Path) -> Result<(), CliError> {
    let wavelength = config.transport.wavelength_um;
    let index = config.optics.refractive_index.at(wavelength).map_err(optics_error)?;
    let x = 2.0 * std::f64::consts::PI * SPHERE_RADIUS_UM / wavelength;
    let angles: Vec<f64> = (0..=1800).map(|i| f64::from(i) / 10.0).collect();
    let sphere = mie::scatter(x, index, &angles)?;
    let scale = 4.0 / (x * x * sphere.efficiencies.q_sca);
    let rows: Vec<_> = angles
        .iter()
        .zip(&sphere.amplitudes)
        .map(|(theta_deg, amplitudes)| PhaseRow { theta_deg: *theta_deg, p: scale * amplitudes.intensity() })
        .collect();
    Ok(write_csv(&folder.join("sphere.csv"), &rows)?)
}

/// Reads what the stage wrote.
///
/// # Errors
/// [`CliError::Input`] naming the file that is missing or damaged.
pub fn read(config: &Config, dir: &Path) -> Result<(OpticsDocument, Cloud), CliError> {
    let folder = dir.join("optics");
    let document: OpticsDocument = read_json(&folder.join("optics.json"))?;
    let wavelength = config.transport.wavelength_um;
    let one: &WavelengthOptics = document
        .wavelengths
        .iter()
        .find(|w| w.wavelength_um == wavelength)
        .ok_or_else(|| missing(wavelength))?;
    let phase = PhaseTable::read(&folder.join(&one.phase_csv), Norm::Strict).map_err(optics_error)?;
    let extinction = [one.extinction_per_m.paper, one.extinction_per_m.mie];
    let numbers = [one.asymmetry, one.forward_fraction.value];
    let cloud = cloud(config, phase, one.single_scattering_albedo, extinction, numbers)?;
    Ok((document, cloud))
}
