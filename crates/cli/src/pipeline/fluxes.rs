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

/// Reflectance and transmittance of both media at one incidence.
pub struct IncidenceFluxes {
    /// Angle or diffuse.
    pub row: RowIncidence,
    /// Optical thicknesses of the full medium.
    pub tau: Vec<f64>,
    /// Orders 0 to [`MAX_ORDER`], tail and total inside thickness.
    pub full: Vec<(Estimate, Estimate)>,
    /// The same of the modified medium.
    pub modified: Vec<(Estimate, Estimate)>,
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
    /// Reflectance and transmittance of `order` at thickness `k`.
    pub fn estimate(&self, medium: Medium, k: usize, order: Order) -> (Estimate, Estimate) {
        let rows = match medium {
            Medium::Full => &self.full,
            Medium::Modified => &self.modified,
        };
        let count = Order::rows(MAX_ORDER).count();
        let place = match order {
            Order::Exactly(n) => n as usize,
            Order::Tail => count - 2,
            Order::Total => count - 1,
        };
        rows[k * count + place]
    }

    /// Takes out what is fitted.
    pub fn referred(self, config: &Config, covariance: Covariance) -> Referred {
        let transport = &config.transport;
        let each = |medium, order, part: fn((Estimate, Estimate)) -> Estimate| -> Vec<f64> {
            (0..self.tau.len()).map(|k| part(self.estimate(medium, k, order)).value).collect()
        };
        let of_order = |n, part| each(transport.orders_medium, Order::Exactly(n), part);
        let reference = Reference {
            incidence: self.row.clone(),
            tau: self.tau.clone(),
            t_ms: each(transport.totals_medium, Order::Total, |both| both.1),
            t_ms_covariance: covariance.t_ms,
            orders: [
                of_order(1, |both| both.1),
                of_order(2, |both| both.1),
                of_order(1, |both| both.0),
                of_order(2, |both| both.0),
            ],
            orders_covariance: covariance.orders,
        };
        Referred { reference, fluxes: self }
    }

    /// The rows of `orders.csv`.
    pub fn orders_rows(&self, thickness_m: &[f64]) -> Vec<OrdersRow> {
        let row = |medium: Medium, k: usize, order: Order| {
            let (reflectance, transmittance) = self.estimate(medium, k, order);
            OrdersRow {
                theta_l_deg: self.row.to_string(),
                thickness_m: thickness_m[k],
                medium,
                order: order.to_string(),
                reflectance: reflectance.value,
                reflectance_std_error: reflectance.std_error,
                transmittance: transmittance.value,
                transmittance_std_error: transmittance.std_error,
            }
        };
        let mut rows = Vec::new();
        for medium in [Medium::Full, Medium::Modified] {
            for k in 0..thickness_m.len() {
                rows.extend(Order::rows(MAX_ORDER).map(|order| row(medium, k, order)));
            }
        }
        rows
    }

    /// The fluxes that the emitted table is held against.
    ///
    /// # Errors
    /// [`CliError::Input`] if a thickness or angle is out of domain.
    pub fn points(&self, config: &Config) -> Result<Vec<ReferencePoint>, CliError> {
        let incidence = light(&self.row)?;
        let mut points = Vec::new();
        for (k, tau) in self.tau.iter().enumerate() {
            let order = |order| self.estimate(config.transport.orders_medium, k, order);
            let (r_ms, t_ms) = self.estimate(config.transport.totals_medium, k, Order::Total);
            let t_0 = order(Order::Exactly(0)).1;
            let (r_1, t_1) = order(Order::Exactly(1));
            let (r_2, t_2) = order(Order::Exactly(2));
            let (r_3_plus, t_3_plus) = order(Order::Tail);
            for (quantity, estimate) in [
                ("t_ms", t_ms),
                ("r_ms", r_ms),
                ("t_0", t_0),
                ("t_1", t_1),
                ("t_2", t_2),
                ("t_3_plus", t_3_plus),
                ("r_1", r_1),
                ("r_2", r_2),
                ("r_3_plus", r_3_plus),
            ] {
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
