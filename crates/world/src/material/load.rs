//! A material from a folder that `reproduce` wrote, or a committed one: `accepted/` with numbers, `generated/` with text.

use super::Material;
use crate::WorldError;
use std::path::Path;
use stratiform_artifact::{ArtifactError, MediumRecord, ParametersDocument, read_json, read_text};
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;

/// What a folder must hold.
const NEEDED: [&str; 7] = [
    "accepted/parameters.json",
    "accepted/phase_full.csv",
    "accepted/phase_squared.csv",
    "generated/parameters.json",
    "generated/stratiform.wgsl",
    "generated/stratiform_weights.wgsl",
    "generated/stratiform_phase.wgsl",
];

impl Material {
    /// Reads `folder`.
    ///
    /// # Errors
    /// [`WorldError::Folder`] naming all files that are missing, or those that were made from different configs;
    /// [`WorldError::Artifact`] and [`WorldError::Optics`] with file and line for a damaged one.
    pub fn load(folder: &Path) -> Result<Self, WorldError> {
        check_files(folder)?;
        let [accepted, generated] = ["accepted", "generated"].map(|name| folder.join(name));
        let parameters: ParametersDocument = read_json(&accepted.join("parameters.json"))?;
        check_medium(&parameters.medium, &accepted.join("parameters.json"))?;
        check_text(folder, &parameters)?;
        let phase = read_phase(&accepted.join("phase_full.csv"))?;
        let squared = read_phase(&accepted.join("phase_squared.csv"))?;
        let medium = parameters.medium;
        Ok(Self {
            generated,
            extinction_per_m: medium.extinction_per_m,
            extinction_convention: medium.extinction_convention,
            single_scattering_albedo: medium.single_scattering_albedo,
            asymmetry: medium.asymmetry,
            theta_f_deg: medium.theta_f_deg,
            forward_fraction: medium.forward_fraction,
            colour: [phase.clone(), phase.clone(), phase.clone()],
            colour_squared: [squared.clone(), squared.clone(), squared],
            phase,
        })
    }
}

fn refused(folder: &Path, message: String) -> WorldError {
    WorldError::Folder { folder: folder.to_owned(), message }
}

fn check_files(folder: &Path) -> Result<(), WorldError> {
    if !folder.is_dir() {
        return Err(refused(folder, "is no folder that `reproduce` wrote".to_owned()));
    }
    let missing: Vec<_> = NEEDED.iter().copied().filter(|file| !folder.join(file).is_file()).collect();
    match missing[..] {
        [] => Ok(()),
        _ => Err(refused(folder, format!("lacks {}", missing.join(", ")))),
    }
}

/// That the numbers are those of a medium.
fn check_medium(medium: &MediumRecord, file: &Path) -> Result<(), WorldError> {
    let share = Range { max_included: false, ..Range::closed(0.0, 1.0) };
    let checks = [
        ("extinction_per_m", medium.extinction_per_m, Range::closed(1e-9, 1e9)),
        ("single_scattering_albedo", medium.single_scattering_albedo, Range::closed(0.0, 1.0)),
        ("asymmetry", medium.asymmetry, Range::closed(-1.0, 1.0)),
        ("theta_f_deg", medium.theta_f_deg, Range::closed(0.0, 90.0)),
        ("forward_fraction", medium.forward_fraction, share),
    ];
    for (name, value, range) in checks {
        range.check(name, value).map_err(|error| ArtifactError::format(file, None, error.to_string()))?;
    }
    Ok(())
}

/// That the emitted text was made from these parameters, by the `Config` that stands in its head.
fn check_text(folder: &Path, parameters: &ParametersDocument) -> Result<(), WorldError> {
    let expected = &parameters.provenance.config_hash;
    for file in NEEDED.iter().filter(|file| file.ends_with(".wgsl")) {
        let text = read_text(&folder.join(file))?;
        let config = text.lines().find_map(|line| line.strip_prefix("// Config "));
        match config.map(str::trim) {
            Some(found) if found == expected => {}
            Some(found) => {
                let message =
                    format!("{file} was made from config {found}, accepted/parameters.json from {expected}");
                return Err(refused(folder, message));
            }
            None => return Err(refused(folder, format!("{file} does not say what config it was made from"))),
        }
    }
    Ok(())
}

/// A normalised table; what is wrong with its norm is told with the file's name.
fn read_phase(file: &Path) -> Result<PhaseTable, WorldError> {
    PhaseTable::read(file, Norm::Strict).map_err(|error| match error {
        OpticsError::NotNormalised { .. } => ArtifactError::format(file, None, error.to_string()).into(),
        other => other.into(),
    })
}
