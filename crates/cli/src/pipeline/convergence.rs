//! `convergence.csv`: how both tracers' errors fall with photons and with seconds.

use super::optics::Cloud;
use super::reference::Media;
use crate::CliError;
use crate::config::{Config, ConvergenceConfig};
use crate::output::Talk;
use crate::{interrupt, progress};
use std::path::Path;
use std::time::Instant;
use stratiform_artifact::{ConvergenceRow, OrdersRow, read_csv, write_csv};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, Order};
use stratiform_transport::{
    Control, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

type Tracer = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

/// What every point of the curves shares.
struct Curve<'a> {
    settings: &'a ConvergenceConfig,
    seed: u64,
    media: Media,
    /// Thicknesses, each with the reference's total reflectance.
    truth: Vec<(f64, f64)>,
    talk: Talk,
}

/// Runs both tracers with rising numbers of photons and writes the file. The error is held against the reference of
/// the fit, traced with other photons.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] if the angle is none of the reference's or a file fails.
pub fn write(
    config: &Config,
    settings: &ConvergenceConfig,
    cloud: &Cloud,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let reference = reference(dir, settings.theta_l_deg)?;
    let truth =
        thicknesses(config, settings).iter().map(|k| (cloud.tau(config)[*k], reference[*k])).collect();
    let seed = config.transport.seed.unwrap_or_default();
    let curve = Curve { settings, seed, media: Media::new(config, cloud)?, truth, talk };
    let mut rows = curve.points("plain", trace_plain, &settings.plain_photons)?;
    rows.extend(curve.points("half-space", trace_half_space, &settings.half_space_photons)?);
    write_csv(&dir.join("convergence.csv"), &rows)?;
    Ok(vec!["convergence.csv".to_owned()])
}

/// Places in the fit's grid that are nearest to the thicknesses asked for, each once.
fn thicknesses(config: &Config, settings: &ConvergenceConfig) -> Vec<usize> {
    let grid = config.fit.thickness_m.metres();
    let away = |k: &usize, wanted: f64| libm::log(grid[*k] / wanted).abs();
    let nearest = |wanted: &f64| (0..grid.len()).min_by(|a, b| away(a, *wanted).total_cmp(&away(b, *wanted)));
    let mut places: Vec<_> = settings.thickness_m.iter().filter_map(nearest).collect();
    places.sort_unstable();
    places.dedup();
    places
}

impl Curve<'_> {
    fn points(
        &self,
        estimator: &str,
        tracer: Tracer,
        photons: &[u64],
    ) -> Result<Vec<ConvergenceRow>, CliError> {
        let mut rows = Vec::new();
        for &photons in photons {
            let bar = progress::bar(photons, &format!("{estimator} {photons}"), self.talk.quiet);
            let advanced = |done: u64, _total: u64| bar.set_position(done);
            let start = Instant::now();
            let request = self.request(photons)?;
            let traced = tracer(
                self.media.get(Medium::Full),
                &request,
                super::control(&advanced, &interrupt::watch()),
            )
            .map_err(super::trace_error)?;
            let seconds = start.elapsed().as_secs_f64();
            bar.finish_and_clear();
            rows.extend(self.compare(estimator, photons, seconds, &traced));
        }
        Ok(rows)
    }

    fn request(&self, photons: u64) -> Result<TraceRequest, CliError> {
        Ok(TraceRequest {
            tau: self.truth.iter().map(|(tau, _)| *tau).collect(),
            incidence: Incidence::beam(cos_degrees(self.settings.theta_l_deg))?,
            stop: Stop::Photons(photons),
            max_order: 0,
            // Other photons than the reference's, and others for each point.
            seed: self.seed ^ photons.wrapping_mul(0x9e37_79b9_7f4a_7c15),
            stream: 0,
        })
    }

    fn compare(&self, estimator: &str, photons: u64, seconds: f64, traced: &Traced) -> Vec<ConvergenceRow> {
        let row = |(index, (tau, truth)): (usize, &(f64, f64))| {
            let reflectance = traced.estimate(index, Order::Total).0;
            ConvergenceRow {
                estimator: estimator.to_owned(),
                theta_l_deg: self.settings.theta_l_deg,
                tau: *tau,
                order: Order::Total.to_string(),
                photons,
                seconds,
                error: (reflectance.value - truth).abs(),
                std_error: reflectance.std_error,
            }
        };
        self.truth.iter().enumerate().map(row).collect()
    }
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
