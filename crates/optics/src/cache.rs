//! Results kept on disk under the hash of their inputs.
//!
//! An entry is a line with the hash of the rest, then JSON. Whatever does not read back whole (cut short, edited,
//! of another version) is computed again and replaced; a cache folder that cannot be written is an error.

use crate::OpticsError;
use crate::config::OpticsConfig;
use crate::ensemble::Ensemble;
use crate::phase::{Norm, PhaseTable};
use crate::run::compute;
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{ArtifactError, Extinction, ReachedError, create_folder, hash_bytes, write_atomic};

/// An [`Ensemble`] as it is kept.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    wavelength_um: f64,
    refractive_index: [f64; 2],
    extinction: Extinction,
    single_scattering_albedo: f64,
    asymmetry: f64,
    theta_f_deg: f64,
    forward_fraction: f64,
    reached: ReachedError,
    theta_deg: Vec<f64>,
    p: Vec<f64>,
}

/// [`compute`], unless `folder` holds the results of the same inputs.
///
/// # Errors
/// As [`compute`], and if `folder` cannot be written.
pub fn load_or_compute(config: &OpticsConfig, folder: &Path) -> Result<Vec<Ensemble>, OpticsError> {
    config.resolve()?;
    let path = folder.join(format!("optics-{}.json", config.input_hash()?));
    if let Some(ensembles) = load(&path) {
        return Ok(ensembles);
    }
    let ensembles = compute(config)?;
    create_folder(folder)?;
    store(&path, &ensembles)?;
    Ok(ensembles)
}

fn load(path: &Path) -> Option<Vec<Ensemble>> {
    let text = std::fs::read_to_string(path).ok()?;
    let (hash, body) = text.split_once('\n')?;
    if hash != hash_bytes(body.as_bytes()) {
        return None;
    }
    let entries: Vec<Entry> = serde_json::from_str(body).ok()?;
    entries.into_iter().map(Entry::restore).collect()
}

fn store(path: &Path, ensembles: &[Ensemble]) -> Result<(), ArtifactError> {
    let entries: Vec<Entry> = ensembles.iter().map(Entry::of).collect();
    let body = serde_json::to_string(&entries)
        .map_err(|error| ArtifactError::format(path, None, error.to_string()))?;
    write_atomic(path, format!("{}\n{body}", hash_bytes(body.as_bytes())).as_bytes())
}

impl Entry {
    fn of(one: &Ensemble) -> Self {
        Self {
            wavelength_um: one.wavelength_um,
            refractive_index: one.refractive_index,
            extinction: one.extinction,
            single_scattering_albedo: one.single_scattering_albedo,
            asymmetry: one.asymmetry,
            theta_f_deg: one.theta_f_deg,
            forward_fraction: one.forward_fraction,
            reached: one.reached,
            theta_deg: one.phase.theta_deg().to_vec(),
            p: one.phase.values().to_vec(),
        }
    }

    fn restore(self) -> Option<Ensemble> {
        Some(Ensemble {
            wavelength_um: self.wavelength_um,
            refractive_index: self.refractive_index,
            extinction: self.extinction,
            single_scattering_albedo: self.single_scattering_albedo,
            asymmetry: self.asymmetry,
            theta_f_deg: self.theta_f_deg,
            forward_fraction: self.forward_fraction,
            reached: self.reached,
            phase: PhaseTable::new(self.theta_deg, self.p, Norm::Strict).ok()?,
        })
    }
}
