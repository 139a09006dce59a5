//! Whether a table still agrees with fresh reference fluxes: the gate that a table's users put into their tests.
//!
//! Two comparisons, each within a bound plus z standard errors of the difference, where z keeps the probability that any of
//! all N comparisons fails a correct table at the false-alarm rate (see [`family_threshold`]):
//!
//! * **fluxes** T_ms, T_1, T_2, R_1, R_2 of the table against the fresh ones at every thickness, bounded absolutely. The model is
//!   not the truth, so these bounds cannot be below its misfit, which hides small slips of a parameter;
//! * **parameters** b, κ_c, t, r of the table against a fresh fit, bounded relatively. The misfit is the same in both and cancels.

use crate::{FitConfig, FitError, ORDERS, Reference, fit};
use serde::{Deserialize, Serialize};
use stratiform_artifact::{FittedParameter, ParameterRow, ParametersDocument};
use stratiform_model::{Form, Parameters, Thickness, Values};
use stratiform_quantities::Range;
use stratiform_stats::family_threshold;

/// What is accepted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "the names are those of the model")]
pub struct RegressionBounds {
    /// Rows beyond this angle are not held to anything: the model's form cannot fit there.
    pub up_to_deg: f64,
    /// Largest |table - fresh fit| relative to the table, for b, κ_c, t and r.
    pub parameters_relative: f64,
    /// Largest |table - fresh flux|, from here on.
    pub t_ms: f64,
    pub t_1: f64,
    pub t_2: f64,
    pub r_1: f64,
    pub r_2: f64,
}

impl RegressionBounds {
    /// Checks every number.
    ///
    /// # Errors
    /// [`FitError::Domain`] naming the bound.
    pub fn check(&self) -> Result<(), FitError> {
        Range::closed(0.0, 90.0).check("up_to_deg", self.up_to_deg)?;
        let Self { parameters_relative, t_ms, t_1, t_2, r_1, r_2, .. } = *self;
        let all = [
            ("parameters_relative", parameters_relative),
            ("t_ms", t_ms),
            ("t_1", t_1),
            ("t_2", t_2),
            ("r_1", r_1),
            ("r_2", r_2),
        ];
        for (name, bound) in all {
            Range::closed(0.0, 1.0).check(name, bound)?;
        }
        Ok(())
    }
}

/// One number of the table held against a fresh one.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Row of the table.
    pub theta_l_deg: String,
    /// Flux or parameter.
    pub quantity: &'static str,
    /// Optical thickness, for fluxes.
    pub tau: Option<f64>,
    /// What the table says.
    pub table: f64,
    /// What the fresh run says.
    pub fresh: f64,
    /// The bound.
    pub bound: f64,
    /// Standard error of the difference.
    pub std_error: f64,
}

/// The whole comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Regression {
    /// Everything that was compared.
    pub held: Vec<Held>,
    /// Standard errors allowed beyond the bound.
    pub threshold: f64,
}

impl Regression {
    /// What is off by more than bound and noise, worst first.
    pub fn failures(&self) -> Vec<&Held> {
        let excess =
            |held: &Held| (held.table - held.fresh).abs() - held.bound - self.threshold * held.std_error;
        let mut failures: Vec<_> =
            self.held.iter().filter(|held| excess(held).is_nan() || excess(held) > 0.0).collect();
        failures.sort_by(|a, b| excess(b).total_cmp(&excess(a)));
        failures
    }
}

