//! `[sun]`.

use crate::Interval;
use serde::{Deserialize, Serialize};

/// Where the sun stands, and for a picture what it is like.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sun {
    /// Angle to the normal.
    pub theta_deg: Interval,
    /// Clockwise from north.
    #[serde(default = "azimuth_deg")]
    pub azimuth_deg: f64,
    /// Half of its apparent diameter (Allen's Astrophysical Quantities, 4th ed., section 14.1: 959.63″).
    #[serde(default = "angular_radius_deg")]
    pub angular_radius_deg: f64,
    /// Normal to its beam above the cloud, linear sRGB; all other light is in its units. Left out: white, or what a clear sky leaves of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub irradiance: Option<[f64; 3]>,
}

fn azimuth_deg() -> f64 {
    180.0
}

fn angular_radius_deg() -> f64 {
    0.2666
}

impl Sun {
    /// In the south at these angles to the normal.
    pub fn at(theta_deg: Interval) -> Self {
        Self {
            theta_deg,
            azimuth_deg: azimuth_deg(),
            angular_radius_deg: angular_radius_deg(),
            irradiance: None,
        }
    }
}
