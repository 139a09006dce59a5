//! What the accepted table emits against the deterministic truth: T_ms, T_1, T_2, R_1, R_2 at the table's angles and half-way
//! between them, and in diffuse light, over the config's thicknesses, each within an absolute bound; and β, b, c, κ_c, t, r
//! against a fresh fit to the truth, within a relative bound (of 1-β for β) and the table's own standard errors.
//!
//! The model is not the truth, so the fluxes' bounds cannot be below its misfit, which hides small slips of a parameter.
//! The misfit is the same in both fits and cancels, so a slip of 2 % in one parameter shows there. Where b is so near 1 that
//! one of the fits does not determine c, T_ms is held in its place, within the same relative bound: any c that keeps it passes.
//!
//! Numbers that follow from others do so to rounding in every row: what is emitted from the fitted value, the table in metres
//! from the optical one, κ_S and the extinction from the config's medium.

use super::truth::{LISTED, Solvers, Truth};
use super::{Comparison, Place};
use crate::CliError;
use crate::config::Config;
use crate::pipeline::{fluxes, reference::Media, source};
use crate::pipeline::{input_error, optics::Cloud};
use stratiform_artifact::{ParameterTable, ParametersDocument, Provenance, RowIncidence, hash_of};
use stratiform_codegen::{diffuse_parameters, parameter_grid};
use stratiform_fit::{HeldParameter, ModelBounds, Reference, derived_numbers, held_parameters};
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, Parameters, Thickness};
use stratiform_quantities::Order;
use stratiform_stats::{Estimate, family_threshold};

/// Relative rounding of a number that follows from others of the table.
const ROUNDING: f64 = 1e-12;
/// The same of what the config's medium says, which is computed anew.
const MEDIUM_ROUNDING: f64 = 1e-9;

