//! `chart.csv`, `knobs.csv`, `manifest.json`: error against cost of every method over scenes.

use crate::Provenance;
use serde::{Deserialize, Serialize};

/// One method, one scene, one quantity: a row of `chart.csv`. Errors are relative, (method - truth)/truth.
///
/// `ns_per_evaluation` and `pareto`, which follows from it, differ between runs and machines; nothing else does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChartRow {
    /// Name of the scene.
    pub scene: String,
    /// Stable name of the method, with its knob.
    pub method: String,
    /// The knob's setting, where it has one.
    pub knob: Option<String>,
    /// Its place among the classes of Hufnagel & Held 2012.
    pub class: String,
    /// `radiance_top`, `radiance_bottom`, `reflectance` or `transmittance`.
    pub quantity: String,
    /// Points whose truth is known well enough.
    pub points: u64,
    /// Points of the scene left out because the truth is not.
    pub excluded: u64,
    /// Of `points`, those that lie outside the method's domain or that it could not answer.
    pub refused: u64,
    /// Of `points`, those answered by no finite number.
    pub not_finite: u64,
    /// Median of the error's magnitude over the points that were answered.
    pub median: Option<f64>,
    /// Its 95th percentile.
    pub p95: Option<f64>,
    /// Its largest value.
    pub worst: Option<f64>,
    /// Median of the signed error.
    pub bias: Option<f64>,
    /// `f32`: one evaluation in single precision on one thread; `batch`: one thread's time for many points, divided.
    pub cost: String,
    /// Nanoseconds.
    pub ns_per_evaluation: Option<f64>,
    /// Bytes of tables of a shader; empty where it is none.
    pub table_bytes: Option<u64>,
    /// Whether no other method that answers every point is better in cost or median and no worse in the other.
    pub pareto: bool,
}

impl ChartRow {
    /// The quantities, in the order of tables.
    pub const QUANTITIES: [&str; 4] = ["radiance_top", "radiance_bottom", "reflectance", "transmittance"];
}

/// One setting of one knob: a row of `knobs.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnobRow {
    /// Name of the scene.
    pub scene: String,
    /// The method without its knob.
    pub method: String,
    /// What is turned: `orders`, `streams`, `photons`, `phase table texels` and so on.
    pub knob: String,
    /// To where.
    pub setting: f64,
    /// As in [`ChartRow`].
    pub quantity: String,
    /// As in [`ChartRow`].
    pub points: u64,
    /// As in [`ChartRow`].
    pub refused: u64,
    /// As in [`ChartRow`].
    pub median: Option<f64>,
    /// As in [`ChartRow`].
    pub p95: Option<f64>,
    /// As in [`ChartRow`].
    pub worst: Option<f64>,
    /// As in [`ChartRow`].
    pub ns_per_evaluation: Option<f64>,
    /// As in [`ChartRow`].
    pub table_bytes: Option<u64>,
}

/// What a chart was made of: `manifest.json`. It holds no time, so that the same inputs give the same bytes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChartDocument {
    /// `stratiform/chart/1`.
    pub schema: String,
    /// Program, version, hash of scenes, methods and grid.
    pub provenance: Provenance,
    /// Whether the small grid was used.
    pub quick: bool,
    /// A point is left out if the truth's own estimated error exceeds this share of its value.
    pub largest_truth_error: f64,
    /// The scenes.
    pub scenes: Vec<ChartScene>,
    /// The methods.
    pub methods: Vec<ChartMethod>,
}

impl ChartDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/chart/1";
}

/// A scene of a chart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChartScene {
    /// Name.
    pub name: String,
    /// For people.
    pub title: String,
    /// Hash of what the file says.
    pub hash: String,
    /// The droplets and wavelengths sampled.
    pub clouds: Vec<ChartCloud>,
}

/// A cloud of a scene of a chart, and its part of the grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChartCloud {
    /// r_e.
    pub effective_radius_um: f64,
    /// λ.
    pub wavelength_um: f64,
    /// κH.
    pub tau: Vec<f64>,
    /// θ_l.
    pub theta_l_deg: Vec<f64>,
    /// θ_v.
    pub theta_v_deg: Vec<f64>,
    /// φ.
    pub phi_deg: Vec<f64>,
    /// Radiances whose truth is known well enough.
    pub radiances: u64,
    /// Radiances left out.
    pub excluded: u64,
    /// Largest relative error that the truth itself may have at a point that counts.
    pub worst_truth_error: f64,
}

/// A method of a chart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChartMethod {
    /// Stable name.
    pub name: String,
    /// For people.
    pub title: String,
    /// Paper and equation.
    pub source: String,
    /// Its class.
    pub class: String,
}
