//! The fluxes of a reproduced folder on the CPU, in f64: what `stratiform.wgsl` of the same folder gives on the device.

use super::RadiosityError;
use crate::parameters::{angles, values};
use std::path::Path;
use stratiform_artifact::{ParametersDocument, read_json};
use stratiform_model::table::ParameterGrid;
use stratiform_model::{Fluxes, Form, Parameters, Thickness};
use stratiform_quantities::Incidence;

/// Fluxes of a slab by the fitted parameters, per optical thickness.
#[derive(Clone, Debug)]
pub struct Slab {
    grid: ParameterGrid<f64>,
    diffuse: Parameters<f64>,
}

impl Slab {
    /// From `parameters.json` of a folder.
    ///
    /// # Errors
    /// [`RadiosityError::Artifact`] if the file is missing or malformed, [`RadiosityError::Model`] for parameters out of domain,
    /// [`RadiosityError::Contents`] without a row of diffuse light.
    pub fn load(folder: &Path) -> Result<Self, RadiosityError> {
        let path = folder.join("parameters.json");
        let document: ParametersDocument = read_json(&path)?;
        let table = &document.optical;
        let diffuse = table.rows.iter().find(|row| row.theta_l_deg.degrees().is_none());
        let missing = || RadiosityError::Contents(format!("{}: no row of diffuse light", path.display()));
        let diffuse = values(table, diffuse.ok_or_else(missing)?);
        Ok(Self {
            grid: ParameterGrid::new(&angles(table))?,
            diffuse: Parameters::new(&diffuse, Incidence::Diffuse)?,
        })
    }

    /// Lit by a beam.
    ///
    /// # Errors
    /// [`RadiosityError::Model`] for μ_l outside the table, or τ outside \[0, 1e6\].
    pub fn beam(&self, mu_l: f64, tau: f64) -> Result<Fluxes<f64>, RadiosityError> {
        Ok(self.grid.at(mu_l)?.fluxes(Form::Corrected, Thickness::new(tau)?))
    }

    /// Lit by uniform light.
    ///
    /// # Errors
    /// [`RadiosityError::Model`] for τ outside \[0, 1e6\].
    pub fn diffuse(&self, tau: f64) -> Result<Fluxes<f64>, RadiosityError> {
        Ok(self.diffuse.fluxes(Form::Corrected, Thickness::new(tau)?))
    }
}
