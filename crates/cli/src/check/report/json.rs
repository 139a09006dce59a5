//! For programs: schema `stratiform/check/1`.

use crate::CliError;
use crate::check::{Comparison, Verdict};
use serde::{Deserialize, Serialize};
use stratiform_artifact::{Provenance, RowIncidence};
use stratiform_quantities::{Medium, Order};

/// The schema's name and version.
pub const SCHEMA: &str = "stratiform/check/1";

#[derive(Serialize, Deserialize)]
struct Document {
    schema: String,
    provenance: Provenance,
    passed: bool,
    compared: usize,
    failed: usize,
    parts: Vec<PartRecord>,
    /// Failures, worst first.
    offenders: Vec<Record>,
}

#[derive(Serialize, Deserialize)]
struct PartRecord {
    part: String,
    compared: usize,
    quantities: Vec<QuantityRecord>,
}

#[derive(Serialize, Deserialize)]
struct QuantityRecord {
    quantity: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    order: Option<Order>,
    compared: usize,
    failed: usize,
    worst: Record,
}

/// A comparison; numbers that are not finite are `null`.
#[derive(Serialize, Deserialize)]
struct Record {
    part: String,
    quantity: String,
    theta_l_deg: RowIncidence,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    theta_v_deg: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    phi_deg: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tau: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    medium: Option<Medium>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    order: Option<Order>,
    value: Option<f64>,
    truth: Option<f64>,
    difference: Option<f64>,
    bound: Option<f64>,
}

impl Record {
    fn of(part: &str, one: &Comparison) -> Self {
        let finite = |value: f64| value.is_finite().then_some(value);
        let place = &one.place;
        Self {
            part: part.to_owned(),
            quantity: one.quantity.clone(),
            theta_l_deg: place.theta_l_deg.clone(),
            theta_v_deg: place.theta_v_deg,
            phi_deg: place.phi_deg,
            tau: place.tau,
            medium: place.medium,
            order: place.order,
            value: finite(one.value),
            truth: finite(one.truth),
            difference: finite(one.difference()),
            bound: finite(one.bound),
        }
    }
}

/// The document; `worst` failures at most.
///
/// # Errors
/// [`CliError::Input`] if it cannot be written as JSON.
pub fn to_json(verdict: &Verdict, provenance: &Provenance, worst: usize) -> Result<String, CliError> {
    let failures = verdict.failures();
    let parts = verdict.parts.iter().map(|(part, list)| {
        let quantities = verdict.summaries(*part).into_iter().map(|summary| QuantityRecord {
            quantity: summary.worst.quantity.clone(),
            order: summary.worst.place.order,
            compared: summary.compared,
            failed: summary.failed,
            worst: Record::of(&part.to_string(), summary.worst),
        });
        PartRecord { part: part.to_string(), compared: list.len(), quantities: quantities.collect() }
    });
    let document = Document {
        schema: SCHEMA.to_owned(),
        provenance: provenance.clone(),
        passed: verdict.passes(),
        compared: verdict.compared(),
        failed: failures.len(),
        parts: parts.collect(),
        offenders: failures
            .iter()
            .take(worst)
            .map(|(part, one)| Record::of(&part.to_string(), one))
            .collect(),
    };
    Ok(stratiform_artifact::to_json(&document)?)
}
