//! What the optics of one cloud depends on, as a section of configs.

use crate::OpticsError;
use crate::droplets::{DropletDistribution, SizeDistribution};
use crate::ensemble::QuadratureTolerance;
use crate::mie::RefractiveIndex;
use crate::water::IndexSource;
use serde::{Deserialize, Serialize};
use stratiform_artifact::{ArtifactError, hash_of, read_text};
use stratiform_quantities::Range;

/// Changes whenever the same config gives other numbers: part of every hash, so that no cache hands out what an earlier
/// program computed. `tests/paper_cloud.rs` fails if numbers change without it.
const REVISION: u32 = 3;

/// Droplets, wavelengths, θ_f, and the error to reach.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpticsConfig {
    /// N(r)/N0.
    pub droplets: DropletDistribution,
    /// N0.
    pub number_density_per_cm3: f64,
    /// λ, each once.
    pub wavelengths_um: Vec<f64>,
    /// `"hale-querry-1973"`, `"segelstein-1981"` or `[n, k]`.
    #[serde(default)]
    pub refractive_index: IndexSource,
    /// θ_f.
    #[serde(default = "paper_theta_f")]
    pub theta_f_deg: f64,
    /// The error of the radius quadrature.
    #[serde(default)]
    pub tolerance: QuadratureTolerance,
}

/// 5°, as in Bouthors, Neyret & Lefebvre 2006, section 4.1.
fn paper_theta_f() -> f64 {
    5.0
}

impl OpticsConfig {
    /// Checks every number and reads the droplets' file if there is one.
    ///
    /// # Errors
    /// [`OpticsError`] naming the key, its value and its range.
    pub fn resolve(&self) -> Result<SizeDistribution, OpticsError> {
        Range::closed(1e-6, 1e9).check("number_density_per_cm3", self.number_density_per_cm3)?;
        Range::open(0.0, 90.0).check("theta_f_deg", self.theta_f_deg)?;
        self.tolerance.check()?;
        if self.wavelengths_um.is_empty() {
            return Err(OpticsError::Config("wavelengths_um is empty: give at least one".to_owned()));
        }
        for (i, wavelength) in self.wavelengths_um.iter().enumerate() {
            Range::closed(0.05, 100.0).check("wavelengths_um", *wavelength)?;
            if self.wavelengths_um[..i].contains(wavelength) {
                return Err(OpticsError::Config(format!("wavelengths_um lists {wavelength} twice")));
            }
            let [n, k] = self.refractive_index.at(*wavelength)?;
            RefractiveIndex::new(n, k)?;
        }
        self.droplets.resolve()
    }

    /// Hash of everything the results depend on: this config, and the content, not the path, of the droplets' file.
    ///
    /// # Errors
    /// [`ArtifactError`] if that file cannot be read.
    pub fn input_hash(&self) -> Result<String, ArtifactError> {
        let (droplets, file) = match &self.droplets {
            DropletDistribution::Tabulated { file } => (None, Some(read_text(file)?)),
            law => (Some(law), None),
        };
        let rest = (self.number_density_per_cm3, &self.wavelengths_um, &self.refractive_index);
        Ok(hash_of(&("stratiform/optics", REVISION, droplets, file, rest, self.theta_f_deg, &self.tolerance)))
    }
}
