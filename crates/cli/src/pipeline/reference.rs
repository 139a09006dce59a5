//! The Monte Carlo reference of a fit: full and modified medium at every incidence of the table, and half-way between.

use super::optics::Cloud;
use crate::CliError;
use crate::config::Config;
use crate::interrupt;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stratiform_artifact::{OrdersRow, RowIncidence};
use stratiform_codegen::ReferencePoint;
use stratiform_fit::Reference;
use stratiform_model::table::cos_degrees;
use stratiform_optics::phase::Modified;
use stratiform_quantities::{Incidence, Medium, OpticalThickness, Order};
use stratiform_transport::{Control, Quantity, Stop, TraceMedium, TraceRequest, Traced, TransportError};

/// Largest order that the model describes by itself.
const MAX_ORDER: u32 = 2;

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
    pub fn nodes(config: &Config, cloud: &Cloud) -> Self {
        let transport = &config.transport;
        Self {
            rows: node_rows(config),
            tau: cloud.tau(config),
            photons: transport.photons,
            seed: transport.seed,
        }
    }

    /// The angles half-way between.
    pub fn between(config: &Config, cloud: &Cloud) -> Self {
        let middle = |pair: &[f64]| RowIncidence::Degrees(0.5 * (pair[0] + pair[1]));
        Self {
            rows: config.fit.theta_l_deg.windows(2).map(middle).collect(),
            photons: config.transport.photons_between,
            ..Self::nodes(config, cloud)
        }
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
                result.map_err(super::trace_error)
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
    ) -> Result<Traced, TransportError> {
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
    }
}

/// The incidences of the table: its angles, then diffuse light.
pub fn node_rows(config: &Config) -> Vec<RowIncidence> {
    let angles = config.fit.theta_l_deg.iter().map(|theta| RowIncidence::Degrees(*theta));
    angles.chain([RowIncidence::diffuse()]).collect()
}

/// The incidence of a table's row.
///
/// # Errors
/// [`TransportError::Domain`] for an angle beyond 90 degrees.
pub fn light(row: &RowIncidence) -> Result<Incidence, TransportError> {
    Ok(match row.degrees() {
        Some(theta) => Incidence::beam(cos_degrees(theta))?,
        None => Incidence::Diffuse,
    })
}

/// What the fit needs of one incidence.
pub fn fit_reference(config: &Config, traced: &TracedIncidence) -> Reference {
    let (totals, orders) =
        (traced.get(config.transport.totals_medium), traced.get(config.transport.orders_medium));
    let count = totals.tau().len();
    let all = |quantity: Quantity| (0..count).map(move |k| (k, quantity)).collect::<Vec<_>>();
    let total = all(Quantity::Transmittance(Order::Total));
    let quantities = [
        Quantity::Transmittance(Order::Exactly(1)),
        Quantity::Transmittance(Order::Exactly(2)),
        Quantity::Reflectance(Order::Exactly(1)),
        Quantity::Reflectance(Order::Exactly(2)),
    ];
    let values = |traced: &Traced, list: &[(usize, Quantity)]| {
        list.iter().map(|(k, quantity)| traced.hits(*k, *quantity) as f64 / traced.photons() as f64).collect()
    };
    let each: Vec<_> = quantities.iter().flat_map(|quantity| all(*quantity)).collect();
    Reference {
        incidence: traced.row.clone(),
        tau: totals.tau().to_vec(),
        t_ms: values(totals, &total),
        t_ms_covariance: totals.covariance(&total).concat(),
        orders: quantities.map(|quantity| values(orders, &all(quantity))),
        orders_covariance: orders.covariance(&each).concat(),
    }
}

/// The rows of `orders.csv`.
pub fn orders_rows(traced: &TracedIncidence, thickness_m: &[f64]) -> Vec<OrdersRow> {
    let row = |medium: Medium, k: usize, order: Order| {
        let (reflectance, transmittance) = traced.get(medium).estimate(k, order);
        OrdersRow {
            theta_l_deg: traced.row.to_string(),
            thickness_m: thickness_m[k],
            medium,
            order: order.to_string(),
            reflectance: reflectance.value,
            reflectance_std_error: reflectance.std_error,
            transmittance: transmittance.value,
            transmittance_std_error: transmittance.std_error,
        }
    };
    let mut rows = Vec::new();
    for medium in [Medium::Full, Medium::Modified] {
        for k in 0..thickness_m.len() {
            rows.extend(Order::rows(MAX_ORDER).map(|order| row(medium, k, order)));
        }
    }
    rows
}

/// The fluxes that the emitted table is held against.
///
/// # Errors
/// [`CliError::Input`] if a thickness or angle is out of domain.
pub fn points(config: &Config, traced: &TracedIncidence) -> Result<Vec<ReferencePoint>, CliError> {
    let (totals, orders) =
        (traced.get(config.transport.totals_medium), traced.get(config.transport.orders_medium));
    let incidence = light(&traced.row).map_err(super::trace_error)?;
    let mut points = Vec::new();
    for (k, tau) in totals.tau().iter().enumerate() {
        let (r_ms, t_ms) = totals.estimate(k, Order::Total);
        let t_0 = orders.estimate(k, Order::Exactly(0)).1;
        let (r_1, t_1) = orders.estimate(k, Order::Exactly(1));
        let (r_2, t_2) = orders.estimate(k, Order::Exactly(2));
        let (r_3_plus, t_3_plus) = orders.estimate(k, Order::Tail);
        for (quantity, estimate) in [
            ("t_ms", t_ms),
            ("r_ms", r_ms),
            ("t_0", t_0),
            ("t_1", t_1),
            ("t_2", t_2),
            ("t_3_plus", t_3_plus),
            ("r_1", r_1),
            ("r_2", r_2),
            ("r_3_plus", r_3_plus),
        ] {
            let tau = OpticalThickness::new(*tau)?;
            points.push(ReferencePoint {
                incidence,
                tau,
                quantity: quantity.to_owned(),
                value: estimate.value,
                std_error: estimate.std_error,
            });
        }
    }
    Ok(points)
}
