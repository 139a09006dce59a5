//! `stratiform advise`: the cheapest method within a budget.

mod config;

use crate::CliError;
use crate::args::AdviseArgs;
use crate::output::{Data as Text, Talk};
use crate::pipeline::{input_error, optics};
use std::path::Path;
use stratiform_advise::{Advice, AdviseError, Budget, Data, advise, unneeded};
use stratiform_artifact::{read_csv, to_json, write_atomic};
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_quantities::ExtinctionConvention;
use stratiform_scene::{Interval, Scene, find};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for a bad scene, budget or data; [`CliError::Unmet`] with the nearest answer if nothing meets the budget.
pub fn run(args: &AdviseArgs, talk: Talk) -> Result<Text, CliError> {
    let max_error = args.max_error.as_deref().map(Budget::share).transpose().map_err(refused)?;
    let budget = Budget::new(max_error, args.max_ns).map_err(refused)?;
    let (name, scene) = find(&args.scene).map_err(input_error)?;
    let data = args.data.as_deref().map_or_else(Data::committed, Data::load).map_err(refused)?;
    let tau = thickness(&scene)?;
    let mut advice = advise(&data, &scene, tau, &budget, args.ground_albedo).map_err(refused)?;
    advice.notes.extend(contributions(args, (&name, &scene), &budget)?);
    let text = if args.json { to_json(&advice)? } else { advice.to_string() };
    if !advice.met {
        return Err(CliError::Unmet { message: nearest(&advice), data: text });
    }
    if let Some(path) = &args.emit {
        write_atomic(path, config::text(&advice, &scene, tau, path).as_bytes())?;
        talk.say(format!("{}: run `stratiform reproduce` on it", path.display()));
    }
    Ok(text)
}

/// Where `scripts/compare-pictures` puts the table of ablations.
const ABLATION: &str = "fit-configs/render/ablation.csv";

/// Which parts a scene's picture does not need: by the table that was named, which must know the scene, or by the usual one where it is
/// there and does.
fn contributions(
    args: &AdviseArgs,
    (name, scene): (&str, &Scene),
    budget: &Budget,
) -> Result<Option<String>, CliError> {
    let path = args.ablation.as_deref().unwrap_or(Path::new(ABLATION));
    let wanted = args.ablation.is_some() || (scene.camera.is_some() && path.exists());
    let Some(max_error) = budget.max_error.filter(|_| wanted) else { return Ok(None) };
    match unneeded(&read_csv(path)?, name, max_error) {
        Some(found) => Ok(Some(found.to_string())),
        None if args.ablation.is_none() => Ok(None),
        None => Err(CliError::Input(format!("{}: no rows of the scene `{name}`", path.display()))),
    }
}

fn refused(error: AdviseError) -> CliError {
    CliError::Input(error.to_string())
}

fn nearest(advice: &Advice) -> String {
    let error = 100.0 * advice.prediction.error;
    format!(
        "no listed method meets the budget: the nearest is {}, error {error:.1} %, {:.1} ns",
        advice.method, advice.ns
    )
}

/// Optical thickness of the scene; metres by the extinction of its smallest and largest droplets.
fn thickness(scene: &Scene) -> Result<Interval, CliError> {
    if let Some(tau) = scene.layer.optical_thickness {
        return Ok(tau);
    }
    let missing = || CliError::Input("the scene has no thickness".to_owned());
    let metres = scene.layer.thickness_m.ok_or_else(missing)?;
    let number = scene.droplets.number_density_per_cm3.ok_or_else(missing)?;
    let kappa = |radius: f64| match scene.layer.extinction_convention {
        Some(ExtinctionConvention::Mie) => mie_extinction(scene, number, radius),
        _ => Ok(1e-6 * number * std::f64::consts::PI * radius * radius),
    };
    let radii = scene.droplets.effective_radius_um;
    Ok(Interval { min: kappa(radii.min)? * metres.min, max: kappa(radii.max)? * metres.max })
}

fn mie_extinction(
    scene: &Scene,
    number_density_per_cm3: f64,
    effective_radius_um: f64,
) -> Result<f64, CliError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: scene.droplets.gamma(), effective_radius_um },
        number_density_per_cm3,
        wavelengths_um: scene.wavelengths_um[..1].to_vec(),
        refractive_index: Default::default(),
        theta_f_deg: scene.droplets.theta_f_deg,
        tolerance: Default::default(),
    };
    Ok(optics::ensembles(&config)?[0].extinction.mie)
}
