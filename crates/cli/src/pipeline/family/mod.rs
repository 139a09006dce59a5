//! One table for a family of clouds: a table per effective radius, what interpolation between them loses, and whether
//! scaled thickness would make the radii superfluous.
//!
//! Every member has the config's law of droplet sizes, stretched to its r_e, and the N0 at which N0 π r_e² is the config's:
//! the grid of thicknesses is then the same grid of optical thicknesses. Tables are used in optical thickness, so that
//! N0 does not matter.
//!
//! | file | content |
//! | --- | --- |
//! | `family.json` | the tables, with g, P_f, κ of each radius |
//! | `family-interpolation.csv` | radii half-way between: interpolated tables against the solver, and against their own fit |
//! | `family-scaling.csv` | the table of the config's own radius at the others, entered with scaled thicknesses |

mod errors;
mod interpolation;
mod member;
mod scaling;
mod summary;

pub use summary::summary;

use crate::CliError;
use crate::config::{Config, FamilyConfig};
use crate::output::Talk;
use crate::progress;
use member::Computed;
use std::path::Path;
use stratiform_artifact::{FamilyDocument, Provenance, hash_of, write_csv, write_json};
use stratiform_model::family::RadiusCoordinate;

/// The coordinate that `family-interpolation.csv` finds best, and emitted code uses.
pub const COORDINATE: RadiusCoordinate = RadiusCoordinate::TwoThirds;

/// The files, in the order of the table above.
pub const FILES: [&str; 3] = ["family.json", "family-interpolation.csv", "family-scaling.csv"];

/// What the family depends on.
pub fn inputs(config: &Config, family: &FamilyConfig) -> impl serde::Serialize + use<> {
    let source = config.transport.source;
    (config.optics.clone(), config.transport.that_counts(source), config.fit.clone(), family.clone())
}

/// Computes every member and writes the files.
///
/// # Errors
/// Those of optics, solver and fit, and [`CliError::Input`] if a file cannot be written.
pub fn write(
    config: &Config,
    family: &FamilyConfig,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let radii = &family.effective_radius_um;
    let half_way: Vec<f64> = radii.windows(2).map(|pair| (pair[0] * pair[1]).sqrt()).collect();
    let bar = progress::bar((radii.len() + half_way.len()) as u64, "effective radii", talk.quiet);
    let compute = |radii: &[f64]| -> Result<Vec<Computed>, CliError> {
        let one = |radius: &f64| {
            let member = Computed::new(config, *radius);
            bar.inc(1);
            member
        };
        radii.iter().map(one).collect()
    };
    let (members, between) = (compute(radii)?, compute(&half_way)?);
    bar.finish_and_clear();
    let document = FamilyDocument {
        schema: FamilyDocument::SCHEMA.to_owned(),
        provenance: provenance(config, family),
        coordinate: COORDINATE.to_string(),
        members: members.iter().map(Computed::artifact).collect(),
    };
    write_json(&dir.join(FILES[0]), &document)?;
    write_csv(&dir.join(FILES[1]), &interpolation::rows(&members, &between)?)?;
    write_csv(&dir.join(FILES[2]), &scaling::rows(config, &members)?)?;
    Ok(FILES.map(str::to_owned).to_vec())
}

/// Provenance of the whole family.
pub fn provenance(config: &Config, family: &FamilyConfig) -> Provenance {
    Provenance { config_hash: hash_of(&inputs(config, family)), ..super::provenance(config) }
}
