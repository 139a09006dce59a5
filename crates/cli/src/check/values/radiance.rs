//! The truth of radiance rows: πL/(μ0 F0) from the deterministic solver, totals in the config's `totals_medium`, orders in
//! its `orders_medium`.
//!
//! Rows of one sun share a call, which solves for each
//! of their thicknesses and views.

use super::ValueRow;
use crate::check::config::Quantity;
use crate::config::Config;
use crate::pipeline::fluxes::light;
use crate::pipeline::reference::Media;
use crate::{CliError, pipeline};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, Order, Side};
use stratiform_stats::Estimate;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, View};

/// Rows of one medium and sun, with their places in the list of all.
struct Group<'a> {
    medium: Medium,
    mu0: f64,
    rows: Vec<(usize, &'a ValueRow)>,
}

/// The truth of each of the radiance rows among `rows`, with its place.
///
/// # Errors
/// [`CliError::Failed`] if order 2 is not known to the config's tolerance; [`CliError::Input`] for directions out of domain.
pub(super) fn truths(
    config: &Config,
    media: &Media,
    rows: &[ValueRow],
) -> Result<Vec<(usize, Estimate)>, CliError> {
    let mut truths = Vec::new();
    for group in groups(config, rows)? {
        truths.extend(solve(config, media, &group)?);
    }
    Ok(truths)
}

fn groups<'a>(config: &Config, rows: &'a [ValueRow]) -> Result<Vec<Group<'a>>, CliError> {
    let mut groups: Vec<Group> = Vec::new();
    for (i, row) in rows.iter().enumerate().filter(|(_, row)| row.quantity.is_radiance()) {
        let medium = match row.order {
            Order::Total => config.transport.totals_medium,
            _ => config.transport.orders_medium,
        };
        // The reader admits beams only.
        let Incidence::Beam(mu0) = light(&row.theta_l_deg)? else { continue };
        let mu0 = mu0.get();
        match groups.iter_mut().find(|group| group.medium == medium && group.mu0 == mu0) {
            Some(group) => group.rows.push((i, row)),
            None => groups.push(Group { medium, mu0, rows: vec![(i, row)] }),
        }
    }
    Ok(groups)
}

fn solve(config: &Config, media: &Media, group: &Group) -> Result<Vec<(usize, Estimate)>, CliError> {
    let mut tau: Vec<f64> = group.rows.iter().map(|(_, row)| row.tau).collect();
    tau.sort_by(f64::total_cmp);
    tau.dedup();
    let mut views: Vec<View> = Vec::new();
    for view in group.rows.iter().map(|(_, row)| view(row)) {
        if !views.contains(&view) {
            views.push(view);
        }
    }
    let orders = group.rows.iter().map(|(_, row)| order(row));
    let highest = orders.max_by_key(|order| *order as usize).unwrap_or(RadianceOrder::Total);
    let solver = RadianceSolver::new(media.get(group.medium).into(), config.check.radiance_tolerance)
        .map_err(pipeline::trace_error)?;
    // What no number of streams brings within the tolerance widens the bound of its row.
    let solved = solver.radiance_as_reached(highest, &tau, &[group.mu0], &views).map_err(|error| {
        let sun = group.rows.first().map_or_else(String::new, |(_, row)| row.theta_l_deg.to_string());
        pipeline::trace_error(error).at(&format!("the deterministic truth of radiance at theta_l {sun}"))
    })?;
    let truth = |(i, row): &(usize, &ValueRow)| {
        let at = tau.iter().position(|tau| *tau == row.tau)?;
        let seen = views.iter().position(|one| *one == view(row))?;
        Some((*i, solved.estimate(at, 0, seen, order(row))))
    };
    Ok(group.rows.iter().filter_map(truth).collect())
}

fn view(row: &ValueRow) -> View {
    let side = if row.quantity == Quantity::RadianceTop { Side::Top } else { Side::Bottom };
    let (theta, phi_deg) = (row.theta_v_deg.unwrap_or(0.0), row.phi_deg.unwrap_or(0.0));
    View { side, mu: cos_degrees(theta), phi_deg }
}

fn order(row: &ValueRow) -> RadianceOrder {
    match row.order {
        Order::Exactly(1) => RadianceOrder::One,
        Order::Exactly(2) => RadianceOrder::Two,
        _ => RadianceOrder::Total,
    }
}
