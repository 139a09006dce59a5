//! The phase functions in linear sRGB: what a renderer shades with.
//!
//! P at `[colour] wavelengths_um` of the config's droplets, and P_S convolved with itself at each, through the CIE
//! observer ([`stratiform_tables::colour`]), at the texels of [`PhaseColour`]. κ, ω and P_f stay those of the transport's
//! wavelength, which leaves out that droplets extinguish and send forward a little differently at others..

use super::{input_error, optics};
use crate::CliError;
use crate::config::{ColourConfig, Config};
use rayon::prelude::*;
use std::path::Path;
use stratiform_artifact::{PhaseColour, PhaseColourRow, create_folder};
use stratiform_optics::OpticsConfig;
use stratiform_optics::ensemble::Ensemble;
use stratiform_optics::phase::PhaseTable;
use stratiform_tables::colour::{SrgbPhase, srgb_phase};

/// The file, in the folder `accepted`.
pub const FILE: &str = "phase_colour.csv";

/// The droplets of `optics` at the wavelengths of `colour`.
pub fn optics(optics: &OpticsConfig, colour: &ColourConfig) -> OpticsConfig {
    OpticsConfig { wavelengths_um: colour.wavelengths_um.clone(), ..optics.clone() }
}

/// Runs the stage.
///
/// # Errors
/// As [`table`], and [`CliError::Input`] if the file cannot be written.
pub fn write(config: &Config, dir: &Path) -> Result<Vec<String>, CliError> {
    create_folder(&dir.join("accepted"))?;
    table(config)?.write(&dir.join("accepted").join(FILE))?;
    Ok(vec![format!("accepted/{FILE}")])
}

/// The cloud's phase functions in colour.
///
/// # Errors
/// [`CliError`] of the optics; [`CliError::Failed`] where a channel is negative: a colour that sRGB does not have.
pub fn table(config: &Config) -> Result<PhaseColour, CliError> {
    let ensembles = optics::ensembles(&optics(&config.optics, &config.colour))?;
    let [full, squared] = spectra(&ensembles)?.map(|spectrum| srgb_phase(&spectrum).map_err(input_error));
    let (full, squared) = (full?, squared?);
    for (name, colour) in [("P", &full), ("P_S * P_S", &squared)] {
        check_gamut(name, colour)?;
    }
    let row = |index| {
        let theta_deg = PhaseColour::theta_deg(index);
        let [p_red, p_green, p_blue] = full.at(theta_deg);
        let [squared_red, squared_green, squared_blue] = squared.at(theta_deg);
        PhaseColourRow { index, theta_deg, p_red, p_green, p_blue, squared_red, squared_green, squared_blue }
    };
    Ok(PhaseColour {
        config_hash: super::provenance(config).config_hash,
        wavelengths_um: config.colour.wavelengths_um.clone(),
        rows: (0..PhaseColour::TEXELS).map(row).collect(),
    })
}

type Spectrum = Vec<(f64, PhaseTable)>;

/// P, and P_S convolved with itself, by wavelength.
fn spectra(ensembles: &[Ensemble]) -> Result<[Spectrum; 2], CliError> {
    let squared = |one: &Ensemble| one.phase.modified(one.theta_f_deg)?.squared();
    let squares: Vec<_> = ensembles.par_iter().map(|one| (one.wavelength_um, squared(one))).collect();
    let squares =
        squares.into_iter().map(|(wavelength, table)| Ok((wavelength, table.map_err(input_error)?)));
    let full = ensembles.iter().map(|one| (one.wavelength_um, one.phase.clone())).collect();
    Ok([full, squares.collect::<Result<_, CliError>>()?])
}

fn check_gamut(name: &str, colour: &SrgbPhase) -> Result<(), CliError> {
    match colour.smallest_channel() {
        (smallest, theta_deg) if smallest < 0.0 => Err(CliError::Failed(format!(
            "colour: a channel of {name} is {smallest:.3e} at {theta_deg:.2} degrees: outside sRGB. Give more wavelengths in \
             [colour], or none: wavelengths_um = []"
        ))),
        _ => Ok(()),
    }
}
