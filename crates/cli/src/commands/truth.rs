//! `stratiform truth`: a scene's picture, path by path.

use crate::CliError;
use crate::args::TruthArgs;
use crate::commands::picture::world;
use crate::output::{Data, Talk};
use crate::pipeline::input_error;
use serde::{Deserialize, Serialize};
use std::time::Instant;
use stratiform_artifact::{create_folder, to_json, write_atomic};
use stratiform_imaging::{Image, Tone, write_exr};
use stratiform_pathtrace::{Crop, Request, Stop, Truth, trace};
use stratiform_scene::{Scene, find};
use stratiform_world::World;

/// Samples when nothing is said, and the most for a target.
const SAMPLES: u64 = 64;
const MOST: u64 = 1_000_000;

/// `truth.json`.
#[derive(Serialize, Deserialize)]
struct Document {
    schema: String,
    scene: String,
    moment_s: f64,
    /// Columns and rows of the whole picture.
    width: usize,
    height: usize,
    crop: [usize; 4],
    samples: u64,
    seed: u64,
    /// Over pixels, the standard error of luminance as a share of it.
    median_error: f64,
    /// Over pixels, the share of luminance that one path brought.
    largest_share: Shares,
    version: String,
}

#[derive(Serialize, Deserialize)]
struct Shares {
    median: f32,
    most: f32,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture, numbers out of domain, files that cannot be read or written;
/// [`CliError::Unmet`] if the samples did not suffice for the target.
pub fn run(args: &TruthArgs, talk: Talk) -> Result<Data, CliError> {
    let (name, scene) = find(&args.scene).map_err(input_error)?;
    let world = world(&args.scene, &scene, args.time, args.size)?;
    let request = request(args);
    let start = Instant::now();
    let truth = trace(&world, &request).map_err(input_error)?;
    let paths = truth.samples as f64 * truth.mean.pixels().len() as f64;
    let seconds = start.elapsed().as_secs_f64();
    talk.say(format!(
        "{} paths a pixel, {:.3e} paths a second; median error {:.2} %",
        truth.samples,
        paths / seconds,
        100.0 * truth.median_error
    ));
    let document = to_json(&document(args, name, &world, &truth))?;
    let files = write(args, &scene, &truth, &document)?;
    let data = if args.json { document } else { files };
    match args.target {
        Some(target) if truth.median_error > target => Err(CliError::Unmet {
            message: format!(
                "the median error is {} after {} samples, not {target}",
                truth.median_error, truth.samples
            ),
            data,
        }),
        _ => Ok(data),
    }
}

fn request(args: &TruthArgs) -> Request {
    let stop = match (args.target, args.seconds) {
        (Some(error), _) => Stop::Target { error, at_most: args.samples.unwrap_or(MOST) },
        (None, Some(seconds)) => Stop::Seconds(seconds),
        (None, None) => Stop::Samples(args.samples.unwrap_or(SAMPLES)),
    };
    let crop = args.crop.map(|[x, y, width, height]| Crop { x, y, width, height });
    Request { stop, crop, seed: args.seed }
}

fn document(args: &TruthArgs, scene: String, world: &World, truth: &Truth) -> Document {
    let Crop { x, y, width, height } = truth.crop;
    let mut shares = truth.largest_share.clone();
    shares.sort_by(f32::total_cmp);
    Document {
        schema: "stratiform/truth/1".to_owned(),
        scene,
        moment_s: args.time,
        width: world.camera.width,
        height: world.camera.height,
        crop: [x, y, width, height],
        samples: truth.samples,
        seed: args.seed,
        median_error: truth.median_error,
        largest_share: Shares { median: shares[shares.len() / 2], most: shares[shares.len() - 1] },
        version: env!("CARGO_PKG_VERSION").to_owned(),
    }
}

fn write(args: &TruthArgs, scene: &Scene, truth: &Truth, document: &str) -> Result<Data, CliError> {
    create_folder(&args.out)?;
    let mut layers = vec![("std_error".to_owned(), &truth.std_error)];
    for (part, mean, error) in &truth.parts {
        layers.push((part.name().to_owned(), mean));
        layers.push((format!("{}_std_error", part.name()), error));
    }
    let layers: Vec<(&str, &Image)> = layers.iter().map(|(name, image)| (name.as_str(), *image)).collect();
    let [exr, png, json] = ["truth.exr", "truth.png", "truth.json"].map(|name| args.out.join(name));
    let comment = format!("Scene {}; {} paths a pixel, seed {}.", args.scene, truth.samples, args.seed);
    write_exr(&exr, &truth.mean, &layers, &comment).map_err(input_error)?;
    truth.mean.write_png(&png, &Tone::at(scene.picture.exposure_ev)).map_err(input_error)?;
    write_atomic(&json, document.as_bytes())?;
    Ok([exr, png, json].iter().map(|path| path.display().to_string() + "\n").collect())
}
