//! The answer.

use crate::{Budget, Emitted, Prediction};
use serde::{Deserialize, Serialize};

/// What there is to evaluate for a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Channels {
    /// Once, at the middle wavelength.
    Grey,
    /// Once for each wavelength.
    Rgb,
}

/// `stratiform/advice/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Advice {
    /// Schema's name and version.
    pub schema: String,
    /// Of the scene.
    pub title: String,
    /// What was asked for.
    pub budget: Budget,
    /// Whether the method below meets it; if not, it comes nearest.
    pub met: bool,
    /// Name of the method, with its knob.
    pub method: String,
    /// For people.
    pub method_title: String,
    /// One value for all channels, or one each.
    pub channels: Channels,
    /// What is promised.
    pub prediction: Prediction,
    /// Nanoseconds for a pixel in f32 on one thread: one evaluation for each channel, and those of the ground's light.
    pub ns: f64,
    /// Tables of all channels and droplet sizes; absent where the method is no shader code.
    pub table_bytes: Option<u64>,
    /// Texels of the phase table; absent where the method has none.
    pub phase_texels: Option<u64>,
    /// Orders of scattering that count: 1, 2, or more than 2 (absent).
    pub orders: Option<u32>,
    /// Emitted code to call; absent for methods that are not emitted.
    pub emitted: Option<Emitted>,
    /// r_e of the phase tables between which to interpolate.
    pub phase_radii_um: Vec<f64>,
    /// r_e of the tables of fitted parameters; empty where one set serves all, or there is none.
    pub parameter_radii_um: Vec<f64>,
    /// Suns of their rows.
    pub theta_l_nodes_deg: Vec<f64>,
    /// Light between cloud and ground, where it is seen.
    pub bounce: Option<Bounce>,
    /// What the promise does not cover.
    pub notes: Vec<String>,
    /// Every other method.
    pub rejected: Vec<Rejected>,
}

/// Light between cloud and ground.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounce {
    /// Method of R and T.
    pub method: String,
    /// What it promises of them.
    pub error: f64,
    /// Nanoseconds for a pair.
    pub ns: f64,
    /// ρ.
    pub ground_albedo: f64,
    /// R of the thickest cloud in diffuse light.
    pub cloud_albedo: f64,
    /// Passes of radiosity: the i-th carries (ρR)^i.
    pub passes: u32,
}

/// Why not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rejected {
    /// Its name.
    pub method: String,
    /// Promised error; absent where none is given.
    pub error: Option<f64>,
    /// Cost with its channels.
    pub ns: Option<f64>,
    /// In words.
    pub reason: String,
}