/// The deterministic truth that a table is held against. It does not depend on the table.
pub struct ModelTruth {
    /// The table's rows, then the angles half-way between.
    rows: Vec<RowIncidence>,
    tau: Vec<f64>,
    truth: Truth,
    /// What is fitted to it at the table's rows.
    fresh: ParametersDocument,
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
        let references: Vec<_> =
            rows[..nodes].iter().enumerate().map(|(i, row)| reference(&truth, i, row, &tau)).collect();
        let provenance = Provenance::new(hash_of(config), None, "fit to the deterministic truth");
        let fresh = source::fit(config, cloud, &references, provenance)?;
        Ok(Self { rows, tau, truth, fresh })
    }

    /// Holds `table` against it.
    ///
    /// # Errors
    /// [`CliError::Input`] for a table that is out of the model's domain or does not belong to the config.
    pub fn compare(&self, config: &Config, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let mut comparisons = self.fluxes(&config.check.model, table)?;
        comparisons.extend(self.parameters(config, table)?);
        comparisons.extend(self.derived(table)?);
        Ok(comparisons)
    }

    fn fluxes(&self, bounds: &ModelBounds, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let emitted = Emitted::of(&table.optical)?;
        let mut comparisons = Vec::new();
        for (i, row) in self.rows.iter().enumerate().filter(|(_, row)| bounds.hold(row)) {
            let parameters = emitted.at(row)?;
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

    /// The emitted parameters against those that are fitted to the truth.
    fn parameters(&self, config: &Config, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let bounds = &config.check.model;
        let held = held_parameters(table, &self.fresh, bounds).map_err(input_error)?;
        let threshold = family_threshold(config.check.false_alarm_rate, held.len() + 1).unwrap_or(0.0);
        let compare = |held: HeldParameter| Comparison {
            quantity: format!("parameter {}", held.parameter),
            place: Place::of(held.theta_l_deg),
            value: held.table,
            truth: held.fresh,
            bound: bounds.parameters_relative * held.fresh.abs() + threshold * held.std_error,
        };
        let mut comparisons: Vec<_> = held.into_iter().map(compare).collect();
        let (beta, fresh) = (table.optical.beta, self.fresh.optical.beta);
        comparisons.push(Comparison {
            quantity: "parameter beta".to_owned(),
            place: for_all(),
            value: beta.value,
            truth: fresh.value,
            // Thick layers follow (1-β)/β.
            bound: bounds.parameters_relative * (1.0 - fresh.value)
                + threshold * libm::hypot(beta.std_error, fresh.std_error),
        });
        comparisons.extend(self.curves(bounds, threshold, table)?);
        Ok(comparisons)
    }

    /// T_ms against that of the fresh fit, where c is undetermined in one of them. The curve moves by less than b does, so
    /// that b's standard error bounds the noise.
    fn curves(
        &self,
        bounds: &ModelBounds,
        threshold: f64,
        table: &ParametersDocument,
    ) -> Result<Vec<Comparison>, CliError> {
        let [emitted, fresh] = [Emitted::of(&table.optical)?, Emitted::of(&self.fresh.optical)?];
        let mut comparisons = Vec::new();
        let rows = table.optical.rows.iter().filter(|row| bounds.hold(&row.theta_l_deg));
        for row in rows {
            let again = self.fresh.optical.rows.iter().find(|r| r.theta_l_deg == row.theta_l_deg);
            let Some(again) = again.filter(|r| r.c.value.is_none() || row.c.value.is_none()) else {
                continue;
            };
            let noise = libm::hypot(row.b.std_error.unwrap_or(0.0), again.b.std_error.unwrap_or(0.0));
            let [a, b] = [emitted.at(&row.theta_l_deg)?, fresh.at(&row.theta_l_deg)?];
            for &tau in &self.tau {
                let thickness = Thickness::new(tau).map_err(input_error)?;
                let [value, truth] = [a, b].map(|p| p.fluxes(Form::Corrected, thickness).t_ms);
                comparisons.push(Comparison {
                    quantity: "t_ms of b and c".to_owned(),
                    place: Place { tau: Some(tau), ..Place::of(row.theta_l_deg.clone()) },
                    value,
                    truth,
                    bound: bounds.parameters_relative * truth.abs() + threshold * noise,
                });
            }
        }
        Ok(comparisons)
    }

    /// What does not depend on the fit: κ_S and the extinction of the config's medium, and what follows from the rest of
    /// the table itself, in all its rows.
    fn derived(&self, table: &ParametersDocument) -> Result<Vec<Comparison>, CliError> {
        let (medium, own) = (&self.fresh.medium, &table.medium);
        let shared = [
            ("extinction_per_m", own.extinction_per_m, medium.extinction_per_m),
            ("forward_fraction", own.forward_fraction, medium.forward_fraction),
            ("optical kappa_s", table.optical.kappa_s, self.fresh.optical.kappa_s),
        ];
        let exact =
            |quantity: String, row: Option<RowIncidence>, value: f64, truth: f64, rounding: f64| Comparison {
                quantity,
                place: row.map_or_else(for_all, Place::of),
                value,
                truth,
                bound: rounding * truth.abs(),
            };
        let mut comparisons: Vec<_> = shared
            .into_iter()
            .map(|(name, value, truth)| exact(name.to_owned(), None, value, truth, MEDIUM_ROUNDING))
            .collect();
        let numbers = derived_numbers(table).map_err(input_error)?;
        comparisons.extend(
            numbers.into_iter().map(|n| exact(n.name, n.theta_l_deg, n.document, n.follows, ROUNDING)),
        );
        Ok(comparisons)
    }
}

/// The place of what all rows share.
fn for_all() -> Place {
    Place::of(RowIncidence::Word("all".to_owned()))
}

/// What the fit needs of one row. The truth has no noise; its error is far below what the fit misses it by.
fn reference(truth: &Truth, row: usize, incidence: &RowIncidence, tau: &[f64]) -> Reference {
    let count = tau.len();
    let each = |order: Order, part: fn((Estimate, Estimate)) -> Estimate| -> Vec<f64> {
        (0..count).map(|k| part(truth.at(row, k, order)).value.clamp(0.0, 1.0)).collect()
    };
    Reference {
        incidence: incidence.clone(),
        tau: tau.to_vec(),
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

/// The angles half-way between those of the table, up to the bounds' angle.
fn between(config: &Config) -> impl Iterator<Item = RowIncidence> {
    fluxes::between(config).into_iter().filter(|row| config.check.model.hold(row))
}

/// Every incidence that the bounds are about: of the table, then half-way between.
pub fn held_rows(config: &Config) -> Vec<RowIncidence> {
    let nodes = fluxes::nodes(config).into_iter().filter(|row| config.check.model.hold(row));
    nodes.chain(between(config)).collect()
}

/// A table as emitted code has it.
struct Emitted {
    grid: ParameterGrid<f64>,
    diffuse: Parameters<f64>,
}

impl Emitted {
    fn of(table: &ParameterTable) -> Result<Self, CliError> {
        let grid = parameter_grid(table).map_err(input_error)?;
        Ok(Self { grid, diffuse: diffuse_parameters(table).map_err(input_error)? })
    }

    fn at(&self, row: &RowIncidence) -> Result<Parameters<f64>, CliError> {
        match row.degrees() {
            Some(theta) => self.grid.at(cos_degrees(theta)).map_err(input_error),
            None => Ok(self.diffuse),
        }
    }
}
