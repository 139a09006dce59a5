//! The Monte Carlo reference of a fit: full and modified medium at every incidence of the table, or half-way between.

use super::fluxes::{Covariance, IncidenceFluxes, MAX_ORDER, Referred, light};
use super::optics::Cloud;
use crate::CliError;
use crate::config::Config;
use crate::interrupt;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stratiform_artifact::RowIncidence;
use stratiform_fit::Reference;
use stratiform_optics::phase::Modified;
use stratiform_quantities::{Medium, Order};
use stratiform_transport::{Control, Quantity, Stop, TraceMedium, TraceRequest, Traced};

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

/// Both media traced at one incidence.
pub struct TracedIncidence {
    /// Angle or diffuse.
    pub row: RowIncidence,
    full: Traced,
    modified: Traced,
}

impl TracedIncidence {
    /// One medium's result.
    pub fn get(&self, medium: Medium) -> &Traced {
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

    /// Traces everything; `control` sees the photons of one incidence and medium at a time.
    ///
    /// # Errors
    /// [`CliError::Interrupted`], or [`CliError::Input`] for numbers out of domain.
    pub fn trace(
        &self,
        media: &Media,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Vec<TracedIncidence>, CliError> {
        let mut before = 0;
        let mut traced = Vec::new();
        for row in &self.rows {
            let mut one = |medium| {
                let advanced = |done: u64, _total: u64| progress(before + done);
                let result =
                    self.trace_one(media, row, medium, super::control(&advanced, &interrupt::watch()));
                before += self.photons;
                result
            };
            let (full, modified) = (one(Medium::Full)?, one(Medium::Modified)?);
            traced.push(TracedIncidence { row: row.clone(), full, modified });
        }
        Ok(traced)
    }

    fn trace_one(
        &self,
        media: &Media,
        row: &RowIncidence,
        medium: Medium,
        control: Control<'_>,
    ) -> Result<Traced, CliError> {
        let incidence = light(row)?;
        let request = TraceRequest {
            tau: self.tau.clone(),
            incidence,
            stop: Stop::Photons(self.photons),
            max_order: MAX_ORDER,
            seed: self.seed,
            stream: super::stream_of(incidence, medium),
        };
        stratiform_transport::trace_half_space(media.get(medium), &request, control)
            .map_err(super::trace_error)
    }
}

/// What the fit needs of one incidence.
pub fn fit_reference(config: &Config, traced: &TracedIncidence) -> Reference {
    referred(config, traced).reference
}

/// All that other stages need of one incidence; the covariance is that of batch means.
pub fn referred(config: &Config, traced: &TracedIncidence) -> Referred {
    let tau = traced.full.tau().to_vec();
    let estimates = |medium| {
        let one = traced.get(medium);
        let rows = |k| Order::rows(MAX_ORDER).map(move |order| one.estimate(k, order));
        (0..tau.len()).flat_map(rows).collect()
    };
    let (full, modified) = (estimates(Medium::Full), estimates(Medium::Modified));
    let all = |quantity| (0..tau.len()).map(move |k| (k, quantity)).collect::<Vec<_>>();
    let each = [
        Quantity::Transmittance(Order::Exactly(1)),
        Quantity::Transmittance(Order::Exactly(2)),
        Quantity::Reflectance(Order::Exactly(1)),
        Quantity::Reflectance(Order::Exactly(2)),
    ];
    let (totals, orders) =
        (traced.get(config.transport.totals_medium), traced.get(config.transport.orders_medium));
    let covariance = Covariance {
        t_ms: totals.covariance(&all(Quantity::Transmittance(Order::Total))).concat(),
        orders: orders.covariance(&each.into_iter().flat_map(all).collect::<Vec<_>>()).concat(),
    };
    IncidenceFluxes { row: traced.row.clone(), tau, full, modified }.referred(config, covariance)
}
