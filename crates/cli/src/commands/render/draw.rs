//! Builds the world, draws it, writes the files.

use super::settings::settings;
use crate::CliError;
use crate::args::RenderArgs;
use crate::commands::picture::world;
use crate::output::{Data, Talk};
use crate::pipeline::input_error;
use std::fmt::Write as _;
use std::path::Path;
use stratiform_gpu::Gpu;
use stratiform_imaging::{Image, Tone, write_exr};
use stratiform_render::{PassTime, Renderer};
use stratiform_scene::find;

/// Runs the command.
///
/// # Errors
/// As the command's.
pub fn run(args: &RenderArgs, talk: Talk) -> Result<Data, CliError> {
    let (_, scene) = find(&args.scene).map_err(input_error)?;
    let settings = settings(args, &scene)?;
    let tone = Tone::at(args.exposure.unwrap_or(scene.picture.exposure_ev));
    let mut world = world(&args.scene, &scene, args.time, args.size)?;
    let rays = usize::from(args.oversample);
    world.camera.width *= rays;
    world.camera.height *= rays;
    std::iter::once(&args.out).chain(&args.exr).try_for_each(|path| has_folder(path))?;
    let gpu = Gpu::new().map_err(input_error)?;
    talk.say(format!("drawing on {}", gpu.adapter()));
    let mut renderer = Renderer::new(&gpu, &world, &settings).map_err(input_error)?;
    let image = renderer.draw().map_err(input_error)?.downsample(rays).map_err(input_error)?;
    let files = write(args, &image, &tone)?;
    if args.timings { times(&renderer.timings(), talk) } else { Ok(files) }
}

/// Refuses, before anything is drawn, a file whose folder is not there.
fn has_folder(path: &Path) -> Result<(), CliError> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(CliError::Input(format!("{}: there is no folder {}", path.display(), folder.display())))
        }
        _ => Ok(()),
    }
}

fn write(args: &RenderArgs, image: &Image, tone: &Tone) -> Result<Data, CliError> {
    image.write_png(&args.out, tone).map_err(input_error)?;
    if let Some(path) = &args.exr {
        write_exr(path, image, &[], &format!("Scene {}.", args.scene)).map_err(input_error)?;
    }
    let files = [Some(&args.out), args.exr.as_ref()].into_iter().flatten();
    Ok(files.map(|path| path.display().to_string() + "\n").collect())
}

fn times(times: &[PassTime], talk: Talk) -> Result<Data, CliError> {
    if times.is_empty() {
        talk.say("this adapter has no time stamps");
    }
    let mut table = "pass,seconds\n".to_owned();
    for PassTime { name, seconds } in times {
        writeln!(table, "{name},{seconds}").map_err(input_error)?;
    }
    Ok(table)
}
