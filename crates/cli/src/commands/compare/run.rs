//! Draws, traces, compares, writes.

use super::said::{models, settings};
use crate::CliError;
use crate::args::CompareArgs;
use crate::commands::picture::world;
use crate::compare::{Draw, FLOOR_SHARE, Subject, Truth, ablation, costs, pictures, rows};
use crate::output::{Data, Talk};
use crate::pipeline::input_error;
use stratiform_artifact::{
    ComparisonDocument, ComparisonRow, Provenance, create_folder, hash_of, to_csv, write_csv, write_json,
};
use stratiform_gpu::Gpu;
use stratiform_imaging::Tone;
use stratiform_imaging::compare::flip::PIXELS_PER_DEGREE;
use stratiform_pathtrace::{Request, Stop, trace};
use stratiform_scene::{Scene, find};
use stratiform_world::World;

/// Runs the command.
///
/// # Errors
/// As the command's.
pub fn run(args: &CompareArgs, talk: Talk) -> Result<Data, CliError> {
    let (name, scene) = find(&args.scene).map_err(input_error)?;
    let models = models(args.model);
    let mut world = world(&args.scene, &scene, args.time, args.size)?;
    let settings = settings(&scene, models);
    let gpu = Gpu::new().map_err(input_error)?;
    let given = args.truth.as_deref().map(Truth::read).transpose()?;
    if let Some(truth) = &given {
        fit(&mut world, truth, args)?;
    }
    talk.say(format!("drawing on {}", gpu.adapter()));
    let mut draw = Draw::new(&gpu, &world, &settings, usize::from(args.oversample))?;
    draw.picture(&settings)?;
    let truth = given.map_or_else(|| traced(args, &world, talk), Ok)?;
    let tone = Tone::at(args.exposure.unwrap_or(scene.picture.exposure_ev));
    let subject = Subject { name: &name, world: &world, settings, models, tone };
    let (rows, compared) = rows(&subject, &truth, &mut draw)?;
    create_folder(&args.out)?;
    let mut document = document(args, &scene, &subject, (&truth, gpu.adapter()));
    document.pictures = pictures(&args.out, &subject, &compared)?;
    truth.write(&args.out.join("truth.exr"))?;
    if args.ablation {
        let table = ablation(&subject, &truth, &mut draw, |change| talk.say(change))?;
        write_csv(&args.out.join("ablation.csv"), &table)?;
    }
    if !args.costs.is_empty() {
        let table = costs(&gpu, &subject, &args.costs, |size| talk.say(size))?;
        write_csv(&args.out.join("render-costs.csv"), &table)?;
    }
    finish(args, &document, &rows, talk)
}

fn finish(
    args: &CompareArgs,
    document: &ComparisonDocument,
    rows: &[ComparisonRow],
    talk: Talk,
) -> Result<Data, CliError> {
    write_csv(&args.out.join("comparison.csv"), rows)?;
    write_json(&args.out.join("comparison.json"), document)?;
    let page = stratiform_report::build_comparison(&args.out).map_err(input_error)?;
    talk.say(format!("page: {}", page.display()));
    if !args.json {
        return Ok(to_csv(rows)?);
    }
    Ok(format!("{:#}\n", serde_json::json!({ "comparison": document, "rows": rows })))
}

/// Gives the picture the size of the truth.
fn fit(world: &mut World, truth: &Truth, args: &CompareArgs) -> Result<(), CliError> {
    let size = [truth.mean.width(), truth.mean.height()];
    if let Some(asked) = args.size.filter(|asked| *asked != size) {
        return Err(CliError::Input(format!(
            "--size is {} x {}, but the truth has {} x {} pixels",
            asked[0], asked[1], size[0], size[1]
        )));
    }
    (world.camera.width, world.camera.height) = (size[0], size[1]);
    Ok(())
}

fn traced(args: &CompareArgs, world: &World, talk: Talk) -> Result<Truth, CliError> {
    let pixels = world.camera.width * world.camera.height;
    talk.say(format!("tracing {} paths through each of {pixels} pixels", args.samples));
    let request = Request { stop: Stop::Samples(args.samples), crop: None, seed: args.seed };
    let truth = trace(world, &request).map_err(input_error)?;
    talk.say(format!("median standard error {:.2} %", 100.0 * truth.median_error));
    Ok(Truth::of(truth, args.seed))
}

fn document(
    args: &CompareArgs,
    scene: &Scene,
    subject: &Subject<'_>,
    (truth, adapter): (&Truth, &str),
) -> ComparisonDocument {
    let hash = hash_of(&(scene, format!("{:?}", subject.settings), args.time, args.oversample));
    let seed = args.truth.is_none().then_some(args.seed);
    ComparisonDocument {
        schema: ComparisonDocument::SCHEMA.to_owned(),
        provenance: Provenance::new(
            hash,
            seed,
            "compute passes against path tracing; standard errors of the latter",
        ),
        scene: subject.name.to_owned(),
        title: scene.title.clone(),
        width: subject.world.camera.width as u64,
        height: subject.world.camera.height as u64,
        exposure_ev: subject.tone.exposure_ev,
        pixels_per_degree: PIXELS_PER_DEGREE,
        floor_share: FLOOR_SHARE,
        truth: truth.words.clone(),
        adapter: adapter.to_owned(),
        pictures: Vec::new(),
    }
}