/// Holds `table` against `fresh` fluxes, which must stand on the grid of `config`.
///
/// # Errors
/// [`FitError`] for bounds or a rate out of domain, references that do not fit the config, or rows without a reference.
pub fn regression(
    table: &ParametersDocument,
    config: &FitConfig,
    fresh: &[Reference],
    bounds: &RegressionBounds,
    false_alarm_rate: f64,
) -> Result<Regression, FitError> {
    bounds.check()?;
    Range::open(0.0, 1.0).check("false_alarm_rate", false_alarm_rate)?;
    let refit = fit(config, fresh, table.medium.clone(), table.provenance.clone())?;
    let mut held = Vec::new();
    for row in &table.optical.rows {
        if row.theta_l_deg.degrees().is_some_and(|theta| theta > bounds.up_to_deg) {
            continue;
        }
        let missing = || FitError::Inconsistent(format!("no fresh fluxes at theta_l = {}", row.theta_l_deg));
        let reference = fresh.iter().find(|r| r.incidence == row.theta_l_deg).ok_or_else(missing)?;
        let again =
            refit.optical.rows.iter().find(|r| r.theta_l_deg == row.theta_l_deg).ok_or_else(missing)?;
        held.extend(fluxes(table, row, reference, bounds)?);
        held.extend(parameters(row, again, bounds));
    }
    let threshold = family_threshold(false_alarm_rate, held.len()).unwrap_or(f64::INFINITY);
    Ok(Regression { held, threshold })
}

fn fluxes(
    table: &ParametersDocument,
    row: &ParameterRow,
    reference: &Reference,
    bounds: &RegressionBounds,
) -> Result<Vec<Held>, FitError> {
    let optical = &table.optical;
    let values = Values {
        beta: optical.beta.value,
        b: row.b.emitted,
        c: row.c.emitted,
        kappa_c: row.kappa_c.emitted,
        t: row.t.emitted,
        r: row.r.emitted,
        kappa_s: optical.kappa_s,
    };
    let parameters = Parameters::new(&values, reference.light()?)?;
    let count = reference.tau.len();
    let variance = |covariance: &[f64], size: usize, i: usize| covariance[i * size + i];
    let mut held = Vec::new();
    for (k, tau) in reference.tau.iter().enumerate() {
        let model = parameters.fluxes(Form::Corrected, Thickness::new(*tau)?);
        let mut hold = |quantity, table, fresh, bound, variance: f64| {
            let theta_l_deg = row.theta_l_deg.to_string();
            let std_error = variance.sqrt();
            held.push(Held { theta_l_deg, quantity, tau: Some(*tau), table, fresh, bound, std_error });
        };
        hold(
            "t_ms",
            model.t_ms,
            reference.t_ms[k],
            bounds.t_ms,
            variance(&reference.t_ms_covariance, count, k),
        );
        let orders = [
            (model.t_1, bounds.t_1),
            (model.t_2, bounds.t_2),
            (model.r_1, bounds.r_1),
            (model.r_2, bounds.r_2),
        ];
        for (q, (model, bound)) in orders.into_iter().enumerate() {
            let variance = variance(&reference.orders_covariance, 4 * count, q * count + k);
            hold(ORDERS[q], model, reference.orders[q][k], bound, variance);
        }
    }
    Ok(held)
}

fn parameters(row: &ParameterRow, again: &ParameterRow, bounds: &RegressionBounds) -> Vec<Held> {
    let pairs: [(&'static str, &FittedParameter, &FittedParameter); 4] = [
        ("b", &row.b, &again.b),
        ("kappa_c", &row.kappa_c, &again.kappa_c),
        ("t", &row.t, &again.t),
        ("r", &row.r, &again.r),
    ];
    let hold = |(quantity, a, b): (&'static str, &FittedParameter, &FittedParameter)| {
        let (table, fresh) = (a.value?, b.value?);
        let bound = bounds.parameters_relative * table.abs();
        let errors = [a.std_error.unwrap_or(0.0), b.std_error.unwrap_or(0.0)];
        let std_error = libm::hypot(errors[0], errors[1]);
        Some(Held {
            theta_l_deg: row.theta_l_deg.to_string(),
            quantity,
            tau: None,
            table,
            fresh,
            bound,
            std_error,
        })
    };
    pairs.into_iter().filter_map(hold).collect()
}
