//! Whether a table's parameters still are what a fresh fit gives: b, κ_c, t, r, bounded relatively.
//!
//! A fit's misfit hides small slips of a parameter in the fluxes. It is the same in both fits here and cancels, so that this
//! bound may be small. Not compared are c, and with it b, of a row where only one of the fits has a c.

use crate::FitError;
use serde::{Deserialize, Serialize};
use stratiform_artifact::{FittedParameter, ParameterRow, ParametersDocument, RowIncidence};
use stratiform_quantities::{DomainError, Range};

/// What is accepted of a table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "the names are those of the model")]
pub struct ModelBounds {
    /// Rows beyond this angle are not held to anything: the model's form cannot fit there.
    pub up_to_deg: f64,
    /// Largest |table - fresh fit| relative to the table, for b, κ_c, t and r.
    pub parameters_relative: f64,
    /// Largest |table - true flux|, from here on.
    pub t_ms: f64,
    pub t_1: f64,
    pub t_2: f64,
    pub r_1: f64,
    pub r_2: f64,
}

impl ModelBounds {
    /// Checks every number; `table` is the config's name of these bounds.
    ///
    /// # Errors
    /// [`DomainError`] naming the bound.
    pub fn check(&self, table: &str) -> Result<(), DomainError> {
        let Self { up_to_deg, parameters_relative, t_ms, t_1, t_2, r_1, r_2 } = *self;
        Range::closed(0.0, 90.0).check(&format!("{table}.up_to_deg"), up_to_deg)?;
        let all = [
            ("parameters_relative", parameters_relative),
            ("t_ms", t_ms),
            ("t_1", t_1),
            ("t_2", t_2),
            ("r_1", r_1),
            ("r_2", r_2),
        ];
        for (name, bound) in all {
            Range::closed(0.0, 1.0).check(&format!("{table}.{name}"), bound)?;
        }
        Ok(())
    }

    /// Whether a row is held to them: all but angles beyond `up_to_deg`.
    pub fn hold(&self, row: &RowIncidence) -> bool {
        row.degrees().is_none_or(|theta| theta <= self.up_to_deg)
    }
}

/// One parameter of a table beside that of a fresh fit.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldParameter {
    /// Row of the table.
    pub theta_l_deg: RowIncidence,
    /// `b`, `kappa_c`, `t` or `r`.
    pub parameter: &'static str,
    /// What the table says.
    pub table: f64,
    /// What the fresh fit says.
    pub fresh: f64,
    /// Standard error of the difference.
    pub std_error: f64,
}

/// The parameters of `table` beside those of `fresh`, in optical thickness, up to the bounds' angle.
///
/// # Errors
/// [`FitError::Inconsistent`] if `fresh` lacks a row.
pub fn held_parameters(
    table: &ParametersDocument,
    fresh: &ParametersDocument,
    bounds: &ModelBounds,
) -> Result<Vec<HeldParameter>, FitError> {
    let mut held = Vec::new();
    for row in table.optical.rows.iter().filter(|row| bounds.hold(&row.theta_l_deg)) {
        let missing = || FitError::Inconsistent(format!("no fresh fit at theta_l = {}", row.theta_l_deg));
        let again = fresh.optical.rows.iter().find(|r| r.theta_l_deg == row.theta_l_deg);
        held.extend(of_row(row, again.ok_or_else(missing)?));
    }
    Ok(held)
}

fn of_row(row: &ParameterRow, again: &ParameterRow) -> Vec<HeldParameter> {
    let pairs: [(&'static str, &FittedParameter, &FittedParameter); 4] = [
        ("b", &row.b, &again.b),
        ("kappa_c", &row.kappa_c, &again.kappa_c),
        ("t", &row.t, &again.t),
        ("r", &row.r, &again.r),
    ];
    let same_c = row.c.value.is_some() == again.c.value.is_some();
    let hold = |(parameter, a, b): (&'static str, &FittedParameter, &FittedParameter)| {
        let errors = [a.std_error.unwrap_or(0.0), b.std_error.unwrap_or(0.0)];
        Some(HeldParameter {
            theta_l_deg: row.theta_l_deg.clone(),
            parameter,
            table: a.value?,
            fresh: b.value?,
            std_error: libm::hypot(errors[0], errors[1]),
        })
    };
    pairs.into_iter().filter(|(name, ..)| same_c || *name != "b").filter_map(hold).collect()
}
