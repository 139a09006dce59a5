//! Fluxes from a family's tables, and their errors against solver and own fit.

use super::member::Computed;
use crate::CliError;
use crate::pipeline::fluxes::light;
use crate::pipeline::input_error;
use crate::pipeline::ladder::loss::{Nine, Step, at};
use stratiform_artifact::{FamilyErrorRow, LadderRow};
use stratiform_codegen::{diffuse_parameters, family_member, parameter_grid};
use stratiform_model::family::{ParameterFamily, RadiusCoordinate};
use stratiform_model::{Form, ModelError, Parameters, Thickness};
use stratiform_quantities::Incidence;

/// The family of these members.
///
/// # Errors
/// [`CliError::Input`] for parameters out of the model's domain.
pub fn family(coordinate: RadiusCoordinate, members: &[&Computed]) -> Result<ParameterFamily<f64>, CliError> {
    let tables = members.iter().map(|one| family_member(one.radius_um, &one.parameters.optical));
    let tables = tables.collect::<Result<Vec<_>, _>>().map_err(input_error)?;
    ParameterFamily::new(coordinate, &tables).map_err(input_error)
}

/// The model at the places of `computed` with the parameters that `beam` and `diffuse` give, thickness multiplied by
/// `scale`.
pub fn fluxes(
    computed: &Computed,
    scale: f64,
    beam: impl Fn(f64) -> Result<Parameters<f64>, ModelError>,
    diffuse: &Parameters<f64>,
) -> Result<Vec<Nine>, CliError> {
    let one = |place: &crate::pipeline::ladder::loss::Place| {
        let parameters = match light(&place.row)? {
            Incidence::Beam(mu) => beam(mu.get()).map_err(input_error)?,
            Incidence::Diffuse => *diffuse,
        };
        let thickness = Thickness::new(place.tau * scale).map_err(input_error)?;
        Ok(parameters.fluxes(Form::Corrected, thickness).named().map(|(_, value)| value))
    };
    computed.places.iter().map(one).collect()
}

/// The model with the table of `table`, entered at `scale` times the thicknesses of `computed`.
pub fn from_table(computed: &Computed, scale: f64, table: &Computed) -> Result<Vec<Nine>, CliError> {
    let optical = &table.parameters.optical;
    let grid = parameter_grid(optical).map_err(input_error)?;
    let diffuse = diffuse_parameters(optical).map_err(input_error)?;
    fluxes(computed, scale, |mu| grid.at(mu), &diffuse)
}

/// Rows for `values` at the places of `computed`, against the solver and against its own fit.
pub fn rows(
    computed: &Computed,
    method: &str,
    table_radii: &[f64],
    values: &[Nine],
) -> Result<Vec<FamilyErrorRow>, CliError> {
    let solved = at(&computed.places, &computed.points)?.values;
    let fitted = from_table(computed, 1.0, computed)?;
    let table_radii_um =
        table_radii.iter().map(|radius| format!("{radius:.4}")).collect::<Vec<_>>().join(" ");
    let mut rows = Vec::new();
    for (against, truth) in [("solver", &solved), ("fit", &fitted)] {
        let places = &computed.places;
        let step = Step {
            rung: "",
            places,
            before: truth,
            after: values,
            chance: None,
            known: [true; 9],
            note: String::new(),
        };
        rows.extend(step.rows().into_iter().map(|row| FamilyErrorRow {
            effective_radius_um: computed.radius_um,
            table_radii_um: table_radii_um.clone(),
            method: method.to_owned(),
            against: against.to_owned(),
            ..error_row(row)
        }));
    }
    Ok(rows)
}

fn error_row(row: LadderRow) -> FamilyErrorRow {
    FamilyErrorRow {
        effective_radius_um: 0.0,
        table_radii_um: String::new(),
        method: String::new(),
        against: String::new(),
        angles: row.angles,
        quantity: row.quantity,
        rms: row.rms.unwrap_or(0.0),
        worst: row.worst.unwrap_or(0.0),
        worst_theta_l_deg: row.worst_theta_l_deg,
        worst_tau: row.worst_tau.unwrap_or(0.0),
        points: row.points,
    }
}
