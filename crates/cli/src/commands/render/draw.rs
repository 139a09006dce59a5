//! Builds the world, draws it, writes the files.

use super::settings::settings;
use crate::CliError;
use crate::args::RenderArgs;
use crate::output::{Data, Talk};
use crate::pipeline::input_error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use stratiform_gpu::Gpu;
use stratiform_imaging::{Image, Tone, write_exr};
use stratiform_render::{PassTime, Renderer};
use stratiform_scene::{Scene, find};
use stratiform_world::World;

/// Where the named scenes stand.
const SCENES: &str = "fit-configs/scenes";

/// Runs the command.
///
/// # Errors
/// As the command's.
pub fn run(args: &RenderArgs, talk: Talk) -> Result<Data, CliError> {
    let (_, scene) = find(&args.scene).map_err(input_error)?;
    let settings = settings(args, &scene)?;
    let tone = Tone::at(args.exposure.unwrap_or(scene.picture.exposure_ev));
    let world = world(args, &scene)?;
    let gpu = Gpu::new().map_err(input_error)?;
    talk.say(format!("drawing on {}", gpu.adapter()));
    let mut renderer = Renderer::new(&gpu, &world, &settings).map_err(input_error)?;
    let image = renderer.draw().map_err(input_error)?;
    let files = write(args, &image, &tone)?;
    if args.timings { times(&renderer.timings()) } else { Ok(files) }
}

fn world(args: &RenderArgs, scene: &Scene) -> Result<World, CliError> {
    let mut world = World::build(scene, &folder(&args.scene), args.time).map_err(input_error)?;
    if let Some([width, height]) = args.size {
        (world.camera.width, world.camera.height) = (width, height);
    }
    Ok(world)
}

/// The folder from which a scene names its files.
fn folder(scene: &str) -> PathBuf {
    let file = Path::new(scene);
    match file.parent() {
        Some(folder) if file.exists() => folder.to_owned(),
        _ => PathBuf::from(SCENES),
    }
}

fn write(args: &RenderArgs, image: &Image, tone: &Tone) -> Result<Data, CliError> {
    if let Some(path) = &args.exr {
        write_exr(path, image, &[], &format!("Scene {}.", args.scene)).map_err(input_error)?;
    }
    image.write_png(&args.out, tone).map_err(input_error)?;
    let files = [Some(&args.out), args.exr.as_ref()].into_iter().flatten();
    Ok(files.map(|path| path.display().to_string() + "\n").collect())
}

fn times(times: &[PassTime]) -> Result<Data, CliError> {
    if times.is_empty() {
        return Err(CliError::Input(
            "this adapter has no time stamps: --timings has nothing to print".to_owned(),
        ));
    }
    let mut table = "pass,seconds\n".to_owned();
    for PassTime { name, seconds } in times {
        writeln!(table, "{name},{seconds}").map_err(input_error)?;
    }
    Ok(table)
}
