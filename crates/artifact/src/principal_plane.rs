//! `figures/principal-plane.csv`: reflectance per scattering order in the plane of the sun.

use serde::{Deserialize, Serialize};
use std::fmt;
use stratiform_quantities::Medium;

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PlaneSource {
    /// Photons: local estimates in the modified medium; in the full one order 1 so, later orders in bins.
    Mc,
    /// The angular model of the paper, with the fitted parameters.
    Model,
    /// The fitted radiance model: single scattering and one exponential.
    Radiance,
    /// The deterministic solver.
    Solver,
}

/// A scattering order as the figures group them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneOrder {
    /// Exactly so many.
    Exactly(u32),
    /// So many or more, `3+`.
    From(u32),
    /// All scattered light.
    Total,
}

impl fmt::Display for PlaneOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exactly(n) => write!(f, "{n}"),
            Self::From(n) => write!(f, "{n}+"),
            Self::Total => f.write_str("total"),
        }
    }
}

impl std::str::FromStr for PlaneOrder {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| {
            text.parse().map_err(|_| format!("order `{text}` is neither 1, 2, …, nor `3+`, nor `total`"))
        };
        match (text, text.strip_suffix('+')) {
            ("total", _) => Ok(Self::Total),
            (_, Some(least)) => number(least).map(Self::From),
            (exactly, None) => number(exactly).map(Self::Exactly),
        }
    }
}

impl Serialize for PlaneOrder {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for PlaneOrder {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

/// One value of one curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrincipalPlaneRow {
    /// Full, or modified: orders then count wide events.
    pub medium: Medium,
    /// The sun's zenith angle.
    pub theta_l_deg: f64,
    /// Of the slab, in metres.
    pub thickness_m: f64,
    /// The viewer's zenith angle: positive where leaving light keeps the sun's azimuth (the pseudo-specular is near
    /// +θ_l), negative on the sun's side (the glory is at -θ_l).
    pub theta_v_deg: f64,
    /// Scattering order.
    pub order: PlaneOrder,
    /// πL/(μ_l F0), the BRDF times π.
    pub value: f64,
    /// Standard error of photons, estimated error of the solver; a model has none.
    pub std_error: Option<f64>,
    /// Where it comes from.
    pub source: PlaneSource,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_read_as_they_are_written() {
        for order in [PlaneOrder::Exactly(5), PlaneOrder::From(3), PlaneOrder::Total] {
            assert_eq!(order.to_string().parse(), Ok(order));
        }
        for text in ["", "+", "tail", "-1", "1.5"] {
            assert!(text.parse::<PlaneOrder>().is_err(), "{text}");
        }
    }
}
