//! What is traced: full and modified medium at every incidence of the table, or half-way between.

use super::fluxes::{MAX_ORDER, light};
use super::optics::Cloud;
use crate::CliError;
use crate::config::Config;
use crate::interrupt;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stratiform_artifact::RowIncidence;
use stratiform_optics::phase::Modified;
use stratiform_quantities::{Incidence, Medium};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest, TransportError};

/// Both media, ready to be traced.
pub struct Media {
    full: TraceMedium,
    modified: TraceMedium,
}

impl Media {
    /// The media of `cloud`, modified at θ_f of the config.
    ///
    /// # Errors
    /// [`CliError::Input`] if θ_f or ω is out of domain.
    pub fn new(config: &Config, cloud: &Cloud) -> Result<Self, CliError> {
        let phase = Arc::new(cloud.phase.clone());
        let modified = Modified::new(phase.clone(), config.optics.theta_f_deg)?;
        let forward_fraction = modified.forward_fraction();
        Ok(Self {
            full: TraceMedium::full(phase, cloud.omega),
            modified: TraceMedium::modified(Arc::new(modified), cloud.omega, forward_fraction)
                .map_err(super::trace_error)?,
        })
    }

    /// One of them.
    pub fn get(&self, medium: Medium) -> &TraceMedium {
        match medium {
            Medium::Full => &self.full,
            Medium::Modified => &self.modified,
        }
    }
}

/// What was traced in both media at one incidence.
pub struct AtIncidence<T> {
    /// Angle or diffuse.
    pub row: RowIncidence,
    full: T,
    modified: T,
}

impl<T> AtIncidence<T> {
    /// One medium's result.
    pub fn get(&self, medium: Medium) -> &T {
        match medium {
            Medium::Full => &self.full,
            Medium::Modified => &self.modified,
        }
    }
}

/// What is traced: everything that the photons depend on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Plan {
    /// Angles and `diffuse`.
    pub rows: Vec<RowIncidence>,
    /// Optical thicknesses of the full medium.
    pub tau: Vec<f64>,
    /// Photons per incidence and medium.
    pub photons: u64,
    /// Seed.
    pub seed: u64,
}

impl Plan {
    /// The table's incidences.
    pub fn nodes(config: &Config, cloud: &Cloud, photons: u64, seed: u64) -> Self {
        Self { rows: super::fluxes::nodes(config), tau: cloud.tau(config), photons, seed }
    }

    /// The angles half-way between.
    pub fn between(config: &Config, cloud: &Cloud, photons: u64, seed: u64) -> Self {
        Self { rows: super::fluxes::between(config), ..Self::nodes(config, cloud, photons, seed) }
    }

    /// Histories altogether.
    pub fn histories(&self) -> u64 {
        2 * self.photons * self.rows.len() as u64
    }

    /// Traces every incidence and medium by `one`; `progress` sees the photons done so far.
    ///
    /// # Errors
    /// [`CliError::Interrupted`], or [`CliError::Input`] for numbers out of domain.
    pub fn trace<T>(
        &self,
        progress: &(dyn Fn(u64) + Sync),
        one: impl Fn(Medium, &TraceRequest, Control<'_>) -> Result<T, TransportError>,
    ) -> Result<Vec<AtIncidence<T>>, CliError> {
        let mut before = 0;
        let mut traced = Vec::new();
        for row in &self.rows {
            let incidence = light(row)?;
            let mut trace = |medium| {
                let advanced = |done: u64, _total: u64| progress(before + done);
                let watch = interrupt::watch();
                let control = super::control(&advanced, &watch);
                let result = one(medium, &self.request(incidence, medium), control);
                before += self.photons;
                result.map_err(super::trace_error)
            };
            let (full, modified) = (trace(Medium::Full)?, trace(Medium::Modified)?);
            traced.push(AtIncidence { row: row.clone(), full, modified });
        }
        Ok(traced)
    }

    fn request(&self, incidence: Incidence, medium: Medium) -> TraceRequest {
        TraceRequest {
            tau: self.tau.clone(),
            incidence,
            stop: Stop::Photons(self.photons),
            max_order: MAX_ORDER,
            seed: self.seed,
            stream: super::stream_of(incidence, medium),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_signal_is_looked_for_while_photons_fly() {
        let rows = vec![RowIncidence::Degrees(0.0), RowIncidence::diffuse()];
        let plan = Plan { rows, tau: vec![1.0], photons: 2, seed: 1 };
        let watched = |_, _: &TraceRequest, _: Control<'_>| Ok(interrupt::is_watched());
        for traced in plan.trace(&|_| (), watched).unwrap() {
            assert!(*traced.get(Medium::Full) && *traced.get(Medium::Modified));
        }
    }
}
