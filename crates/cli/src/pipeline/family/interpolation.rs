//! `family-interpolation.csv`: at radii half-way between, tables interpolated in every coordinate; and the same from every
//! second table, and from the first and the last alone, at the radii left out.

use super::errors::{family, fluxes, from_table, rows as error_rows};
use super::member::Computed;
use crate::CliError;
use crate::pipeline::input_error;
use stratiform_artifact::FamilyErrorRow;
use stratiform_model::family::RadiusCoordinate;

/// Every row of the file.
///
/// # Errors
/// [`CliError::Input`] for parameters out of the model's domain.
pub fn rows(members: &[Computed], half_way: &[Computed]) -> Result<Vec<FamilyErrorRow>, CliError> {
    let all: Vec<&Computed> = members.iter().collect();
    let mut rows = Vec::new();
    for computed in half_way {
        rows.extend(error_rows(
            computed,
            "own",
            &[computed.radius_um],
            &from_table(computed, 1.0, computed)?,
        )?);
    }
    rows.extend(interpolated(&all, &half_way.iter().collect::<Vec<_>>())?);
    for step in [2, members.len() - 1] {
        let (kept, left_out): (Vec<_>, Vec<_>) = (0..).zip(&all).partition(|(i, _)| i % step == 0);
        let [kept, left_out] =
            [kept, left_out].map(|list| list.into_iter().map(|(_, one)| *one).collect::<Vec<_>>());
        if kept.len() > 1 && kept.len() < all.len() {
            rows.extend(interpolated(&kept, &left_out)?);
        }
    }
    Ok(rows)
}

/// Errors at those of `wanted` that lie between `tables`.
fn interpolated(tables: &[&Computed], wanted: &[&Computed]) -> Result<Vec<FamilyErrorRow>, CliError> {
    let radii: Vec<f64> = tables.iter().map(|one| one.radius_um).collect();
    let inside = |one: &&&Computed| radii.last().is_some_and(|last| one.radius_um < *last);
    let mut rows = Vec::new();
    for coordinate in RadiusCoordinate::ALL {
        let family = family(coordinate, tables)?;
        for computed in wanted.iter().filter(inside) {
            let radius = computed.radius_um;
            let diffuse = family.diffuse(radius).map_err(input_error)?;
            let values = fluxes(computed, 1.0, |mu| family.at(mu, radius), &diffuse)?;
            rows.extend(error_rows(computed, &coordinate.to_string(), &radii, &values)?);
        }
    }
    Ok(rows)
}
