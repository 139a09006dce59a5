//! Results kept on disk under the hash of their inputs.
//!
//! Every wavelength has an entry of its own, so that stages share them. An entry is a line with the hash of the rest, then JSON. Whatever does not read back whole (cut short, edited,
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

/// [`compute`], but for the wavelengths whose results of the same inputs `folder` holds.
///
/// # Errors
/// As [`compute`], and if `folder` cannot be written.
pub fn load_or_compute(config: &OpticsConfig, folder: &Path) -> Result<Vec<Ensemble>, OpticsError> {
    config.resolve()?;
    let at = |wavelengths_um: Vec<f64>| OpticsConfig { wavelengths_um, ..config.clone() };
    let path =
        |wavelength: &f64| Ok(folder.join(format!("optics-{}.json", at(vec![*wavelength]).input_hash()?)));
    let paths = config.wavelengths_um.iter().map(path).collect::<Result<Vec<_>, OpticsError>>()?;
    let kept: Vec<Option<Ensemble>> = paths.iter().map(|path| load(path)).collect();
    let missing = config.wavelengths_um.iter().zip(&kept).filter(|(_, kept)| kept.is_none());
    let missing: Vec<f64> = missing.map(|(wavelength, _)| *wavelength).collect();
    if missing.is_empty() {
        return Ok(kept.into_iter().flatten().collect());
    }
    let mut computed = compute(&at(missing))?.into_iter();
    create_folder(folder)?;
    let mut ensembles = Vec::with_capacity(kept.len());
    for (path, kept) in paths.iter().zip(kept) {
        let new = if kept.is_none() { computed.next() } else { None };
        if let Some(one) = &new {
            store(path, one)?;
        }
        ensembles.extend(kept.or(new));
    }
    Ok(ensembles)
}

fn load(path: &Path) -> Option<Ensemble> {
    let text = std::fs::read_to_string(path).ok()?;
    let (hash, body) = text.split_once('\n')?;
    if hash != hash_bytes(body.as_bytes()) {
        return None;
    }
    serde_json::from_str::<Entry>(body).ok()?.restore()
}

fn store(path: &Path, ensemble: &Ensemble) -> Result<(), ArtifactError> {
    let body = serde_json::to_string(&Entry::of(ensemble))
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
