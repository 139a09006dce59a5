//! Somebody else's values against the deterministic truth.
//!
//! Rows of one incidence share a list of thicknesses, and incidences with the same list one call of the solver: a designed
//! grid costs one call, scattered rows one per incidence. τ is the full medium's. Totals are those of the config's
//! `totals_medium`; orders, and the tail of orders three and more, those of its `orders_medium`.

mod points;
mod radiance;
mod read;

pub use points::{Point, points};
pub use read::{COLUMNS, ValueRow, read};

use super::config::{Bound, Quantity, bound};
use super::truth::Solvers;
use super::{Comparison, Place};
use crate::CliError;
use crate::config::Config;
use crate::pipeline::reference::Media;
use std::path::Path;
use stratiform_artifact::RowIncidence;
use stratiform_quantities::Order;
use stratiform_stats::Estimate;

/// Holds the values of `file` against the truth within the bounds of `[check.values]`.
///
/// # Errors
/// [`CliError::Input`] with file and line for rows that mean nothing or have no bound, [`CliError::Failed`] where the truth is
/// less certain than the bound; as [`Solvers::solve`].
pub fn check(config: &Config, media: &Media, file: &Path) -> Result<Vec<Comparison>, CliError> {
    let rows = read(file)?;
    let bounds = rows.iter().map(|row| bound_of(config, row, file)).collect::<Result<Vec<_>, _>>()?;
    let truths = truths(config, media, &rows)?;
    rows.iter()
        .zip(bounds)
        .zip(truths)
        .map(|((row, bound), truth)| {
            compare(config, row, bound, truth).map_err(|error| error.at(&row.line_of(file)))
        })
        .collect()
}

/// The truth's own error widens the bound; a truth that misses its tolerance and is less certain than the bound judges
/// nothing.
fn compare(config: &Config, row: &ValueRow, bound: Bound, truth: Estimate) -> Result<Comparison, CliError> {
    let own = bound.around(truth.value);
    let tolerance = config.check.radiance_tolerance * truth.value.abs().max(1.0);
    if truth.std_error > own.max(tolerance) {
        let message = format!(
            "the truth of {} at {} is known to {:.1e} only, its bound is {own:.1e}",
            row.quantity,
            row.place(),
            truth.std_error
        );
        return Err(CliError::Failed(message));
    }
    Ok(Comparison {
        quantity: row.quantity.to_string(),
        place: row.place(),
        value: row.value,
        truth: truth.value,
        bound: own + truth.std_error,
    })
}

fn bound_of(config: &Config, row: &ValueRow, file: &Path) -> Result<Bound, CliError> {
    let found = config.check.values.get(&row.quantity).and_then(|bounds| bound(bounds, row.order));
    found.ok_or_else(|| {
        let (quantity, order) = (row.quantity, row.order);
        let message =
            format!("the config states no bound for {quantity} of order {order}: [check.values.{quantity}]");
        CliError::Input(message).at(&row.line_of(file))
    })
}

impl ValueRow {
    fn line_of(&self, file: &Path) -> String {
        format!("{}:{}", file.display(), self.line)
    }

    fn place(&self) -> Place {
        Place {
            theta_v_deg: self.theta_v_deg,
            phi_deg: self.phi_deg,
            tau: Some(self.tau),
            order: Some(self.order),
            ..Place::of(self.theta_l_deg.clone())
        }
    }
}

/// The truth of every row, in their order.
fn truths(config: &Config, media: &Media, rows: &[ValueRow]) -> Result<Vec<Estimate>, CliError> {
    let mut truths = vec![None; rows.len()];
    for (i, truth) in radiance::truths(config, media, rows)? {
        truths[i] = Some(truth);
    }
    let solvers = Solvers::new(config, media)?;
    for group in groups(rows) {
        let listed = group.members.iter().filter_map(|&i| match rows[i].order {
            Order::Exactly(n) => Some(n),
            _ => None,
        });
        let truth = solvers.solve(&group.incidences, &group.tau, listed.max().unwrap_or(0))?;
        for &i in &group.members {
            truths[i] = group.place(&rows[i]).map(|(incidence, tau)| {
                let (reflectance, transmittance) = truth.at(incidence, tau, rows[i].order);
                if rows[i].quantity == Quantity::Reflectance { reflectance } else { transmittance }
            });
        }
    }
    let all: Option<Vec<_>> = truths.into_iter().collect();
    all.ok_or_else(|| CliError::Failed("a row of the values has no truth: a defect of the check".to_owned()))
}

/// Rows that one call of the solver serves: every incidence at every thickness.
struct Group {
    incidences: Vec<RowIncidence>,
    /// Rising.
    tau: Vec<f64>,
    /// Places in the list of rows.
    members: Vec<usize>,
}

impl Group {
    fn place(&self, row: &ValueRow) -> Option<(usize, usize)> {
        let incidence = self.incidences.iter().position(|one| *one == row.theta_l_deg)?;
        Some((incidence, self.tau.iter().position(|tau| *tau == row.tau)?))
    }
}

fn groups(rows: &[ValueRow]) -> Vec<Group> {
    let mut single: Vec<Group> = Vec::new();
    for (i, row) in rows.iter().enumerate().filter(|(_, row)| !row.quantity.is_radiance()) {
        match single.iter_mut().find(|group| group.incidences[0] == row.theta_l_deg) {
            Some(group) => {
                group.tau.push(row.tau);
                group.members.push(i);
            }
            None => {
                let incidences = vec![row.theta_l_deg.clone()];
                single.push(Group { incidences, tau: vec![row.tau], members: vec![i] });
            }
        }
    }
    let mut groups: Vec<Group> = Vec::new();
    for mut group in single {
        group.tau.sort_by(f64::total_cmp);
        group.tau.dedup();
        match groups.iter_mut().find(|other| other.tau == group.tau) {
            Some(other) => {
                other.incidences.append(&mut group.incidences);
                other.members.append(&mut group.members);
            }
            None => groups.push(group),
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(theta: f64, tau: f64) -> ValueRow {
        ValueRow {
            line: 0,
            quantity: Quantity::Reflectance,
            theta_l_deg: RowIncidence::Degrees(theta),
            theta_v_deg: None,
            phi_deg: None,
            tau,
            order: Order::Total,
            value: 0.0,
        }
    }

    #[test]
    fn a_grid_is_one_group_and_every_row_has_its_place() {
        let mut rows: Vec<_> =
            [0.0, 10.0].iter().flat_map(|theta| [2.0, 1.0].map(|tau| row(*theta, tau))).collect();
        assert_eq!(groups(&rows).len(), 1);
        rows.push(row(20.0, 5.0));
        let groups = groups(&rows);
        assert_eq!(groups.len(), 2);
        assert_eq!(groups.iter().map(|group| group.members.len()).sum::<usize>(), rows.len());
        for group in &groups {
            for &i in &group.members {
                let (incidence, tau) = group.place(&rows[i]).unwrap();
                assert_eq!(group.incidences[incidence], rows[i].theta_l_deg);
                assert_eq!(group.tau[tau], rows[i].tau);
            }
        }
    }
}
