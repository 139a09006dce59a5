//! `convergence.csv`: how both tracers' errors fall with photons and with seconds, on the fit's whole thickness grid.

use super::optics::Cloud;
use super::reference::Media;
use crate::CliError;
use crate::config::Config;
use crate::output::Talk;
use crate::progress;
use std::path::Path;
use std::time::Instant;
use stratiform_artifact::{ConvergenceRow, OrdersRow, read_csv, write_csv};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, Order};
use stratiform_transport::{Stop, TraceRequest, Traced, trace_half_space, trace_plain};

/// Runs both tracers with rising numbers of photons and writes the file. The error is held against the reference of
/// the fit, traced with other photons.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] if the angle is none of the reference's or a file fails.
pub fn write(config: &Config, cloud: &Cloud, dir: &Path, talk: Talk) -> Result<Vec<String>, CliError> {
    let theta = config.convergence.theta_l_deg;
    let reference = reference(dir, theta)?;
    let media = Media::new(config, cloud)?;
    let mut rows = Vec::new();
    for &photons in &config.convergence.photons {
        let request = TraceRequest {
            tau: cloud.tau(config),
            incidence: Incidence::beam(cos_degrees(theta))?,
            stop: Stop::Photons(photons),
            max_order: 0,
            // Other photons than the reference's, and others for each point.
            seed: config.transport.seed ^ photons.wrapping_mul(0x9e37_79b9_7f4a_7c15),
            stream: 0,
        };
        for estimator in ["plain", "half-space"] {
            let bar = progress::bar(photons, &format!("{estimator} {photons}"), talk.quiet);
            let advanced = |done: u64, _total: u64| bar.set_position(done);
            let start = Instant::now();
            let (medium, control) = (media.get(Medium::Full), super::control(&advanced));
            let traced = match estimator {
                "plain" => trace_plain(medium, &request, control),
                _ => trace_half_space(medium, &request, control),
            }
            .map_err(super::trace_error)?;
            let seconds = start.elapsed().as_secs_f64();
            bar.finish_and_clear();
            rows.extend(compare(estimator, theta, photons, seconds, &traced, &reference));
        }
    }
    write_csv(&dir.join("convergence.csv"), &rows)?;
    Ok(vec!["convergence.csv".to_owned()])
}

/// Total reflectance of the full medium at each thickness.
fn reference(dir: &Path, theta: f64) -> Result<Vec<f64>, CliError> {
    let rows: Vec<OrdersRow> = read_csv(&dir.join("orders.csv"))?;
    let name = theta.to_string();
    let wanted =
        |row: &&OrdersRow| row.theta_l_deg == name && row.medium == Medium::Full && row.order == "total";
    let values: Vec<_> = rows.iter().filter(wanted).map(|row| row.reflectance).collect();
    if values.is_empty() {
        return Err(CliError::Input(format!(
            "convergence.theta_l_deg = {theta} is not one of fit.theta_l_deg"
        )));
    }
    Ok(values)
}

fn compare(
    estimator: &str,
    theta_l_deg: f64,
    photons: u64,
    seconds: f64,
    traced: &Traced,
    reference: &[f64],
) -> Vec<ConvergenceRow> {
    let row = |(index, tau): (usize, &f64)| {
        let reflectance = traced.estimate(index, Order::Total).0;
        ConvergenceRow {
            estimator: estimator.to_owned(),
            theta_l_deg,
            tau: *tau,
            order: Order::Total.to_string(),
            photons,
            seconds,
            error: (reflectance.value - reference[index]).abs(),
            std_error: reflectance.std_error,
        }
    };
    traced.tau().iter().enumerate().map(row).collect()
}
