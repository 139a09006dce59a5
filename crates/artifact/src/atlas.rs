//! `atlas.csv`, `atlas_summary.csv`, `atlas.json`: where methods break.

use crate::Provenance;
use serde::{Deserialize, Serialize};

/// One value of one method: a row of `atlas.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasRow {
    /// Stable name of the method.
    pub method: String,
    /// Name of the plane.
    pub plane: String,
    /// What runs along x.
    pub x_name: String,
    /// Where.
    pub x: f64,
    /// What runs along y.
    pub y_name: String,
    /// Where.
    pub y: f64,
    /// `f64` or `f32`.
    pub precision: String,
    /// `radiance_top`, `radiance_bottom`, `reflectance` or `transmittance`.
    pub quantity: String,
    /// One of [`AtlasRow::CLASSES`].
    pub class: String,
    /// What the method said; empty where that is no finite number.
    pub value: Option<f64>,
    /// What the solver said; empty where it is not known well enough.
    pub truth: Option<f64>,
    /// (value - truth)/truth.
    pub error: Option<f64>,
}

impl AtlasRow {
    /// The classes, from best to worst.
    pub const CLASSES: [&str; 9] = [
        "ok",
        "no-promise",
        "refused",
        "loses-digits",
        "over-bound",
        "above-one",
        "negative",
        "not-finite",
        "not-refused",
    ];
}

/// How often a class occurs: a row of `atlas_summary.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasCount {
    /// Stable name of the method.
    pub method: String,
    /// `f64` or `f32`.
    pub precision: String,
    /// Values asked for.
    pub cells: u64,
    /// The promise that covers the value holds.
    pub ok: u64,
    /// Finite and not negative; more is not promised there, or the truth is not known.
    pub no_promise: u64,
    /// Outside the declared domain, and refused.
    pub refused: u64,
    /// In f32, far from f64.
    pub loses_digits: u64,
    /// Further from the truth than promised.
    pub over_bound: u64,
    /// A flux above 1.
    pub above_one: u64,
    /// Below 0.
    pub negative: u64,
    /// NaN or infinite.
    pub not_finite: u64,
    /// Outside the declared domain, and answered.
    pub not_refused: u64,
    /// Largest relative error where the truth is known and the domain includes the point.
    pub worst_error: Option<f64>,
}

/// What an atlas was made of: `atlas.json`. It holds no time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasDocument {
    /// `stratiform/atlas/1`.
    pub schema: String,
    /// Program, version, hash of planes and methods.
    pub provenance: Provenance,
    /// Whether the planes were thinned.
    pub quick: bool,
    /// In f32 a value counts as having lost its digits if it differs from f64 by more than this share.
    pub largest_f32_share: f64,
    /// A truth counts if its own estimated error is within this share of its value.
    pub largest_truth_error: f64,
    /// The planes.
    pub planes: Vec<AtlasPlane>,
    /// Methods by name.
    pub methods: Vec<AtlasMethod>,
}

impl AtlasDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/atlas/1";
}

/// A plane through the base point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasPlane {
    /// Name.
    pub name: String,
    /// What runs along x.
    pub x_name: String,
    /// What runs along y.
    pub y_name: String,
    /// What is held.
    pub held: String,
}

/// A method of an atlas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AtlasMethod {
    /// Stable name.
    pub name: String,
    /// For people.
    pub title: String,
    /// Its promise for radiances, in words.
    pub radiance: Option<String>,
    /// Its promise for fluxes, in words.
    pub flux: Option<String>,
}
