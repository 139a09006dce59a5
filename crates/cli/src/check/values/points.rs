//! The places at which another implementation is best evaluated: the angles of the table up to the bounds' angle, those
//! half-way between, and diffuse light; the config's thicknesses; every order with a bound.

use crate::check::config::{Quantity, bound};
use crate::check::model::held_rows;
use crate::config::Config;
use serde::Serialize;
use stratiform_quantities::Order;

/// A row of the template, in the columns of `--values`; what is empty stays empty, or is for the user to fill in.
#[derive(Serialize)]
pub struct Point {
    quantity: Quantity,
    theta_l_deg: String,
    theta_v_deg: Option<f64>,
    phi_deg: Option<f64>,
    tau: f64,
    order: String,
    value: Option<f64>,
}

/// All places of fluxes with a bound in the config; `tau` are the thicknesses.
pub fn points(config: &Config, tau: &[f64]) -> Vec<Point> {
    let mut points = Vec::new();
    for (quantity, bounds) in config.check.values.iter().filter(|(quantity, _)| !quantity.is_radiance()) {
        // Nothing is reflected without a scattering.
        let orders = Order::rows(super::super::truth::LISTED)
            .filter(|order| (*quantity, *order) != (Quantity::Reflectance, Order::Exactly(0)))
            .filter(|order| bound(bounds, *order).is_some());
        let orders: Vec<_> = orders.collect();
        for row in held_rows(config) {
            for tau in tau {
                points.extend(orders.iter().map(|order| Point {
                    quantity: *quantity,
                    theta_l_deg: row.to_string(),
                    theta_v_deg: None,
                    phi_deg: None,
                    tau: *tau,
                    order: order.to_string(),
                    value: None,
                }));
            }
        }
    }
    points
}
