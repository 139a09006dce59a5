//! The sun.

use glam::DVec3;

/// The sun: a beam for all that it lights, a disc for who looks at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Towards it.
    pub direction: DVec3,
    /// Irradiance normal to the beam above the cloud.
    pub irradiance: [f64; 3],
    /// Half of its apparent diameter, degrees.
    pub angular_radius_deg: f64,
}
