//! Whether what a table emits still is what a fresh fit gives: b, c, κ_c, t, r, bounded relatively.
//!
//! A fit's misfit hides small slips of a parameter in the fluxes. It is the same in both fits here and cancels, so that this
//! bound may be small. Not compared are c of a row where one of the fits does not determine it, and b where only one does:
//! what they make of T_ms together is for the caller to hold.

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
    /// Largest |table - fresh fit| relative to the table, for b, c, κ_c, t and r.
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

/// One emitted parameter of a table beside that of a fresh fit.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldParameter {
    /// Row of the table.
    pub theta_l_deg: RowIncidence,
    /// `b`, `c`, `kappa_c`, `t` or `r`.
    pub parameter: &'static str,
    /// What the table emits.
    pub table: f64,
    /// What the fresh fit would.
    pub fresh: f64,
    /// Standard error of the difference.
    pub std_error: f64,
}

/// The emitted parameters of `table` beside those of `fresh`, in optical thickness, up to the bounds' angle.
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
    let hold = |((parameter, a), (_, b)): ((&'static str, &FittedParameter), (&str, &FittedParameter))| {
        HeldParameter {
            theta_l_deg: row.theta_l_deg.clone(),
            parameter,
            table: a.emitted,
            fresh: b.emitted,
            std_error: libm::hypot(a.std_error.unwrap_or(0.0), b.std_error.unwrap_or(0.0)),
        }
    };
    let determined = [row.c.value.is_some(), again.c.value.is_some()];
    let comparable = |name: &str| match name {
        "b" => determined[0] == determined[1],
        "c" => determined == [true, true],
        _ => true,
    };
    named(row).into_iter().zip(named(again)).filter(|((name, _), _)| comparable(name)).map(hold).collect()
}

/// The parameters of a row by their names.
pub(crate) fn named(row: &ParameterRow) -> [(&'static str, &FittedParameter); 5] {
    [("b", &row.b), ("c", &row.c), ("kappa_c", &row.kappa_c), ("t", &row.t), ("r", &row.r)]
}
