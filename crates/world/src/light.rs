//! Sun and sky.

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

/// Light from above other than the sun's.
#[derive(Clone, Debug, PartialEq)]
pub enum Sky {
    /// The same radiance from everywhere.
    Uniform([f64; 3]),
}

impl Sky {
    /// Radiance from `direction`; below the horizon there is none.
    pub fn radiance(&self, direction: DVec3) -> [f64; 3] {
        match self {
            Self::Uniform(radiance) if direction.z > 0.0 => *radiance,
            Self::Uniform(_) => [0.0; 3],
        }
    }

    /// Irradiance of a horizontal plane, ∫ L cosθ dω.
    pub fn irradiance(&self) -> [f64; 3] {
        match self {
            Self::Uniform(radiance) => radiance.map(|l| l * std::f64::consts::PI),
        }
    }
}
