//! The artifacts that code is generated from: a folder with parameters, phase tables and reference fluxes.
//!
//! `reproduce` writes such a folder under its own; a copy of it, once looked at, is what is committed as accepted.

use crate::CliError;
use std::path::Path;
use stratiform_artifact::{read_csv, read_json, write_csv, write_json};
use stratiform_codegen::{Inputs, PhaseTables};

/// The files, in the order of the fields.
pub const FILES: [&str; 5] =
    ["parameters.json", "phase_full.csv", "phase_modified.csv", "phase_squared.csv", "reference.csv"];

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
        reference: read_csv(&folder.join(FILES[4]))?,
    })
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
    Ok(())
}
