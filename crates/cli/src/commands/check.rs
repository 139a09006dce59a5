//! `stratiform check`: from what was typed to what is printed and written.

use crate::CliError;
use crate::args::CheckArgs;
use crate::check::config::TracerConfig;
use crate::check::{Part, Verdict, counts, model, report, tracer, values};
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline::{self, optics::Cloud, reference::Media};
use std::path::{Path, PathBuf};
use stratiform_artifact::{Provenance, hash_of, to_csv, write_atomic, write_csv};
use stratiform_reference_data::sha256;

const METHOD: &str = "truth by discrete ordinates; photons by half-space Monte Carlo";

/// Runs the command.
///
/// # Errors
/// [`CliError::Unmet`], with the result, if something is out of bounds; [`CliError`] of bad input.
pub fn run(args: &CheckArgs, talk: Talk) -> Result<Data, CliError> {
    let mut config = Config::load(&args.config)?;
    can_be_written(args)?;
    if let Some(file) = &args.store_counts {
        return store_counts(&mut config, args, file, talk);
    }
    override_tracer(&mut config, args)?;
    let cloud = cloud(&config)?;
    if let Some(file) = &args.points {
        write_csv(file, &values::points(&config, &cloud.tau(&config)))?;
        return Ok(format!("{}\n", file.display()));
    }
    let verdict = match &args.values {
        Some(file) => {
            let judged = values::check(&config, &Media::new(&config, &cloud)?, file)?;
            Verdict { parts: [(Part::Values, judged)].into() }
        }
        None => own(&config, args, &cloud, talk)?,
    };
    render(&config, args, &verdict)
}

/// Whether every file can be written, and over no input and no other output, before any work is done.
fn can_be_written(args: &CheckArgs) -> Result<(), CliError> {
    let outputs = [
        ("--junit", &args.junit),
        ("--markdown", &args.markdown),
        ("--points", &args.points),
        ("--store-counts", &args.store_counts),
    ];
    let inputs = [("the config", Some(&args.config)), ("--values", args.values.as_ref())];
    let named = inputs
        .iter()
        .map(|(name, file)| (*name, *file))
        .chain(outputs.map(|(name, file)| (name, file.as_ref())));
    if let Some((name, _)) = named.into_iter().find(|(_, file)| file.is_some_and(|file| *file == *"-")) {
        return Err(CliError::Input(format!("{name} `-`: pipes are not read or written, name a file")));
    }
    let mut taken: Vec<(&str, PathBuf)> =
        inputs.into_iter().filter_map(|(name, file)| Some((name, resolved(file?)))).collect();
    for (name, file) in outputs.into_iter().filter_map(|(name, file)| Some((name, file.as_ref()?))) {
        let refuse = |why: &str| Err(CliError::Input(format!("cannot write {}: {why}", file.display())));
        if file.is_dir() || file.file_name().is_none() {
            return refuse("it is a folder");
        }
        if file.parent().is_some_and(|p| *p != *"" && !p.is_dir()) {
            return refuse("its folder does not exist");
        }
        let place = resolved(file);
        if let Some((other, _)) = taken.iter().find(|(_, path)| *path == place) {
            return refuse(&format!("{name} is the same file as {other}"));
        }
        taken.push((name, place));
    }
    Ok(())
}

/// The path without links and dots, of a file that need not exist.
fn resolved(file: &Path) -> PathBuf {
    let folder = file.parent().filter(|folder| **folder != *"").unwrap_or(Path::new("."));
    let named = || Some(folder.canonicalize().ok()?.join(file.file_name()?));
    file.canonicalize().ok().or_else(named).unwrap_or_else(|| file.to_owned())
}

/// The cloud at the wavelength of the transport: the others are not needed.
fn cloud(config: &Config) -> Result<Cloud, CliError> {
    let mut config = config.clone();
    config.optics.wavelengths_um = vec![config.transport.wavelength_um];
    pipeline::optics::at_transport_wavelength(&config)
}

/// A path of the config, which is relative to its folder.
fn beside(args: &CheckArgs, path: &str) -> PathBuf {
    args.config.parent().unwrap_or(Path::new("")).join(path)
}

/// The table and the tracer of this project.
fn own(config: &Config, args: &CheckArgs, cloud: &Cloud, talk: Talk) -> Result<Verdict, CliError> {
    let media = Media::new(config, cloud)?;
    let table = pipeline::accepted::read(&beside(args, &config.codegen.accepted))?.parameters;
    let truth = model::ModelTruth::solve(config, cloud, &media)?;
    let mut verdict = Verdict::default();
    verdict.parts.insert(Part::Model, truth.compare(config, &table)?);
    match &config.check.tracer {
        Some(section) => {
            let file = beside(args, &section.counts);
            verdict.parts.insert(Part::Tracer, tracer::check(config, cloud, section, &file, talk)?);
        }
        None => talk.say("tracer: left out (no section [check.tracer])"),
    }
    Ok(verdict)
}

fn render(config: &Config, args: &CheckArgs, verdict: &Verdict) -> Result<Data, CliError> {
    let junit = report::to_junit(verdict, args.worst)?;
    let markdown = report::to_markdown(verdict, &config.title, args.worst);
    let data = if args.json {
        let seed = config.check.tracer.as_ref().filter(|_| args.values.is_none()).map(|tracer| tracer.seed);
        let provenance = Provenance::new(hash_of(config), seed, METHOD);
        report::to_json(verdict, &provenance, args.worst)?
    } else {
        report::to_text(verdict, args.worst)
    };
    for (file, text) in [(&args.junit, &junit), (&args.markdown, &markdown)] {
        if let Some(file) = file {
            write_atomic(file, text.as_bytes())?;
        }
    }
    if verdict.passes() {
        Ok(data)
    } else {
        Err(CliError::Unmet { message: report::headline(verdict), data })
    }
}

fn override_tracer(config: &mut Config, args: &CheckArgs) -> Result<(), CliError> {
    if args.photons.is_none() && args.seed.is_none() {
        return Ok(());
    }
    let tracer = tracer_section(config, &args.config)?;
    tracer.photons = args.photons.unwrap_or(tracer.photons);
    tracer.seed = args.seed.unwrap_or(tracer.seed);
    config.check_again()
}

fn tracer_section<'a>(config: &'a mut Config, path: &Path) -> Result<&'a mut TracerConfig, CliError> {
    let message = format!("{}: the section [check.tracer] is missing", path.display());
    config.check.tracer.as_mut().ok_or(CliError::Input(message))
}

fn store_counts(config: &mut Config, args: &CheckArgs, file: &Path, talk: Talk) -> Result<Data, CliError> {
    let tracer = tracer_section(config, &args.config)?;
    tracer.stored_photons = args.photons.unwrap_or(tracer.stored_photons);
    tracer.stored_seed = args.seed.unwrap_or(tracer.stored_seed);
    let tracer = tracer.clone();
    config.check_again()?;
    let cloud = cloud(config)?;
    let rows = counts::trace(config, &cloud, &tracer, tracer.stored_photons, tracer.stored_seed, talk)?;
    let text = to_csv(&rows)?;
    write_atomic(file, text.as_bytes())?;
    talk.say(format!("SHA-256 for SOURCE.toml: {}", sha256(text.as_bytes())));
    Ok(format!("{}\n", file.display()))
}
