//! The world of a named scene or file, as all commands of pictures build it.

use crate::CliError;
use crate::pipeline::input_error;
use std::path::{Path, PathBuf};
use stratiform_scene::Scene;
use stratiform_world::World;

/// Where the named scenes stand.
const SCENES: &str = "fit-configs/scenes";

/// The folder from which a scene names its files.
pub fn folder(scene: &str) -> PathBuf {
    let file = Path::new(scene);
    match file.parent() {
        Some(folder) if file.exists() => folder.to_owned(),
        _ => PathBuf::from(SCENES),
    }
}

/// What a program says that was built without the cargo `feature` that it takes to `draw` a scene.
#[cfg(not(feature = "view"))]
pub fn unavailable(draw: &str, scene: &str, feature: &str) -> CliError {
    CliError::Input(format!(
        "cannot {draw} `{scene}`: this program was built without the cargo feature `{feature}`; build it with `cargo build --release -p \
         stratiform-cli --features {feature}`"
    ))
}

/// The world of the scene called `name` at a moment, in seconds; a `size` takes the place of the scene's.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture or names files that cannot be read.
pub fn world(name: &str, scene: &Scene, moment_s: f64, size: Option<[usize; 2]>) -> Result<World, CliError> {
    let mut world = World::build(scene, &folder(name), moment_s).map_err(input_error)?;
    if let Some([width, height]) = size {
        (world.camera.width, world.camera.height) = (width, height);
    }
    Ok(world)
}
