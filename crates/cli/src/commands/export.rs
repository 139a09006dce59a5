//! `stratiform export`: phase functions and parameters as others load them.

use crate::args::{ExportArgs, Format};
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline::export::{accepted_parameters, phase_set};
use crate::{CliError, pipeline, progress};
use serde::Serialize;
use stratiform_artifact::{create_folder, write_atomic};
use stratiform_tables::TablesError;
use stratiform_tables::colour::check_wavelengths;
use stratiform_tables::parameters::ParameterTexels;
use stratiform_tables::peer::{NamedFile, Program};
use stratiform_tables::sampled::TEXELS;
use stratiform_tables::set::{Function, NamedCard, PhaseSet, SampledSet};
use stratiform_tables::write::{
    Precision, parameters_csv, parameters_exr, parameters_json, parameters_ktx2, parameters_npz, phase_csv,
    phase_exr, phase_json, phase_ktx2, phase_npz, rounding,
};

/// A file before it is written.
#[derive(Clone, Serialize)]
struct File {
    #[serde(rename = "file")]
    name: String,
    #[serde(skip)]
    bytes: Vec<u8>,
    #[serde(flatten)]
    worth: Worth,
}

/// What a file is worth against what it was made from.
#[derive(Clone, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Worth {
    /// A card per phase function and channel.
    Cards(Vec<NamedCard>),
    /// Of a parameter table.
    Rounding {
        precision: Precision,
        rows: usize,
        /// Largest relative change by rounding.
        largest_error: f64,
    },
}

/// What the writers choose from.
struct Source {
    /// A channel per wavelength.
    spectral: Phase,
    /// Linear sRGB.
    colour: Option<Phase>,
    /// None before a table was accepted.
    parameters: Option<ParameterTexels>,
}

/// Phase functions before and after sampling.
struct Phase {
    /// The name in files.
    name: &'static str,
    tables: PhaseSet,
    texels: SampledSet,
}

impl Phase {
    fn new(name: &'static str, tables: PhaseSet, texels: usize) -> Result<Self, TablesError> {
        Ok(Self { name, texels: tables.sample(texels)?, tables })
    }
}

/// Runs the command. Every file is made before the first is written.
///
/// # Errors
/// [`CliError::Input`] for bad input, or a number that a format cannot hold.
pub fn run(args: &ExportArgs, talk: Talk) -> Result<Data, CliError> {
    let source = source(args, talk)?;
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
    for (name, largest, at_deg) in files.iter().filter_map(coarse) {
        talk.say(format!("{name}: P is off by {:.0} % at {at_deg:.2} degrees", 100.0 * largest));
    }
    Ok(if args.json { object(&files) } else { table(&files) })
}

fn source(args: &ExportArgs, talk: Talk) -> Result<Source, CliError> {
    let config = Config::load(&args.config)?;
    // Before the optics, which may take long.
    TEXELS.check("texels", args.texels as f64)?;
    check_colour(args, &config)?;
    let parameters = accepted_parameters(&config, &args.config)?;
    if parameters.is_none() {
        talk.say("no accepted parameters of this config: phase functions only");
    }
    let spinner = progress::spinner("optics", talk.quiet);
    let phase = phase_set(&config);
    spinner.finish_and_clear();
    let spectral = phase?;
    let colour = args.srgb.then(|| spectral.linear_srgb());
    let colour = colour.map(|set| Phase::new("phase-srgb", set?, args.texels)).transpose();
    let spectral = Phase::new("phase", spectral, args.texels).map_err(pipeline::input_error)?;
    Ok(Source { spectral, colour: colour.map_err(pipeline::input_error)?, parameters })
}

/// Whether the wavelengths have the colour that is asked for, and a file to hold it.
fn check_colour(args: &ExportArgs, config: &Config) -> Result<(), CliError> {
    if args.srgb && args.formats.iter().all(|format| format.is_peer()) {
        let message =
            "--srgb: none of the formats asked for holds it (csv, json, npz, exr, ktx2-32, ktx2-16 do)";
        return Err(CliError::Input(message.to_owned()));
    }
    let mut wavelengths = config.optics.wavelengths_um.clone();
    wavelengths.sort_by(f64::total_cmp);
    let check = |what: &str| check_wavelengths(&wavelengths).map_err(|e| pipeline::input_error(e).at(what));
    if args.srgb {
        check("--srgb")?;
    }
    if args.formats.contains(&Format::Bevy) {
        check("--formats bevy")?;
    }
    Ok(())
}

