//! What a scene says about its cloud layer, its sun and its camera.
//!
//! A scene is one TOML file: ranges of thickness, droplets, sun and view, and which effects are seen. [`Scene::load`] reads a file,
//! [`named`] one of the scenes that come with the program, [`find`] either. Angles are in degrees from the slab's normal; azimuth 0 is where light
//! keeps the sun's. Whatever is empty, inverted, not a number or out of its domain is refused with file and line.

mod effect;
mod error;
mod interval;
mod layer;
mod names;
mod scene;

pub use effect::Effect;
pub use error::SceneError;
pub use interval::Interval;
pub use layer::{Droplets, Layer};
pub use names::{NAMES, find, named};
pub use scene::{Ground, Scene, Sun, View};
