//! `stratiform optics`: a droplet distribution's optical properties.

use crate::args::OpticsArgs;
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::{CliError, pipeline, progress};
use std::fmt::Write;
use stratiform_artifact::{OpticsDocument, create_folder, to_json};
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;

/// Runs the command.
///
/// # Errors
/// [`CliError`] for bad input, or if the tolerance is not met.
pub fn run(args: &OpticsArgs, talk: Talk) -> Result<Data, CliError> {
    let config = config(args)?;
    create_folder(&args.out)?;
    let spinner = progress::spinner("optics", talk.quiet);
    let ensembles = pipeline::optics::ensembles(&config);
    spinner.finish_and_clear();
    let ensembles = ensembles?;
    let document =
        stratiform_optics::write(&config, &ensembles, &args.out).map_err(pipeline::optics::optics_error)?;
    talk.say(format!("written to {}", args.out.display()));
    if args.json { Ok(to_json(&document)?) } else { Ok(table(&document)) }
}

fn config(args: &OpticsArgs) -> Result<OpticsConfig, CliError> {
    if let Some(path) = &args.config {
        return Ok(Config::load(path)?.optics);
    }
    let need =
        |value: Option<f64>, name: &str| value.ok_or_else(|| CliError::Input(format!("--{name} is missing")));
    let droplets = DropletDistribution::ModifiedGamma {
        effective_radius_um: need(args.r_eff, "r-eff")?,
        gamma: need(args.gamma, "gamma")?,
    };
    let config = OpticsConfig {
        droplets,
        number_density_per_cm3: need(args.n0, "n0")?,
        wavelengths_um: args.wavelength.clone(),
        refractive_index: Default::default(),
        theta_f_deg: args.modified,
        tolerance: Default::default(),
    };
    config.resolve().map_err(pipeline::optics::optics_error)?;
    Ok(config)
}

fn table(document: &OpticsDocument) -> String {
    let mut text = String::from(
        "wavelength_um,n,k,extinction_paper_per_m,extinction_mie_per_m,single_scattering_albedo,asymmetry,theta_f_deg,\
         forward_fraction\n",
    );
    for w in &document.wavelengths {
        let [n, k] = w.refractive_index;
        let _ = writeln!(
            text,
            "{},{n},{k},{},{},{},{},{},{}",
            w.wavelength_um,
            w.extinction_per_m.paper,
            w.extinction_per_m.mie,
            w.single_scattering_albedo,
            w.asymmetry,
            w.forward_fraction.theta_f_deg,
            w.forward_fraction.value
        );
    }
    text
}
