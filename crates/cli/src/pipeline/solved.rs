//! The deterministic reference of a fit: the same fluxes as the photons', from the solver.
//!
//! **Errors.** The solver's estimated errors stand where photons have standard errors. They are no independent noise: an
//! error of discretisation has one sign over many thicknesses, which nobody knows. A parameter whose answer to datum i
//! is a_i is off by at most Σ|a_i|e_i. Neither independent errors, √Σa_i²e_i², nor fully correlated ones, |Σa_ie_i|,
//! bound that; the covariance diag(N e_i²) over the N data of one least-squares problem does, by Cauchy and Schwarz:
//! Σ|a_i|e_i ≤ √(N Σa_i²e_i²). It is what is handed to the fit, and overstates by √N at most.
//!
//! Fluxes at most their own error outside \[0, 1\] are rounding and are put on its end.

use super::fluxes::{Covariance, IncidenceFluxes, MAX_ORDER, MediumFluxes, Referred, light};
use super::reference::Media;
use crate::CliError;
use crate::config::Config;
use stratiform_artifact::RowIncidence;
use stratiform_quantities::{Incidence, Medium, Order};
use stratiform_stats::Estimate;
use stratiform_transport::solve::{SolveMedium, Solved, Solver};

/// Solves both media at `rows` within the config's tolerance.
///
/// # Errors
/// [`CliError::Failed`] if the tolerance is not met, [`CliError::Input`] for numbers out of domain.
pub fn solve(
    config: &Config,
    media: &Media,
    tau: &[f64],
    rows: &[RowIncidence],
) -> Result<Vec<Referred>, CliError> {
    let incidences = rows.iter().map(light).collect::<Result<Vec<_>, _>>()?;
    let [full, modified] = [Medium::Full, Medium::Modified].map(|medium| {
        let medium = SolveMedium::from(media.get(medium));
        solve_medium(medium, config.transport.tolerance, tau, &incidences)
    });
    let (full, modified) = (full?, modified?);
    let one = |(i, row): (usize, &RowIncidence)| IncidenceFluxes {
        row: row.clone(),
        tau: tau.to_vec(),
        full: estimates(&full, i),
        modified: estimates(&modified, i),
    };
    rows.iter().enumerate().map(one).map(|fluxes| referred(config, fluxes)).collect()
}

fn solve_medium(
    medium: SolveMedium,
    tolerance: f64,
    tau: &[f64],
    incidences: &[Incidence],
) -> Result<Solved, CliError> {
    let name = format!("transport.tolerance, {} medium", medium.medium());
    let solver = Solver::new(medium, tolerance).map_err(super::trace_error)?;
    solver.orders(tau, incidences, MAX_ORDER).map_err(|error| super::trace_error(error).at(&name))
}

fn estimates(solved: &Solved, incidence: usize) -> MediumFluxes {
    let rows: Vec<Order> = Order::rows(MAX_ORDER).collect();
    MediumFluxes::new(rows.clone(), solved.tau().len(), |k, order| {
        let place = rows.iter().position(|row| *row == order)?;
        let (reflectance, transmittance) = solved.estimate(incidence, k, place);
        Some((rounded(reflectance), rounded(transmittance)))
    })
}

fn rounded(Estimate { value, std_error }: Estimate) -> Estimate {
    let nearest = value.clamp(0.0, 1.0);
    Estimate { value: if (value - nearest).abs() <= std_error { nearest } else { value }, std_error }
}

fn referred(config: &Config, fluxes: IncidenceFluxes) -> Result<Referred, CliError> {
    let transport = &config.transport;
    let count = fluxes.tau.len();
    let errors = |medium, order| {
        let known = (0..count).filter_map(|k| fluxes.of(medium).get(k, order));
        known
            .map(|(reflectance, transmittance)| [reflectance.std_error, transmittance.std_error])
            .collect::<Vec<_>>()
    };
    let totals: Vec<f64> =
        errors(transport.totals_medium, Order::Total).into_iter().map(|error| error[1]).collect();
    let orders: Vec<f64> = [(1, 1), (2, 1), (1, 0), (2, 0)]
        .into_iter()
        .flat_map(|(n, part)| {
            errors(transport.orders_medium, Order::Exactly(n)).into_iter().map(move |error| error[part])
        })
        .collect();
    // β is fitted to all rows together, κ_c, t and r to the orders of one row.
    let covariance = Covariance {
        t_ms: bound(&totals, count * config.fit.theta_l_deg.len()),
        orders: bound(&orders, orders.len()),
    };
    fluxes.referred(config, covariance)
}

/// diag(N e²), row by row.
fn bound(errors: &[f64], data: usize) -> Vec<f64> {
    let size = errors.len();
    let mut covariance = vec![0.0; size * size];
    for (i, error) in errors.iter().enumerate() {
        covariance[i * (size + 1)] = data as f64 * error * error;
    }
    covariance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_covariance_bounds_errors_of_any_sign() {
        let (errors, answers) = ([3e-7, 1e-7, 2e-7], [0.5, -2.0, 1.5]);
        let covariance = bound(&errors, 3);
        let claimed = (0..3).fold(0.0, |sum, i| sum + answers[i] * answers[i] * covariance[4 * i]).sqrt();
        let worst = (0..3).fold(0.0, |sum, i| sum + f64::abs(answers[i] * errors[i]));
        assert!(claimed >= worst && claimed <= 3_f64.sqrt() * worst, "{claimed} {worst}");
        assert_eq!(covariance[1], 0.0);
    }

    #[test]
    fn rounding_is_trimmed_and_faults_are_not() {
        let at = |value| rounded(Estimate { value, std_error: 1e-9 }).value;
        assert_eq!([at(-1e-12), at(1.0 + 1e-12), at(0.5)], [0.0, 1.0, 0.5]);
        assert_eq!(at(-1e-3), -1e-3);
    }
}
