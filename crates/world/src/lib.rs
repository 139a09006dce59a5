//! A scene made concrete: what the renderer and the path tracer both read.
//!
//! Metres; x to the east, y to the north, z up; the ground is z = 0. The cloud fills `base <= z <= base + H(x, y)`, H periodic in x and y,
//! with one extinction everywhere. Directions are unit vectors; the sun's points to it. Radiance and irradiance are in
//! units of the sun's irradiance normal to its beam (luminance 1), linear sRGB.

mod build;
mod camera;
mod contribution;
mod error;
mod field;
mod ground;
mod ground_map;
mod height_field;
mod light;
mod map;
mod material;
mod sky;

pub use camera::Camera;
pub use contribution::Contribution;
pub use error::WorldError;
pub use ground::Ground;
pub use height_field::HeightField;
pub use light::Sun;
pub use map::Map;
pub use material::Material;
pub use sky::{Air, ClearSky, Sky, SkyTable};

/// All that a picture is of.
#[derive(Clone, Debug)]
pub struct World {
    /// Where it is seen from.
    pub camera: Camera,
    /// The sun.
    pub sun: Sun,
    /// All other light from above.
    pub sky: Sky,
    /// The plane z = 0.
    pub ground: Ground,
    /// Altitude of the cloud's flat base, m.
    pub base_m: f64,
    /// How thick the cloud is where.
    pub field: HeightField,
    /// What it consists of.
    pub material: Material,
}
