//! `stratiform export`: phase functions and parameters as others load them.

use crate::args::{ExportArgs, Format};
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline::export::phase_set;
use crate::{CliError, pipeline, progress};
use serde::Serialize;
use stratiform_artifact::{create_folder, write_atomic};
use stratiform_tables::TablesError;
use stratiform_tables::set::{NamedCard, PhaseSet, SampledSet};
use stratiform_tables::write::{Precision, phase_csv, phase_exr, phase_json, phase_ktx2, phase_npz};

/// A file before it is written.
#[derive(Clone, Serialize)]
struct File {
    #[serde(rename = "file")]
    name: String,
    #[serde(skip)]
    bytes: Vec<u8>,
    /// What its phase functions are worth.
    cards: Vec<NamedCard>,
}

/// What the writers choose from.
struct Source {
    phase: PhaseSet,
    sampled: SampledSet,
}

/// Runs the command. Every file is made before the first is written.
///
/// # Errors
/// [`CliError::Input`] for bad input, or a number that a format cannot hold.
pub fn run(args: &ExportArgs, talk: Talk) -> Result<Data, CliError> {
    let config = Config::load(&args.config)?;
    let spinner = progress::spinner("optics", talk.quiet);
    let phase = phase_set(&config);
    spinner.finish_and_clear();
    let phase = phase?;
    let sampled = phase.sample(args.texels).map_err(pipeline::input_error)?;
    let source = Source { phase, sampled };
    let mut formats = args.formats.clone();
    formats.sort();
    formats.dedup();
    let files = formats.into_iter().map(|format| files(format, &source));
    let files = files.collect::<Result<Vec<_>, _>>().map_err(pipeline::input_error)?.concat();
    create_folder(&args.out)?;
    for file in &files {
        write_atomic(&args.out.join(&file.name), &file.bytes)?;
    }
    talk.say(format!("{} files written to {}", files.len(), args.out.display()));
    Ok(if args.json { object(&files) } else { table(&files) })
}

/// The files of one format.
fn files(format: Format, source: &Source) -> Result<Vec<File>, TablesError> {
    let Source { phase, sampled } = source;
    let file = |name: &str, precision: Precision, bytes: Result<Vec<u8>, TablesError>| {
        Ok(vec![File { name: name.to_owned(), bytes: bytes?, cards: phase.cards(sampled, precision) }])
    };
    match format {
        Format::Csv => file("phase.csv", Precision::F64, phase_csv(sampled)),
        Format::Json => file("phase.json", Precision::F64, phase_json(sampled)),
        Format::Npz => file("phase.npz", Precision::F64, phase_npz(sampled)),
        Format::Exr => file("phase.exr", Precision::F32, phase_exr(sampled)),
        Format::Ktx2F32 => file("phase-rgba32f.ktx2", Precision::F32, phase_ktx2(sampled, Precision::F32)),
        Format::Ktx2F16 => file("phase-rgba16f.ktx2", Precision::F16, phase_ktx2(sampled, Precision::F16)),
    }
}

fn table(files: &[File]) -> String {
    let rows =
        files.iter().flat_map(|file| file.cards.iter().map(|card| format!("{},{}\n", file.name, card.csv())));
    format!("file,{}\n{}", NamedCard::columns(), rows.collect::<String>())
}

fn object(files: &[File]) -> String {
    let object = serde_json::json!({ "schema": "stratiform/export/1", "files": files });
    format!("{object}\n")
}
