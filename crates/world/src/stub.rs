//! Stands in for `Material::load` until that reads a folder's colours: all channels are those of the tables' wavelength.

use crate::{Material, WorldError};
use std::path::Path;
use stratiform_artifact::{ParametersDocument, read_json};
use stratiform_optics::phase::{Norm, PhaseTable};

pub fn load(folder: &Path) -> Result<Material, WorldError> {
    let accepted = folder.join("accepted");
    let table: ParametersDocument = read_json(&accepted.join("parameters.json"))?;
    let medium = table.medium;
    let phase = PhaseTable::read(&accepted.join("phase_full.csv"), Norm::Strict)?;
    let squared = phase.squared()?;
    Ok(Material {
        generated: folder.join("generated"),
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
