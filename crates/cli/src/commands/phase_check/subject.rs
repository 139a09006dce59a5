//! What is looked at: a table, an analytic phase function, or single constants.

use crate::CliError;
use crate::args::PhaseCheckArgs;
use crate::pipeline::input_error;
use std::path::Path;
use stratiform_artifact::{line_of, read_json, read_text};
use stratiform_tables::TablesError;
use stratiform_tables::diagnosis::{Constants, tabulated};
use stratiform_tables::nearest::Blend;
use stratiform_tables::read::{Choice, RawTable, read};

/// What was named on the command line.
pub(super) struct Subject {
    /// The file, or the option as typed.
    pub(super) name: String,
    /// A table read, or a phase function tabulated.
    pub(super) table: Option<RawTable>,
    pub(super) constants: Option<Constants>,
}

impl Subject {
    pub(super) fn of(args: &PhaseCheckArgs) -> Result<Self, CliError> {
        match &args.file {
            Some(file) => Self::from_file(file, args),
            None => {
                let (name, blend) = typed(args)?;
                Self::from_constants(name, Constants { blend: Some(blend), ..Constants::default() })
            }
        }
    }

    /// Constants from .toml and .json, tables from everything else.
    fn from_file(file: &Path, args: &PhaseCheckArgs) -> Result<Self, CliError> {
        let name = file.display().to_string();
        let is_constants =
            file.extension().is_some_and(|extension| extension == "json" || extension == "toml");
        if is_constants
            && (args.column.is_some() || args.file_wavelength.is_some() || args.file_r_eff.is_some())
        {
            let message =
                "constants have no rows: --column, --file-wavelength and --file-r-eff are for tables";
            return Err(CliError::Input(format!("{name}: {message}")));
        }
        match file.extension().and_then(|extension| extension.to_str()) {
            Some("json") => Self::from_constants(name, read_json(file)?),
            Some("toml") => Self::from_constants(name, read_toml(file)?),
            _ => {
                let choice = Choice {
                    column: args.column.clone(),
                    wavelength: args.file_wavelength,
                    effective_radius: args.file_r_eff,
                };
                let table = Some(read(file, &choice).map_err(input_error)?);
                Ok(Self { name, table, constants: None })
            }
        }
    }

    fn from_constants(name: String, constants: Constants) -> Result<Self, CliError> {
        if constants.is_empty() {
            return Err(CliError::Input(format!("{name}: no constants")));
        }
        let tabulate = |blend: Blend| -> Result<RawTable, TablesError> { tabulated(&blend.phase()?) };
        let table = constants.phase().and_then(|blend| blend.map(tabulate).transpose());
        let table = table.map_err(|error| input_error(error).at(&name))?;
        Ok(Self { name, table, constants: Some(constants) })
    }
}

fn read_toml(file: &Path) -> Result<Constants, CliError> {
    let text = read_text(file)?;
    toml::from_str(&text).map_err(|error| {
        let line = error.span().map_or(1, |span| line_of(&text, span.start));
        CliError::Input(format!("{}:{line}: {}", file.display(), error.message()))
    })
}

/// The phase function of `--hg`, `--two-lobe` or `--draine`.
fn typed(args: &PhaseCheckArgs) -> Result<(String, Blend), CliError> {
    let needed = |what: &str, count: usize| CliError::Input(format!("--{what}: {count} numbers are needed"));
    if let Some(g) = args.hg {
        return Ok((format!("--hg {g}"), Blend::henyey_greenstein(g)));
    }
    if !args.two_lobe.is_empty() {
        let [w, g1, g2] = args.two_lobe[..] else { return Err(needed("two-lobe", 3)) };
        return Ok((format!("--two-lobe {w},{g1},{g2}"), Blend::two_lobe(w, g1, g2)));
    }
    let [w, g1, g2, alpha] = args.draine[..] else { return Err(needed("draine", 4)) };
    Ok((format!("--draine {w},{g1},{g2},{alpha}"), Blend { w, g1, g2, alpha }))
}
