//! Fluxes of both media at one incidence, whatever computed them, in the forms that the other stages read.

use crate::CliError;
use crate::config::Config;
use stratiform_artifact::{OrdersRow, RowIncidence};
use stratiform_codegen::ReferencePoint;
use stratiform_fit::Reference;
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, OpticalThickness, Order};
use stratiform_stats::Estimate;

/// Largest order that the model describes by itself.
pub const MAX_ORDER: u32 = 2;

/// The incidences of the table.
pub fn nodes(config: &Config) -> Vec<RowIncidence> {
    let angles = config.fit.theta_l_deg.iter().map(|theta| RowIncidence::Degrees(*theta));
    angles.chain([RowIncidence::diffuse()]).collect()
}

/// The angles half-way between.
pub fn between(config: &Config) -> Vec<RowIncidence> {
    let middle = |pair: &[f64]| RowIncidence::Degrees(0.5 * (pair[0] + pair[1]));
    config.fit.theta_l_deg.windows(2).map(middle).collect()
}

/// The incidence of a table's row.
///
/// # Errors
/// [`CliError::Input`] for an angle out of domain.
pub fn light(row: &RowIncidence) -> Result<Incidence, CliError> {
    Ok(match row.degrees() {
        Some(theta) => Incidence::beam(cos_degrees(theta))?,
        None => Incidence::Diffuse,
    })
}

/// Reflectance and transmittance of one medium at one incidence.
pub struct MediumFluxes {
    /// Orders that are known.
    orders: Vec<Order>,
    /// Orders inside thickness.
    estimates: Vec<Option<(Estimate, Estimate)>>,
}

impl MediumFluxes {
    /// `estimate` of each of `orders` at every of so many thicknesses.
    pub fn new(
        orders: Vec<Order>,
        thicknesses: usize,
        estimate: impl Fn(usize, Order) -> Option<(Estimate, Estimate)>,
    ) -> Self {
        let rows = (0..thicknesses).flat_map(|k| orders.iter().map(move |order| (k, *order)));
        let estimates = rows.map(|(k, order)| estimate(k, order)).collect();
        Self { orders, estimates }
    }

    /// At thickness `k`; none for an order that is not known.
    pub fn get(&self, k: usize, order: Order) -> Option<(Estimate, Estimate)> {
        let place = self.orders.iter().position(|known| *known == order)?;
        self.estimates.get(k * self.orders.len() + place).copied().flatten()
    }
}

/// Reflectance and transmittance of both media at one incidence.
pub struct IncidenceFluxes {
    /// Angle or diffuse.
    pub row: RowIncidence,
    /// Optical thicknesses of the full medium.
    pub tau: Vec<f64>,
    /// Of the full medium.
    pub full: MediumFluxes,
    /// Of the modified medium.
    pub modified: MediumFluxes,
}

/// Covariances of what the model is fitted to, as [`Reference`] has them.
pub struct Covariance {
    /// Of T_ms.
    pub t_ms: Vec<f64>,
    /// Of T_1, T_2, R_1, R_2.
    pub orders: Vec<f64>,
}

/// One incidence, ready to be fitted and to be written.
pub struct Referred {
    /// Every order.
    pub fluxes: IncidenceFluxes,
    /// What is fitted.
    pub reference: Reference,
}

impl IncidenceFluxes {
    /// One medium's.
    pub fn of(&self, medium: Medium) -> &MediumFluxes {
        match medium {
            Medium::Full => &self.full,
            Medium::Modified => &self.modified,
        }
    }

    /// Takes out what is fitted.
    ///
    /// # Errors
    /// [`CliError::Failed`] if that is not known.
    pub fn referred(self, config: &Config, covariance: Covariance) -> Result<Referred, CliError> {
        let transport = &config.transport;
        let each = |medium, order, part: fn((Estimate, Estimate)) -> Estimate| {
            let value = |k| self.of(medium).get(k, order).map(|both| part(both).value);
            let missing = || CliError::Failed(format!("order {order} of the {medium} medium is not known"));
            (0..self.tau.len()).map(value).collect::<Option<Vec<f64>>>().ok_or_else(missing)
        };
        let of_order = |n, part| each(transport.orders_medium, Order::Exactly(n), part);
        let reference = Reference {
            incidence: self.row.clone(),
            tau: self.tau.clone(),
            t_ms: each(transport.totals_medium, Order::Total, |both| both.1)?,
            t_ms_covariance: covariance.t_ms,
            orders: [
                of_order(1, |both| both.1)?,
                of_order(2, |both| both.1)?,
                of_order(1, |both| both.0)?,
                of_order(2, |both| both.0)?,
            ],
            orders_covariance: covariance.orders,
        };
        Ok(Referred { reference, fluxes: self })
    }

    /// The rows of `orders.csv`.
    pub fn orders_rows(&self, thickness_m: &[f64]) -> Vec<OrdersRow> {
        let row = |medium: Medium, k: usize, order: Order| {
            let (reflectance, transmittance) = self.of(medium).get(k, order)?;
            Some(OrdersRow {
                theta_l_deg: self.row.to_string(),
                thickness_m: thickness_m[k],
                medium,
                order: order.to_string(),
                reflectance: reflectance.value,
                reflectance_std_error: reflectance.std_error,
                transmittance: transmittance.value,
                transmittance_std_error: transmittance.std_error,
            })
        };
        let mut rows = Vec::new();
        for medium in [Medium::Full, Medium::Modified] {
            for k in 0..thickness_m.len() {
                rows.extend(Order::rows(MAX_ORDER).filter_map(|order| row(medium, k, order)));
            }
        }
        rows
    }

    /// The fluxes that the emitted table is held against, as far as they are known.
    ///
    /// # Errors
    /// [`CliError::Input`] if a thickness or angle is out of domain.
    pub fn points(&self, config: &Config) -> Result<Vec<ReferencePoint>, CliError> {
        let incidence = light(&self.row)?;
        let (totals, orders) =
            (self.of(config.transport.totals_medium), self.of(config.transport.orders_medium));
        let mut points = Vec::new();
        for (k, tau) in self.tau.iter().enumerate() {
            let total = totals.get(k, Order::Total);
            let [zero, once, twice] = [0, 1, 2].map(|n| orders.get(k, Order::Exactly(n)));
            let tail = orders.get(k, Order::Tail);
            for (quantity, estimate) in [
                ("t_ms", transmittance(total)),
                ("r_ms", reflectance(total)),
                ("t_0", transmittance(zero)),
                ("t_1", transmittance(once)),
                ("t_2", transmittance(twice)),
                ("t_3_plus", transmittance(tail)),
                ("r_1", reflectance(once)),
                ("r_2", reflectance(twice)),
                ("r_3_plus", reflectance(tail)),
            ] {
                let Some(estimate) = estimate else { continue };
                points.push(ReferencePoint {
                    incidence,
                    tau: OpticalThickness::new(*tau)?,
                    quantity: quantity.to_owned(),
                    value: estimate.value,
                    std_error: estimate.std_error,
                });
            }
        }
        Ok(points)
    }
}

fn reflectance(both: Option<(Estimate, Estimate)>) -> Option<Estimate> {
    both.map(|(reflectance, _)| reflectance)
}

fn transmittance(both: Option<(Estimate, Estimate)>) -> Option<Estimate> {
    both.map(|(_, transmittance)| transmittance)
}
