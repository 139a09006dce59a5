//! `convergence.csv`: how the tracers' errors fall with photons, the solver's with streams, and all with seconds; and
//! what the solver costs.

use super::optics::Cloud;
use super::reference::Media;
use super::solver_cost;
use crate::CliError;
use crate::config::{Config, ConvergenceConfig};
use crate::output::Talk;
use crate::{interrupt, progress};
use std::path::Path;
use std::time::Instant;
use stratiform_artifact::{ConvergenceRow, write_csv};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, Order};
use stratiform_transport::solve::{SolveMedium, Solver};
use stratiform_transport::{
    Control, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

type Tracer = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

/// Moments of the phase function are enough for this.
const TOLERANCE: f64 = 1e-7;

/// Streams per hemisphere of the truth, and of the points.
const FINEST: usize = 96;
const STREAMS: [usize; 9] = [2, 4, 6, 8, 12, 16, 24, 32, 48];

/// Runs of the solver of which the fastest counts, at most; all but the first end within `ENOUGH` seconds.
const REPEATS: usize = 5;
const ENOUGH: f64 = 0.005;

/// What every point of the curves shares.
struct Curve<'a> {
    settings: &'a ConvergenceConfig,
    seed: u64,
    media: Media,
    solver: Solver,
    incidence: Incidence,
    /// Thicknesses, each with the true total reflectance.
    truth: Vec<(f64, f64)>,
    talk: Talk,
}

/// Runs both tracers with rising numbers of photons, the solver with rising numbers of streams, and writes the files.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] if a file fails.
pub fn write(
    config: &Config,
    settings: &ConvergenceConfig,
    cloud: &Cloud,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let tau: Vec<f64> = thicknesses(config, settings).iter().map(|k| cloud.tau(config)[*k]).collect();
    let media = Media::new(config, cloud)?;
    let solver =
        Solver::new(SolveMedium::from(media.get(Medium::Full)), TOLERANCE).map_err(super::trace_error)?;
    let incidence = Incidence::beam(cos_degrees(settings.theta_l_deg))?;
    // The kernels of all points with it.
    let finest = solver.totals_with_streams(FINEST, &tau, &[incidence]).map_err(super::trace_error)?;
    let truth = tau.iter().zip(finest).map(|(tau, (reflectance, _))| (*tau, reflectance)).collect();
    let seed = config.transport.seed.unwrap_or_default();
    // Its table belongs to no point.
    media.get(Medium::Full).pieces();
    let cost = solver_cost::rows(&SolveMedium::from(media.get(Medium::Full)), incidence)?;
    let curve = Curve { settings, seed, media, solver, incidence, truth, talk };
    let mut rows = curve.points("plain", trace_plain, &settings.plain_photons)?;
    rows.extend(curve.points("half-space", trace_half_space, &settings.half_space_photons)?);
    rows.extend(curve.solved()?);
    write_csv(&dir.join("convergence.csv"), &rows)?;
    write_csv(&dir.join("solver_cost.csv"), &cost)?;
    Ok(vec!["convergence.csv".to_owned(), "solver_cost.csv".to_owned()])
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
            incidence: self.incidence,
            stop: Stop::Photons(photons),
            max_order: 0,
            // Other photons than the reference's, and others for each point.
            seed: self.seed ^ photons.wrapping_mul(0x9e37_79b9_7f4a_7c15),
            stream: 0,
        })
    }

    fn compare(&self, estimator: &str, photons: u64, seconds: f64, traced: &Traced) -> Vec<ConvergenceRow> {
        let total = |index| traced.estimate(index, Order::Total).0;
        let values =
            (0..self.truth.len()).map(|index| (total(index).value, total(index).std_error)).collect();
        self.rows(estimator, photons, seconds, values)
    }

    /// The solver's points. The medium is prepared, as the tracers' tables are; the modes are not.
    fn solved(&self) -> Result<Vec<ConvergenceRow>, CliError> {
        let tau: Vec<f64> = self.truth.iter().map(|(tau, _)| *tau).collect();
        let solve = |streams| -> Result<(f64, Vec<f64>), CliError> {
            let solver = self.solver.unsolved();
            let start = Instant::now();
            let pairs = solver.totals_with_streams(streams, &tau, &[self.incidence]);
            let seconds = start.elapsed().as_secs_f64();
            Ok((seconds, pairs.map_err(super::trace_error)?.into_iter().map(|pair| pair.0).collect()))
        };
        let (mut rows, mut before) = (Vec::new(), solve(1)?.1);
        for streams in STREAMS {
            let (mut seconds, values) = solve(streams)?;
            let begin = Instant::now();
            for _ in 1..REPEATS {
                if begin.elapsed().as_secs_f64() + seconds > ENOUGH {
                    break;
                }
                seconds = seconds.min(solve(streams)?.0);
            }
            let changes = values.iter().zip(&before).map(|(value, before)| (*value, (value - before).abs()));
            rows.extend(self.rows("solver", streams as u64, seconds, changes.collect()));
            before = values;
        }
        Ok(rows)
    }

    /// Rows of one run from its reflectances and their claimed errors.
    fn rows(
        &self,
        estimator: &str,
        photons: u64,
        seconds: f64,
        values: Vec<(f64, f64)>,
    ) -> Vec<ConvergenceRow> {
        let row = |((tau, truth), (value, std_error)): (&(f64, f64), (f64, f64))| ConvergenceRow {
            estimator: estimator.to_owned(),
            theta_l_deg: self.settings.theta_l_deg,
            tau: *tau,
            order: Order::Total.to_string(),
            photons,
            seconds,
            error: (value - truth).abs(),
            std_error,
        };
        self.truth.iter().zip(values).map(row).collect()
    }
}
