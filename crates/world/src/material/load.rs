//! A material from a folder that `reproduce` wrote, or a committed one: `accepted/` with numbers, `generated/` with text.
//!
//! All that it reads says from which config it was made, but for `phase_full.csv`, whose P_f must be that of the parameters.

use super::Material;
use crate::WorldError;
use std::path::Path;
use stratiform_artifact::{
    ArtifactError, MediumRecord, ParametersDocument, PhaseColour, read_json, read_text,
};
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;

/// What a folder must hold.
const NEEDED: [&str; 7] = [
    "accepted/parameters.json",
    "accepted/phase_full.csv",
    "accepted/phase_colour.csv",
    "generated/parameters.json",
    "generated/stratiform.wgsl",
    "generated/stratiform_weights.wgsl",
    "generated/stratiform_phase.wgsl",
];

/// How far P_f of a table may be from what the parameters say: between nodes the table is linear.
const SAME_SHARE: f64 = 1e-4;

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
        let [colour, colour_squared] = read_colour(folder, &parameters)?;
        let medium = parameters.medium;
        check_share(&phase, &medium, &accepted)?;
        Ok(Self {
            generated,
            extinction_per_m: medium.extinction_per_m,
            extinction_convention: medium.extinction_convention,
            single_scattering_albedo: medium.single_scattering_albedo,
            asymmetry: medium.asymmetry,
            theta_f_deg: medium.theta_f_deg,
            forward_fraction: medium.forward_fraction,
            phase,
            colour,
            colour_squared,
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
    PhaseTable::read(file, Norm::Strict).map_err(|error| told(file, error))
}

/// That the table has the share of forward scattering that the parameters were fitted with.
fn check_share(phase: &PhaseTable, medium: &MediumRecord, accepted: &Path) -> Result<(), WorldError> {
    let found = if medium.theta_f_deg > 0.0 { phase.forward_fraction(medium.theta_f_deg)? } else { 0.0 };
    if (found - medium.forward_fraction).abs() < SAME_SHARE {
        return Ok(());
    }
    let message = format!(
        "phase_full.csv sends {found} of its light below {} degrees, parameters.json says {}",
        medium.theta_f_deg, medium.forward_fraction
    );
    Err(refused(accepted, message))
}

/// P and P² in red, green and blue.
fn read_colour(folder: &Path, parameters: &ParametersDocument) -> Result<[[PhaseTable; 3]; 2], WorldError> {
    let file = folder.join("accepted/phase_colour.csv");
    let table = PhaseColour::read(&file)?;
    let expected = &parameters.provenance.config_hash;
    if table.config_hash != *expected {
        let found = &table.config_hash;
        let message = format!(
            "phase_colour.csv was made from config {found}, parameters.json beside it from {expected}"
        );
        return Err(refused(folder, message));
    }
    let theta: Vec<f64> = table.rows.iter().map(|row| row.theta_deg).collect();
    let channel = |k: usize, c: usize| {
        let p = table.rows.iter().map(|row| row.channels()[k][c]).collect();
        PhaseTable::new(theta.clone(), p, Norm::Strict).map_err(|error| told(&file, error))
    };
    let channels = |k| Ok::<_, WorldError>([channel(k, 0)?, channel(k, 1)?, channel(k, 2)?]);
    Ok([channels(0)?, channels(1)?])
}

fn told(file: &Path, error: OpticsError) -> WorldError {
    match error {
        OpticsError::NotNormalised { .. } => ArtifactError::format(file, None, error.to_string()).into(),
        other => other.into(),
    }
}
