//! `stratiform chart`: error against cost of methods over scenes.

use crate::args::ChartArgs;
use crate::output::{Data, Talk};
use crate::pipeline::optics::cache_folder;
use crate::{CliError, interrupt, pipeline, progress};
use stratiform_artifact::{ChartDocument, ChartRow, KnobRow, create_folder, to_csv, write_csv, write_json};
use stratiform_chart::cost::Effort;
use stratiform_chart::{
    ChartError, Knob, KnobSetting, Sample, Source, Watch, chart, clouds, document, knobs,
};
use stratiform_methods::{self as methods, Method, by_name};
use stratiform_scene::{NAMES, Scene, find};

type Methods = Vec<Box<dyn Method>>;

/// The scene whose main cloud the knobs are turned in, where it is asked for; otherwise the first one.
const KNOB_SCENE: &str = "stratocumulus-above";

/// Methods whose knobs are turned where none is asked for: one of each kind.
const TURNED: [&str; 9] = [
    "single-mie",
    "octaves",
    "bouthors-corrected",
    "bouthors-family",
    "fitted",
    "orders",
    "solver",
    "monte-carlo",
    "half-space",
];

/// What was found.
struct Found {
    manifest: ChartDocument,
    rows: Vec<ChartRow>,
    knobs: Vec<KnobRow>,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for unknown scenes or methods, or files that cannot be written.
pub fn run(args: &ChartArgs, talk: Talk) -> Result<Data, CliError> {
    let scenes = scenes(&args.scene)?;
    let methods = chosen(&args.methods)?;
    let turned = if args.quick { Vec::new() } else { turned(&args.methods)? };
    create_folder(&args.out)?;
    let found = measure(args.quick, &scenes, &methods, &turned, talk)?;
    say_excluded(&found.manifest, talk);
    write_csv(&args.out.join("chart.csv"), &found.rows)?;
    if !found.knobs.is_empty() {
        write_csv(&args.out.join("knobs.csv"), &found.knobs)?;
    }
    write_json(&args.out.join("manifest.json"), &found.manifest)?;
    let drawn = stratiform_report::build_chart(&args.out).map_err(pipeline::input_error)?;
    talk.say(format!("page: {}", drawn.page.display()));
    if !args.json {
        return Ok(to_csv(&found.rows)?);
    }
    let object = serde_json::json!({ "manifest": found.manifest, "chart": found.rows, "knobs": found.knobs });
    Ok(format!("{object:#}\n"))
}

/// The scenes asked for under their names, or all that have one.
fn scenes(asked: &[String]) -> Result<Vec<(String, Scene)>, CliError> {
    let all: Vec<String> = NAMES.iter().map(|name| (*name).to_owned()).collect();
    let asked = if asked.is_empty() { &all } else { asked };
    let mut scenes: Vec<(String, Scene)> = Vec::new();
    for word in asked {
        let (name, scene) = find(word).map_err(pipeline::input_error)?;
        if scenes.iter().any(|(known, _)| *known == name) {
            return Err(CliError::Input(format!("scene {name} is named twice")));
        }
        scenes.push((name, scene));
    }
    Ok(scenes)
}

fn chosen(asked: &[String]) -> Result<Methods, CliError> {
    if asked.is_empty() {
        return Ok(methods::all());
    }
    if let Some((_, twice)) = asked.iter().enumerate().find(|(i, name)| asked[..*i].contains(name)) {
        return Err(CliError::Input(format!("method {twice} is named twice")));
    }
    asked.iter().map(|name| by_name(name).map_err(pipeline::input_error)).collect()
}

/// The knobs of the methods asked for, or of some.
fn turned(asked: &[String]) -> Result<Vec<Knob>, CliError> {
    let mut stems: Vec<&str> =
        asked.iter().map(|name| name.split_once(':').map_or(name.as_str(), |(stem, _)| stem)).collect();
    stems.dedup();
    if stems.is_empty() {
        stems.extend(TURNED);
    }
    let turned: Vec<Option<Knob>> = stems.into_iter().map(knob).collect::<Result<_, _>>()?;
    Ok(turned.into_iter().flatten().collect())
}

/// The knob of a method, if it has one.
fn knob(stem: &str) -> Result<Option<Knob>, CliError> {
    let Some(knob) = methods::knobs(stem) else { return Ok(None) };
    let setting = |value: &f64| {
        let method = by_name(&format!("{stem}:{value}")).map_err(pipeline::input_error)?;
        Ok(KnobSetting { setting: *value, method })
    };
    let settings = knob.values.iter().map(setting).collect::<Result<_, CliError>>()?;
    Ok(Some(Knob { method: stem.to_owned(), knob: knob.counts.to_owned(), settings }))
}

fn measure(
    quick: bool,
    scenes: &[(String, Scene)],
    methods: &Methods,
    turned: &[Knob],
    talk: Talk,
) -> Result<Found, CliError> {
    let clouds: usize =
        scenes.iter().map(|(_, scene)| if quick { 1 } else { clouds::places(scene).len() }).sum();
    let settings: usize = turned.iter().map(|knob| knob.settings.len()).sum();
    let steps = clouds + scenes.len() * methods.len() + settings;
    let bar = progress::bar(steps as u64, "chart", talk.quiet);
    let interrupted = interrupt::watch();
    let watch = Watch { progress: &|| bar.inc(1), cancel: interrupted.flag() };
    let cache = cache_folder();
    let source = Source { quick, cache: cache.as_deref(), watch };
    let samples: Vec<Sample> = scenes
        .iter()
        .map(|(name, scene)| Sample::of_scene(name, scene, &source))
        .collect::<Result<_, _>>()
        .map_err(fault)?;
    let effort = if quick { Effort::QUICK } else { Effort::FULL };
    let manifest = document(&samples, methods, quick);
    let mut rows = Vec::new();
    for sample in &samples {
        rows.extend(chart(sample, methods, effort, watch).map_err(fault)?);
    }
    let place = samples.iter().position(|sample| sample.name == KNOB_SCENE).unwrap_or(0);
    let main = samples.into_iter().nth(place).map(Sample::main_only);
    let knobs = main.map(|sample| knobs(&sample, turned, effort, watch)).transpose().map_err(fault)?;
    bar.finish_and_clear();
    Ok(Found { manifest, rows, knobs: knobs.unwrap_or_default() })
}

/// What is not known well enough does not vanish silently.
fn say_excluded(manifest: &ChartDocument, talk: Talk) {
    for scene in &manifest.scenes {
        let sum =
            |count: fn(&stratiform_artifact::ChartCloud) -> u64| scene.clouds.iter().map(count).sum::<u64>();
        let (known, excluded) = (sum(|cloud| cloud.radiances), sum(|cloud| cloud.excluded));
        if excluded > 0 {
            talk.say(format!(
                "{}: {excluded} of {} radiances left out, the truth there being uncertain by more than {} %",
                scene.name,
                known + excluded,
                100.0 * manifest.largest_truth_error
            ));
        }
    }
}

fn fault(error: ChartError) -> CliError {
    match error {
        ChartError::Cancelled => CliError::Interrupted,
        ChartError::Optics(error) => pipeline::optics::optics_error(error),
        ChartError::Transport(error) => pipeline::trace_error(error),
        other => CliError::Input(other.to_string()),
    }
}
