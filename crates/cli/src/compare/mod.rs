//! Pictures against their truth: draws, compares, leaves parts out, times.

mod ablation;
mod costs;
mod draw;
mod part;
mod rows;
mod truth;
mod write;

pub use ablation::ablation;
pub use costs::costs;
pub use draw::{Draw, model_name};
pub use part::Part;
pub use rows::{FLOOR_SHARE, rows};
pub use truth::Truth;
pub use write::pictures;

use stratiform_imaging::Tone;
use stratiform_render::{Model, Settings};
use stratiform_world::World;

/// What is drawn and shown.
pub struct Subject<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// At the size of the truth.
    pub world: &'a World,
    /// As the scene says; the models below take their turns in it.
    pub settings: Settings,
    /// Which are compared.
    pub models: &'a [Model],
    /// How all pictures are shown, and what FLIP sees.
    pub tone: Tone,
}
