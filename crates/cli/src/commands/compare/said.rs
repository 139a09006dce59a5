//! What the scene says to tracer and renderer.

use crate::CliError;
use crate::args::{CompareArgs, ComparedModels};
use crate::commands::render::said;
use crate::pipeline::input_error;
use std::path::{Path, PathBuf};
use stratiform_render::{Model, Settings};
use stratiform_scene::Scene;
use stratiform_world::World;

/// Where the named scenes stand.
const SCENES: &str = "fit-configs/scenes";

/// The world at the moment and size that were typed.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture or names files that cannot be read.
pub fn world(args: &CompareArgs, scene: &Scene) -> Result<World, CliError> {
    let file = Path::new(&args.scene);
    let folder = file.parent().filter(|_| file.exists()).map_or(PathBuf::from(SCENES), Path::to_owned);
    let mut world = World::build(scene, &folder, args.time).map_err(input_error)?;
    if let Some([width, height]) = args.size {
        (world.camera.width, world.camera.height) = (width, height);
    }
    Ok(world)
}

/// As the scene says, by the first of the models.
pub fn settings(scene: &Scene, models: &[Model]) -> Settings {
    let usual = said(scene);
    Settings { model: models.first().copied().unwrap_or(usual.model), ..usual }
}

/// The models in their order.
pub fn models(asked: ComparedModels) -> &'static [Model] {
    match asked {
        ComparedModels::Angular => &[Model::Angular],
        ComparedModels::Fitted => &[Model::Fitted],
        ComparedModels::Both => &[Model::Fitted, Model::Angular],
    }
}
