//! `optics/quadrature.csv`: how the error of the size average falls with radii and with seconds.

use super::optics::optics_error;
use crate::CliError;
use crate::config::Config;
use std::path::Path;
use std::time::Instant;
use stratiform_artifact::{QuadratureRow, ReachedError, write_csv};
use stratiform_optics::OpticsError;
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, refine};
use stratiform_optics::phase::PhaseTable;

/// Refines the average at the transport's wavelength up to `most_radii`, whatever error that reaches.
///
/// # Errors
/// [`CliError::Input`] for numbers out of domain or a file that cannot be written.
pub fn write(config: &Config, most_radii: u64, dir: &Path) -> Result<Vec<String>, CliError> {
    let droplets = config.optics.resolve().map_err(optics_error)?;
    let wavelength_um = config.transport.wavelength_um;
    let spec = EnsembleSpec {
        droplets: &droplets,
        number_density_per_cm3: config.optics.number_density_per_cm3,
        wavelength_um,
        refractive_index: config.optics.refractive_index.at(wavelength_um).map_err(optics_error)?,
        theta_f_deg: config.optics.theta_f_deg,
        tolerance: unreachable(most_radii),
    };
    let start = Instant::now();
    let mut rows = Vec::new();
    let progress = |reached: &ReachedError, _: &PhaseTable| rows.push(row(wavelength_um, start, reached));
    match refine(&spec, progress) {
        Ok(_) | Err(OpticsError::NotConverged { .. }) => {}
        Err(other) => return Err(optics_error(other)),
    }
    let path = dir.join("optics/quadrature.csv");
    if rows.is_empty() {
        // Droplets of one size need no quadrature, and another cloud's must not stay.
        let _ = std::fs::remove_file(path);
        return Ok(Vec::new());
    }
    write_csv(&path, &rows)?;
    Ok(vec!["optics/quadrature.csv".to_owned()])
}

/// A tolerance that only the number of radii ends.
fn unreachable(most_radii: u64) -> QuadratureTolerance {
    const NEVER: f64 = 1e-12;
    QuadratureTolerance {
        asymmetry: NEVER,
        forward_fraction: NEVER,
        moments: NEVER,
        phase_below_60_deg: NEVER,
        phase_beyond_60_deg: NEVER,
        most_radii,
    }
}

fn row(wavelength_um: f64, start: Instant, reached: &ReachedError) -> QuadratureRow {
    QuadratureRow {
        wavelength_um,
        radii: reached.radii,
        seconds: start.elapsed().as_secs_f64(),
        asymmetry: reached.asymmetry,
        forward_fraction: reached.forward_fraction,
        moments: reached.moments,
        phase_below_60_deg: reached.phase_below_60_deg,
        phase_beyond_60_deg: reached.phase_beyond_60_deg,
    }
}
