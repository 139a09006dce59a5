//! `[check]` of a config: what is accepted. Unknown keys are refused.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stratiform_fit::ModelBounds;
use stratiform_quantities::{DomainError, OpticalThickness, Order, Range};

/// `[check]`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CheckConfig {
    /// Largest error of the deterministic truth, absolute.
    pub tolerance: f64,
    /// The same of radiance, absolute below 1 and relative above.
    #[serde(default = "default_radiance_tolerance")]
    pub radiance_tolerance: f64,
    /// Probability that a correct table, or a correct tracer, fails.
    pub false_alarm_rate: f64,
    /// The accepted table against the solver.
    pub model: ModelBounds,
    /// Fresh photons against stored counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tracer: Option<TracerConfig>,
    /// Values of other implementations against the solver.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<Quantity, OrderBounds>,
}

fn default_radiance_tolerance() -> f64 {
    1e-3
}

/// `[check.tracer]`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TracerConfig {
    /// The stored counts, listed with their SHA-256 in the `SOURCE.toml` beside them; relative to the config file.
    pub counts: String,
    /// Optical thicknesses that are counted at.
    pub tau: Vec<f64>,
    /// Photons per incidence and medium of the fresh run.
    pub photons: u64,
    /// Its seed.
    pub seed: u64,
    /// Photons per incidence and medium of the stored counts.
    pub stored_photons: u64,
    /// Their seed.
    pub stored_seed: u64,
}

/// What a row of `--values` is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Reflected flux per incident flux.
    Reflectance,
    /// Transmitted flux per incident flux.
    Transmittance,
    /// πL/(μ0 F0) leaving the top.
    RadianceTop,
    /// πL/(μ0 F0) leaving the bottom.
    RadianceBottom,
}

/// Bounds by order: `0`, `1`, …, `tail`, `total`, or `any` for those that are not listed.
pub type OrderBounds = BTreeMap<String, Bound>;

/// |value - truth| may be up to absolute + relative·|truth|.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bound {
    /// Share of the incident flux.
    #[serde(default)]
    pub absolute: f64,
    /// Share of the truth.
    #[serde(default)]
    pub relative: f64,
}

impl Bound {
    /// The largest difference allowed from `truth`.
    pub fn around(&self, truth: f64) -> f64 {
        self.absolute + self.relative * truth.abs()
    }
}

/// The key that stands for all orders not listed.
pub const ANY: &str = "any";

/// The bound of `order`.
pub fn bound(bounds: &OrderBounds, order: Order) -> Option<Bound> {
    bounds.get(&order.to_string()).or_else(|| bounds.get(ANY)).copied()
}

/// A key with what is wrong with its value.
pub struct Refused {
    /// The dotted key.
    pub key: String,
    /// The message.
    pub message: String,
}

impl From<DomainError> for Refused {
    fn from(error: DomainError) -> Self {
        Self { message: error.to_string(), key: error.quantity }
    }
}

impl CheckConfig {
    /// Checks every number.
    pub(crate) fn validate(&self) -> Result<(), Refused> {
        Range { max_included: false, ..Range::closed(1e-12, 1.0) }
            .check("check.tolerance", self.tolerance)?;
        Range { max_included: false, ..Range::closed(2e-8, 1.0) }
            .check("check.radiance_tolerance", self.radiance_tolerance)?;
        Range::open(0.0, 1.0).check("check.false_alarm_rate", self.false_alarm_rate)?;
        self.model.check("check.model")?;
        self.tracer.iter().try_for_each(TracerConfig::validate)?;
        self.values.iter().try_for_each(|(quantity, bounds)| validate_bounds(*quantity, bounds))
    }
}

impl TracerConfig {
    fn validate(&self) -> Result<(), Refused> {
        for (key, photons) in
            [("check.tracer.photons", self.photons), ("check.tracer.stored_photons", self.stored_photons)]
        {
            stratiform_transport::PHOTONS.check(key, photons as f64)?;
        }
        let key = "check.tracer.tau";
        let mut allowed = Range { min_included: false, ..OpticalThickness::RANGE };
        for &tau in &self.tau {
            allowed.check(key, tau)?;
            allowed = Range { min: tau, ..allowed };
        }
        if self.tau.is_empty() {
            return Err(Refused { key: key.to_owned(), message: format!("{key} is empty") });
        }
        if self.seed == self.stored_seed {
            let key = "check.tracer.seed";
            let message = format!(
                "{key} = {} is also that of the stored counts: its photons would not be fresh",
                self.seed
            );
            return Err(Refused { key: key.to_owned(), message });
        }
        Ok(())
    }
}

fn validate_bounds(quantity: Quantity, bounds: &OrderBounds) -> Result<(), Refused> {
    let table = format!("check.values.{quantity}");
    for (order, bound) in bounds {
        let key = format!("{table}.{order}");
        if order != ANY && order.parse::<Order>().is_err() {
            let message = format!("{key}: `{order}` is neither an order, `tail`, `total` nor `{ANY}`");
            return Err(Refused { key, message });
        }
        for (name, value) in [("absolute", bound.absolute), ("relative", bound.relative)] {
            Range::closed(0.0, 1e6).check(&format!("{key}.{name}"), value)?;
        }
    }
    Ok(())
}

impl Quantity {
    /// Whether it has a direction of view.
    pub fn is_radiance(self) -> bool {
        matches!(self, Self::RadianceTop | Self::RadianceBottom)
    }
}

impl std::fmt::Display for Quantity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Quantity::Reflectance => "reflectance",
            Quantity::Transmittance => "transmittance",
            Quantity::RadianceTop => "radiance_top",
            Quantity::RadianceBottom => "radiance_bottom",
        })
    }
}

impl std::str::FromStr for Quantity {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let all = [Self::Reflectance, Self::Transmittance, Self::RadianceTop, Self::RadianceBottom];
        all.into_iter().find(|quantity| quantity.to_string() == text).ok_or_else(|| {
            format!("quantity `{text}` is none of reflectance, transmittance, radiance_top, radiance_bottom")
        })
    }
}
