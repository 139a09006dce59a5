//! What a scene says about its cloud layer, its sun and its camera.
//!
//! A scene is one TOML file: ranges of thickness, droplets, sun and view, and which effects are seen; with `[camera]` and `[clouds]` it is a
//! picture too, and its ranges of view and thickness follow from these unless they are written. [`Scene::load`] reads a file,
//! [`named`] one of the scenes that come with the program, [`find`] either. Angles are in degrees: of light from the slab's normal, where azimuth 0
//! keeps the sun's; of sun and camera on the compass, clockwise from north. Whatever is empty, inverted, not a number, out of its domain or without
//! effect is refused with file and line.

mod camera;
mod check;
mod check_picture;
mod clouds;
mod effect;
mod error;
mod fault;
mod ground;
mod interval;
mod layer;
mod names;
mod picture;
mod scene;
mod sun;

pub use camera::{Camera, GRAZING_DEG, direction};
pub use clouds::{Clouds, Pattern, PatternKeys};
pub use effect::Effect;
pub use error::SceneError;
pub use ground::{Albedo, Ground, GroundPattern};
pub use interval::Interval;
pub use layer::{Droplets, Layer};
pub use names::{NAMES, PICTURES, find, named};
pub use picture::{Picture, Radiosity, Rings, Sky, SkyModel};
pub use scene::{Scene, View};
pub use sun::Sun;