/// The files of one format.
fn files(format: Format, source: &Source) -> Result<Vec<File>, TablesError> {
    use Precision::{F16, F32, F64};
    match format {
        Format::Csv => source.pair("csv", F64, phase_csv, parameters_csv),
        Format::Json => source.pair("json", F64, phase_json, parameters_json),
        Format::Npz => source.pair("npz", F64, phase_npz, parameters_npz),
        Format::Exr => source.pair("exr", F32, phase_exr, parameters_exr),
        Format::Ktx2F32 => {
            source.pair("rgba32f.ktx2", F32, |set| phase_ktx2(set, F32), |table| parameters_ktx2(table, F32))
        }
        Format::Ktx2F16 => {
            source.pair("rgba16f.ktx2", F16, |set| phase_ktx2(set, F16), |table| parameters_ktx2(table, F16))
        }
        Format::Mitsuba => source.peer(Program::Mitsuba),
        Format::MitsubaIrregular => source.peer(Program::MitsubaIrregular),
        Format::Eradiate => source.peer(Program::Eradiate),
        Format::Mcx => source.peer(Program::Mcx),
        Format::Disort => source.peer(Program::Disort),
        Format::Bevy => source.peer(Program::Bevy),
    }
}

type Bytes = Result<Vec<u8>, TablesError>;

impl Source {
    /// Another program's files.
    fn peer(&self, program: Program) -> Result<Vec<File>, TablesError> {
        let file =
            |file: NamedFile| File { name: file.name, bytes: file.bytes, worth: Worth::Cards(file.cards) };
        Ok(program.files(&self.spectral.tables)?.into_iter().map(file).collect())
    }

    /// The container of the phase functions, and that of the parameters if there are any.
    fn pair(
        &self,
        ending: &str,
        precision: Precision,
        phase: impl Fn(&SampledSet) -> Bytes,
        parameters: impl Fn(&ParameterTexels) -> Bytes,
    ) -> Result<Vec<File>, TablesError> {
        let mut files = Vec::new();
        for set in [&self.spectral].into_iter().chain(&self.colour) {
            files.push(File {
                name: format!("{}.{ending}", set.name),
                bytes: phase(&set.texels)?,
                worth: Worth::Cards(set.tables.cards(&set.texels, precision)?),
            });
        }
        if let Some(table) = &self.parameters {
            let largest_error = rounding(table, precision);
            let worth = Worth::Rounding { precision, rows: table.rows.len(), largest_error };
            files.push(File { name: format!("parameters.{ending}"), bytes: parameters(table)?, worth });
        }
        Ok(files)
    }
}

/// Relative error of P from which a file is called coarse on stderr.
const COARSE: f64 = 0.05;

/// The file's largest error of P and its place, if it is above [`COARSE`].
fn coarse(file: &File) -> Option<(&str, f64, f64)> {
    let Worth::Cards(cards) = &file.worth else { return None };
    let full = cards.iter().filter(|card| card.function == Function::Full).map(|card| &card.card);
    let worst = full.max_by(|a, b| a.largest_error.total_cmp(&b.largest_error))?;
    (worst.largest_error > COARSE).then_some((file.name.as_str(), worst.largest_error, worst.largest_at_deg))
}

/// A line per card; of a parameter table, a line with what rounding changes.
fn table(files: &[File]) -> String {
    let mut text = format!("file,{}\n", NamedCard::columns());
    for file in files {
        match &file.worth {
            Worth::Cards(cards) => {
                text.extend(cards.iter().map(|card| format!("{},{}\n", file.name, card.csv())));
            }
            Worth::Rounding { precision, rows, largest_error } => {
                let name = precision.name();
                text += &format!("{},parameters,,{name},{rows},,,,,,,,,{largest_error},,,\n", file.name);
            }
        }
    }
    text
}

fn object(files: &[File]) -> String {
    let object = serde_json::json!({ "schema": "stratiform/export/1", "files": files });
    format!("{object}\n")
}
