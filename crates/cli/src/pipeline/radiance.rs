//! The radiance model: reference radiances of the full medium from the solver, the fit, and its errors at other points.

use super::optics::Cloud;
use super::{input_error, source, trace_error};
use crate::CliError;
use crate::config::Config;
use crate::output::Talk;
use crate::progress;
use std::path::Path;
use std::sync::Arc;
use stratiform_artifact::{Provenance, create_folder, hash_of, write_json};
use stratiform_fit::{Draw, Drawn, RadianceConfig, RadiancePlan, RadiancePoint, fit_radiance};
use stratiform_model::angular::PhaseLookup;
use stratiform_optics::phase::{Modified, PhaseFunction};
use stratiform_quantities::Side;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Radiances, SolveMedium, View};

const METHOD: &str = "discrete ordinates; weighted linear least squares of ln(I - I1); std_error is that of White's sandwich: the \
                      spread that other points would give";

/// The file, which is also put among those to be accepted.
pub const FILE: &str = "radiance_parameters.json";

/// Provenance of the coefficients.
pub fn provenance(config: &Config, settings: &RadianceConfig) -> Provenance {
    let transport = &config.transport;
    let medium =
        (transport.wavelength_um, transport.extinction_convention, transport.single_scattering_albedo);
    Provenance::new(hash_of(&(&config.optics, medium, settings)), None, METHOD)
}

/// Runs the stage.
///
/// # Errors
/// [`CliError::Failed`] if the tolerance is not met, [`CliError::Input`] for a cloud that absorbs.
pub fn write(
    config: &Config,
    settings: &RadianceConfig,
    cloud: &Cloud,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let phase = Arc::new(cloud.phase.clone());
    let medium = SolveMedium::full(phase.clone(), cloud.omega);
    let solver = RadianceSolver::new(medium, settings.tolerance).map_err(trace_error)?;
    let plans = [Draw::Fitted, Draw::Check].map(|draw| RadiancePlan::new(settings, draw));
    let spinner = progress::spinner("radiances", talk.quiet);
    let solved = plans.iter().map(|plan| solve(&solver, plan)).collect::<Result<Vec<_>, _>>();
    spinner.finish_and_clear();
    let solved = solved?;
    let wide = Wide(Modified::new(phase, config.optics.theta_f_deg)?);
    let [fitted, check] = [0, 1].map(|i| Drawn { sample: &plans[i].sample, points: &solved[i] });
    let record = source::medium(config, cloud)?;
    let document =
        fit_radiance(&fitted, &[check], record, provenance(config, settings), &wide).map_err(input_error)?;
    create_folder(&dir.join("accepted"))?;
    let files = [FILE.to_owned(), format!("accepted/{FILE}")];
    files.iter().try_for_each(|file| write_json(&dir.join(file), &document))?;
    Ok(files.to_vec())
}

/// All suns of a plan in one go, each with its views: the work that they share is most of it.
fn solve(solver: &RadianceSolver, plan: &RadiancePlan) -> Result<Vec<RadiancePoint>, CliError> {
    let view = |&(side, mu, phi_deg): &(Side, f64, f64)| View { side, mu, phi_deg };
    let suns: Vec<(f64, Vec<View>)> =
        plan.suns.iter().map(|sun| (sun.mu_l, sun.views.iter().map(view).collect())).collect();
    let solved = solver.radiance_of_suns(&plan.tau, &suns).map_err(trace_error)?;
    Ok(suns.iter().zip(&solved).flat_map(|(sun, solved)| points(&plan.tau, sun, solved)).collect())
}

fn points(tau: &[f64], (mu_l, views): &(f64, Vec<View>), solved: &Radiances) -> Vec<RadiancePoint> {
    let mut points = Vec::new();
    for (t, &tau) in tau.iter().enumerate() {
        points.extend(views.iter().enumerate().map(|(v, view)| RadiancePoint {
            tau,
            mu_l: *mu_l,
            mu_v: view.mu,
            phi_deg: view.phi_deg,
            side: view.side,
            radiance: solved.estimate(t, 0, v, RadianceOrder::Total),
        }));
    }
    points
}

/// P_S; the model looks up nothing else.
struct Wide(Modified);

impl PhaseLookup<f64> for Wide {
    fn full(&self, v: f64) -> f64 {
        self.wide(v)
    }

    fn wide(&self, v: f64) -> f64 {
        self.0.value(v)
    }

    fn wide_squared(&self, v: f64) -> f64 {
        self.wide(v)
    }
}
