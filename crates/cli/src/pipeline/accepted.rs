//! The artifacts that code is generated from: a folder with parameters, phase tables and reference fluxes.
//!
//! `reproduce` writes such a folder under its own; a copy of it, once looked at, is what is committed as accepted.

use super::{family, input_error, provenance, radiance};
use crate::CliError;
use crate::config::Config;
use std::path::Path;
use stratiform_artifact::{FamilyDocument, ParametersDocument, read_csv, read_json, write_csv, write_json};
use stratiform_codegen::{Files, Inputs, PhaseTables, generate, generate_family};

/// The files, in the order of the fields.
pub const FILES: [&str; 5] =
    ["parameters.json", "phase_full.csv", "phase_modified.csv", "phase_squared.csv", "reference.csv"];

/// Beside them, where the medium has a forward peak.
pub const HALO: &str = "halo.json";

/// Reads `folder`.
///
/// # Errors
/// [`CliError::Input`] naming the file that is missing or damaged.
pub fn read(folder: &Path) -> Result<Inputs, CliError> {
    Ok(Inputs {
        parameters: read_json(&folder.join(FILES[0]))?,
        phase: PhaseTables {
            full: read_csv(&folder.join(FILES[1]))?,
            modified: read_csv(&folder.join(FILES[2]))?,
            squared: read_csv(&folder.join(FILES[3]))?,
        },
        halo: Some(folder.join(HALO))
            .filter(|path| path.exists())
            .map(|path| read_json(&path))
            .transpose()?,
        radiance: Some(folder.join(radiance::FILE))
            .filter(|path| path.exists())
            .map(|path| read_json(&path))
            .transpose()?,
        reference: read_csv(&folder.join(FILES[4]))?,
    })
}

/// Whether `parameters` were made from the optics, transport and fit of `config`.
pub fn belong(parameters: &ParametersDocument, config: &Config) -> bool {
    parameters.provenance.config_hash == provenance(config).config_hash
}

/// The family's tables, where the config has one.
pub const FAMILY: &str = "family.json";

/// Reads the family's tables of `folder`, none if the config has no family.
///
/// # Errors
/// [`CliError::Input`] for a missing or damaged file; [`CliError::Failed`] if it was made from another config.
pub fn read_family(config: &Config, folder: &Path) -> Result<Option<FamilyDocument>, CliError> {
    let Some(section) = &config.family else { return Ok(None) };
    let document: FamilyDocument = read_json(&folder.join(FAMILY))?;
    if document.provenance.config_hash != family::provenance(config, section).config_hash {
        let file = folder.join(FAMILY);
        let message = format!("{}: the accepted family is of another config: reproduce it", file.display());
        return Err(CliError::Failed(message));
    }
    Ok(Some(document))
}

/// Everything that is emitted for the config from `inputs` and what `folder` holds of its family.
///
/// # Errors
/// As [`read_family`], and [`CliError::Input`] for inputs that give no code.
pub fn emitted(config: &Config, inputs: &Inputs, folder: &Path) -> Result<Files, CliError> {
    let targets = &config.codegen.targets;
    let files = generate(inputs, targets).map_err(input_error)?;
    match read_family(config, folder)? {
        None => Ok(files),
        Some(family) => Ok(files.and(generate_family(inputs, &family, targets).map_err(input_error)?)),
    }
}

/// That the coefficients of radiance among `inputs`, if any, were made from the optics and the radiance settings of `config`.
fn check_radiance(config: &Config, inputs: &Inputs, folder: &Path) -> Result<(), CliError> {
    let Some(document) = &inputs.radiance else { return Ok(()) };
    let file = folder.join(radiance::FILE);
    let expected =
        config.radiance.as_ref().map(|settings| radiance::provenance(config, settings).config_hash);
    match expected {
        Some(expected) if expected == document.provenance.config_hash => Ok(()),
        Some(expected) => Err(CliError::Failed(format!(
            "{}: the accepted radiance model is of another config (hash {}, this one's optics and [radiance] have {expected}): \
             reproduce it",
            file.display(),
            document.provenance.config_hash
        ))),
        None => Err(CliError::Failed(format!(
            "{}: the config has no [radiance], whose result this is: delete the file",
            file.display()
        ))),
    }
}

/// Reads `folder` if what is in it was made from `config`.
///
/// # Errors
/// As [`read`]; [`CliError::Failed`] if it was made from another config's optics, transport, fit or radiance model.
pub fn read_for(config: &Config, folder: &Path) -> Result<Inputs, CliError> {
    let inputs = read(folder)?;
    if !belong(&inputs.parameters, config) {
        let (found, expected) = (&inputs.parameters.provenance.config_hash, provenance(config).config_hash);
        return Err(CliError::Failed(format!(
            "{}: the accepted parameters are of another config (hash {found}, this one's optics, transport and fit have \
             {expected}): run `stratiform reproduce` on it, look at the result, and copy its folder `accepted` there",
            folder.display()
        )));
    }
    check_radiance(config, &inputs, folder)?;
    Ok(inputs)
}

/// Writes `folder`, which must exist.
///
/// # Errors
/// [`CliError::Input`] if a file cannot be written.
pub fn write(folder: &Path, inputs: &Inputs) -> Result<(), CliError> {
    write_json(&folder.join(FILES[0]), &inputs.parameters)?;
    write_csv(&folder.join(FILES[1]), &inputs.phase.full)?;
    write_csv(&folder.join(FILES[2]), &inputs.phase.modified)?;
    write_csv(&folder.join(FILES[3]), &inputs.phase.squared)?;
    write_csv(&folder.join(FILES[4]), &inputs.reference)?;
    if let Some(halo) = &inputs.halo {
        write_json(&folder.join(HALO), halo)?;
    }
    Ok(())
}
