//! The accepted table against the deterministic truth: T_ms, T_1, T_2, R_1, R_2 at the table's angles and half-way between
//! them, and in diffuse light, over the config's thicknesses, each within an absolute bound; and b, κ_c, t, r against a
//! fresh fit to the truth, within a relative bound and the table's own standard errors.
//!
//! The model is not the truth, so the fluxes' bounds cannot be below its misfit, which hides small slips of a parameter.
//! The misfit is the same in both fits and cancels, so a slip of 2 % in one parameter shows there.

use super::truth::{LISTED, Solvers, Truth};
use super::{Comparison, Place};
use crate::CliError;
use crate::config::Config;
use crate::pipeline::{fluxes, reference::Media};
use crate::pipeline::{input_error, optics::Cloud};
use stratiform_artifact::{ParametersDocument, RowIncidence};
use stratiform_codegen::{diffuse_parameters, parameter_grid};
use stratiform_fit::{ModelBounds, Reference, fit, held_parameters};
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, Parameters, Thickness};
use stratiform_quantities::Order;
use stratiform_stats::{Estimate, family_threshold};

/// The deterministic truth that a table is held against. It does not depend on the table.
pub struct ModelTruth {
    /// The table's rows, then the angles half-way between.
    rows: Vec<RowIncidence>,
    nodes: usize,
    tau: Vec<f64>,
    truth: Truth,
}

impl ModelTruth {
    /// Solves at the config's angles, half-way between, and for diffuse light.
    ///
    /// # Errors
    /// As [`Solvers::solve`].
    pub fn solve(config: &Config, cloud: &Cloud, media: &Media) -> Result<Self, CliError> {
        let mut rows = fluxes::nodes(config);
        let nodes = rows.len();
        rows.extend(between(config));
        let tau = cloud.tau(config);
        let truth = Solvers::new(config, media)?.solve(&rows, &tau, LISTED)?;
        Ok(Self { rows, nodes, tau, truth })
    }

    /// Holds `table` against it.
    ///
    /// # Errors
    /// [`CliError::Input`] for a table that is out of the model's domain or does not belong to the config.
    pub fn compare(&self, config: &Config, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let mut comparisons = self.fluxes(&config.check.model, table)?;
        comparisons.extend(self.parameters(config, table)?);
        Ok(comparisons)
    }

    fn fluxes(&self, bounds: &ModelBounds, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let grid = parameter_grid(&table.optical).map_err(input_error)?;
        let diffuse = diffuse_parameters(&table.optical).map_err(input_error)?;
        let mut comparisons = Vec::new();
        for (i, row) in self.rows.iter().enumerate().filter(|(_, row)| bounds.hold(row)) {
            let parameters = parameters_at(row, &grid, &diffuse)?;
            for (k, tau) in self.tau.iter().enumerate() {
                comparisons.extend(self.at(i, k, &parameters, bounds, *tau)?);
            }
        }
        Ok(comparisons)
    }

    /// The five fluxes at one place.
    fn at(
        &self,
        row: usize,
        k: usize,
        parameters: &Parameters<f64>,
        bounds: &ModelBounds,
        tau: f64,
    ) -> Result<[Comparison; 5], CliError> {
        let model = parameters.fluxes(Form::Corrected, Thickness::new(tau).map_err(input_error)?);
        let total = self.truth.at(row, k, Order::Total);
        let once = self.truth.at(row, k, Order::Exactly(1));
        let twice = self.truth.at(row, k, Order::Exactly(2));
        let place = Place { tau: Some(tau), ..Place::of(self.rows[row].clone()) };
        let hold = |(quantity, value, truth, bound): (&str, f64, Estimate, f64)| Comparison {
            quantity: quantity.to_owned(),
            place: place.clone(),
            value,
            truth: truth.value,
            bound: bound + truth.std_error,
        };
        Ok([
            ("t_ms", model.t_ms, total.1, bounds.t_ms),
            ("t_1", model.t_1, once.1, bounds.t_1),
            ("t_2", model.t_2, twice.1, bounds.t_2),
            ("r_1", model.r_1, once.0, bounds.r_1),
            ("r_2", model.r_2, twice.0, bounds.r_2),
        ]
        .map(hold))
    }

    /// The table's parameters against those that are fitted to the truth.
    fn parameters(&self, config: &Config, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let references: Vec<_> = (0..self.nodes).map(|row| self.reference(row)).collect();
        let fresh = fit(&config.fit, &references, table.medium.clone(), table.provenance.clone())
            .map_err(input_error)?;
        let bounds = &config.check.model;
        let held = held_parameters(table, &fresh, bounds).map_err(input_error)?;
        let threshold = family_threshold(config.check.false_alarm_rate, held.len()).unwrap_or(0.0);
        let compare = |held: stratiform_fit::HeldParameter| Comparison {
            quantity: format!("parameter {}", held.parameter),
            place: Place::of(held.theta_l_deg),
            value: held.table,
            truth: held.fresh,
            bound: bounds.parameters_relative * held.table.abs() + threshold * held.std_error,
        };
        Ok(held.into_iter().map(compare).collect())
    }

    /// What the fit needs of one row. The truth has no noise; its error is far below what the fit misses it by.
    fn reference(&self, row: usize) -> Reference {
        let count = self.tau.len();
        let each = |order: Order, part: fn((Estimate, Estimate)) -> Estimate| -> Vec<f64> {
            (0..count).map(|k| part(self.truth.at(row, k, order)).value.clamp(0.0, 1.0)).collect()
        };
        Reference {
            incidence: self.rows[row].clone(),
            tau: self.tau.clone(),
            t_ms: each(Order::Total, |both| both.1),
            t_ms_covariance: vec![0.0; count * count],
            orders: [
                each(Order::Exactly(1), |both| both.1),
                each(Order::Exactly(2), |both| both.1),
                each(Order::Exactly(1), |both| both.0),
                each(Order::Exactly(2), |both| both.0),
            ],
            orders_covariance: vec![0.0; 16 * count * count],
        }
    }
}

/// The angles half-way between those of the table, up to the bounds' angle.
fn between(config: &Config) -> impl Iterator<Item = RowIncidence> {
    fluxes::between(config).into_iter().filter(|row| config.check.model.hold(row))
}

/// Every incidence that the bounds are about: of the table, then half-way between.
pub fn held_rows(config: &Config) -> Vec<RowIncidence> {
    let nodes = fluxes::nodes(config).into_iter().filter(|row| config.check.model.hold(row));
    nodes.chain(between(config)).collect()
}

fn parameters_at(
    row: &RowIncidence,
    grid: &ParameterGrid<f64>,
    diffuse: &Parameters<f64>,
) -> Result<Parameters<f64>, CliError> {
    match row.degrees() {
        Some(theta) => grid.at(cos_degrees(theta)).map_err(input_error),
        None => Ok(*diffuse),
    }
}
