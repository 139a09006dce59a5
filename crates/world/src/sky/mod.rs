//! Light from above other than the sun's.

mod air;
mod chapman;
mod clear;
mod diffuse;
mod sight;
mod table;

pub use air::Air;
pub use clear::ClearSky;
pub use table::SkyTable;

use glam::DVec3;
use std::f64::consts::PI;

/// The sky.
#[derive(Clone, Debug, PartialEq)]
pub enum Sky {
    /// The same radiance from everywhere.
    Uniform([f64; 3]),
    /// Clear air over the cloud.
    Clear(ClearSky),
}

impl Sky {
    /// Radiance from `direction`; below the horizon there is none.
    pub fn radiance(&self, direction: DVec3) -> [f64; 3] {
        match self {
            _ if direction.z <= 0.0 => [0.0; 3],
            Self::Uniform(radiance) => *radiance,
            Self::Clear(clear) => clear.table().radiance(direction),
        }
    }

    /// Irradiance of a horizontal plane, ∫ L cosθ dω.
    pub fn irradiance(&self) -> [f64; 3] {
        match self {
            Self::Uniform(radiance) => radiance.map(|l| l * PI),
            Self::Clear(clear) => clear.irradiance(),
        }
    }

    /// The uniform sky of the same irradiance.
    pub fn mean_radiance(&self) -> [f64; 3] {
        match self {
            Self::Uniform(radiance) => *radiance,
            Self::Clear(clear) => clear.irradiance().map(|e| e / PI),
        }
    }

    /// What a shader looks up: [`radiance`](Self::radiance) is its look-up too. A uniform sky has one texel.
    pub fn table(&self) -> SkyTable {
        match self {
            Self::Uniform(radiance) => SkyTable::uniform(*radiance),
            Self::Clear(clear) => clear.table().clone(),
        }
    }
}
