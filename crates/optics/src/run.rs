//! The optics stage: config in, averages and their files out.

use crate::OpticsError;
use crate::config::OpticsConfig;
use crate::droplets::SizeDistribution;
use crate::ensemble::{Ensemble, EnsembleSpec, ensemble};
use crate::phase::PhaseFunction;
use rayon::prelude::*;
use std::path::Path;
use stratiform_artifact::{
    ForwardFraction, OpticsDocument, Provenance, SizeDensity, WavelengthOptics, create_folder, write_atomic,
    write_csv, write_json,
};

/// Radii at which `optics.json` samples N(r).
const SIZE_SAMPLES: usize = 200;

/// χ_l below this are not written.
const SMALLEST_MOMENT: f64 = 1e-6;

/// The averages at every wavelength, in the config's order. Wavelengths share the threads, and no number depends on how many
/// there are.
///
/// # Errors
/// [`OpticsError`] for what the config gets wrong, or a quadrature that does not converge.
pub fn compute(config: &OpticsConfig) -> Result<Vec<Ensemble>, OpticsError> {
    let droplets = config.resolve()?;
    let one = |wavelength_um: &f64| {
        ensemble(&EnsembleSpec {
            droplets: &droplets,
            number_density_per_cm3: config.number_density_per_cm3,
            wavelength_um: *wavelength_um,
            refractive_index: config.refractive_index.at(*wavelength_um)?,
            theta_f_deg: config.theta_f_deg,
            tolerance: config.tolerance,
        })
    };
    // The first error in the config's order is the one told.
    let all: Vec<Result<Ensemble, OpticsError>> = config.wavelengths_um.par_iter().map(one).collect();
    all.into_iter().collect()
}

/// Writes `optics.json`, and per wavelength P, P_S and the moments, into `folder`; the document comes last.
///
/// # Errors
/// [`OpticsError`] if a file cannot be written.
pub fn write(
    config: &OpticsConfig,
    ensembles: &[Ensemble],
    folder: &Path,
) -> Result<OpticsDocument, OpticsError> {
    create_folder(folder)?;
    let droplets = config.resolve()?;
    let wavelengths =
        ensembles.iter().map(|one| write_wavelength(one, folder)).collect::<Result<Vec<_>, _>>()?;
    let document = OpticsDocument {
        schema: OpticsDocument::SCHEMA.to_owned(),
        provenance: Provenance::new(config.input_hash()?, None, "Mie theory averaged over the droplet sizes"),
        droplets: droplets.words().to_owned(),
        effective_radius_um: droplets.effective_radius(),
        effective_variance: droplets.effective_variance(),
        number_density_per_cm3: config.number_density_per_cm3,
        size_density: size_density(&droplets, config.number_density_per_cm3),
        wavelengths,
    };
    write_json(&folder.join("optics.json"), &document)?;
    Ok(document)
}

fn write_wavelength(one: &Ensemble, folder: &Path) -> Result<WavelengthOptics, OpticsError> {
    let name = |kind: &str| format!("{kind}_{}um.csv", one.wavelength_um);
    let [phase_csv, modified_phase_csv, moments_csv] = ["phase", "modified_phase", "moments"].map(name);
    write_csv(&folder.join(&phase_csv), &one.phase.rows())?;
    write_csv(&folder.join(&modified_phase_csv), &one.phase.modified(one.theta_f_deg)?.rows())?;
    let moments: String = significant_moments(one).iter().map(|chi| format!("{chi}\n")).collect();
    write_atomic(&folder.join(&moments_csv), moments.as_bytes())?;
    Ok(WavelengthOptics {
        wavelength_um: one.wavelength_um,
        refractive_index: one.refractive_index,
        extinction_per_m: one.extinction,
        single_scattering_albedo: one.single_scattering_albedo,
        asymmetry: one.asymmetry,
        forward_fraction: ForwardFraction { theta_f_deg: one.theta_f_deg, value: one.forward_fraction },
        reached_error: one.reached,
        phase_csv,
        modified_phase_csv,
        moments_csv,
    })
}

/// χ_l up to the last that matters; the first is 1 exactly.
fn significant_moments(one: &Ensemble) -> Vec<f64> {
    const MOST: usize = 1 << 15;
    let mut count = 1024;
    let mut moments = one.phase.moments(count);
    while count < MOST && moments[count - count / 8..].iter().any(|chi| chi.abs() > SMALLEST_MOMENT) {
        count *= 2;
        moments = one.phase.moments(count);
    }
    let last = moments.iter().rposition(|chi| chi.abs() > SMALLEST_MOMENT).unwrap_or(0);
    moments.truncate(last + 1);
    moments[0] = 1.0;
    moments
}

fn size_density(droplets: &SizeDistribution, number: f64) -> SizeDensity {
    if let Some(radius) = droplets.single_radius() {
        // A single size has no density; its number stands at its radius.
        return SizeDensity { radius_um: vec![radius], number_per_cm3_um: vec![number] };
    }
    let [low, high] = droplets.scattering_range();
    let radius_um: Vec<f64> =
        (0..SIZE_SAMPLES).map(|i| low + (high - low) * i as f64 / (SIZE_SAMPLES - 1) as f64).collect();
    let number_per_cm3_um = radius_um.iter().map(|r| number * droplets.density(*r)).collect();
    SizeDensity { radius_um, number_per_cm3_um }
}
