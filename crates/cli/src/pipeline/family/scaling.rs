//! `family-scaling.csv`: the table of one radius at the others, entered with scaled thickness.
//!
//! Similarity (van de Hulst 1980, chapter 14) says that thick slabs depend on (1-g)τ alone; scatterings counted one by one
//! know nothing of it.
//!
//! Found for the table of 7 µm at 4 to 20 µm (fit-configs/family.toml), worst error up to 80° against each radius's own table
//! in shares of the incident flux:
//!
//! | thickness | T_ms | T_1 | T_2 | R_1 | R_2 |
//! | --- | --- | --- | --- | --- | --- |
//! | τ | 0.038 | 0.023 | 0.018 | 0.0044 | 0.0057 |
//! | (1-P_f)τ | 0.016 | 0.0036 | 0.0044 | 0.0039 | 0.0029 |
//! | (1-g)τ | 0.011 | 0.012 | 0.010 | 0.0039 | 0.0037 |
//!
//! Totals in (1-g)τ and orders in (1-P_f)τ thus remove the axis to about 0.01, as much as the model's own misfit (0.014 in
//! T_ms); (1-g_S)(1-P_f)τ is (1-g)τ again. R_1 keeps its error: how much is scattered back changes with size. Two tables,
//! interpolated, are ten times better.

use super::errors::{from_table, rows as error_rows};
use super::member::Computed;
use crate::CliError;
use crate::config::Config;
use crate::pipeline::optics::optics_error;
use stratiform_artifact::FamilyErrorRow;

/// A thickness: its name, and the factor of τ.
type Variable = (&'static str, fn(&Computed) -> f64);

/// The thicknesses tried.
const VARIABLES: [Variable; 4] = [
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
