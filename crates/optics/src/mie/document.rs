//! One sphere as JSON: schema `stratiform/mie/1`.

use super::SphereScattering;
use serde::{Deserialize, Serialize};

/// The document printed by `stratiform mie`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MieDocument {
    /// `stratiform/mie/1`.
    pub schema: String,
    /// Size parameter.
    pub x: f64,
    /// n, k of m = n + ik.
    pub m: [f64; 2],
    /// Extinction efficiency.
    pub q_ext: f64,
    /// Scattering efficiency.
    pub q_sca: f64,
    /// Asymmetry parameter.
    pub g: f64,
    /// The angles asked for.
    pub angles: Vec<MieAngle>,
}

/// Amplitudes at one angle, real and imaginary part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MieAngle {
    /// Θ in degrees.
    pub theta_deg: f64,
    /// S1.
    pub s1: [f64; 2],
    /// S2.
    pub s2: [f64; 2],
}

impl MieDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/mie/1";

    /// The document of one result of [`scatter`](super::scatter).
    pub fn new(x: f64, m: [f64; 2], sphere: &SphereScattering) -> Self {
        let angles = sphere.amplitudes.iter().map(|s| MieAngle {
            theta_deg: s.angle.degrees(),
            s1: [s.s1.re, s.s1.im],
            s2: [s.s2.re, s.s2.im],
        });
        let q = sphere.efficiencies;
        Self {
            schema: Self::SCHEMA.to_owned(),
            x,
            m,
            q_ext: q.q_ext,
            q_sca: q.q_sca,
            g: q.g,
            angles: angles.collect(),
        }
    }
}
