//! `family-scaling.csv`: the table of one radius at the others, entered with scaled thickness.
//!
//! Similarity (van de Hulst 1980, chapter 14) says that thick slabs depend on (1-g)τ alone; scatterings counted one by one
//! know nothing of it.

use super::errors::{from_table, rows as error_rows};
use super::member::Computed;
use crate::CliError;
use crate::config::Config;
use crate::pipeline::optics::optics_error;
use stratiform_artifact::FamilyErrorRow;

/// The thicknesses tried: name, and the factor of τ.
const VARIABLES: [(&str, fn(&Computed) -> f64); 4] = [
    ("tau", |_| 1.0),
    ("(1-P_f) tau", scattering),
    ("(1-g) tau", |one| 1.0 - one.parameters.medium.asymmetry),
    ("(1-g_S)(1-P_f) tau", |one| (1.0 - one.modified_asymmetry) * scattering(one)),
];

fn scattering(one: &Computed) -> f64 {
    1.0 - one.parameters.medium.forward_fraction
}

/// Every row of the file.
///
/// # Errors
/// Those of the config's own member, and [`CliError::Input`] for parameters out of the model's domain.
pub fn rows(config: &Config, members: &[Computed]) -> Result<Vec<FamilyErrorRow>, CliError> {
    let own = config.optics.resolve().map_err(optics_error)?.effective_radius();
    // The member nearest to the config's own radius.
    let distance = |one: &&Computed| (one.radius_um / own - 1.0).abs();
    let nearest = members.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let table = nearest.ok_or_else(|| CliError::Input("the family is empty".to_owned()))?;
    let mut rows = Vec::new();
    for computed in members {
        let own = from_table(computed, 1.0, computed)?;
        rows.extend(error_rows(computed, "own", &[computed.radius_um], &own)?);
        for (name, factor) in VARIABLES {
            let values = from_table(computed, factor(computed) / factor(table), table)?;
            rows.extend(error_rows(computed, name, &[table.radius_um], &values)?);
        }
    }
    Ok(rows)
}
