//! What the scene says to tracer and renderer.

use crate::CliError;
use crate::args::{CompareArgs, ComparedModels};
use crate::pipeline::input_error;
use std::path::{Path, PathBuf};
use stratiform_render::{Model, Radiosity, RingRule, Settings};
use stratiform_scene::{Rings, Scene};
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
    let said = &scene.radiosity;
    let rings = match said.rings {
        Rings::AsPrinted => RingRule::AsPrinted,
        Rings::WiderSquares => RingRule::WiderSquares,
        Rings::SquareWeights => RingRule::SquareWeights,
    };
    let usual = Settings::default();
    let radiosity =
        Radiosity { side: said.side, passes: said.passes, error: said.error, rings, ..usual.radiosity };
    Settings { model: models.first().copied().unwrap_or(usual.model), radiosity, ..usual }
}

/// The models in their order.
pub fn models(asked: ComparedModels) -> &'static [Model] {
    match asked {
        ComparedModels::Angular => &[Model::Angular],
        ComparedModels::Fitted => &[Model::Fitted],
        ComparedModels::Both => &[Model::Fitted, Model::Angular],
    }
}
